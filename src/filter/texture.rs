//! C0: a color map over a value of which a pixel covers a normal distribution.
//!
//! Source: Heitz, Nowrouzezahrai, Poulin and Neyret 2014, "Filtering Non-Linear Transfer Functions on Surfaces",
//! section 4, equation 9.

use super::terms::{constant, distance, placed, terms};
use super::{knots, Kernel, Tier};
use crate::accuracy::{promise, Bound, Ranges};
use crate::reference::normal::{cumulative, density};
use crate::table::bake::Plan;
use crate::table::grid::{Axis, Spacing};
use crate::table::learned::Learned;
use crate::table::Table;
use crate::transfer::color_map::{ColorMap, Colors};
use crate::transfer::pieces::Pieces;
use crate::Error;

/// Segments narrower than this part of the means' range, or of three deviations, become ramps: a difference of kinks
/// loses 6e-8/width.
const NARROW: f64 = 0.01;

/// With the fast kernel, segments become ramps that rise by more than this many hulls over the means' unit: each of
/// their kinks would err by 6e-7 times the slope, and 6e-5 is what a kink may.
const STEEP: f64 = 100.0;

/// Nodes along the mean and along the deviation of the table of [`Tier::Table`].
pub(crate) const NODES: [usize; 2] = [512, 16];

/// Sizes from which an accuracy chooses: each has up to twice the nodes of the one before it along either axis.
pub(crate) const SIZES: [[usize; 2]; 5] = [[64, 8], [128, 8], [256, 16], NODES, [1024, 32]];

/// Beyond this many deviations from the outermost knots a mean is constant to f32.
pub(super) const REACH: f32 = 8.0;

/// A C0 export before it has a name: the body's lines, the tables that it reads, and its bound.
pub(crate) struct Filter {
    /// Statements that end in a `return` of a color.
    pub body: String,
    /// What the body reads, in parameter order.
    pub tables: Vec<Table>,
    /// Against the mean of the map over a normal variable.
    pub bound: Bound,
    /// Iterations of the loop in the shelf, where there is one.
    pub trips: usize,
}

impl Filter {
    /// The filter whose body calls this one, and errs by `more` besides.
    pub(super) fn beneath(&self, map: &ColorMap, more: f64, body: String) -> Self {
        let sum = more as f32 + self.bound.value();
        let bound = match self.bound {
            // Neither the color nor the integral leaves the hull.
            Bound::Guaranteed(_) => Bound::Guaranteed(sum.min(map.widest_span())),
            Bound::Estimated(_) => Bound::Estimated(sum),
        };
        Self { body, tables: self.tables.clone(), bound, trips: self.trips }
    }
}

/// The filter of one tier, its table having so many nodes; it is not baked where its bound is sure to be above `most`.
///
/// # Errors
/// A tier that does not go with the colors.
pub(crate) fn filter(
    map: &ColorMap,
    colors: Colors,
    tier: Tier,
    nodes: [usize; 2],
    ranges: Ranges,
    most: f32,
) -> Result<Filter, Error> {
    match (tier, colors) {
        (Tier::Paper, _) => Ok(paper(map, ranges)),
        (Tier::Table, _) => Ok(by_deviation(map, colors, nodes, ranges, |plan| plan.of_values("table", 0.5 * most))),
        (Tier::Naive, Colors::Constant) => Ok(naive(map, ranges)),
        (Tier::ClosedForm(kernel), Colors::Constant) => Ok(closed_form(map, kernel, ranges)),
        (Tier::ClosedForm(Kernel::Exact), Colors::Dynamic) => Ok(dynamic(map, ranges)),
        (Tier::Naive | Tier::ClosedForm(Kernel::Fast), Colors::Dynamic) => Err(Error::Conflict(format!(
            "{tier} needs constant colors; dynamic colors go with the exact closed form and the tables"
        ))),
    }
}

/// The map's pieces for a kernel.
pub(super) fn pieces(map: &ColorMap, kernel: Kernel, ranges: Ranges) -> Pieces {
    let span = f64::from(ranges.mean.1) - f64::from(ranges.mean.0);
    let narrow = NARROW * span.max(3.0 * f64::from(ranges.deviation));
    let hull = map.spans();
    let unit = scale(map, ranges);
    Pieces::new(map, |width, rise| {
        let steep = rise.iter().zip(hull).any(|(rise, hull)| rise.abs() * unit > STEEP * hull * width);
        width < narrow || (kernel == Kernel::Fast && steep)
    })
}

/// `vec3f` or `vec4f`.
pub(crate) fn color_type(channels: usize) -> &'static str {
    if channels == 3 {
        "vec3f"
    } else {
        "vec4f"
    }
}

pub(super) fn swizzle(map: &ColorMap) -> &'static str {
    if map.channels() == 3 {
        ".xyz"
    } else {
        ""
    }
}

/// A color as WGSL, one number where the channels agree: every constructor of a vector takes a scalar.
pub(crate) fn color(map: &ColorMap, value: [f32; 4]) -> String {
    let channels = &value[..map.channels()];
    if channels.iter().all(|channel| channel.to_bits() == channels[0].to_bits()) {
        return format!("{}({})", color_type(map.channels()), number(channels[0]));
    }
    let list: Vec<String> = channels.iter().map(|&channel| number(channel)).collect();
    format!("{}({})", color_type(map.channels()), list.join(", "))
}

