//! Slopes of transferred heights: a factor of two values times the slopes.

use prefilter::reference::transfer::slopes;

use super::Row;

pub(super) fn rows() -> Vec<Row> {
    let surface = |x: &[f64]| {
        let [x_mean, y_mean, xx, xy, yy] = slopes([x[2], x[3]], [x[4], x[5]], [x[6], x[7], x[8]]);
        [x[0], x[1], 0.0, 0.0, x_mean, y_mean, xx, xy, yy]
    };
    vec![Row::new("transfer_surface", surface)]
}
