//! Hashes, bit for bit.

use prefilter::reference::hash::{pair, triple};

use super::Row;

pub(super) fn rows() -> Vec<Row> {
    vec![
        Row::new("hash_pair", |x| pair([x[0] as u32, x[1] as u32]).map(f64::from)),
        Row::new("hash_triple", |x| triple([x[0] as u32, x[1] as u32, x[2] as u32]).map(f64::from)),
    ]
}
