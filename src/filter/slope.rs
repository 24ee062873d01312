//! Cs: a color map over one component of the slopes of a rough surface that a view sees.
//!
//! A facet of the slope s counts by its area in the picture; the distribution of the slopes that are seen is D_s, in
//! `wgsl/visibility/slopes.wgsl`. Along any vector it is represented by one or two normal distributions, over each of
//! which the color is that of C0. Of a flat mesh with a map of normals all slopes count the same.
//!
//! Source: Heitz, Nowrouzezahrai, Poulin and Neyret 2014, "Filtering Non-Linear Transfer Functions on Surfaces",
//! section 5.2, equation 18.

use super::envelope::{largest_error, Envelope};
use super::height::variation;
use super::shared::{statements, Shared};
use super::texture::{color_type, number, Filter};
use crate::accuracy::Ranges;
use crate::transfer::color_map::ColorMap;

/// How the distribution of visible slopes is represented: a ladder from the cheapest to the closest.
///
/// The step error is the largest difference of its cumulative function from that of D_s, along any vector and for
/// views above the horizon of the mean surface; times a map's total variation it bounds the error of any map.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum SlopeTier {
    /// The map at the mean slope: no filtering at all, to compare with. A step errs by up to 1.
    Naive,
    /// The distribution of all slopes, whatever the view: exact for flat meshes with maps of normals. A step errs by up
    /// to 0.58 over surfaces that are rough.
    Unweighted,
    /// A normal distribution with the mean and covariance of D_s: 4.7e-2.
    ///
    /// This is the paper's representation, "a single Gaussian whose parameters can be computed directly from" the mean
    /// and covariance of all slopes. How the paper computes them is in a supplement that is not public; here they are
    /// the exact moments, whose derivation `wgsl/visibility/slopes.wgsl` has at its top.
    #[doc(alias = "Paper")]
    Gaussian,
    /// Two normal distributions with the mean and covariance of D_s together: 1.2e-2. Evaluates the color map twice,
    /// once where one is within 5.1e-3. A map of the whole slope takes a narrow third away from two: 3e-3.
    Pair,
}

impl std::fmt::Display for SlopeTier {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.write_str(match self {
            Self::Naive => "the mean slope",
            Self::Unweighted => "all slopes alike",
            Self::Gaussian => "one normal distribution",
            Self::Pair => "two normal distributions",
        })
    }
}

/// Step errors at the horizon of the mean surface, where they are largest: 0.578 between the normal distribution and
/// that of Rayleigh; `worst_steps_keep_the_figures_of_their_tiers` in `spirv-tests/tests/slope/figures.rs` measures
/// them on the device.
const NAIVE: f64 = 1.0;
const UNWEIGHTED: f64 = 0.579;
const GAUSSIAN: f64 = 4.66e-2;
const PAIR: f64 = 1.19e-2;

/// The same by the distance of the step from the mean of the visible slopes' component, in its deviations, for one and
/// for two normal distributions: `steps_far_from_the_mean_keep_their_figures`, in the same file.
const ENVELOPE: [[f64; 2]; 10] = [
    [0.0, GAUSSIAN],
    [0.5, 4e-2],
    [0.75, 3.52e-2],
    [1.75, 3.46e-2],
    [2.0, 2.4e-2],
    [2.25, 1.3e-2],
    [2.5, 9.3e-3],
    [3.0, 4.4e-3],
    [4.0, 6e-4],
    [5.0, 3.6e-5],
];
const ENVELOPE_OF_TWO: [[f64; 2]; 7] =
    [[0.0, PAIR], [2.0, 8.4e-3], [2.25, 5.2e-3], [2.5, 4.6e-3], [3.0, 3.1e-3], [3.5, 1.5e-3], [4.0, 5.5e-4]];

/// What rounding adds: φ(0) times 2^-24 of the largest mean over the smallest deviation, 1e-3 of it, for each of three
/// sums; and of the parameter at a reach of 1e-3.
const ROUNDED: f64 = 2e-4;

