//! Simplex noise: sums over lattice points, gradients by differences.

use prefilter::reference::lattice::gradient;
use prefilter::reference::leveled::leveled;
use prefilter::reference::retained::Noise;
use prefilter::reference::simplex::{noise, part};

use super::lattice::{lost, ordered};
use super::Row;

pub(super) fn rows() -> Vec<Row> {
    vec![
        Row::new("simplex_part", |x| {
            let (away, slope) = ([x[0], x[1]], [x[2], x[3]]);
            let [along, across] = gradient(away, |away| part(away, slope));
            [part(away, slope), along, across]
        }),
        Row::new("simplex_noise", |x| {
            let (position, seed) = ([x[0], x[1]], x[2] as u32);
            let [along, across] = gradient(position, |at| noise(at, seed));
            [noise(position, seed), along, across]
        }),
        Row::new("simplex_lost", |x| [lost(Noise::Simplex, x)]),
        Row::new("simplex_filter", |x| Noise::Simplex.filter([x[0], x[1]])).only_where(ordered),
        Row::new("simplex_leveled", |x| leveled(Noise::Simplex, [x[0], x[1]])),
    ]
}
