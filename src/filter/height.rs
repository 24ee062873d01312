//! Ch: a color map over the heights of a rough surface that are seen and lit.
//!
//! Heights are normal about a mean. Of those at the height h, in deviations from the mean, the share Φ(h)^Λ is visible,
//! Λ being the sum of Smith's Λ of the view and of the light; the color is the map's mean over the distribution
//! D_h ∝ Φ(h)^Λ φ(h). How much of the surface is visible at all is an export of its own.
//!
//! Source: Heitz, Nowrouzezahrai, Poulin and Neyret 2014, "Filtering Non-Linear Transfer Functions on Surfaces",
//! sections 3 and 5.1.

use super::texture::{color, color_type, number, returned, Filter};
use crate::accuracy::{Bound, Ranges};
use crate::transfer::color_map::{ColorMap, Colors};
use crate::transfer::pieces::Pieces;
use crate::Error;

/// How the distribution of visible heights is represented: a ladder from the cheapest to the closest.
///
/// The step error is the largest difference of its cumulative function from that of D_h; times a map's total variation
/// it bounds the error of any map.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum HeightTier {
    /// A normal distribution of the paper's mean and deviation, to compare with. A step errs by up to 9.1e-2 for Λ up
    /// to 100, and 0.48 up to 1e4.
    Paper,
    /// A normal distribution of the mean and deviation of D_h. 4.5e-2 for Λ up to 100, 5.8e-2 up to 1e4.
    Gaussian,
    /// Two normal distributions with the mean and deviation of D_h together: 6e-3 for Λ up to 100, 9e-3 up to 1e4.
    /// Evaluates the color map twice.
    Mixture,
    /// D_h itself, for bands of constant colors: f32 rounding at any Λ.
    Exact,
}

impl std::fmt::Display for HeightTier {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.write_str(match self {
            Self::Paper => "the paper's fits",
            Self::Gaussian => "one normal distribution",
            Self::Mixture => "two normal distributions",
            Self::Exact => "bands in closed form",
        })
    }
}

/// What hides parts of a rough surface, and what the module says of it; what is off leaves no trace in the text.
///
/// Write what differs and `..Microsurface::default()`: more switches will come.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default))]
pub struct Microsurface {
    /// The light casts shadows: `NAME_height` takes it, and `NAME_visibility` is exported. Default: yes.
    pub shadowing: bool,
    /// View and light from similar azimuths see the same heights: along the light everything is lit. The paper takes
    /// them for independent. Matters with `shadowing` only. Default: no.
    pub hotspot: bool,
    /// `NAME_masking`, the share of the surface that the view sees, is exported. Default: no, because engines have such
    /// a term.
    pub masking: bool,
}

impl Default for Microsurface {
    fn default() -> Self {
        Self { shadowing: true, hotspot: false, masking: false }
    }
}

/// Step errors for Λ up to 1e4, as `worst_steps_keep_the_figures_of_their_tiers` in
/// `spirv-tests/tests/height/figures.rs` measures them on the device; it fails where they are exceeded, and where they
/// are more than 3% too wide.
const PAPER: f64 = 0.484;
const GAUSSIAN: f64 = 5.75e-2;
const MIXTURE: f64 = 9e-3;

/// The step error of bands at any Λ by the shelf's promises: 1e-6 of the probability, 3.1e-6 for the directions' Λ and
/// slope correlations up to 0.98, and the rounding of a height in deviations. The same test has up to 8e-7.
const EXACT: f64 = 6e-6;

/// What the directions' Λ adds to a step error: at most 1/e of their error relative to 1 + Λ, which the shelf promises
/// to be 9e-5 for the fast form.
const LAMBDA: f64 = 4e-5;

/// What rounding of the mean visible height adds for deviations from [`FLOOR`] on: φ(0) 2^-24 / (0.304 · 1e-3).
const ROUNDED: f64 = 1e-4;

/// The smallest deviation that bounds of the tiers over C0 hold from, as a part of the largest mean.
const FLOOR: f32 = 1e-3;

/// How far a C0 mean may lie above the mean height and how wide it may be, in deviations of the heights: 4.07 and 1.003
/// by the mixture, 4.2 and 1 by the paper's fits, at Λ up to 1e4.
const REACH: f32 = 4.25;
const WIDTH: f32 = 1.01;

