//! Maps whose knots are the texels of a texture, for dynamic colors: the texture, and what weights by knot may err by.

use crate::table::{Format, Level, Sampling, Table};
use crate::transfer::color_map::{ColorMap, Knot};
use crate::transfer::pieces::ROUNDING;

/// Rows of left colors, right colors and what is said of positions, by index and knot.
pub(super) fn table(map: &ColorMap, position: impl Fn(usize, &Knot) -> [f32; 4]) -> Table {
    let knots = map.knots();
    let positions = knots.iter().enumerate().flat_map(|(index, knot)| position(index, knot));
    let lefts = knots.iter().flat_map(|knot| knot.left);
    let texels = lefts.chain(knots.iter().flat_map(|knot| knot.right)).chain(positions).collect();
    row("knots", knots.len() as u32, 3, texels)
}

/// A table of single texels of four numbers.
pub(super) fn row(name: &str, width: u32, height: u32, texels: Vec<f32>) -> Table {
    Table {
        name: name.to_owned(),
        format: Format::Rgba32Float,
        sampling: Sampling::Loaded,
        levels: vec![Level { width, height, depth: 1, texels }],
        error: 0.0,
    }
}

/// Each segment and each edge is a weight times a difference of colors, so that what weights may be off by is enough:
/// `step` for an edge, and for a segment what `ramp` says of its ends. Three roundings of the term come on top and one
/// of the sum, which stays in the hull.
pub(super) fn bound(map: &ColorMap, step: f64, ramp: impl Fn(f64, f64) -> f64) -> f64 {
    let (low, high) = map.hull();
    let channel = |channel: usize| {
        let largest = f64::from(low[channel].abs().max(high[channel].abs()));
        let term = |from: [f32; 4], to: [f32; 4], weight: f64| {
            let change = (f64::from(to[channel]) - f64::from(from[channel])).abs();
            let rounding = if change > 0.0 { ROUNDING * largest } else { 0.0 };
            change * (weight + 3.0 * ROUNDING) + rounding
        };
        let edges = map.knots().iter().map(|knot| term(knot.left, knot.right, step));
        let segments = map.knots().windows(2).map(|pair| {
            let weight = ramp(pair[0].position.into(), pair[1].position.into());
            term(pair[0].right, pair[1].left, weight)
        });
        edges.sum::<f64>() + segments.sum::<f64>()
    };
    (0..4).map(channel).fold(0.0, f64::max)
}
