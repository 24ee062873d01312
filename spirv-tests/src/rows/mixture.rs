//! Two normal distributions from their moments, by bisection.

use prefilter::reference::mixture::Pair;

use super::Row;

fn pair(x: &[f64]) -> [f64; 5] {
    let known = |moment: f64| if moment.abs() < f64::from(1e-6f32) { 0.0 } else { moment };
    let [skewness, kurtosis] = [known(x[0]), known(x[1])];
    let Pair { offsets: [higher, lower], weights: [first, second], deviation } = Pair::with(skewness, kurtosis);
    [higher, lower, first, second, deviation]
}

pub(super) fn rows() -> Vec<Row> {
    // Nothing known; symmetric and two-valued; the narrowest pair and what no distribution has; the farthest.
    let turns = [[0.0, 0.0], [0.0, -2.0], [1.0, -1.0], [2.0, 1.5], [1.0, 32.0], [1e-6, 0.0], [0.0, -1e-6], [0.1, 3.2]];
    vec![Row::new("mixture_pair", pair).at(turns)]
}
