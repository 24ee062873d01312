//! C0: means of color maps over a normal variable, by quadrature of the map times the density.

use prefilter::gpu::Address;
use prefilter::reference::beta::Beta;
use prefilter::reference::texture::{mean, PiecewiseLinear};
use prefilter::table::{Format, Level, Sampling, Table};
use prefilter::{ColorMap, Colors, Distribution, Ranges, Scene, Tier};

use super::Row;
use crate::maps;

/// A map of one channel: its knots with the values on the left and on the right.
pub(super) fn map(knots: &[(f64, f64, f64)]) -> PiecewiseLinear {
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

/// What lies a deviation to either side of the mean, drawn together.
fn narrowed(x: &[f64]) -> [f64; 2] {
    let &[mean, deviation, whole, middle, most] = x else { return [f64::NAN; 2] };
    let share = if whole > most { most / whole } else { 1.0 };
    let [low, high] = [mean - deviation, mean + deviation].map(|at| middle + share * (at - middle));
    [0.5 * (low + high), 0.5 * (high - low)]
}

/// The map's mean; the first two numbers are the variable's mean and deviation.
fn colors(map: &ColorMap) -> impl Fn(&[f64]) -> [f64; 4] {
    let map = map.reference();
    move |x| mean(&map, x[0], x[1])
}

/// A map's knots as a table, laid out by hand.
pub(super) fn knots_table(map: &ColorMap) -> Table {
    let all = || map.knots().iter();
    let lines = [
        all().flat_map(|knot| knot.left).collect::<Vec<f32>>(),
        all().flat_map(|knot| knot.right).collect(),
        all().flat_map(|knot| [knot.position, 0.0, 0.0, 0.0]).collect(),
    ];
    let level = Level { width: map.knots().len() as u32, height: 3, depth: 1, texels: lines.concat() };
    let (format, sampling) = (Format::Rgba32Float, Sampling::Loaded);
    Table { name: "knots".into(), format, sampling, levels: vec![level], error: 0.0 }
}

/// A row of `texture_knots` for a map.
fn knots(map: &ColorMap) -> Row {
    let all = || map.knots().iter();
    let breakpoints: Vec<[f64; 2]> = all().flat_map(|knot| [1e-6, 0.01].map(|s| [knot.position.into(), s])).collect();
    Row::new("texture_knots", colors(map)).table(knots_table(map), Address::Clamp).at(breakpoints)
}

/// A row of `texture_table` for a map over the whole domain.
fn table(map: &ColorMap) -> Row {
    let ranges = Ranges { mean: (-0.25, 1.25), deviation: 0.5 };
    // Of dynamic colors, whose axes do not depend on the map: the contract can name them.
    let scene = Scene::new("judged").texture(map.clone()).colors(Colors::Dynamic).tier(Tier::Table).ranges(ranges);
    let table = scene.module().expect("the ranges are those of the contract").tables()[0].clone();
    Row::new("texture_table", colors(map)).table(table, Address::Clamp)
}

/// A row of `texture_bounded_table` for a map over the whole domain.
fn bounded_table(map: &ColorMap) -> Row {
    let between = Distribution::Beta { low: 0.0, high: 1.0 };
    let module = Scene::new("judged").texture(map.clone()).distribution(between).module();
    let table = module.expect("the ends are those of the contract").tables()[0].clone();
    let map = map.reference();
    let color = move |x: &[f64]| Beta::new([0.0, 1.0], x[0], x[1]).mean_by_parts(&map);
    Row::new("texture_bounded_table", color)
        .table(table, Address::Clamp)
        .at([[0.0, 0.1, 0.0, 1.0], [0.5, 0.5, 0.0, 1.0]])
}

pub(super) fn rows() -> Vec<Row> {
    let steps = [[0.0, 1e-6], [0.0, 0.5], [8e-6, 1e-6], [-0.8, 0.1], [0.6, 0.1]];
    // Narrow ramps turn into steps at width/deviation = 0.02.
    let widths = [0.0, 0.2, -0.3, 1.0].map(|reach| [reach * 0.3, 0.02 * 0.3, 0.3]);
    let terrain = maps::named("terrain").expect("the file holds terrain");
    let hard = maps::random(32, true, 7).expect("32 stops are a map");
    let edge =
        ColorMap::gradient([(0.3, [0.2, 0.9, 0.1, 1.0]), (0.3, [0.8, 0.1, 0.4, 0.0])]).expect("an edge is a map");
    vec![
        knots(&terrain),
        knots(&hard),
        knots(&edge),
        table(&terrain),
        bounded_table(&terrain),
        Row::new("texture_kink", kink).at(steps),
        Row::new("texture_kink_fast", kink).at(steps),
        Row::new("texture_step", step).at(steps),
        Row::new("texture_step_fast", step).at(steps),
        Row::new("texture_narrowed", narrowed).at([[0.3, 0.2, 0.5, 0.1, 0.5], [-0.7, 0.4, 1e3, 0.2, 0.8]]),
        Row::new("texture_ramp", ramp).at(widths).at([[1e-5, 1e-5, 1e-6], [5e-6, 1e-5, 1e-6], [0.25, 0.5, 0.5]]),
    ]
}
