//! Sums of cosines over a Gaussian footprint: exactly, by all pairs of waves, and single waves by quadrature.

use std::f64::consts::TAU;

use super::normal::density;
use super::quadrature::integrate;

/// A wave: amplitude times the cosine of 2π times (frequency · position + phase).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wave {
    /// Cycles a unit, along x and y.
    pub frequency: [f64; 2],
    /// Half the distance from trough to crest.
    pub amplitude: f64,
    /// In turns.
    pub phase: f64,
}

impl Wave {
    /// The angle at a position.
    fn angle(&self, position: [f64; 2]) -> f64 {
        let turns = dot(self.frequency, position) + self.phase;
        TAU * (turns - turns.round())
    }

    /// The height and its slopes at a position.
    fn at(&self, position: [f64; 2]) -> [f64; 3] {
        let (sin, cos) = self.angle(position).sin_cos();
        let slope = self.frequency.map(|along| -TAU * along * self.amplitude * sin);
        [self.amplitude * cos, slope[0], slope[1]]
    }
}

/// What a footprint holds of a function and of its slopes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface {
    /// Mean of the function.
    pub mean: f64,
    /// Its variance.
    pub variance: f64,
    /// Mean slope.
    pub slope: [f64; 2],
    /// Covariance of slopes: xx, xy, yy.
    pub slope_covariance: [f64; 3],
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// The sum at a position, with its slopes.
pub fn value(waves: &[Wave], position: [f64; 2]) -> [f64; 3] {
    waves.iter().map(|wave| wave.at(position)).fold([0.0; 3], |sum, at| [0, 1, 2].map(|part| sum[part] + at[part]))
}

/// What a footprint of covariance across acrossᵀ + along alongᵀ holds of a sum: every product of two waves is the sum
/// of two waves, which fade by themselves.
pub fn surface(waves: &[Wave], position: [f64; 2], across: [f64; 2], along: [f64; 2]) -> Surface {
    let fade = |frequency: [f64; 2]| {
        let square = dot(frequency, across).powi(2) + dot(frequency, along).powi(2);
        libm::exp(-0.5 * TAU * TAU * square)
    };
    let mut found = Surface { mean: 0.0, variance: 0.0, slope: [0.0; 2], slope_covariance: [0.0; 3] };
    for wave in waves {
        let faded = fade(wave.frequency);
        let [height, x, y] = wave.at(position).map(|value| faded * value);
        found.mean += height;
        found.slope = [found.slope[0] + x, found.slope[1] + y];
    }
    for (one, other) in waves.iter().flat_map(|one| waves.iter().map(move |other| (one, other))) {
        let [a, b] = [one, other].map(|wave| wave.angle(position));
        let [[p, q], [r, s]] = [one.frequency, other.frequency];
        let own = fade(one.frequency) * fade(other.frequency);
        let half = 0.5 * one.amplitude * other.amplitude;
        // Of each term the covariance: mean of the product less the product of the means.
        let sum = half * (fade([p + r, q + s]) - own) * libm::cos(a + b);
        let difference = half * (fade([p - r, q - s]) - own) * libm::cos(a - b);
        found.variance += difference + sum;
        let slopes = TAU * TAU * (difference - sum);
        let products = [p * r, 0.5 * (p * s + q * r), q * s];
        found.slope_covariance = [0, 1, 2].map(|part| found.slope_covariance[part] + products[part] * slopes);
    }
    found
}

