//! Noise on visible heights: the nearest tails by the convolution.

use std::sync::OnceLock;

use prefilter::reference::heights::{lambda_of_skewness, moments};
use prefilter::reference::perturbed::nearest_tails;

use super::Row;

/// Nodes of [`nearest`] along the skewness without noise and along the noise's share of the variance, and where they
/// end.
const NODES: [usize; 2] = [13, 20];
const ENDS: [f64; 2] = [0.8624, 0.95];

/// The nearest tails for a deviation of 1, by linear interpolation over the skewness without noise and the noise's
/// share, which leaves 2e-3: the convolutions take too long for each point.
fn nearest(skewness: f64, share: f64) -> [f64; 10] {
    static TABLE: OnceLock<Vec<[f64; 10]>> = OnceLock::new();
    let table = TABLE.get_or_init(|| {
        let node = |number: usize| {
            let [skewness, share] = [(number % NODES[0], 0), (number / NODES[0], 1)]
                .map(|(node, axis)| ENDS[axis] * node as f64 / (NODES[axis] - 1) as f64);
            let lambda = lambda_of_skewness(skewness);
            let [_, own, ..] = moments(lambda);
            nearest_tails(1.0, lambda, own * (share / (1.0 - share)).sqrt())
        };
        (0..NODES[0] * NODES[1]).map(node).collect()
    });
    let place = |value: f64, axis: usize| {
        let at = value / ENDS[axis] * (NODES[axis] - 1) as f64;
        let node = (at as usize).min(NODES[axis] - 2);
        (node, at - node as f64)
    };
    let ((column, x), (row, y)) = (place(skewness, 0), place(share, 1));
    let at = |column: usize, row: usize, number: usize| table[row * NODES[0] + column][number];
    std::array::from_fn(|number| {
        let line = |row: usize| at(column, row, number) * (1.0 - x) + at(column + 1, row, number) * x;
        line(row) * (1.0 - y) + line(row + 1) * y
    })
}

/// The skewness of the heights without noise, and the noise's share of the variance.
fn alone(x: &[f64]) -> [f64; 2] {
    let share = (x[2] / x[0]).powi(2);
    [x[1] / (1.0 - share).powf(1.5), share]
}

pub(super) fn rows() -> Vec<Row> {
    let possible = |x: &[f64]| alone(x)[1] <= ENDS[1] && alone(x)[0] <= ENDS[0];
    let tails = |x: &[f64]| {
        let [skewness, share] = alone(x);
        let mut tails = nearest(skewness, share);
        tails[0] /= x[0];
        tails[1] *= x[0];
        tails
    };
    vec![Row::new("perturbed_tails", tails).only_where(possible)]
}
