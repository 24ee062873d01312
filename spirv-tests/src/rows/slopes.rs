//! Visible slopes: moments by quadrature over the weighted density, the factor by turning the principal axes, and what
//! follows from a factor by enumeration of variables with few values.

use prefilter::reference::heights::sum_moments;
use prefilter::reference::slopes::standard::{moments, nearest_pair, weight};
use prefilter::reference::slopes::Visible;

use super::Row;

/// A view of slopes that vary along the first vector of a factor alone: the numbers are view, mean slope and factor.
fn seen(x: &[f64]) -> Visible {
    let &[vx, vy, vz, sx, sy, ex, ey, ..] = x else {
        return Visible { view: [f64::NAN; 3], covariance: [f64::NAN; 3], mean: [f64::NAN; 2] };
    };
    Visible { view: [vx, vy, vz], covariance: [ex * ex, ex * ey, ey * ey], mean: [sx, sy] }
}

/// The first vector of the factor points against the view, with some reach.
fn against(x: &[f64]) -> bool {
    x[0] * x[5] + x[1] * x[6] <= -0.1
}

/// The view's azimuth is that of an f32 square, or there is none.
fn has_azimuth(x: &[f64]) -> bool {
    let away = x[0].hypot(x[1]);
    away == 0.0 || away > 2e-18
}

/// The moments of s̄ + e u + f w along two vectors, u having two values that give its mean and variance, w being ±1.
fn enumerated(along: [f64; 2], [ex, ey, fx, fy]: [f64; 4], [mean, variance]: [f64; 2]) -> [f64; 2] {
    let [e, f] = [along[0] * ex + along[1] * ey, along[0] * fx + along[1] * fy];
    let [mean, deviation, _] = sum_moments([mean * e, variance.max(0.0).sqrt() * e.abs(), 0.0], [0.0, f.abs()]);
    [mean, deviation]
}

pub(super) fn rows() -> Vec<Row> {
    let axes = [[1.0, 0.0], [0.0, 1.0], [1.0, 1.0]];
    vec![
        Row::new("slopes_factor", |x| {
            Visible { view: [x[0], x[1], x[2]], covariance: [x[3], x[4], x[5]], mean: [0.0; 2] }.factor()
        })
        .at([
            [0.0, 0.0, 1.0, 1.0, -0.4, 0.25],
            [0.0, 1.0, 0.0, 1.0, 0.4, 0.25],
            [-1.0, 0.0, 0.0, 0.01, 0.0, 4.0],
            [1e-9, -2e-9, 1.0, 1.0, -0.4, 0.25],
        ])
        .only_where(has_azimuth),
        Row::new("slopes_parameter", |x| [seen(x).parameter().max(-12.0)]).only_where(against),
        Row::new("slopes_tail", |x| {
            let [mean, variance, _] = moments(-x[0]);
            [mean, variance, weight(-x[0])]
        }),
        Row::new("slopes_moments", |x| {
            let [mean, variance, _] = moments(x[0]);
            [mean, variance]
        })
        .at([[0.0], [1.0], [-1.0], [8.0], [-8.0], [1e3], [1e6]]),
        Row::new("slopes_skewness", |x| [moments(x[0])[2]]).at([[0.0], [1.0], [-1.0], [8.0], [-8.0], [40.0], [1e3]]),
        Row::new("slopes_area", |x| {
            let visible = seen(x);
            [visible.reach() * weight(visible.parameter())]
        })
        .only_where(against),
        Row::new("slopes_pair", |x| nearest_pair(x[0])).at([[0.0], [1.0], [-1.0]]),
        Row::new("slopes_covariance", move |x| {
            let factor = [x[0], x[1], x[2], x[3]];
            let [xx, yy, both] = axes.map(|axis| enumerated(axis, factor, [0.0, x[4]])[1].powi(2));
            [xx, 0.5 * (both - xx - yy), yy]
        }),
        Row::new("slopes_along", |x| {
            let &[dx, dy, sx, sy, ex, ey, fx, fy, mean, variance] = x else { return [f64::NAN; 2] };
            let [moved, deviation] = enumerated([dx, dy], [ex, ey, fx, fy], [mean, variance]);
            [moved + dx * sx + dy * sy, deviation]
        }),
    ]
}
