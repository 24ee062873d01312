//! Ch: means of color maps over visible heights, by quadrature of the map times their density.

use std::sync::OnceLock;

use prefilter::gpu::Address;
use prefilter::reference::height::mean;
use prefilter::reference::heights::{lambda_of_skewness, moments};
use prefilter::reference::tails::nearest_tails;
use prefilter::reference::texture::PiecewiseLinear;
use prefilter::{ColorMap, Colors, HeightTier, Ranges, Scene};

use super::texture::{knots_table, map};
use super::Row;
use crate::maps;

/// Nodes of [`visible`], and the skewness between two.
const NODES: usize = 264;
const SPACING: f64 = 0.87 / 256.0;

/// log₂(1 + Λ), mean and deviation of the visible heights of a skewness, by cubic interpolation, which leaves 1e-8: the
/// bisection takes too long to be asked for each point.
pub(super) fn visible(skewness: f64) -> [f64; 3] {
    static TABLE: OnceLock<Vec<[f64; 3]>> = OnceLock::new();
    let table = TABLE.get_or_init(|| {
        let node = |index: usize| {
            let lambda = lambda_of_skewness(SPACING * index as f64);
            let [mean, deviation, ..] = moments(lambda);
            [(1.0 + lambda).log2(), mean, deviation]
        };
        (0..NODES).map(node).collect()
    });
    let at = (skewness / SPACING).clamp(0.0, 256.0);
    let first = (at.floor() as usize).saturating_sub(1);
    let x = at - first as f64;
    let weights = [
        -(x - 1.0) * (x - 2.0) * (x - 3.0) / 6.0,
        x * (x - 2.0) * (x - 3.0) / 2.0,
        -x * (x - 1.0) * (x - 3.0) / 2.0,
        x * (x - 1.0) * (x - 2.0) / 6.0,
    ];
    std::array::from_fn(|number| (0..4).map(|node| weights[node] * table[first + node][number]).sum())
}

/// The map's mean over visible heights of a mean, deviation and skewness.
fn over(map: &PiecewiseLinear, at: f64, deviation: f64, skewness: f64) -> [f64; 4] {
    let [bits, own_mean, own_deviation] = visible(skewness);
    let scale = deviation / own_deviation;
    mean(map, at - scale * own_mean, scale, bits.exp2() - 1.0)
}

pub(super) fn kink(x: &[f64]) -> [f64; 1] {
    let &[distance, deviation, skewness] = x else { return [f64::NAN] };
    // Visible heights end before the far knot: the kink goes on as far as it matters.
    let far = distance.abs() + 40.0 * deviation;
    [over(&map(&[(0.0, 0.0, 0.0), (far, far, far)]), distance, deviation, skewness)[0]]
}

pub(super) fn step(x: &[f64]) -> [f64; 1] {
    let &[distance, deviation, skewness] = x else { return [f64::NAN] };
    [over(&map(&[(0.0, 0.0, 1.0)]), distance, deviation, skewness)[0]]
}

pub(super) fn ramp(x: &[f64]) -> [f64; 1] {
    let &[distance, width, deviation, skewness] = x else { return [f64::NAN] };
    [over(&map(&[(0.0, 0.0, 0.0), (width, 1.0, 1.0)]), distance, deviation, skewness)[0]]
}

/// A row of `height_knots` for a map.
fn knots(map: &ColorMap) -> Row {
    let reference = map.reference();
    Row::new("height_knots", move |x| over(&reference, x[0], x[1], x[2])).table(knots_table(map), Address::Clamp)
}

/// A row of `height_table` for a map over the whole domain.
fn table(map: &ColorMap) -> Row {
    // Of dynamic colors, whose axes do not depend on the map: the contract can name them.
    let ranges = Ranges { mean: (-0.25, 1.25), deviation: 0.5 };
    let scene = Scene::new("judged").height(map.clone()).colors(Colors::Dynamic).ranges(ranges);
    let module = scene.height_tier(HeightTier::Skewed).module().expect("the ranges are those of the contract");
    let reference = map.reference();
    Row::new("height_table", move |x| over(&reference, x[0], x[1], x[2]))
        .table(module.tables()[0].clone(), Address::Clamp)
}

/// Distances, deviations and skewnesses of pieces, at corners and where both tails meet.
pub(super) const STEPS: [[f64; 3]; 4] = [[0.0, 1e-6, 0.3], [0.0, 0.5, 0.0], [-0.8, 0.2, 0.86], [0.6, 0.1, 0.86]];

/// A distance, a width, a deviation and a skewness of a ramp.
pub(super) const NARROWEST: [f64; 4] = [1e-5, 1e-5, 1e-6, 0.2];

/// The same of ramps that turn into steps, at width/deviation = 0.02.
pub(super) fn widths() -> [[f64; 4]; 4] {
    [0.0, 0.2, -0.3, 1.0].map(|reach| [reach * 0.3, 0.02 * 0.3, 0.3, 0.5])
}

pub(super) fn rows() -> Vec<Row> {
    let widths = widths();
    let hard = maps::random(32, true, 7).expect("32 stops are a map");
    let terrain = maps::named("terrain").expect("the file holds terrain");
    vec![
        knots(&terrain),
        table(&terrain),
        knots(&hard),
        Row::new("height_skewed", |x| nearest_tails(x[0], visible(x[1])[0].exp2() - 1.0)),
        Row::new("height_excess", |x| [kink(x)[0] - x[0].max(0.0)]).at(STEPS),
        Row::new("height_kink", kink).at(STEPS),
        Row::new("height_step", step).at(STEPS),
        Row::new("height_ramp", ramp).at(widths).at([NARROWEST]),
    ]
}
