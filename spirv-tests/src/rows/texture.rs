//! C0: means of color maps over a normal variable, by quadrature of the map times the density.

use prefilter::reference::texture::{mean, PiecewiseLinear};

use super::Row;

/// A map of one channel: its knots with the values on the left and on the right.
fn map(knots: &[(f64, f64, f64)]) -> PiecewiseLinear {
    let knots = knots.iter().map(|&(at, left, right)| (at, [left, 0.0, 0.0, 0.0], [right, 0.0, 0.0, 0.0]));
    PiecewiseLinear { knots: knots.collect() }
}

fn kink(x: &[f64]) -> [f64; 1] {
    let &[distance, deviation] = x else { return [f64::NAN] };
    // The density ends before the far knot: the kink goes on as far as it matters.
    let far = distance.abs() + 20.0 * deviation;
    let [value, ..] = mean(&map(&[(0.0, 0.0, 0.0), (far, far, far)]), distance, deviation);
    [value]
}

fn step(x: &[f64]) -> [f64; 1] {
    let &[distance, deviation] = x else { return [f64::NAN] };
    let [value, ..] = mean(&map(&[(0.0, 0.0, 1.0)]), distance, deviation);
    [value]
}

fn ramp(x: &[f64]) -> [f64; 1] {
    let &[distance, width, deviation] = x else { return [f64::NAN] };
    let [value, ..] = mean(&map(&[(0.0, 0.0, 0.0), (width, 1.0, 1.0)]), distance, deviation);
    [value]
}

pub(super) fn rows() -> Vec<Row> {
    let steps = [[0.0, 1e-6], [0.0, 0.5], [8e-6, 1e-6], [-0.8, 0.1], [0.6, 0.1]];
    // Narrow ramps turn into steps at width/deviation = 0.02.
    let widths = [0.0, 0.2, -0.3, 1.0].map(|reach| [reach * 0.3, 0.02 * 0.3, 0.3]);
    vec![
        Row::new("texture_kink", kink).at(steps),
        Row::new("texture_kink_fast", kink).at(steps),
        Row::new("texture_step", step).at(steps),
        Row::new("texture_step_fast", step).at(steps),
        Row::new("texture_ramp", ramp).at(widths).at([[1e-5, 1e-5, 1e-6], [5e-6, 1e-5, 1e-6], [0.25, 0.5, 0.5]]),
    ]
}