/// What one wave adds: mean; variance beyond that of the mean's plane; gradient; second derivatives xx, xy, yy;
/// covariance of slopes beyond that of the second derivatives. By quadrature over the angle.
pub fn wave(wave: Wave, position: [f64; 2], across: [f64; 2], along: [f64; 2]) -> [f64; 10] {
    let spread = TAU * dot(wave.frequency, across).hypot(dot(wave.frequency, along));
    let angle = wave.angle(position);
    let means = |about: [f64; 2]| {
        let apart = move |at: f64| {
            let (sin, cos) = (angle + at).sin_cos();
            let [sin, cos] = [sin - about[0], cos - about[1]];
            [sin, cos, sin * sin, cos * cos]
        };
        if spread < 1e-9 {
            return apart(0.0);
        }
        let weighted = |at: f64| apart(at).map(|value| value * density(at / spread) / spread);
        integrate(-8.0 * spread, 8.0 * spread, spread.min(1.0), weighted)
    };
    // About the means, so that small variances keep their digits.
    let [sin, cos, ..] = means([0.0; 2]);
    let [_, _, sines, cosines] = means([sin, cos]);
    let (a, [x, y]) = (wave.amplitude, wave.frequency);
    let products = [x * x, x * y, y * y].map(|product| TAU * TAU * product);
    let own = a * a * (cosines - spread * spread * sin * sin);
    let slopes = a * a * (sines - spread * spread * cos * cos);
    let [xx, xy, yy] = products;
    [
        a * cos,
        own,
        -TAU * a * sin * x,
        -TAU * a * sin * y,
        -a * cos * xx,
        -a * cos * xy,
        -a * cos * yy,
        slopes * xx,
        slopes * xy,
        slopes * yy,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    const WAVES: [Wave; 3] = [
        Wave { frequency: [0.7, -0.2], amplitude: 0.4, phase: 0.13 },
        Wave { frequency: [0.5, 0.9], amplitude: -0.25, phase: -3.4 },
        Wave { frequency: [-0.6, 0.3], amplitude: 0.3, phase: 0.5 },
    ];

    /// By quadrature over both axes of the footprint.
    #[test]
    fn pairs_of_waves_are_the_integral() {
        let (position, across, along) = ([0.31, -1.7], [0.2, 0.1], [-0.15, 0.3]);
        let at = |u: f64, v: f64| {
            let [h, x, y] = value(&WAVES, [0, 1].map(|axis| position[axis] + u * across[axis] + v * along[axis]));
            [h, x, y, h * h, x * x, x * y, y * y]
        };
        let row = |u: f64| {
            integrate(-8.0, 8.0, 1.0, |v| at(u, v).map(|value| value * density(v))).map(|value| value * density(u))
        };
        let [h, x, y, hh, xx, xy, yy] = integrate(-8.0, 8.0, 1.0, row);
        let own = surface(&WAVES, position, across, along);
        let expected = [h, hh - h * h, x, y, xx - x * x, xy - x * y, yy - y * y];
        let [a, b, c] = own.slope_covariance;
        let found = [own.mean, own.variance, own.slope[0], own.slope[1], a, b, c];
        for (found, expected) in found.into_iter().zip(expected) {
            assert!((found - expected).abs() < 1e-12, "{found} {expected}");
        }
    }

    /// One wave alone: the plane and the rest are all that it varies.
    #[test]
    fn single_waves_are_the_sum_of_one() {
        let (position, across, along) = ([2.3, 0.4], [0.3, -0.1], [0.05, 0.2]);
        for one in WAVES {
            let whole = surface(&[one], position, across, along);
            let part = wave(one, position, across, along);
            let plane = dot([part[2], part[3]], across).powi(2) + dot([part[2], part[3]], along).powi(2);
            assert!((part[0] - whole.mean).abs() < 1e-13);
            assert!((part[1] + plane - whole.variance).abs() < 1e-13, "{part:?} {whole:?}");
            let bent = |axis: [f64; 2]| [dot([part[4], part[5]], axis), dot([part[5], part[6]], axis)];
            let ([a, b], [c, d]) = (bent(across), bent(along));
            for (index, square) in [a * a + c * c, a * b + c * d, b * b + d * d].into_iter().enumerate() {
                let own = part[7 + index] + square;
                assert!((own - whole.slope_covariance[index]).abs() < 1e-12, "{part:?} {whole:?}");
            }
        }
    }
}
