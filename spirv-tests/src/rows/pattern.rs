//! Patterns of two values: shares of a footprint on two sets of lines at once.

use prefilter::reference::pattern::{checker, checker_box, grid, grid_box, moments};

use super::Row;

/// Shares of lines are in [0, 1]; the neighbors of its ends that f32 holds need not be.
fn shares(x: &[f64]) -> [f64; 2] {
    [x[0].clamp(0.0, 1.0), x[1].clamp(0.0, 1.0)]
}

pub(super) fn rows() -> Vec<Row> {
    vec![
        Row::new("pattern_checker", |x| [checker([x[0], x[1]], [x[2], x[3], x[4]])]),
        Row::new("pattern_grid", |x| [grid([x[0], x[1]], shares(&x[2..]), [x[4], x[5], x[6]])]),
        Row::new("pattern_checker_box", |x| [checker_box([x[0], x[1]], [x[2], x[3]])]),
        Row::new("pattern_grid_box", |x| [grid_box([x[0], x[1]], shares(&x[2..]), [x[4], x[5]])]),
        Row::new("pattern_moments", |x| moments(x[0])),
    ]
}