/// The means and deviations that C0 is asked for.
pub(crate) fn texture_ranges(ranges: Ranges) -> Ranges {
    let (low, high) = ranges.mean;
    Ranges { mean: (low, high + REACH * ranges.deviation), deviation: WIDTH * ranges.deviation }
}

/// The smallest deviation that a bound holds from.
pub(crate) fn floor(tier: HeightTier, ranges: Ranges) -> f32 {
    match tier {
        HeightTier::Exact => 1e-6,
        _ => (FLOOR * ranges.mean.0.abs().max(ranges.mean.1.abs())).max(1e-5),
    }
}

/// Whether a map's colors are constant between its edges.
pub(crate) fn banded(map: &ColorMap) -> bool {
    map.knots().windows(2).all(|pair| pair[0].right == pair[1].left)
}

/// The step error of a tier, the errors of the directions' Λ included.
pub(crate) fn step_error(tier: HeightTier) -> f64 {
    match tier {
        HeightTier::Paper => PAPER + LAMBDA + ROUNDED,
        HeightTier::Gaussian => GAUSSIAN + LAMBDA + ROUNDED,
        HeightTier::Mixture => MIXTURE + LAMBDA + ROUNDED,
        HeightTier::Exact => EXACT,
    }
}

/// The most that a channel rises and falls from the first to the last knot.
pub(crate) fn variation(map: &ColorMap) -> f64 {
    let change = |at: usize, from: [f32; 4], to: [f32; 4]| (f64::from(to[at]) - f64::from(from[at])).abs();
    let of = |channel: usize| {
        let edges = map.knots().iter().map(|knot| change(channel, knot.left, knot.right));
        let segments = map.knots().windows(2).map(|pair| change(channel, pair[0].right, pair[1].left));
        edges.sum::<f64>() + segments.sum::<f64>()
    };
    (0..4).map(of).fold(0.0, f64::max)
}

/// The filter of a tier over C0: its body calls `NAME_texture` with the `arguments` of C0's tables.
pub(crate) fn over(
    texture: &Filter,
    map: &ColorMap,
    tier: HeightTier,
    ranges: Ranges,
    name: &str,
    arguments: &str,
) -> Filter {
    let at = |mean: &str, width: &str| format!("{name}_texture(mean + s * {mean}, s * {width}{arguments})");
    let moments = |function: &str| {
        format!("    let visible = {function}(seen + lit);\n    return {};\n", at("visible.x", "visible.y"))
    };
    let mut body = format!("    let s = clamp(deviation, 0.0, {});\n", number(ranges.deviation));
    body += &match tier {
        HeightTier::Paper => moments("heights_moments_paper"),
        HeightTier::Gaussian | HeightTier::Exact => moments("heights_moments_fast"),
        HeightTier::Mixture => format!(
            "    let visible = heights_mixture(seen + lit);\n    let high = {};\n    let low = {};\n    return low + \
             0.375 * (high - low);\n",
            at("visible.x", "visible.y"),
            at("visible.z", "visible.w")
        ),
    };
    let sum = (variation(map) * step_error(tier)) as f32 + texture.bound.value();
    let bound = match texture.bound {
        // Neither the color nor the integral leaves the hull.
        Bound::Guaranteed(_) => Bound::Guaranteed(sum.min(map.widest_span())),
        Bound::Estimated(_) => Bound::Estimated(sum),
    };
    Filter { body, tables: texture.tables.clone(), bound, trips: texture.trips }
}

/// The filter of bands by the distribution itself: a probability an edge.
///
/// # Errors
/// A map with gradients, and dynamic colors.
pub(crate) fn bands(map: &ColorMap, colors: Colors, ranges: Ranges) -> Result<Filter, Error> {
    if !banded(map) || colors == Colors::Dynamic {
        let why = if colors == Colors::Dynamic { "dynamic colors" } else { "this map, which has gradients" };
        let tier = HeightTier::Exact;
        return Err(Error::Conflict(format!(
            "{tier} need a map of constant colors between hard edges, in the text, not {why}; {} take any",
            HeightTier::Mixture
        )));
    }
    let pieces = Pieces::new(map, |_, _| false);
    let mut body = format!("    let r = 1.0 / clamp(deviation, 1e-6, {});\n", number(ranges.deviation));
    body += "    let lambda = seen + lit;\n";
    body += &format!("    var c = {};\n", color(map, pieces.base));
    for step in &pieces.steps {
        let (change, edge) = (color(map, step.change), number(step.position));
        body += &format!("    c += {change} * (1.0 - heights_cdf(({edge} - mean) * r, lambda));\n");
    }
    body += &returned(map, "c");
    let error = |channel: usize| {
        let sizes = pieces.steps.iter().map(|step| f64::from(step.change[channel].abs()));
        sizes.sum::<f64>() * EXACT + pieces.rounding(channel, |_| 0.0)
    };
    let bound = Bound::Guaranteed((0..4).map(error).fold(0.0, f64::max) as f32);
    Ok(Filter { body, tables: Vec::new(), bound, trips: 1 })
}

