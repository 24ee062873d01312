//! Perlin's noise in space: sums over lattice points, gradients by differences.

use prefilter::reference::lattice::gradient;
use prefilter::reference::perlin_solid::{noise, slope};
use prefilter::reference::retained::Noise;

use super::lattice::{lost, ordered};
use super::lattice_solid::{place, whole};
use super::Row;

pub(super) fn rows() -> Vec<Row> {
    vec![
        Row::new("perlin_solid_slope", |x| slope(place(x), x[3] as u32)),
        Row::new("perlin_solid_noise", |x| {
            let (position, period, seed) = ([x[0], x[1], x[2]], whole(&x[3..]), x[6] as u32);
            let [x, y, z] = gradient(position, |at| noise(at, period, seed));
            [noise(position, period, seed), x, y, z]
        }),
        Row::new("perlin_solid_lost", |x| [lost(Noise::PerlinSolid, x)]),
        Row::new("perlin_solid_filter", |x| Noise::PerlinSolid.filter([x[0], x[1]])).only_where(ordered),
    ]
}