/// The smallest deviation of the component that bounds hold from, as a part of the largest mean slope; and as one of
/// the largest deviation, where that is less.
const FLOOR: f32 = 1e-3;
const NARROW: f32 = 0.1;

/// How far the means of C0 may lie beyond that of all slopes, in deviations: 1.664 for the pair at the horizon.
const REACH: f32 = 1.67;

/// The step error of a tier.
pub(crate) fn step_error(tier: SlopeTier, ranges: Ranges) -> f64 {
    let rounded = ROUNDED * f64::from(FLOOR * steepest(ranges) / floor(ranges)).max(1.0);
    let model = match tier {
        SlopeTier::Naive => NAIVE,
        SlopeTier::Unweighted => UNWEIGHTED,
        SlopeTier::Gaussian => GAUSSIAN,
        SlopeTier::Pair => PAIR,
    };
    model + rounded
}

/// The largest error of a map over what stands for the visible slopes.
pub(crate) fn model_error(map: &ColorMap, tier: SlopeTier, ranges: Ranges) -> f64 {
    let step = step_error(tier, ranges);
    let within = |envelope: &Envelope| {
        largest_error(map, envelope, ranges.deviation.into()) + (step - envelope[0][1]) * variation(map)
    };
    match tier {
        SlopeTier::Naive | SlopeTier::Unweighted => step * variation(map),
        SlopeTier::Gaussian => within(&ENVELOPE),
        SlopeTier::Pair => within(&ENVELOPE_OF_TWO),
    }
}

/// The largest mean slope that bounds hold for: across the component it may be 1 whatever the component's means are,
/// and rounds the rise over it.
pub(crate) fn steepest(ranges: Ranges) -> f32 {
    ranges.largest_mean().max(1.0)
}

/// The smallest deviation that a bound holds from.
pub(crate) fn floor(ranges: Ranges) -> f32 {
    (FLOOR * steepest(ranges)).min(NARROW * ranges.deviation).max(1e-5)
}

/// The means and deviations that C0 is asked for.
pub(crate) fn texture_ranges(tier: SlopeTier, ranges: Ranges) -> Ranges {
    let (low, high) = ranges.mean;
    let beyond = match tier {
        SlopeTier::Naive | SlopeTier::Unweighted => 0.0,
        SlopeTier::Gaussian | SlopeTier::Pair => REACH * ranges.deviation,
    };
    Ranges { mean: (low - beyond, high + beyond), ..ranges }
}

/// The middle of the map, about which slopes are drawn together whose component deviates by more than the ranges say.
fn middle(map: &ColorMap) -> f32 {
    let knots = map.knots();
    0.5 * knots[0].position + 0.5 * knots[knots.len() - 1].position
}

/// The factor of the covariance and what of the scalar u a tier needs.
pub(crate) fn shared(tier: SlopeTier) -> Vec<Shared> {
    let factor = Shared::new("factor", "vec4f", "slopes_factor(view, slope_covariance)");
    let parameter = Shared::new("parameter", "f32", "slopes_parameter(view, mean_slope, factor)");
    match tier {
        SlopeTier::Naive | SlopeTier::Unweighted => Vec::new(),
        SlopeTier::Gaussian => vec![factor, parameter, Shared::new("moments", "vec2f", "slopes_moments(parameter)")],
        SlopeTier::Pair => vec![factor, parameter, Shared::new("pair", "vec4f", "slopes_pair(parameter)")],
    }
}

