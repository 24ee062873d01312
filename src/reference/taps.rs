//! The mixture of round footprints that stands for a long one.

use super::footprint::{axes, deviations};

/// Places, in deviations of a Gaussian, evenly spaced between −2 and 2 as centers of as many equal parts.
fn place(tap: f64, count: f64) -> f64 {
    let part = 4.0 / count;
    -2.0 + (tap + 0.5) * part
}

/// The place of a tap in units of the deviation of all of `count` places, and its weight.
///
/// Weights are the Gaussian's densities at the places, scaled to the sum 1. A single place has no deviation and is 0.
pub fn placed(tap: f64, count: usize) -> [f64; 2] {
    let density = |at: f64| libm::exp(-0.5 * at * at);
    let places: Vec<f64> = (0..count).map(|tap| place(tap as f64, count as f64)).collect();
    let sum: f64 = places.iter().map(|&at| density(at)).sum();
    let variance = places.iter().map(|&at| density(at) / sum * at * at).sum::<f64>();
    let at = place(tap, count as f64);
    let scaled = if count > 1 { at / variance.sqrt() } else { 0.0 };
    [scaled, density(at) / sum]
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

/// The taps of a footprint. Each has 1.2/count of the major deviation, at least the minor and at most the major one.
pub fn taps(covariance: [f64; 3], count: usize) -> Vec<Tap> {
    let [major, minor] = deviations(covariance);
    let [long, short] = axes(covariance);
    let own = (1.2 / count as f64 * major).clamp(minor, major.max(minor));
    let spread = (major * major - own * own).max(0.0).sqrt();
    let entry = |i: usize, j: usize| own * own * long[i] * long[j] + minor * minor * short[i] * short[j];
    let tap = |number: usize| {
        let [at, weight] = placed(number as f64, count);
        let covariance = [entry(0, 0), entry(0, 1), entry(1, 1)];
        Tap { offset: long.map(|side| side * at * spread), weight, covariance }
    };
    (0..count).map(tap).collect()
}
