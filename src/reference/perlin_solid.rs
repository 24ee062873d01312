//! Perlin's gradient noise in space, by its definition: a sum over lattice points.

use super::lattice::{weight, wrapped};
use super::lattice_solid::{around, word};

/// The directions to the middles of a cube's edges: those in the plane of x and y, of x and z, of y and z.
const EDGES: [[f64; 3]; 12] = [
    [1.0, 1.0, 0.0],
    [-1.0, 1.0, 0.0],
    [1.0, -1.0, 0.0],
    [-1.0, -1.0, 0.0],
    [1.0, 0.0, 1.0],
    [-1.0, 0.0, 1.0],
    [1.0, 0.0, -1.0],
    [-1.0, 0.0, -1.0],
    [0.0, 1.0, 1.0],
    [0.0, -1.0, 1.0],
    [0.0, 1.0, -1.0],
    [0.0, -1.0, -1.0],
];

/// The slope of a lattice point's line: the upper half of its word divides evenly by twelve.
pub fn slope(place: [i64; 3], seed: u32) -> [f64; 3] {
    let part = f64::from(word(place, seed) / 65536) / 65536.0;
    EDGES[(12.0 * part).floor() as usize]
}

/// The noise: the sum over the eight lattice points about a position of their lines, each times its weight.
pub fn noise(position: [f64; 3], period: [i64; 3], seed: u32) -> f64 {
    let part = |place: [i64; 3]| {
        let apart: [f64; 3] = std::array::from_fn(|axis| position[axis] - place[axis] as f64);
        let slope = slope(wrapped(place, period), seed);
        let line: f64 = (0..3).map(|axis| slope[axis] * apart[axis]).sum();
        apart.into_iter().map(weight).product::<f64>() * line
    };
    around(position).into_iter().map(part).sum()
}
