//! Visible heights: moments, probabilities and means by quadrature of the density.

use prefilter::reference::heights::{cumulative, mean, moments, sum_moments};
use prefilter::reference::normal::cumulative as normal_cumulative;

use super::Row;

pub(super) fn rows() -> Vec<Row> {
    let three = |x: &[f64]| {
        let [mean, deviation, skewness, _] = moments(x[0]);
        [mean, deviation, skewness]
    };
    let two = |x: &[f64]| {
        let [mean, deviation, ..] = moments(x[0]);
        [mean, deviation]
    };
    let nothing_hidden = [-8.0, -1.0, 0.0, 0.7, 3.0, 8.0].map(|height| [height, 0.0]);
    vec![
        Row::new("heights_moments", three).at([[0.0], [1.0], [1e4]]),
        Row::new("heights_moments_fast", three).at([[0.0], [1.0], [1e4]]),
        Row::new("heights_moments_paper", two).at([[0.0], [0.56], [42.5]]),
        Row::new("heights_cdf", |x| [cumulative(x[0], x[1])]).at(nothing_hidden),
        Row::new("heights_power", |x| mean(x[1], |height| [normal_cumulative(height).powf(x[0])])),
        Row::new("heights_perturbed", |x| {
            // The heights' mean and deviation scale their standard moments.
            let &[own, share, skewness, mean, deviation, noise_mean, noise_deviation] = x else { return [f64::NAN; 3] };
            sum_moments([mean + deviation * own, deviation * share, skewness], [noise_mean, noise_deviation])
        }),
    ]
}
