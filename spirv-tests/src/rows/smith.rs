//! Smith's Λ: the integral over slopes, and directions by their angles.

use prefilter::reference::footprint::variance_along;
use prefilter::reference::smith::{lambda, Along};

use super::Row;

/// The visibility parameter in the range that the shelf keeps.
fn parameter(direction: &[f64], covariance: [f64; 3], mean_slope: [f64; 2]) -> [f64; 1] {
    let &[x, y, z] = direction else { return [f64::NAN] };
    [Along::new([x, y, z], covariance, mean_slope).parameter().clamp(0.0, 10.0)]
}

pub(super) fn rows() -> Vec<Row> {
    vec![
        // cot θ is the rise over a way of 1.
        Row::new("smith_ratio", |x| {
            [Along { cotangent: x[0], mean: 0.0, deviation: x[1].sqrt() }.parameter().clamp(0.0, 10.0)]
        })
        .at([[0.5, 0.001_25]]),
        Row::new("smith_parameter", |x| parameter(&x[..3], [x[3], x[4], x[5]], [x[6], x[7]])).at([
            [0.6, 0.0, 0.8, 1.0, 0.0, 1.0, 0.0, 0.0],
            [0.6, 0.0, 0.8, 1.0, 0.0, 1.0, 1.0, -1.0],
            [0.0, -0.28, 0.96, 0.01, 0.005, 0.01, -1.0, 1.0],
        ]),
        Row::new("smith_parameter_level", |x| parameter(&x[..3], [x[3], x[4], x[5]], [0.0; 2])).at([
            [0.6, 0.0, 0.8, 1.0, 0.0, 1.0],
            [0.8, 0.6, 1e-6, 1.0, -0.4, 0.25],
            [0.0, 0.0, 1.0, 1.0, -0.4, 0.25],
        ]),
        Row::new("smith_parameter_round", |x| parameter(&x[..3], [x[3] * x[3], 0.0, x[3] * x[3]], [0.0; 2])).at([
            [0.6, 0.0, 0.8, 0.5],
            [0.8, 0.6, 1e-6, 0.5],
            [0.0, 0.0, -1.0, 0.5],
        ]),
        Row::new("smith_variance", |x| [variance_along([x[2], x[3], x[4]], [x[0], x[1]])]),
        Row::new("smith_lambda", |x| [lambda(x[0])]).at([[0.01], [1.0], [2.2], [4.0]]),
        Row::new("smith_lambda_fast", |x| [lambda(x[0])]).at([[0.01], [1.0], [2.2], [4.0]]),
    ]
}
