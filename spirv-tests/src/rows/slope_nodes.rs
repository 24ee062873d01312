//! Nodes of the slopes of transferred heights: areas by quadrature over slopes, shares by their definitions.

use prefilter::reference::slope_nodes::bits;
use prefilter::reference::slopes::standard::weight;
use prefilter::reference::smith::{lambda, Along};

use super::Row;

/// The rise of a node.
fn rise(view: &[f64], mean_slope: &[f64], scale: f64) -> f64 {
    let slope = [0, 1].map(|axis| scale * mean_slope[axis]);
    view[2] - view[0] * slope[0] - view[1] * slope[1]
}

fn rises(x: &[f64], scales: &[f64]) -> [f64; 4] {
    std::array::from_fn(|node| rise(&x[..3], &x[3..5], scales[node]))
}

/// E[max(−t, 0)] of a node: t is normal, its mean the rise.
fn averted(rise: f64, reach: f64) -> f64 {
    if reach == 0.0 || rise.abs() > 12.0 * reach {
        (-rise).max(0.0)
    } else {
        reach * weight(-rise / reach)
    }
}

/// The first vector of the factor is against the view.
fn against(x: &[f64]) -> bool {
    x[0] * x[5] + x[1] * x[6] <= 0.0
}

/// The mean surface rises towards the view by a tenth of what each node may.
fn above_horizon(x: &[f64]) -> bool {
    let [scales, weights] = [&x[5..9], &x[9..13]];
    let sum: f64 = rises(x, scales).iter().zip(weights).map(|(rise, weight)| rise * weight).sum();
    sum > 0.1 * weights.iter().sum::<f64>()
}

/// What faces the view is no small difference.
fn faces(x: &[f64]) -> bool {
    let [scales, weights, averted] = [&x[5..9], &x[9..13], &x[13..17]];
    let rises = rises(x, scales);
    let facing = (0..4).map(|node| weights[node] * (rises[node] + averted[node]).max(0.0));
    facing.sum::<f64>() > 0.05
}

pub(super) fn rows() -> Vec<Row> {
    vec![
        Row::new("slope_nodes_averted", |x| {
            let along = -(x[0] * x[5] + x[1] * x[6]);
            let rises = rises(x, &x[9..13]);
            std::array::from_fn::<f64, 4, _>(|node| averted(rises[node], along * x[9 + node].abs()))
        })
        .at([[0.0, 0.0, 1.0, 0.2, -0.3, -1.0, 0.0, 0.0, 1.0, 0.0, 0.3, 1.0, 2.0]])
        .only_where(against),
        Row::new("slope_nodes_rises", |x| rises(x, &x[5..9])),
        Row::new("slope_nodes_lambda", |x| {
            let [weights, averted] = [&x[9..13], &x[13..17]];
            let mean = |values: &[f64]| values.iter().zip(weights).map(|(value, weight)| value * weight).sum::<f64>();
            [mean(averted) / mean(&rises(x, &x[5..9]))]
        })
        .only_where(above_horizon),
        Row::new("slope_nodes_bits", |x| std::array::from_fn::<f64, 4, _>(|node| bits(x[0], x[1 + node], x[5 + node]))),
        Row::new("slope_nodes_shares", |x| {
            let [weights, averted, bits] = [&x[9..13], &x[13..17], &x[17..21]];
            let rises = rises(x, &x[5..9]);
            let seen: [f64; 4] = std::array::from_fn(|node| {
                weights[node] * (rises[node] + averted[node]).max(0.0) * (-bits[node] * std::f64::consts::LN_2).exp()
            });
            let sum: f64 = seen.iter().sum();
            seen.map(|share| share / sum)
        })
        .only_where(faces),
        Row::new("slope_nodes_ratio", |x| {
            let (&[x, y, z], covariance) = (&[x[0], x[1], x[2]], [x[3], x[4], x[5]]);
            [Along::new([x, y, z], covariance, [0.0; 2]).parameter().clamp(0.0, 1e9)]
        })
        .at([
            [0.6, 0.0, 0.8, 1.0, 0.0, 1.0],
            [0.8, 0.6, 1e-6, 1.0, -0.4, 0.25],
            [0.0, 0.0, 1.0, 1.0, -0.4, 0.25],
        ]),
        Row::new("slope_nodes_hiding", |x| [lambda(x[0] / x[1])]).at([[2.2, 1.0], [0.5, 0.1]]),
    ]
}
