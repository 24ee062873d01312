//! What second derivatives of a noise tell of a footprint: by the moments of its definition, and regression.

use std::f64::consts::{FRAC_PI_2, TAU};
use std::sync::OnceLock;

use super::bent_noise::{second, simplex_part};
use super::quadrature::integrate;
use super::retained::Noise;

/// Moments of a noise over its variance: of a derivative along an axis, of a second derivative along it, and the
/// covariance of the second derivatives along both axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moments {
    /// Variance of a derivative.
    pub slopes: f64,
    /// Variance of a second derivative.
    pub bends: f64,
    /// Covariance of the second derivatives along both axes.
    pub both: f64,
}

impl Noise {
    /// Its moments; nothing of noise in space.
    pub fn moments(self) -> Option<Moments> {
        static ALL: OnceLock<[Moments; 3]> = OnceLock::new();
        let all = ALL.get_or_init(|| {
            let [a, b] = [axis(|_| 1.0), axis(|t| t)];
            // R is A A, or ½ (A B + B A), of which axes take turns.
            let value = Moments { slopes: a[0], bends: a[1], both: a[0] * a[0] };
            let perlin = Moments { slopes: 0.5 * (a[0] + b[0]), bends: 0.5 * (a[1] + b[1]), both: a[0] * b[0] };
            [perlin, value, kernel()]
        });
        match self {
            Self::Perlin => Some(all[0]),
            Self::Value => Some(all[1]),
            Self::Simplex => Some(all[2]),
            Self::PerlinSolid => None,
        }
    }

    /// What a point tells of a footprint where second derivatives are known: (multiplier, coupling, rest, share, bend).
    ///
    /// The regression of the footprint's mean on the noise n and the trace q of ΣH. With q the mean has the covariance
    /// E tr(Σ∇∇R), which is how E R n grows with the logarithm of the footprint's size.
    pub fn bent(self, deviations: [f64; 2]) -> Option<[f64; 5]> {
        const STEP: f64 = 1e-3;
        let moments = self.moments()?;
        let [mean, coupling, rest] = self.filter(deviations);
        let grown = |steps: f64| self.filter(deviations.map(|deviation| deviation * (1.0 + steps * STEP)))[0];
        let with_trace = (8.0 * (grown(1.0) - grown(-1.0)) - (grown(2.0) - grown(-2.0))) / (12.0 * STEP);
        let [level, trace] = moments.trace(deviations);
        let own = trace - level * level;
        let share = 2.0 * (with_trace - level * mean) / own;
        Some(told([mean, coupling, rest], share, [level, trace]))
    }
}

impl Moments {
    /// The covariance of the noise with the trace of ΣH, and the variance of that, over the noise's.
    pub fn trace(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        // Sums over pairs of axes.
        let [xx, yy] = [x * x, y * y];
        let pairs = [(xx * xx, self.bends), (yy * yy, self.bends), (xx * yy, self.both), (yy * xx, self.both)];
        [-(xx + yy) * self.slopes, pairs.iter().map(|(squares, moment)| squares * moment).sum()]
    }
}

/// (multiplier, coupling, rest, share, bend) from (multiplier, coupling, rest) without second derivatives, the share
/// and what a trace's covariance with the noise and its variance are.
///
/// Numbers are sums of independent ones of variance 1: the noise is the first, the trace has some of both. The rest is
/// what means over both leave of the variance, by a rule that is exact for squares.
pub fn told([mean, coupling, rest]: [f64; 3], share: f64, [level, trace]: [f64; 2]) -> [f64; 5] {
    let own = (trace - level * level).max(0.0).sqrt();
    let traced = |[noise, other]: [f64; 2]| level * noise + own * other;
    let best = |at: [f64; 2]| mean * at[0] + 0.5 * share * (traced(at) - traced([at[0], 0.0]));
    let multiplier = best([1.0, -level / own.max(1e-300)]);
    let bend = share * mean;
    let signs = [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]];
    let square = |of: &dyn Fn([f64; 2]) -> f64| signs.iter().map(|&at| 0.25 * of(at).powi(2)).sum::<f64>();
    let more = square(&best) - mean * mean + 0.5 * square(&|at| bend * traced(at));
    [multiplier, coupling, (rest - more).max(0.0), share, bend]
}

/// Mean squares of the derivative and the second derivative of a factor's weighted line along one axis, over that of
/// itself.
fn axis(factor: fn(f64) -> f64) -> [f64; 2] {
    let weighted = |t: f64| factor(t) * (1.0 - t.powi(3) * (10.0 - 15.0 * t + 6.0 * t * t));
    // Mean squares of a derivative are those of the function times its second derivative.
    let [whole, steep, bent] = integrate(0.0, 1.0, 0.5, |t| {
        let (value, bend) = (weighted(t), second(|step| weighted(t + step)));
        [value * value, -value * bend, bend * bend]
    });
    [steep / whole, bent / whole]
}

/// Of simplex noise, whose kernels' lines have all directions alike.
fn kernel() -> Moments {
    let reach = 0.5f64.sqrt();
    let [whole, steep, bent, both] = integrate(0.0, reach, 0.5 * reach, |distance| {
        integrate(0.0, TAU, FRAC_PI_2, |angle| {
            let away = [distance * libm::cos(angle), distance * libm::sin(angle)];
            let [noise, along, _, bend, _, other] = simplex_part(away, [1.0, 0.0]);
            let across = simplex_part(away, [0.0, 1.0]);
            let of = [
                noise * noise + across[0] * across[0],
                along * along + across[1] * across[1],
                bend * bend + across[3] * across[3],
                bend * other + across[3] * across[5],
            ];
            of.map(|square| distance * square)
        })
    });
    Moments { slopes: steep / whole, bends: bent / whole, both: both / whole }
}
