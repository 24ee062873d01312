//! Combinations: nodes by their definition, slopes of nodes by components, products by the covariance of two variables.

use prefilter::reference::combine::node;
use prefilter::reference::footprint::covariance;

use super::Row;

/// s̄ + e (R + √V u) + f w, a component at a time.
fn slope(x: &[f64]) -> [f64; 2] {
    let along = x[9] + x[10].max(0.0).sqrt() * x[0];
    [0, 1].map(|i| x[3 + i] + along * x[5 + i] + x[1] * x[7 + i])
}

/// 0.49 of the image of diag(V, 1) under the factor.
fn spread(x: &[f64]) -> [f64; 3] {
    covariance([x[0], x[1]], [x[2], x[3]], [x[5].clamp(0.0, 1.0), 0.0, 1.0]).map(|entry| 0.49 * entry)
}

/// E[c l] = E[c] E[l] + cov(c, l), within the hull.
fn joint(x: &[f64]) -> [f64; 3] {
    [0, 1, 2].map(|channel| {
        let [color, light, moved, turned, both, low, high] = std::array::from_fn(|part| x[3 * part + channel]);
        let covariance = (both - moved * turned) / (1.0 - 0.7f64.powi(2));
        (color * light + covariance).max(low * light).min(high * light)
    })
}

pub(super) fn rows() -> Vec<Row> {
    vec![
        Row::new("combine_node", |x| node(x[0] as usize, x[1])),
        Row::new("combine_slope", slope),
        Row::new("combine_covariance", spread),
        Row::new("combine_joint", joint),
    ]
}
