//! Value noise, by its definition: a sum over lattice points.

use super::lattice::{around, weight, word, wrapped};

/// The value of a lattice point: the center of one of 2²⁴ equal parts of [−1, 1].
pub fn value(place: [i64; 2], seed: u32) -> f64 {
    let part = f64::from(word(place, seed) / 256);
    -1.0 + (part + 0.5) * 2.0 / 16_777_216.0
}

/// The noise: the sum over the four lattice points about a position of their values, each times its weight.
pub fn noise(position: [f64; 2], period: [i64; 2], seed: u32) -> f64 {
    let part = |place: [i64; 2]| {
        let [x, y] = [0, 1].map(|axis| weight(position[axis] - place[axis] as f64));
        x * y * value(wrapped(place, period), seed)
    };
    around(position).into_iter().map(part).sum()
}
