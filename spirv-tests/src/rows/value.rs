//! Value noise: sums over lattice points, gradients by differences.

use prefilter::reference::lattice::gradient;
use prefilter::reference::leveled::leveled;
use prefilter::reference::retained::Noise;
use prefilter::reference::value::{noise, value};

use super::lattice::{lost, ordered, place, whole};
use super::Row;

pub(super) fn rows() -> Vec<Row> {
    vec![
        Row::new("value_point", |x| [value(place(x), x[2] as u32)]),
        Row::new("value_noise", |x| {
            let (position, period, seed) = ([x[0], x[1]], whole(&x[2..]), x[4] as u32);
            let [along, across] = gradient(position, |at| noise(at, period, seed));
            [noise(position, period, seed), along, across]
        }),
        Row::new("value_lost", |x| [lost(Noise::Value, x)]),
        Row::new("value_filter", |x| Noise::Value.filter([x[0], x[1]])).only_where(ordered),
        Row::new("value_leveled", |x| leveled(Noise::Value, [x[0], x[1]])),
    ]
}
