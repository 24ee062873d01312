//! Maps over percentiles: means by quadrature over heights.

use prefilter::gpu::Address;
use prefilter::reference::percentile::mean;
use prefilter::reference::texture::PiecewiseLinear;
use prefilter::{ColorMap, Colors, Scene};

use super::Row;
use crate::maps;

/// The mean of a map of one channel: its knots with the values on the left and on the right.
fn one(knots: &[(f64, f64, f64)], lambda: f64) -> f64 {
    let knots = knots.iter().map(|&(at, left, right)| (at, [left, 0.0, 0.0, 0.0], [right, 0.0, 0.0, 0.0]));
    let [value, ..] = mean(&PiecewiseLinear { knots: knots.collect() }, lambda);
    value
}

/// A row of `percentile_knots` for a map, whose texture is that of a scene.
fn knots(map: &ColorMap) -> Row {
    let scene = Scene::new("judged").height_percentile(map.clone()).colors(Colors::Dynamic);
    let table = scene.module().expect("positions are shares").tables()[0].clone();
    let map = map.reference();
    Row::new("percentile_knots", move |x| mean(&map, x[0])).table(table, Address::Clamp).at([[0.0], [1.0]])
}

pub(super) fn rows() -> Vec<Row> {
    let at = |bits: f64| (-bits).exp2();
    vec![
        knots(&maps::named("terrain").expect("the file holds terrain")),
        knots(&maps::random(32, true, 7).expect("32 stops are a map")),
        Row::new("percentile_step", move |x| [one(&[(at(x[0]), 1.0, 0.0)], x[1])]).at([[0.0, 1.0], [1.0, 0.0]]),
        Row::new("percentile_kink", move |x| [one(&[(0.0, at(x[0]), at(x[0])), (at(x[0]), 0.0, 0.0)], x[1])])
            .at([[0.0, 1.0], [1.0, 0.0]]),
        Row::new("percentile_ramp", move |x| {
            let &[bits, span, lambda] = x else { return [f64::NAN] };
            let (low, high) = (at(bits + span), at(bits));
            // The width from the span, which the difference of the ends would lose.
            let width = -high * (-span * std::f64::consts::LN_2).exp_m1();
            let mean = one(&[(low, 1.0, 1.0), (high, 0.0, 0.0)], lambda);
            [mean * width / (span * std::f64::consts::LN_2)]
        })
        // The series ends where half the exponent is 0.5.
        .at([[0.5, 0.721_347_5, 0.0], [0.0, 1.442_695e-3, 998.0], [0.3, 1e-7, 0.0]]),
    ]
}
