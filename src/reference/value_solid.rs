//! Value noise in space, by its definition: a sum over lattice points.

use super::lattice::{weight, wrapped};
use super::lattice_solid::{around, word};

/// The value of a lattice point: the center of one of 2²⁴ equal parts of [−1, 1].
pub fn value(place: [i64; 3], seed: u32) -> f64 {
    let part = f64::from(word(place, seed) / 256);
    -1.0 + (part + 0.5) * 2.0 / 16_777_216.0
}

/// The noise: the sum over the eight lattice points about a position of their values, each times its weight.
pub fn noise(position: [f64; 3], period: [i64; 3], seed: u32) -> f64 {
    let part = |place: [i64; 3]| {
        let weights = (0..3).map(|axis| weight(position[axis] - place[axis] as f64));
        weights.product::<f64>() * value(wrapped(place, period), seed)
    };
    around(position).into_iter().map(part).sum()
}
