//! The mixture of smaller and rounder footprints that stands for a long one.

use super::footprint::{axes, deviations};

/// Places, in deviations of a Gaussian, evenly spaced between −2 and 2 as centers of as many equal parts.
fn place(tap: f64, count: f64) -> f64 {
    let part = 4.0 / count;
    -2.0 + (tap + 0.5) * part
}

/// Weighted mean of a function of the places and the rows, +1 and −1 in turn.
fn mean(count: usize, function: impl Fn(f64, f64) -> f64) -> f64 {
    let (mut sum, mut total) = (0.0, 0.0);
    for tap in 0..count {
        let at = place(tap as f64, count as f64);
        let weight = libm::exp(-0.5 * at * at);
        sum += weight * function(at, if tap.is_multiple_of(2) { 1.0 } else { -1.0 });
        total += weight;
    }
    sum / total
}

/// Place along the major axis, place along the minor axis and weight of a tap, by number.
///
/// Weights are the Gaussian's densities at the places, scaled to the sum 1. Both places are scaled to unit deviation;
/// what the rows have in common with the places is taken out of them. One place has no deviation and is 0; two taps,
/// and odd numbers of taps, stand in one row.
pub fn placed(tap: usize, count: usize) -> [f64; 3] {
    let at = place(tap as f64, count as f64);
    let own = if tap.is_multiple_of(2) { 1.0 } else { -1.0 };
    let variance = mean(count, |at, _| at * at);
    let along = if count > 1 { at / variance.sqrt() } else { 0.0 };
    let slope = mean(count, |at, row| at * row) / variance;
    let rest = mean(count, |at, row| (row - slope * at) * (row - slope * at));
    let across = if count > 2 && count.is_multiple_of(2) { (own - slope * at) / rest.sqrt() } else { 0.0 };
    let sum = count as f64 * mean(count, |at, _| libm::exp(0.5 * at * at)).recip();
    [along, across, libm::exp(-0.5 * at * at) / sum]
}

/// One component of a mixture: offset from the center, weight, covariance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tap {
    /// From the center of the footprint.
    pub offset: [f64; 2],
    /// Weights sum to one.
    pub weight: f64,
    /// xx, xy, yy.
    pub covariance: [f64; 3],
}

/// The taps of a footprint. Each has 1.2/count of the major deviation, at least a share of the minor one (0.9 for four
/// taps, 0.75 for six and eight, else all) and at most the major one; across, at most the minor one.
pub fn taps(covariance: [f64; 3], count: usize) -> Vec<Tap> {
    let [major, minor] = deviations(covariance);
    let [long, short] = axes(covariance);
    let share = match count {
        4 => 0.9,
        6 | 8 => 0.75,
        _ => 1.0,
    };
    let along = (1.2 / count as f64 * major).max(share * minor).min(major);
    let across = along.min(minor);
    let spread = [(major, along), (minor, across)].map(|(all, own)| (all * all - own * own).max(0.0).sqrt());
    let entry = |i: usize, j: usize| along * along * long[i] * long[j] + across * across * short[i] * short[j];
    let tap = |number: usize| {
        let [x, y, weight] = placed(number, count);
        let offset = [0, 1].map(|side| long[side] * x * spread[0] + short[side] * y * spread[1]);
        Tap { offset, weight, covariance: [entry(0, 0), entry(0, 1), entry(1, 1)] }
    };
    (0..count).map(tap).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_mixture_has_the_covariance_of_the_footprint() {
        for count in 1..=8 {
            for covariance in [[4.0, 1.5, 1.0], [0.3, -0.1, 0.28], [1e4, 90.0, 1.0], [2.0, 0.0, 2.0]] {
                let taps = taps(covariance, count);
                let sum = |of: &dyn Fn(&Tap) -> f64| taps.iter().map(|tap| tap.weight * of(tap)).sum::<f64>();
                assert!((sum(&|_| 1.0) - 1.0).abs() < 1e-12);
                for side in 0..2 {
                    assert!(sum(&|tap| tap.offset[side]).abs() < 1e-12 * covariance[0], "{count} {covariance:?}");
                }
                for (entry, (i, j)) in [(0, 0), (0, 1), (1, 1)].into_iter().enumerate() {
                    let found = sum(&|tap| tap.covariance[entry] + tap.offset[i] * tap.offset[j]);
                    let expected = covariance[entry];
                    assert!((found - expected).abs() < 1e-12 * covariance[0], "{count}: {found} of {expected}");
                }
            }
        }
    }
}
