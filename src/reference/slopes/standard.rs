//! Visible slopes along the view in standard form: u with the density q(u) ∝ (u + a)⁺ φ(u), which has one parameter a.
//! Across the view slopes stay normal.

use super::tail;
use crate::reference::normal::{cumulative as normal_cumulative, density as normal_density};
use crate::reference::quadrature::integrate;

/// Means of functions of u under q.
fn average<const N: usize>(parameter: f64, function: impl Fn(f64) -> [f64; N]) -> [f64; N] {
    let from = -parameter;
    let offset = 0.5 * from.max(0.0).powi(2);
    let [whole] = tail(from, offset, |u| [u - from]);
    tail(from, offset, |u| function(u).map(|value| (u - from) * value)).map(|sum| sum / whole)
}

/// Mean, variance and skewness of u.
pub fn moments(parameter: f64) -> [f64; 3] {
    let [mean] = average(parameter, |u| [u]);
    let [second, third] = average(parameter, |u| [(u - mean).powi(2), (u - mean).powi(3)]);
    [mean, second, third / second.powf(1.5)]
}

/// Kurtosis of u: 3 of a normal variable.
pub fn kurtosis(parameter: f64) -> f64 {
    let [mean] = average(parameter, |u| [u]);
    let [second, fourth] = average(parameter, |u| [(u - mean).powi(2), (u - mean).powi(4)]);
    fourth / (second * second)
}

/// The mean E[(u + a)⁺] of the weight over a standard normal u.
pub fn weight(parameter: f64) -> f64 {
    let from = -parameter;
    let offset = 0.5 * from.max(0.0).powi(2);
    let [whole] = tail(from, offset, |u| [u - from]);
    whole * (-offset).exp() / std::f64::consts::TAU.sqrt()
}

/// The probability that u is below each of some rising edges.
pub fn cumulative(parameter: f64, edges: &[f64]) -> Vec<f64> {
    let lowest = (-parameter).max(-10.0);
    let offset = 0.5 * lowest.max(0.0).powi(2);
    let [whole] = tail(-parameter, offset, |u| [u + parameter]);
    let (mut sum, mut from) = (0.0, lowest);
    let next = edges.iter().map(|&edge| {
        let to = edge.max(from);
        let [part] = integrate(from, to, 1.0, |u| [(u + parameter) * (offset - 0.5 * u * u).exp()]);
        sum += part;
        from = to;
        sum / whole
    });
    next.collect()
}

/// The probability below z of two normal distributions with equal shares that have the mean 0 and the variance 1
/// together, and its derivatives by d and e: their means are d/2 down and up, their variances (1 − d²/4)(1 ∓ e).
fn pair(z: f64, d: f64, e: f64) -> [f64; 3] {
    let rest = 1.0 - 0.25 * d * d;
    let side = |sign: f64| {
        let (variance, by_d) = (rest * (1.0 + sign * e), -0.5 * d * (1.0 + sign * e));
        let deviation = variance.sqrt();
        let at = (z - 0.5 * sign * d) / deviation;
        let slope = 0.5 * normal_density(at) / deviation;
        let by_variance = -0.5 * slope * at / deviation;
        [0.5 * normal_cumulative(at), -0.5 * sign * slope + by_variance * by_d, by_variance * sign * rest]
    };
    let (low, high) = (side(-1.0), side(1.0));
    std::array::from_fn(|index| low[index] + high[index])
}

/// The change of d and e that makes the errors of three points equal in size and as small as can be, and that size.
///
/// The errors change by their gradients. The weights that make the gradients cancel give the size and the signs.
fn level(points: [&[f64; 3]; 3]) -> Option<(f64, [f64; 2])> {
    let cross = |a: &[f64; 3], b: &[f64; 3]| a[1] * b[2] - a[2] * b[1];
    let [a, b, c] = points;
    let weights = [cross(b, c), cross(c, a), cross(a, b)];
    let total: f64 = weights.iter().map(|weight| weight.abs()).sum();
    let size = (weights[0] * a[0] + weights[1] * b[0] + weights[2] * c[0]) / total;
    // The two points whose gradients differ most fix the change.
    let most = (0..3).max_by(|&i, &j| weights[i].abs().total_cmp(&weights[j].abs()))?;
    let (i, j) = ((most + 1) % 3, (most + 2) % 3);
    let off = |index: usize| size * weights[index].signum() - points[index][0];
    let change = [0, 1].map(|k| {
        let (one, other) = (points[i][2 - k], points[j][2 - k]);
        let sign = if k == 0 { 1.0 } else { -1.0 };
        sign * (off(i) * other - off(j) * one) / weights[most]
    });
    (total > 0.0 && change.iter().all(|change| change.is_finite())).then_some((size.abs(), change))
}

/// The change of d and e that lowers the largest error most, as far as errors change by their gradients.
///
/// The largest error of a linear problem in two unknowns is the largest of those of any three points.
fn change(errors: &[[f64; 3]]) -> Option<[f64; 2]> {
    let peak = |trio: &&[[f64; 3]]| trio[1][0].abs() >= trio[0][0].abs() && trio[1][0].abs() >= trio[2][0].abs();
    let peaks: Vec<&[f64; 3]> = errors.windows(3).filter(peak).map(|trio| &trio[1]).collect();
    let mut best: Option<(f64, [f64; 2])> = None;
    for (i, a) in peaks.iter().enumerate() {
        for (j, b) in peaks.iter().enumerate().skip(i + 1) {
            let found = peaks.iter().skip(j + 1).filter_map(|c| level([a, b, c]));
            best = found.chain(best).max_by(|one, other| one.0.total_cmp(&other.0));
        }
    }
    best.map(|(_, change)| change)
}

/// The two normal distributions with equal shares that have the mean and variance of u together and whose cumulative
/// function is nearest to that of u, by the largest difference: mean and variance of the lower one, then of the higher.
pub fn nearest_pair(parameter: f64) -> [f64; 4] {
    let [mean, variance, _] = moments(parameter);
    let deviation = variance.sqrt();
    let places: Vec<f64> = (-40..=60).map(|index| 0.08 * f64::from(index)).collect();
    let edges: Vec<f64> = places.iter().map(|z| mean + deviation * z).collect();
    let truth = cumulative(parameter, &edges);
    let errors = |[d, e]: [f64; 2]| -> Vec<[f64; 3]> {
        let error = |(&z, truth): (&f64, &f64)| {
            let [below, by_d, by_e] = pair(z, d, e);
            [below - truth, by_d, by_e]
        };
        places.iter().zip(&truth).map(error).collect()
    };
    let largest = |errors: &[[f64; 3]]| errors.iter().fold(0.0, |most: f64, error| most.max(error[0].abs()));
    let mut at = [1.0, 0.3];
    let mut found = errors(at);
    'search: for _ in 0..30 {
        let Some(change) = change(&found) else { break };
        for halvings in 0..5 {
            let share = 0.5f64.powi(halvings);
            let next = [(at[0] + share * change[0]).clamp(0.0, 1.9), (at[1] + share * change[1]).clamp(0.0, 0.95)];
            let there = errors(next);
            if largest(&there) < largest(&found) * (1.0 - 1e-5) {
                (at, found) = (next, there);
                continue 'search;
            }
        }
        break;
    }
    let ([d, e], rest) = (at, variance * (1.0 - 0.25 * at[0] * at[0]));
    [mean - 0.5 * d * deviation, rest * (1.0 - e), mean + 0.5 * d * deviation, rest * (1.0 + e)]
}
