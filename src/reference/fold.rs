//! Folded normal variables: moments of |n| by quadrature of their definition.

use super::normal::{density, REACH};
use super::quadrature::integrate;

/// Mean and variance of |n|, and the mean of its sign, for a normal n of a mean and a variance.
pub fn moments(mean: f64, variance: f64) -> [f64; 3] {
    let deviation = variance.max(0.0).sqrt();
    if deviation == 0.0 {
        return [mean.abs(), 0.0, if mean == 0.0 { 0.0 } else { mean.signum() }];
    }
    // On either side of 0, in deviations about the mean.
    let edge = (-mean / deviation).clamp(-REACH, REACH);
    let over = |from: f64, to: f64, center: f64| -> [f64; 3] {
        integrate(from, to, 1.0, |z| {
            let n = mean + deviation * z;
            [n.abs() - center, (n.abs() - center).powi(2), n.signum()].map(|part| density(z) * part)
        })
    };
    let both = |center: f64| {
        let (below, above) = (over(-REACH, edge, center), over(edge, REACH, center));
        [0, 1, 2].map(|of| below[of] + above[of])
    };
    let middle = mean.abs();
    let first = middle + both(middle)[0];
    let [_, spread, sign] = both(first);
    [first, spread, sign]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of a standard normal variable √(2/π), 1 − 2/π and 0; far from 0 nothing is folded.
    #[test]
    fn known_moments() {
        let [mean, variance, sign] = moments(0.0, 4.0);
        assert!((mean - 2.0 * (2.0 / std::f64::consts::PI).sqrt()).abs() < 1e-13);
        assert!((variance - 4.0 * (1.0 - 2.0 / std::f64::consts::PI)).abs() < 1e-13 && sign.abs() < 1e-13);
        let [mean, variance, sign] = moments(-5.0, 0.25);
        assert!((mean - 5.0).abs() < 1e-12 && (variance - 0.25).abs() < 1e-12 && (sign + 1.0).abs() < 1e-12);
        assert_eq!(moments(-0.5, 0.0), [0.5, 0.0, -1.0]);
    }
}
