//! The standard normal distribution.

use prefilter::reference::normal::{cumulative, excess, surprisal};

use super::Row;

pub(super) fn rows() -> Vec<Row> {
    let ends = [[8.0], [-8.0], [6.0], [-6.0], [0.5], [-0.5]];
    vec![
        Row::new("normal_cdf", |x| [cumulative(x[0])]).at(ends),
        Row::new("normal_cdf_fast", |x| [cumulative(x[0])]).at(ends),
        Row::new("normal_excess", |x| [excess(x[0])]).at([[8.0]]),
        Row::new("normal_excess_fast", |x| [excess(x[0])]).at([[8.0]]),
        Row::new("normal_surprisal", |x| [surprisal(x[0])]).at([[0.0], [0.5], [-0.5], [6.0]]),
    ]
}