/// The filter of a tier over C0: its body calls `NAME_texture` with the `arguments` of C0's tables.
pub(crate) fn over(
    texture: &Filter,
    map: &ColorMap,
    tier: SlopeTier,
    ranges: Ranges,
    name: &str,
    arguments: &str,
) -> Filter {
    let colored = |of: &str| format!("{name}_texture({of}.x, {of}.y{arguments})");
    let (middle, most) = (number(middle(map)), number(ranges.deviation));
    let narrowed = |part: &str| format!("texture_narrowed({part}, whole, {middle}, {most})");
    let along = |mean: &str, variance: &str| format!("slopes_along(direction, mean_slope, factor, {mean}, {variance})");
    let visible = |mean: &str, variance: &str| narrowed(&along(mean, variance));
    let whole = format!("    let whole = {}.y;\n", along("0.0", "1.0"));
    let body = match tier {
        SlopeTier::Naive => format!("    return {name}_texture(dot(direction, mean_slope), 0.0{arguments});\n"),
        SlopeTier::Unweighted => format!(
            "    let whole = sqrt(max(smith_variance(direction, slope_covariance), 0.0));\n    let component = \
             {};\n    return {};\n",
            narrowed("vec2f(dot(direction, mean_slope), whole)"),
            colored("component")
        ),
        SlopeTier::Gaussian => format!(
            "{whole}    let component = {};\n    return {};\n",
            visible("moments.x", "moments.y"),
            colored("component")
        ),
        SlopeTier::Pair => format!(
            "{whole}    let low = {};
    var c = {};
    if parameter < slopes_single {{
        let high = {};
        c = 0.5 * (c + {});
    }}
    return c;
",
            visible("pair.x", "pair.y"),
            colored("low"),
            visible("pair.z", "pair.w"),
            colored("high")
        ),
    };
    texture.beneath(map, model_error(map, tier, ranges), body)
}

/// What `NAME_slope` takes between the slopes' statistics and the tables, each behind a comma.
pub(crate) fn given(tier: SlopeTier) -> &'static str {
    match tier {
        SlopeTier::Unweighted => ", direction: vec2f",
        SlopeTier::Naive | SlopeTier::Gaussian | SlopeTier::Pair => ", view: vec3f, direction: vec2f",
    }
}

/// `NAME_slope` with a body.
pub(crate) fn glue(name: &str, map: &ColorMap, tier: SlopeTier, label: &str, parameters: &str, body: &str) -> String {
    let weighted = tier != SlopeTier::Unweighted;
    let given = given(tier);
    format!(
        "/// Mean color of `{name}` over {},
/// by {label}.
///
/// Positions of the map are components d · s of slopes s along `direction`, d, of length 1 at most. A facet's normal n
/// is along (-s.x, -s.y, 1): with d = -t.xy the component is n · t / n.z - t.z, how much it faces a direction t.
/// Slopes have a mean and a covariance, xx, xy, yy.{}
fn {name}_slope(mean_slope: vec2f, slope_covariance: vec3f{given}{parameters}) -> {} {{
{}{body}}}
",
        if weighted { "the slopes that are seen" } else { "all slopes" },
        if weighted { VIEWED } else { "" },
        color_type(map.channels()),
        statements(&shared(tier))
    )
}

/// What `NAME_slope` says of its view.
pub(super) const VIEWED: &str = "
///
/// `view` is a unit vector away from the surface, z along its normal. Below the horizon of the mean surface the color
/// is that of the slopes that rise above it.";

/// What no bound covers, and how much that was measured to be.
///
/// Source: `docs/slope_gap.csv`, by lines of sight over height fields of four spectra; a test of `spirv-tests`
/// compares.
pub(crate) fn gap(tier: SlopeTier) -> String {
    let model = match tier {
        SlopeTier::Naive | SlopeTier::Unweighted => "",
        SlopeTier::Gaussian | SlopeTier::Pair => MODEL,
    };
    format!("how far slopes are from a normal distribution of that mean and covariance{model}")
}

/// What D_s leaves out.
const MODEL: &str = ". That facets hide
    each other whatever their slopes was measured against lines of sight over rough surfaces: steps along the
    view err by up to 0.03 with a Gaussian autocorrelation, 0.06 with others";
