//! Noises of the plane with their second derivatives, by their definitions: within a cell, and within reach of a
//! lattice point, they are polynomials.

use super::lattice::{around, wrapped};
use super::{perlin, simplex, value};

/// Weights of symmetric differences of eighth order, at one to four steps: first derivatives.
const FIRST: [f64; 4] = [4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0];

/// And second ones, behind the weight of the middle.
const SECOND: [f64; 5] = [-205.0 / 72.0, 8.0 / 5.0, -1.0 / 5.0, 8.0 / 315.0, -1.0 / 560.0];

const STEP: f64 = 0.02;

/// The first derivative of a polynomial of degree up to 8.
fn first(polynomial: impl Fn(f64) -> f64) -> f64 {
    let pair = |(step, weight): (f64, f64)| weight * (polynomial(step * STEP) - polynomial(-step * STEP)) / STEP;
    (1..).map(f64::from).zip(FIRST).map(pair).sum()
}

/// The second derivative of a polynomial of degree up to 9.
pub(super) fn second(polynomial: impl Fn(f64) -> f64) -> f64 {
    let middle = SECOND[0] * polynomial(0.0);
    let pair = |(step, weight): (f64, &f64)| weight * (polynomial(step * STEP) + polynomial(-step * STEP));
    (middle + (1..).map(f64::from).zip(&SECOND[1..]).map(pair).sum::<f64>()) / (STEP * STEP)
}

/// A polynomial at a place, its gradient, and its second derivatives xx, xy, yy.
fn derivatives([x, y]: [f64; 2], polynomial: impl Fn([f64; 2]) -> f64) -> [f64; 6] {
    [
        polynomial([x, y]),
        first(|step| polynomial([x + step, y])),
        first(|step| polynomial([x, y + step])),
        second(|step| polynomial([x + step, y])),
        first(|up| first(|step| polynomial([x + step, y + up]))),
        second(|step| polynomial([x, y + step])),
    ]
}

/// The sum over the corners of a position's cell of something of a corner and of a place, each times its weight.
fn cell(position: [f64; 2], part: impl Fn([i64; 2], [f64; 2]) -> f64) -> [f64; 6] {
    derivatives(position, |at| {
        let weighted = |place: [i64; 2]| {
            let weight = |axis: usize| {
                let apart = at[axis] - place[axis] as f64;
                // Of the cell's own side, and beyond it as the polynomial goes on.
                let t = if position[axis] < place[axis] as f64 { -apart } else { apart };
                1.0 - t.powi(3) * (10.0 - 15.0 * t + 6.0 * t * t)
            };
            weight(0) * weight(1) * part(place, at)
        };
        around(position).into_iter().map(weighted).sum()
    })
}

/// Perlin's noise.
pub fn perlin(position: [f64; 2], period: [i64; 2], seed: u32) -> [f64; 6] {
    cell(position, |place, at| {
        let slope = perlin::slope(wrapped(place, period), seed);
        slope[0] * (at[0] - place[0] as f64) + slope[1] * (at[1] - place[1] as f64)
    })
}

/// Value noise.
pub fn value(position: [f64; 2], period: [i64; 2], seed: u32) -> [f64; 6] {
    cell(position, |place, _| value::value(wrapped(place, period), seed))
}

/// The part of a lattice point in simplex noise at a distance from it.
pub fn simplex_part(away: [f64; 2], slope: [f64; 2]) -> [f64; 6] {
    let rest = |[x, y]: [f64; 2]| 0.5 - x * x - y * y;
    if rest(away) <= 0.0 {
        return [0.0; 6];
    }
    derivatives(away, |at| 70.0 * rest(at).powi(4) * (slope[0] * at[0] + slope[1] * at[1]))
}

/// Simplex noise: the sum over all lattice points near a position.
pub fn simplex(position: [f64; 2], seed: u32) -> [f64; 6] {
    let mut sum = [0.0; 6];
    for (place, away) in simplex::around(position) {
        let part = simplex_part(away, perlin::slope(place, seed));
        sum.iter_mut().zip(part).for_each(|(sum, part)| *sum += part);
    }
    sum
}
