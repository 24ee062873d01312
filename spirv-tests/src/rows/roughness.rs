//! Roughness: mean squares of slopes by quadrature.

use prefilter::reference::roughness::{along, round};

use super::Row;

pub(super) fn rows() -> Vec<Row> {
    vec![
        Row::new("roughness_round", |x| [round(x[0], [x[1], x[2], x[3]])]),
        Row::new("roughness_axes", |x| [along(x[0], x[1]), along(x[0], x[2])]),
    ]
}
