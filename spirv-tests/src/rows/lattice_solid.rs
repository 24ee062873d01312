//! Lattices in space: places in a tile, and words.

use prefilter::reference::lattice::wrapped;
use prefilter::reference::lattice_solid::word;

use super::Row;

/// Whole numbers, as the device takes them.
pub(super) fn whole(parts: &[f64]) -> [i64; 3] {
    [0, 1, 2].map(|axis| parts[axis].floor() as i64)
}

/// The lattice point of a place: towards 0, as numbers become whole.
pub(super) fn place(parts: &[f64]) -> [i64; 3] {
    [0, 1, 2].map(|axis| parts[axis] as i64)
}

pub(super) fn rows() -> Vec<Row> {
    vec![
        Row::new("lattice_solid_wrapped", |x| wrapped(whole(x), whole(&x[3..])).map(|part| part as f64)),
        Row::new("lattice_solid_word", |x| [f64::from(word(place(x), x[3] as u32))]),
    ]
}
