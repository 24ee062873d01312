//! Perlin's noise: sums over lattice points, gradients by differences.

use prefilter::reference::lattice::gradient;
use prefilter::reference::leveled::leveled;
use prefilter::reference::perlin::{noise, slope};
use prefilter::reference::retained::Noise;

use super::lattice::{lost, ordered, place, whole};
use super::Row;

/// A part of a direction as the table has it: in f32, and 0 where the f64 of π leaves 1e-16.
fn tabulated(part: f64) -> f64 {
    if part.abs() < 1e-9 {
        0.0
    } else {
        f64::from(part as f32)
    }
}

pub(super) fn rows() -> Vec<Row> {
    vec![
        Row::new("perlin_slope", |x| slope(place(x), x[2] as u32).map(tabulated)),
        Row::new("perlin_noise", |x| {
            let (position, period, seed) = ([x[0], x[1]], whole(&x[2..]), x[4] as u32);
            let [along, across] = gradient(position, |at| noise(at, period, seed));
            [noise(position, period, seed), along, across]
        }),
        Row::new("perlin_lost", |x| [lost(Noise::Perlin, x)]),
        Row::new("perlin_filter", |x| Noise::Perlin.filter([x[0], x[1]])).only_where(ordered),
        Row::new("perlin_leveled", |x| leveled(Noise::Perlin, [x[0], x[1]])),
    ]
}
