//! Hashes, bit for bit.

use prefilter::reference::hash::pair;

use super::Row;

pub(super) fn rows() -> Vec<Row> {
    vec![Row::new("hash_pair", |x| pair([x[0] as u32, x[1] as u32]).map(f64::from))]
}