/// A float literal that reads back to the same bits; abstract floats need a point or an exponent.
pub(crate) fn number(value: f32) -> String {
    let value = if value == 0.0 { 0.0 } else { value };
    format!("{value:?}")
}

pub(super) fn returned(map: &ColorMap, sum: &str) -> String {
    let (low, high) = map.hull();
    format!("    return clamp({sum}, {}, {});\n", color(map, low), color(map, high))
}

fn naive(map: &ColorMap, ranges: Ranges) -> Filter {
    let pieces = pieces(map, Kernel::Exact, ranges);
    let knots = map.knots();
    let ends = (number(knots[0].position), number(knots[knots.len() - 1].position));
    let mut body = format!("    let m = clamp(mean, {}, {});\n", ends.0, ends.1);
    body += &format!("    var c = {};\n", color(map, pieces.base));
    for kink in &pieces.kinks {
        body += &format!("    c += {} * max({}, 0.0);\n", color(map, kink.change), distance("m", kink.position));
    }
    for ramp in &pieces.ramps {
        let (at, width) = (distance("m", ramp.position), number(ramp.width));
        body += &format!("    c += {} * clamp(({at}) / {width}, 0.0, 1.0);\n", color(map, ramp.change));
    }
    for step in &pieces.steps {
        let edge = number(step.position);
        body += &format!("    c += select({}, {}, mean >= {edge});\n", color(map, [0.0; 4]), color(map, step.change));
    }
    body += &returned(map, "c");
    Filter { body, tables: Vec::new(), bound: naive_bound(map, &pieces, ranges), trips: 1 }
}

/// A map turns a normal variable's mean distance from its mean, σ√(2/π), into at most its steepest slope times that,
/// and never leaves its hull; the rest is rounding.
fn naive_bound(map: &ColorMap, pieces: &Pieces, ranges: Ranges) -> Bound {
    let width = map.widest_span();
    let jumps = map.knots().iter().any(|knot| knot.left != knot.right);
    let steepest = map.knots().windows(2).map(|pair| {
        let rise = pair[0].right.iter().zip(pair[1].left).map(|(from, to)| (to - from).abs()).fold(0.0, f32::max);
        rise / (pair[1].position - pair[0].position)
    });
    let slope = if jumps { f32::INFINITY } else { steepest.fold(0.0, f32::max) };
    let spread = ranges.deviation * (2.0 / std::f32::consts::PI).sqrt();
    let rounding = (0..4).map(|channel| pieces.rounding(channel, |at| reach(ranges, at))).fold(0.0, f64::max);
    Bound::Guaranteed(width.min(slope * spread) + rounding as f32)
}

fn closed_form(map: &ColorMap, kernel: Kernel, ranges: Ranges) -> Filter {
    let pieces = pieces(map, kernel, ranges);
    if pieces.is_constant() {
        return constant(map, pieces.base);
    }
    let suffix = match kernel {
        Kernel::Fast => "_fast",
        Kernel::Exact => "",
    };
    // A deviation beyond the declared one counts as that.
    let mut body = format!("    let m = {};\n", placed(map, ranges, "mean"));
    body += &format!("    let s = min(deviation, {});\n", number(ranges.deviation));
    let [kink, step] = ["kink", "step"].map(|piece| format!("texture_{piece}{suffix}"));
    body += &terms(map, &pieces, [&kink, "texture_ramp", &step], "s");
    Filter { body, tables: Vec::new(), bound: closed_form_bound(map, &pieces, suffix, ranges), trips: 1 }
}

/// The sum of the terms' promises, weighted by what multiplies them, and the rounding of the sum.
///
/// Kinks scale with the unit of their arguments: E[max(λf − λt, 0)] = λ E[max(f − t, 0)]. The shelf promises an error
/// for distances up to 1.5 and deviations up to 0.5, and λ makes those of the scene's ranges.
fn closed_form_bound(map: &ColorMap, pieces: &Pieces, suffix: &str, ranges: Ranges) -> Bound {
    let kink = promise(&format!("texture_kink{suffix}")) * scale(map, ranges);
    let (ramp, step) = (promise("texture_ramp"), promise(&format!("texture_step{suffix}")));
    let bound = |channel: usize| {
        let size = |change: [f32; 4]| f64::from(change[channel].abs());
        pieces.rounding(channel, |at| reach(ranges, at))
            + pieces.kinks.iter().map(|piece| size(piece.change) * kink).sum::<f64>()
            + pieces.ramps.iter().map(|piece| size(piece.change) * ramp).sum::<f64>()
            + pieces.steps.iter().map(|piece| size(piece.change) * step).sum::<f64>()
    };
    Bound::Guaranteed((0..4).map(bound).fold(0.0, f64::max) as f32)
}

