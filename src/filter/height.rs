//! Ch: a color map over the heights of a rough surface that are seen and lit.
//!
//! Heights are normal about a mean. Of those at the height h, in deviations from the mean, the share Φ(h)^Λ is visible,
//! Λ being the sum of Smith's Λ of the view and of the light; the color is the map's mean over the distribution
//! D_h ∝ Φ(h)^Λ φ(h). How much of the surface is visible at all is an export of its own.
//!
//! Bounds and step errors are against that model, Smith's, which is not a surface. By lines of sight over Gaussian
//! height fields of four spectra, a step errs by up to 0.06 for one direction, by up to 0.09 with a light and 0.22 with
//! one near the view; the share that is lit errs by up to 0.23, near the view 0.42, and with `hotspot` by 0.24, near
//! the view 0.04.
//!
//! Source: Heitz, Nowrouzezahrai, Poulin and Neyret 2014, "Filtering Non-Linear Transfer Functions on Surfaces",
//! sections 3 and 5.1.

pub(crate) mod glue;
pub(crate) mod skewed;
pub(crate) mod surface;
pub(crate) mod tails;
pub(crate) mod tier;
pub(crate) mod transferred;

use super::envelope::largest_error;
use super::texture::{color, number, returned, Filter};
use crate::accuracy::{Bound, Ranges};
use crate::transfer::color_map::{ColorMap, Colors};
use crate::transfer::pieces::Pieces;
use crate::Error;
use surface::{clamped, lambda, step_error, visible};

pub use surface::Microsurface;
pub use tier::HeightTier;

/// Whether a map's colors are constant between its edges.
pub(crate) fn banded(map: &ColorMap) -> bool {
    map.knots().windows(2).all(|pair| pair[0].right == pair[1].left)
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
    surface: Microsurface,
    ranges: Ranges,
    name: &str,
    arguments: &str,
) -> Filter {
    let lambda = lambda(surface);
    let moments = match tier {
        HeightTier::Paper if surface.perturbed => format!("vec3f(heights_moments_paper({lambda}), 0.0)"),
        HeightTier::Paper => format!("heights_moments_paper({lambda})"),
        HeightTier::Gaussian
        | HeightTier::Skewed
        | HeightTier::ClosedFormFast
        | HeightTier::ClosedForm
        | HeightTier::Exact => {
            format!("heights_moments_fast({lambda})")
        }
    };
    let (statement, [mean, width]) = visible(&moments, surface);
    let clamped = clamped(surface, ranges);
    let body = format!("{clamped}{statement}    return {name}_texture({mean}, {width}{arguments});\n");
    texture.beneath(map, model_error(map, tier, surface, ranges), body)
}

/// The largest error of a map over what stands for the visible heights, by a tier over C0.
pub(crate) fn model_error(map: &ColorMap, tier: HeightTier, surface: Microsurface, ranges: Ranges) -> f64 {
    let step = step_error(tier, surface, tier::rounded(tier, ranges));
    if !reaches(tier, surface) {
        return step * variation(map);
    }
    let within = largest_error(map, &tier::ENVELOPE, f64::from(tier::WIDTH * ranges.deviation));
    within + (step - tier::GAUSSIAN) * variation(map)
}

/// Whether steps far from the mean are known to err by less. With noise they are those of a sum.
pub(crate) fn reaches(tier: HeightTier, surface: Microsurface) -> bool {
    tier == HeightTier::Gaussian && !surface.perturbed
}

/// The filter of bands by the distribution itself: a probability an edge.
///
/// # Errors
/// A map with gradients, dynamic colors, and noise on the heights.
pub(crate) fn bands(map: &ColorMap, colors: Colors, surface: Microsurface, ranges: Ranges) -> Result<Filter, Error> {
    if surface.perturbed {
        let (tier, other) = (HeightTier::Exact, HeightTier::ClosedForm);
        return Err(Error::Conflict(format!(
            "{tier} know no noise on the heights, whose sum has no closed form; {other} do"
        )));
    }
    if !banded(map) || colors == Colors::Dynamic {
        let why = if colors == Colors::Dynamic { "dynamic colors" } else { "this map, which has gradients" };
        let tier = HeightTier::Exact;
        return Err(Error::Conflict(format!(
            "{tier} need a map of constant colors between hard edges, in the text, not {why}; {} take any",
            HeightTier::ClosedForm
        )));
    }
    let pieces = Pieces::new(map, |_, _| false);
    let mut body = format!("    let r = 1.0 / clamp(deviation, 1e-6, {});\n", number(ranges.deviation));
    body += &format!("    let lambda = {};\n", lambda(surface));
    body += &format!("    var c = {};\n", color(map, pieces.base));
    for step in &pieces.steps {
        let (change, edge) = (color(map, step.change), number(step.position));
        body += &format!("    c += {change} * (1.0 - heights_cdf(({edge} - mean) * r, lambda));\n");
    }
    body += &returned(map, "c");
    let error = |channel: usize| {
        let sizes = pieces.steps.iter().map(|step| f64::from(step.change[channel].abs()));
        sizes.sum::<f64>() * step_error(HeightTier::Exact, surface, 0.0) + pieces.rounding(channel, |_| 0.0)
    };
    let bound = Bound::Guaranteed((0..4).map(error).fold(0.0, f64::max) as f32);
    Ok(Filter { body, tables: Vec::new(), bound, trips: 1 })
}
