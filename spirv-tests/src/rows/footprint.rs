//! Footprints: the matrix product entry by entry, axes by the angle of a rotation.

use prefilter::reference::footprint::{axes, covariance, deviations};

use super::Row;

/// Whether the axes differ enough to have a direction.
fn has_direction(point: &[f64]) -> bool {
    let &[xx, xy, yy] = point else { return false };
    let [major, minor] = deviations([xx, xy, yy]);
    major > 1.1 * minor
}

/// The vector by which a round distribution is stretched, its deviation, and that as a part of the major one.
pub(super) fn stretched(covariance: [f64; 3], least: f64) -> [f64; 4] {
    let [major, minor] = deviations(covariance);
    let part = (minor / major).max(least);
    let long = major * (1.0 - part * part).sqrt();
    // Of the two directions the one whose larger component is positive.
    let [x, y] = axes(covariance)[0];
    let sign = if covariance[0] >= covariance[2] { x } else { y }.signum();
    [sign * long * x, sign * long * y, part * major, part]
}

pub(super) fn rows() -> Vec<Row> {
    vec![
        Row::new("footprint_covariance", |x| covariance([x[0], x[1]], [x[2], x[3]], [x[4], x[5], x[6]])).at([
            [1.0, 0.5, 0.25, -2.0, 1.0, 1.0, 1.0],
            [0.0, 0.0, 0.0, 0.0, 0.25, 0.0, 0.25],
            [8.0, -8.0, 3.0, 0.0, 0.25, 0.0, 0.0],
        ]),
        Row::new("footprint_covariance_round", |x| {
            covariance([x[0], x[1]], [x[2], x[3]], [x[4] * x[4], 0.0, x[4] * x[4]])
        })
        .at([[0.0, 0.0, 0.0, 0.0, 0.5], [3.0, 1.0, 6.0, 2.0, 0.5]]),
        Row::new("footprint_deviations", |x| deviations([x[0], x[1], x[2]])).at([[0.0, 0.0, 0.0], [0.25, 0.0, 0.25]]),
        Row::new("footprint_direction", |x| axes([x[0], x[1], x[2]])[0]).only_where(has_direction).up_to_sign(),
        Row::new("footprint_stretched", |x| stretched([x[0], x[1], x[2]], x[3])).at([
            [0.04, 0.0, 0.04, 0.1],
            [0.09, 0.0, 0.04, 0.1],
            [0.04, 0.01, 0.09, 0.1],
        ]),
    ]
}
