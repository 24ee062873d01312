//! Moments of a curve and of its slope over a normal variable, by quadrature between the places where the curve bends.

use super::normal::{density, REACH};
use super::quadrature::integrate_ends;

/// Widths of panels, in deviations.
const PANEL: f64 = 2.0;

/// The integral of results over the part of a normal distribution between two values, which may be infinite.
fn over<const N: usize>(
    [from, to]: [f64; 2],
    [mean, deviation]: [f64; 2],
    results: impl Fn(f64) -> [f64; N],
) -> [f64; N] {
    let low = from.max(mean - REACH * deviation);
    let high = to.min(mean + REACH * deviation);
    let panels = ((high - low) / (PANEL * deviation)).ceil().max(1.0);
    let mut sum = [0.0; N];
    for panel in 0..panels as usize {
        let [left, right] = [panel, panel + 1].map(|edge| low + (high - low) * edge as f64 / panels);
        let part: [f64; N] = integrate_ends(left, right, |value| {
            let weight = density((value - mean) / deviation) / deviation;
            results(value).map(|result| weight * result)
        });
        for (total, part) in sum.iter_mut().zip(part) {
            *total += part;
        }
    }
    sum
}

/// The integrals of g − a, (g − a)², g′ − b and (g′ − b)² over the part between two values of a normal distribution of
/// a mean and a deviation, of a curve that gives (g, g′) and does not bend there.
pub fn part(ends: [f64; 2], normal: [f64; 2], curve: impl Fn(f64) -> [f64; 2], [a, b]: [f64; 2]) -> [f64; 4] {
    over(ends, normal, |value| {
        let [height, slope] = curve(value);
        [height - a, (height - a).powi(2), slope - b, (slope - b).powi(2)]
    })
}

/// The probability that a normal variable of a mean and a deviation is between two values.
pub fn mass(ends: [f64; 2], normal: [f64; 2]) -> f64 {
    let [mass] = over(ends, normal, |_| [1.0]);
    mass
}

/// Mean and variance of the curve, and of its slope, over a normal variable. The curve gives (g, g′) and bends at some
/// values, by rising order; without a deviation they are those of a point.
pub fn moments(bends: &[f64], curve: impl Fn(f64) -> [f64; 2], mean: f64, deviation: f64) -> [f64; 4] {
    let center = curve(mean);
    if !(deviation > 0.0) {
        return [center[0], 0.0, center[1], 0.0];
    }
    let ends = [f64::NEG_INFINITY].into_iter().chain(bends.iter().copied()).chain([f64::INFINITY]);
    let ends: Vec<f64> = ends.collect();
    let about = |about: [f64; 2]| {
        let parts = ends.windows(2).map(|pair| part([pair[0], pair[1]], [mean, deviation], &curve, about));
        parts.fold([0.0; 4], |sum, part| std::array::from_fn(|at| sum[at] + part[at]))
    };
    // About the point first, which keeps the digits of narrow distributions; then about the means.
    let first = about(center);
    let means = [center[0] + first[0], center[1] + first[2]];
    let second = about(means);
    [means[0] + second[0], second[1] - second[0].powi(2), means[1] + second[2], second[3] - second[2].powi(2)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reference::quadrature::integrate;

    /// Of |x|: √(2/π), 1 − 2/π, 0 and 1; of x³: 0, 15, 3 and 18 by Isserlis' theorem.
    #[test]
    fn known_moments() {
        let [mean, variance, slope, spread] = moments(&[0.0], |x| [x.abs(), x.signum()], 0.0, 2.0);
        assert!((mean - 2.0 * (2.0 / std::f64::consts::PI).sqrt()).abs() < 1e-12, "{mean}");
        assert!((variance - 4.0 * (1.0 - 2.0 / std::f64::consts::PI)).abs() < 1e-12, "{variance}");
        assert!(slope.abs() < 1e-12 && (spread - 1.0).abs() < 1e-12, "{slope}, {spread}");
        let [mean, variance, slope, spread] = moments(&[], |x| [x * x * x, 3.0 * x * x], 0.0, 1.0);
        assert!(mean.abs() < 1e-11 && (variance - 15.0).abs() < 1e-10, "{mean}, {variance}");
        assert!((slope - 3.0).abs() < 1e-11 && (spread - 18.0).abs() < 1e-10, "{slope}, {spread}");
        assert_eq!(moments(&[], |x| [x * x, 2.0 * x], 0.5, 0.0), [0.25, 0.0, 1.0, 0.0]);
    }

    /// The variance of a narrow distribution is that of the tangent.
    #[test]
    fn narrow_distributions_keep_their_digits() {
        let [_, variance, _, spread] = moments(&[], |x| [x.sin(), x.cos()], 0.7, 1e-6);
        assert!((variance / (1e-6 * 0.7f64.cos()).powi(2) - 1.0).abs() < 1e-9, "{variance}");
        assert!((spread / (1e-6 * 0.7f64.sin()).powi(2) - 1.0).abs() < 1e-9, "{spread}");
    }

    /// The rule of Gauss and Legendre agrees, in many panels on both sides of a bend.
    #[test]
    fn both_rules_agree() {
        let curve = |x: f64| [(x - 0.3).abs() * x.cos(), (x - 0.3).signum() * x.cos() - (x - 0.3).abs() * x.sin()];
        for (mean, deviation) in [(0.2, 0.05), (-1.0, 0.7), (0.31, 3.0)] {
            let found = moments(&[0.3], curve, mean, deviation);
            let sum = |results: &dyn Fn(f64) -> [f64; 2]| {
                let weighted = |x: f64| results(x).map(|result| result * density((x - mean) / deviation) / deviation);
                let [low, high] = [mean - 12.0 * deviation, mean + 12.0 * deviation];
                let below: [f64; 2] = integrate(low, high.min(0.3), 0.2 * deviation, weighted);
                let above: [f64; 2] = integrate(low.max(0.3), high, 0.2 * deviation, weighted);
                [below[0] + above[0], below[1] + above[1]]
            };
            let means = sum(&curve);
            let variances = sum(&|x| [0, 1].map(|of| (curve(x)[of] - means[of]).powi(2)));
            let expected = [means[0], variances[0], means[1], variances[1]];
            for (found, expected) in found.iter().zip(expected) {
                assert!((found - expected).abs() < 1e-11, "{mean}, {deviation}: {found} {expected}");
            }
        }
    }

    /// A slope with a root at the end, as that of |x|^1.3.
    #[test]
    fn roots_at_ends_are_integrated() {
        let curve = |x: f64| [x.abs().powf(1.3), 1.3 * x.signum() * x.abs().powf(0.3)];
        let [_, _, mean, spread] = moments(&[0.0], curve, 0.0, 1.0);
        // E|x|^0.6 = 2^0.3 Γ(0.8)/√π, with Γ(0.8) of Abramowitz and Stegun 1964, table 6.1.
        let expected = 1.69 * 2f64.powf(0.3) * 1.164_229_713_7 / std::f64::consts::PI.sqrt();
        assert!(mean.abs() < 1e-12 && (spread - expected).abs() < 1e-9, "{mean}, {spread}, {expected}");
    }
}
