//! Taps: the mixture's definition, weights and variances summed over all taps.

use prefilter::reference::taps::{placed, taps, Tap};

use super::Row;

/// A tap of the footprint with its axes along x and y turned to a direction.
fn tap(direction: [f64; 2], major: f64, minor: f64, count: f64) -> Tap {
    let [x, y] = direction;
    let (a, b) = (major.max(minor), major.min(minor));
    let (a, b) = (a * a, b * b);
    // The other axis is (−y, x).
    let covariance = [a * x * x + b * y * y, (a - b) * x * y, a * y * y + b * x * x];
    taps(covariance, count as usize)[0]
}

/// A major deviation is not below the minor one.
fn ordered(point: &[f64]) -> bool {
    point[point.len() - 3] >= point[point.len() - 2]
}

pub(super) fn rows() -> Vec<Row> {
    let own = |x: &[f64]| tap([1.0, 0.0], x[0], x[1], x[2]).covariance[0].sqrt();
    vec![
        Row::new("taps_place", |x| placed(x[0] as usize, x[1] as usize)),
        Row::new("taps_deviation", move |x| [own(x)]).only_where(ordered),
        Row::new("taps_spread", |x| {
            let single = tap([1.0, 0.0], x[0], x[1], x[2]);
            [(x[0], single.covariance[0]), (x[1], single.covariance[2])].map(|(all, own)| (all * all - own).max(0.0))
        })
        .only_where(ordered),
        Row::new("taps_shares", |x| {
            // A point counts as a line.
            let (major, minor) = if x[0] > 0.0 { (x[0], x[1]) } else { (1.0, 0.0) };
            let Tap { covariance: [along, _, across], .. } = tap([1.0, 0.0], major, minor, x[2]);
            let variances = [(along, major * major), (across, minor * minor)];
            let [along, across] = variances.map(|(own, all)| if all > 0.0 { (own / all).min(1.0) } else { 1.0 });
            [along.sqrt(), across.sqrt(), 1.0 - along, 1.0 - across]
        })
        .only_where(ordered),
        Row::new("taps_covariance", |x| tap([x[0], x[1]], x[2], x[3], x[4]).covariance).only_where(ordered),
    ]
}
