//! Perlin's gradient noise, by its definition: a sum over lattice points.

use std::f64::consts::TAU;

use super::lattice::{around, weight, word, wrapped};

/// The slope of a lattice point's line.
pub fn slope(place: [i64; 2], seed: u32) -> [f64; 2] {
    let (sin, cos) = libm::sincos(f64::from(word(place, seed) >> 28) * TAU / 16.0);
    [cos, sin]
}

/// The noise: the sum over the four lattice points about a position of their lines, each times its weight.
pub fn noise(position: [f64; 2], period: [i64; 2], seed: u32) -> f64 {
    let part = |place: [i64; 2]| {
        let apart = [0, 1].map(|axis| position[axis] - place[axis] as f64);
        let slope = slope(wrapped(place, period), seed);
        weight(apart[0]) * weight(apart[1]) * (slope[0] * apart[0] + slope[1] * apart[1])
    };
    around(position).into_iter().map(part).sum()
}