/// The largest mean of max(f − position, 0) in a scene's ranges: that of the largest mean and deviation.
pub(super) fn reach(ranges: Ranges, position: f32) -> f64 {
    let (distance, deviation) = (f64::from(ranges.mean.1) - f64::from(position), f64::from(ranges.deviation));
    let at = distance / deviation;
    (distance * cumulative(at) + deviation * density(at)).max(0.0)
}

/// How many times a scene's distances and deviations are those of the shelf's contracts.
fn scale(map: &ColorMap, ranges: Ranges) -> f64 {
    (farthest(map, ranges) / 1.5).max(f64::from(ranges.deviation) / 0.5)
}

/// The largest distance of a mean in the ranges from a knot.
fn farthest(map: &ColorMap, ranges: Ranges) -> f64 {
    let (low, high) = ranges.mean;
    let knots = map.knots().iter().map(|knot| f64::from(knot.position));
    knots.map(|at| (f64::from(high) - at).max(at - f64::from(low))).fold(0.0, f64::max)
}

fn dynamic(map: &ColorMap, ranges: Ranges) -> Filter {
    let table = knots::table(map, |_, knot| [knot.position, 0.0, 0.0, 0.0]);
    let reach = number(ranges.deviation);
    let body = format!("    return texture_knots(mean, clamp(deviation, 0.0, {reach}), knots){};\n", swizzle(map));
    let (ramp, step) = (promise("texture_ramp"), promise("texture_step"));
    let bound = Bound::Guaranteed(knots::bound(map, step, |_, _| ramp) as f32);
    Filter { body, tables: vec![table], bound, trips: map.knots().len() }
}

/// The table over values as those of an image.
pub(super) fn learned(map: &ColorMap, colors: Colors, nodes: [usize; 2], ranges: Ranges, image: &Learned) -> Filter {
    by_deviation(map, colors, nodes, ranges, |plan| plan.of_learned_values("table", image))
}

/// The means' axis of constant colors fits the map; that of dynamic ones is the same for all maps.
fn by_deviation(
    map: &ColorMap,
    colors: Colors,
    [columns, rows]: [usize; 2],
    ranges: Ranges,
    bake: impl FnOnce(Plan<'_>) -> Table,
) -> Filter {
    let (low, high) = (f64::from(ranges.mean.0), f64::from(ranges.mean.1));
    let means = match colors {
        Colors::Constant => Axis::fitted(low, high, columns, &bends(map)).in_f32(),
        Colors::Dynamic => Axis::round(low, high, columns).in_f32(),
    };
    let deviations = Axis { low: 0.0, high: ranges.deviation.into(), count: rows, spacing: Spacing::CubeRoot };
    let baked = bake(Plan { map: &map.reference(), means, deviations, judged: ranges.mean });
    let (low, high, reach) = (number(means.low as f32), number(means.high as f32), number(ranges.deviation));
    tabulated(map, &format!("texture_table(mean, deviation, {low}, {high}, {reach}"), baked)
}

/// The table over Beta distributions between two ends, of deviations in parts of the largest.
pub(super) fn bounded(map: &ColorMap, ends: (f32, f32), [columns, rows]: [usize; 2]) -> Filter {
    let means = Axis { low: ends.0.into(), high: ends.1.into(), count: columns, spacing: Spacing::Linear };
    let deviations = Axis { low: 0.0, high: 1.0, count: rows, spacing: Spacing::SquareRoot };
    let baked = Plan { map: &map.reference(), means, deviations, judged: ends }.of_bounded_values("table");
    let (low, high) = (number(ends.0), number(ends.1));
    tabulated(map, &format!("texture_bounded_table(mean, deviation, {low}, {high}"), baked)
}

/// The filter that reads a table by a call.
fn tabulated(map: &ColorMap, call: &str, baked: Table) -> Filter {
    let body = format!("    return {call}, table, table_sampler){};\n", swizzle(map));
    Filter { body, bound: Bound::Estimated(2.0 * baked.error), tables: vec![baked], trips: 1 }
}

/// Positions and the largest slope changes there.
pub(super) fn bends(map: &ColorMap) -> Vec<(f64, f64)> {
    let kinks = Pieces::new(map, |_, _| false).kinks.into_iter();
    let largest = |change: [f32; 4]| change.iter().map(|channel| f64::from(channel.abs())).fold(0.0, f64::max);
    kinks.map(|kink| (kink.position.into(), largest(kink.change))).collect()
}

/// The paper's recipe: 256 texels over means in [0, 1] by 256 over deviations, addressed as the texture is.
fn paper(map: &ColorMap, ranges: Ranges) -> Filter {
    let means = Axis { low: 0.0, high: 1.0, count: 256, spacing: Spacing::Centers };
    let deviations = Axis { low: 0.0, high: ranges.deviation.into(), count: 256, spacing: Spacing::Centers };
    let baked =
        Plan { map: &map.reference(), means, deviations, judged: ranges.mean }.of_values("table", f32::INFINITY);
    let reach = number(ranges.deviation);
    let body = format!(
        "    return textureSampleLevel(table, table_sampler, vec2f(mean, deviation / {reach}), 0.0){};\n",
        swizzle(map)
    );
    Filter { body, bound: Bound::Estimated(2.0 * baked.error), tables: vec![baked], trips: 1 }
}
