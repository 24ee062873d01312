//! Lattices of whole numbers in the plane, by their definition.

use super::hash;

/// A lattice point's place in a tile; a period of 0 is none.
pub fn wrapped<const N: usize>(place: [i64; N], period: [i64; N]) -> [i64; N] {
    std::array::from_fn(|axis| match period[axis] {
        0 => place[axis],
        period => place[axis].rem_euclid(period),
    })
}

/// The random word of a lattice point. A seed has points of its own, far away on the same lattice.
pub fn word(place: [i64; 2], seed: u32) -> u32 {
    let starts = [0x9e37_79b9u32, 0x85eb_ca6b].map(|start| start.wrapping_mul(seed));
    let moved = [0, 1].map(|axis| (place[axis] as i32 as u32).wrapping_add(starts[axis]));
    hash::pair(moved)[1]
}

/// The weight of a lattice point at a distance along one axis, 1 − 6t⁵ + 15t⁴ − 10t³ for t up to 1.
pub fn weight(distance: f64) -> f64 {
    let t = distance.abs().min(1.0);
    1.0 - 6.0 * t.powi(5) + 15.0 * t.powi(4) - 10.0 * t.powi(3)
}

/// The four lattice points about a position.
pub fn around(position: [f64; 2]) -> [[i64; 2]; 4] {
    let corner = position.map(|part| part.floor() as i64);
    [[0, 0], [1, 0], [0, 1], [1, 1]].map(|[x, y]| [corner[0] + x, corner[1] + y])
}

/// The gradient of a function, by a symmetric difference of fourth order.
pub fn gradient<const N: usize>(position: [f64; N], function: impl Fn([f64; N]) -> f64) -> [f64; N] {
    const STEP: f64 = 2e-4;
    std::array::from_fn(|axis| {
        let at = |steps: f64| {
            let mut moved = position;
            moved[axis] += steps * STEP;
            function(moved)
        };
        (8.0 * (at(1.0) - at(-1.0)) - (at(2.0) - at(-2.0))) / (12.0 * STEP)
    })
}