/// The statements that name `seen` and `lit`, the Λ of the view and what the light adds to it.
fn lambdas(tier: HeightTier, surface: Microsurface) -> String {
    let function = if tier == HeightTier::Exact { "smith_lambda" } else { "smith_lambda_fast" };
    let of = |direction: &str| format!("{function}(smith_parameter_level({direction}, slope_covariance))");
    let mut text = format!("    let seen = {};\n", of("view"));
    text += &match (surface.shadowing, surface.hotspot) {
        (false, _) => String::new(),
        (true, false) => format!("    let lit = {};\n", of("light")),
        (true, true) => format!(
            "    let apart = visibility_independence(view, light);\n    let lit = visibility_correlated(seen, {}, \
             apart);\n",
            of("light")
        ),
    };
    text
}

/// The functions of a scene of heights but for `NAME_texture`.
pub(crate) fn glue(
    name: &str,
    map: &ColorMap,
    tier: HeightTier,
    label: &str,
    surface: Microsurface,
    filter: &Filter,
    parameters: &str,
) -> String {
    let lambdas = lambdas(tier, surface);
    let (light, who) = if surface.shadowing { (", light: vec3f", "seen and lit") } else { ("", "seen") };
    let digits = if tier == HeightTier::Exact { "4e-6" } else { "1e-4" };
    let body = if surface.shadowing { filter.body.clone() } else { filter.body.replace("seen + lit", "seen") };
    let mut text = format!(
        "/// Mean color of `{name}` over the heights that are {who},
/// by {label}.
///
/// `mean` and `deviation` of the heights are in the unit of the map's positions. Directions are unit vectors away from
/// the surface, z along its normal; the covariance of its slopes is xx, xy, yy. Below a horizon the color is that of
/// the highest heights.
fn {name}_height(mean: f32, deviation: f32, slope_covariance: vec3f, view: vec3f{light}{parameters}) -> {} {{
{lambdas}{body}}}
",
        color_type(map)
    );
    if surface.shadowing {
        text += &format!(
            "
/// Share of what the view sees of `{name}` that is lit: 0 below a horizon. Within {digits} of Smith's model.
fn {name}_visibility(slope_covariance: vec3f, view: vec3f, light: vec3f) -> f32 {{
{lambdas}    return visibility_shadowing(seen, lit);
}}
"
        );
    }
    if surface.masking {
        let seen = lambdas.lines().next().unwrap_or_default();
        text += &format!(
            "
/// Share of `{name}` that the view sees: 0 below the horizon. Within {digits} of Smith's model.
fn {name}_masking(slope_covariance: vec3f, view: vec3f) -> f32 {{
{seen}
    return visibility_masking(seen);
}}
"
        );
    }
    text
}

/// What no bound of the heights covers, and how much that was measured to be.
///
/// Source: `docs/visibility_gap.csv` and `docs/shadowing_gap.csv`, by lines of sight over height fields of four
/// spectra; a test of `spirv-tests` compares.
pub(crate) fn gap(surface: Microsurface) -> String {
    let light = match (surface.shadowing, surface.hotspot) {
        (false, _) => String::new(),
        (true, false) => lit(["0.09", "0.22", "0.23", "0.42"]),
        (true, true) => lit(["0.10", "0.06", "0.24", "0.04"]),
    };
    format!(
        "how far heights are from normal, slope correlations beyond 0.98, and Λ beyond 1e4, which\n    \
         directions within 8e-5 slope deviations of the horizon have. Smith's model itself was measured against\n    \
         lines of sight over rough surfaces: for one direction steps err by up to 0.04 with a Gaussian\n    \
         autocorrelation, 0.06 with others{light}"
    )
}

/// The gap with a light, away from the view and near it.
fn lit([step, step_near, share, share_near]: [&str; 4]) -> String {
    format!(
        "; with a light by up to {step}, near the view {step_near}, and\n    \
         the share that is lit by {share}, near the view {share_near}"
    )
}
