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
        Row::new("fractal_tilt", |x| {
            let [amplitude, multiplier, coupling, left] = std::array::from_fn(|at| x[8 + at]);
            let ([leveled, noise], [right, up]) = ([[x[12], x[13]], [x[15], x[16]]], [x[17], x[18]]);
            // Along the axis and across it, a quarter turn on.
            let ways = [[right, up], [-up, right]];
            let slopes = ways.map(|way| amplitude * (way[0] * noise[0] + way[1] * noise[1]));
            let kept = leveled.map(|leveled| 1.0 - leveled);
            let [u, v] = [0, 1].map(|at| {
                let square = (amplitude * right).powi(2) + (amplitude * up).powi(2);
                [coupling * slopes[at], kept[at] * slopes[at], square * (1.0 - kept[at] * kept[at])]
            });
            let octave =
                [amplitude * multiplier * x[14], amplitude * amplitude * left, u[0], v[0], u[1], v[1], u[2], v[2]];
            std::array::from_fn::<f64, 8, _>(|at| x[at] + octave[at])
        }),
        Row::new("fractal_slopes", |x| {
            let [mean, rest, coupled_u, coupled_v, slope_u, slope_v, lost_u, lost_v] = std::array::from_fn(|at| x[at]);
            let [right, up, ax, ay, bx, by, center, scale, variance, steepness] = std::array::from_fn(|at| x[8 + at]);
            let turned = |u: f64, v: f64| [u * right - v * up, u * up + v * right];
            let ([x, y], [sx, sy]) = (turned(coupled_u, coupled_v), turned(slope_u, slope_v));
            let rises = [ax * x + ay * y, bx * x + by * y].map(|rise| scale * rise);
            let heights = scale * scale * (variance * rest).max(0.0) + rises[0] * rises[0] + rises[1] * rises[1];
            // Of the two axes, each as long as its deviation.
            let deviations = [lost_u, lost_v].map(|lost| scale * libm::sqrt((variance * steepness * lost).max(0.0)));
            let slopes = covariance(turned(deviations[0], 0.0), turned(0.0, deviations[1]), [1.0, 0.0, 1.0]);
            [center + scale * mean, heights, 0.0, 0.0, scale * sx, scale * sy, slopes[0], slopes[1], slopes[2]]
        }),
        Row::new("fractal_stationary", |x| {
            let lost = x[0].clamp(0.0, 1.0);
            [libm::sqrt(1.0 - lost), 0.0, lost]
        }),
    ]
}
