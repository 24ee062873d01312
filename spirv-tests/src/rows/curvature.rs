//! Curvature: slopes at four points of the pixel.

use prefilter::reference::curvature::covariance;

use super::Row;

fn slopes(x: &[f64], pixel: [f64; 3]) -> [f64; 3] {
    let vector = |at: usize| [x[at], x[at + 1], x[at + 2]];
    covariance([vector(0), vector(3)], [vector(6), vector(9)], pixel)
}

pub(super) fn rows() -> Vec<Row> {
    vec![
        Row::new("curvature_covariance", |x| slopes(x, [x[12], x[13], x[14]])),
        Row::new("curvature_covariance_round", |x| slopes(x, [x[12] * x[12], 0.0, x[12] * x[12]])),
    ]
}
