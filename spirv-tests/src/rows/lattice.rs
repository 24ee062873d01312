//! Lattices in the plane: which points stand about a position, their weights and their words.

use prefilter::reference::lattice::{weight, word, wrapped};
use prefilter::reference::retained::Noise;

use super::Row;

/// What a footprint of 1/√2 times the first two numbers takes from a noise.
pub(super) fn lost(noise: Noise, deviations: &[f64]) -> f64 {
    1.0 - noise.retained([deviations[0], deviations[1]].map(|deviation| deviation / 2f64.sqrt()))
}

/// A major deviation is not below the minor one.
pub(super) fn ordered(point: &[f64]) -> bool {
    point[0] >= point[1]
}

/// Whole numbers, as the device takes them.
pub(super) fn whole(parts: &[f64]) -> [i64; 2] {
    [parts[0].floor() as i64, parts[1].floor() as i64]
}

/// The lattice point of a place: towards 0, as numbers become whole.
pub(super) fn place(parts: &[f64]) -> [i64; 2] {
    [parts[0] as i64, parts[1] as i64]
}

pub(super) fn rows() -> Vec<Row> {
    vec![
        Row::new("lattice_corners", |x| {
            let ([i, j], period) = (whole(x), whole(&x[2..]));
            let ([left, below], [right, above]) = (wrapped([i, j], period), wrapped([i + 1, j + 1], period));
            [left, below, right, above].map(|part| part as f64)
        }),
        Row::new("lattice_fade", |x| {
            let rise = |t: f64| {
                let step = 1e-4;
                let at = |steps: f64| -weight(t + steps * step);
                (8.0 * (at(1.0) - at(-1.0)) - (at(2.0) - at(-2.0))) / (12.0 * step)
            };
            [1.0 - weight(x[0]), 1.0 - weight(x[1]), rise(x[0]), rise(x[1])]
        }),
        Row::new("lattice_fade_bend", |x| {
            // Of fourth order: exact for a polynomial of degree 5.
            const STEP: f64 = 0.05;
            let fade = |t: f64| t.powi(3) * (10.0 + t * (6.0 * t - 15.0));
            [x[0], x[1]].map(|t| {
                let pair = |steps: f64| fade(t + steps * STEP) + fade(t - steps * STEP);
                (16.0 * pair(1.0) - pair(2.0) - 30.0 * fade(t)) / (12.0 * STEP * STEP)
            })
        }),
        Row::new("lattice_word", |x| [f64::from(word(place(x), x[2] as u32))]),
    ]
}
