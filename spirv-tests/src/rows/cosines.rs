//! Sums of cosines: single waves by quadrature over their angle, sums and squares by definition.

use prefilter::reference::cosines::{wave, Wave};
use prefilter::reference::footprint::covariance;

use super::Row;

fn one(x: &[f64]) -> [f64; 10] {
    let given = Wave { frequency: [x[6], x[7]], amplitude: x[8], phase: x[9] };
    wave(given, [x[0], x[1]], [x[2], x[3]], [x[4], x[5]])
}

/// The exponential's series to its end, or the exponential.
fn lost(exponent: f64) -> [f64; 2] {
    let rest = if exponent < 1.0 {
        let mut term = 0.5 * exponent * exponent;
        let mut sum = 0.0;
        for order in 3..30 {
            sum += term;
            term *= -exponent / f64::from(order);
        }
        sum
    } else {
        exponent + libm::expm1(-exponent)
    };
    [-libm::expm1(-exponent), rest]
}

/// Mean, variance, and no shape: the variance along the gradient is an entry of a turned covariance.
fn moments(x: &[f64]) -> [f64; 4] {
    let [along_gradient, ..] = covariance([x[2], 0.0], [x[3], 0.0], covariance([x[10], x[11]], [x[12], x[13]], ROUND));
    [x[0], x[1] + along_gradient, 0.0, 0.0]
}

const ROUND: [f64; 3] = [1.0, 0.0, 1.0];

/// Moments, mean slope, and the covariance of slopes that the second derivatives make of the footprint's.
fn surface(x: &[f64]) -> [f64; 9] {
    let footprint = covariance([x[10], x[11]], [x[12], x[13]], ROUND);
    let [xx, xy, yy] = covariance([x[4], x[5]], [x[5], x[6]], footprint);
    let [mean, variance, ..] = moments(x);
    [mean, variance, 0.0, 0.0, x[2], x[3], x[7] + xx, x[8] + xy, x[9] + yy]
}

pub(super) fn rows() -> Vec<Row> {
    vec![
        Row::new("cosines_lost", |x| lost(x[0])).at([[0.25]]),
        Row::new("cosines_wave", one),
        Row::new("cosines_with", |x| {
            let mut sums = [0.0; 10];
            sums.iter_mut().enumerate().for_each(|(at, sum)| *sum = x[at] + x[10 + at]);
            sums
        }),
        Row::new("cosines_moments", moments),
        Row::new("cosines_surface", surface),
    ]
}
