//! Visible slopes as two normal distributions: the nearest pair of them, and which is the longer one.

use std::sync::OnceLock;

use prefilter::reference::footprint::deviations;
use prefilter::reference::split::nearest;

use super::Row;

/// Parameters a unit at which the nearest pair is known: linear between them it errs by 1e-4.
const KNOWN: f64 = 20.0;

/// The nearest pair between those at parameters from -12 to 3.
fn between(parameter: f64) -> [f64; 4] {
    static PAIRS: OnceLock<Vec<[f64; 4]>> = OnceLock::new();
    let pairs = PAIRS.get_or_init(|| (0..=15 * KNOWN as usize).map(|at| nearest(at as f64 / KNOWN - 12.0)).collect());
    let at = (KNOWN * (parameter + 12.0)).clamp(0.0, pairs.len() as f64 - 1.001);
    let (index, share) = (at as usize, at.fract());
    std::array::from_fn(|number| (1.0 - share) * pairs[index][number] + share * pairs[index + 1][number])
}

/// The minor over the major deviation of both distributions of a pair.
fn round(x: &[f64]) -> [f64; 2] {
    [x[5], x[7]].map(|variance| {
        let [xx, xy, yy] = [[0, 0], [0, 1], [1, 1]].map(|[i, j]| variance * x[i] * x[j] + x[2 + i] * x[2 + j]);
        let [major, minor] = deviations([xx, xy, yy]);
        minor / major
    })
}

/// The pair from one of its distributions on.
fn of(x: &[f64], from: usize) -> [f64; 4] {
    std::array::from_fn(|number| x[4 + (from - 4 + number) % 4])
}

pub(super) fn rows() -> Vec<Row> {
    vec![
        Row::new("split_pair", |x| between(x[0])).at([[0.0], [1.0], [-1.0]]),
        Row::new("split_longer_first", |x| if round(x)[0] < round(x)[1] { of(x, 4) } else { of(x, 6) })
            .only_where(|x| x[5] < x[7] && (round(x)[0] - round(x)[1]).abs() > 1e-3 * round(x)[1]),
    ]
}
