//! Displaced footprints: the factor of the covariance multiplied out.

use prefilter::reference::warp::{covariance, factor};

use super::Row;

/// Whether the covariance is not so singular that f32 has lost its factor.
fn regular(x: &[f64]) -> bool {
    let [xx, xy, yy] = of(x);
    xx > 1e-3 && xx * yy - xy * xy > 1e-4 * xx * yy
}

fn of(x: &[f64]) -> [f64; 3] {
    covariance([[x[0], x[1]], [x[2], x[3]]], [[x[4], x[5]], [x[6], x[7]]], x[8])
}

pub(super) fn rows() -> Vec<Row> {
    vec![Row::new("warp_vectors", |x| factor(of(x))).only_where(regular)]
}
