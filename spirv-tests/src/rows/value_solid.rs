//! Value noise in space: sums over lattice points, gradients by differences.

use prefilter::reference::lattice::gradient;
use prefilter::reference::value_solid::{noise, value};

use super::lattice_solid::{place, whole};
use super::Row;

pub(super) fn rows() -> Vec<Row> {
    vec![
        Row::new("value_solid_point", |x| [value(place(x), x[3] as u32)]),
        Row::new("value_solid_noise", |x| {
            let (position, period, seed) = ([x[0], x[1], x[2]], whole(&x[3..]), x[6] as u32);
            let [x, y, z] = gradient(position, |at| noise(at, period, seed));
            [noise(position, period, seed), x, y, z]
        }),
    ]
}
