//! Sums of octaves: moments added one by one.

use prefilter::reference::footprint::{covariance, deviations};

use super::Row;

pub(super) fn rows() -> Vec<Row> {
    vec![
        Row::new("fractal_deviations", |x| deviations(covariance([x[0], x[1]], [x[2], x[3]], [1.0, 0.0, 1.0]))),
        Row::new("fractal_add", |x| {
            let [mean, rest, across, along, amplitude, multiplier, coupling, left] = std::array::from_fn(|at| x[at]);
            let octave = [multiplier * x[8], amplitude * left, coupling * x[9], coupling * x[10]];
            std::array::from_fn::<f64, 4, _>(|at| [mean, rest, across, along][at] + amplitude * octave[at])
        }),
        Row::new("fractal_statistics", |x| {
            let [mean, rest, across, along, center, scale, variance] = std::array::from_fn(|at| x[at]);
            // The mean square of the scaled sum: of what no gradient tells of, and along both vectors.
            let squares = [(scale * rest.max(0.0).sqrt() * variance.max(0.0).sqrt()), scale * across, scale * along];
            [center + scale * mean, squares.iter().map(|part| part * part).sum(), 0.0, 0.0]
        }),
        Row::new("fractal_stationary", |x| {
            let lost = x[0].clamp(0.0, 1.0);
            [libm::sqrt(1.0 - lost), 0.0, lost]
        }),
    ]
}
