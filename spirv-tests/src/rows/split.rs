//! Visible slopes as two normal distributions less a narrow one: the nearest of them.

use std::sync::OnceLock;

use prefilter::reference::slopes::standard::moments;
use prefilter::reference::split::nearest;

use super::Row;

/// Parameters a unit at which the nearest distributions are known: linear between them they err by 1e-4.
const KNOWN: f64 = 20.0;

/// Mean and variance of the third in deviations of u: what was chosen, as no other is much nearer.
fn third(parameter: f64) -> [f64; 2] {
    let [mean, ..] = moments(parameter);
    let near = mean.max(0.48).recip();
    [-1.7 - 0.347 * near, 0.17 + 0.03 * near]
}

/// The nearest distributions between those at parameters from -12 to 5, where they begin to become one.
fn between(parameter: f64) -> [[f64; 3]; 3] {
    static KEPT: OnceLock<Vec<[[f64; 3]; 3]>> = OnceLock::new();
    let of = |at: f64| nearest(at, third(at));
    let kept = KEPT.get_or_init(|| (0..=17 * KNOWN as usize).map(|at| of(at as f64 / KNOWN - 12.0)).collect());
    let at = (KNOWN * (parameter + 12.0)).clamp(0.0, kept.len() as f64 - 1.001);
    let (index, share) = (at as usize, at.fract());
    let number = |which: usize, number: usize| {
        (1.0 - share) * kept[index][which][number] + share * kept[index + 1][which][number]
    };
    std::array::from_fn(|which| std::array::from_fn(|at| number(which, at)))
}

pub(super) fn rows() -> Vec<Row> {
    vec![
        Row::new("split_part", |x| [1.0 - (x[0] - 5.0).clamp(0.0, 1.0).powi(2)]),
        Row::new("split_less", |x| {
            let [_, _, [mean, variance, weight]] = between(x[0]);
            [mean, variance, -weight]
        })
        .at([[0.0], [1.0], [-1.0]]),
        Row::new("split_pair", |x| {
            let [[low, narrow, _], [high, wide, _], _] = between(x[0]);
            [low, narrow, high, wide]
        })
        .at([[0.0], [1.0], [-1.0]]),
    ]
}
