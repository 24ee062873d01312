//! Lattices of whole numbers in space, by their definition.

use super::hash;

/// The random word of a lattice point. A seed has points of its own, far away on the same lattice.
pub fn word(place: [i64; 3], seed: u32) -> u32 {
    let starts = [0x9e37_79b9u32, 0x85eb_ca6b, 0xc2b2_ae35].map(|start| start.wrapping_mul(seed));
    let moved = [0, 1, 2].map(|axis| (place[axis] as i32 as u32).wrapping_add(starts[axis]));
    hash::triple(moved)[2]
}

/// The eight lattice points about a position.
pub fn around(position: [f64; 3]) -> [[i64; 3]; 8] {
    let corner = position.map(|part| part.floor() as i64);
    std::array::from_fn(|number| [0, 1, 2].map(|axis| corner[axis] + (number as i64 >> axis & 1)))
}
