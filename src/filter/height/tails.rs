//! The tiers without a table: a term a knot over skewed heights, by longer tails or shorter ones.

use super::surface::{clamped, lambda, step_error, visible, Microsurface};
use super::tier::{rounded, texture_ranges, HeightTier};
use super::variation;
use crate::accuracy::{Bound, Ranges};
use crate::filter::terms::{constant, placed, terms};
use crate::filter::texture::{filter, pieces, reach, swizzle, Filter, NODES};
use crate::filter::{Kernel, Tier};
use crate::transfer::color_map::{ColorMap, Colors};
use crate::transfer::pieces::Pieces;
use crate::Error;

/// What rounding costs a kink, in deviations: the argument of its exponential and the result are off by a few units in
/// the last place of at most 0.4.
const KINK: f64 = 2e-7;

/// What rounding costs a ramp: two kinks, 0.02 deviations apart or more, divided by their distance.
const RAMP: f64 = 2e-5;

/// The filter of a map of constant colors by the shorter tails of the visible heights.
///
/// # Errors
/// Dynamic colors.
pub(crate) fn short_tails(
    map: &ColorMap,
    colors: Colors,
    surface: Microsurface,
    ranges: Ranges,
) -> Result<Filter, Error> {
    let tier = HeightTier::ClosedFormFast;
    if colors == Colors::Dynamic {
        return Err(Error::Conflict(format!(
            "{tier} need constant colors; dynamic colors go with {} and {}",
            HeightTier::ClosedForm,
            HeightTier::Skewed
        )));
    }
    let (statement, [mean, width]) = visible(&format!("heights_moments({})", lambda(surface)), surface);
    let mut body = clamped(surface, ranges) + &statement;
    body += &format!("    let tails = tails_skewed({width}, visible.z);\n");
    Ok(constant_colors(map, tier, surface, ranges, body, [mean, "tails"]))
}

/// The filter of a map by the tails of the visible heights.
///
/// # Errors
/// Those of C0 for the same colors.
pub(crate) fn tails(map: &ColorMap, colors: Colors, surface: Microsurface, ranges: Ranges) -> Result<Filter, Error> {
    let (statement, [mean, width]) = visible(&format!("heights_moments({})", lambda(surface)), surface);
    let mut body = clamped(surface, ranges) + &statement;
    body += &if surface.perturbed {
        format!("    let tails = perturbed_tails({width}, visible.z, n);\n")
    } else {
        format!("    let tails = height_skewed({width}, visible.z);\n")
    };
    let tier = HeightTier::ClosedForm;
    if colors == Colors::Constant {
        return Ok(constant_colors(map, tier, surface, ranges, body, [mean, "height"]));
    }
    let texture = filter(map, colors, Tier::ClosedForm(Kernel::Exact), NODES, texture_ranges(ranges), f32::INFINITY)?;
    body += &format!("    return height_knots({mean}, tails, knots){};\n", swizzle(map));
    let sum = variation(map) * (step_error(tier, surface, rounded(tier, ranges)) + RAMP);
    let sum = sum + f64::from(texture.bound.value());
    Ok(Filter { body, tables: texture.tables, bound: bounded(map, sum), trips: texture.trips })
}

/// The filter of a map of constant colors by a term a knot, in which the file of the shelf has the prefix `file`,
/// behind the statements of `body`, which name `tails`.
fn constant_colors(
    map: &ColorMap,
    tier: HeightTier,
    surface: Microsurface,
    ranges: Ranges,
    mut body: String,
    [mean, file]: [&str; 2],
) -> Filter {
    let below = texture_ranges(ranges);
    let pieces = pieces(map, Kernel::Exact, below);
    if pieces.is_constant() {
        return constant(map, pieces.base);
    }
    body += &format!("    let m = {};\n", placed(map, below, mean));
    let [kink, ramp, step] = ["kink", "ramp", "step"].map(|piece| format!("{file}_{piece}"));
    body += &terms(map, &pieces, [&kink, &ramp, &step], "tails");
    let sum = variation(map) * step_error(tier, surface, rounded(tier, ranges)) + rounding(&pieces, below);
    Filter { body, tables: Vec::new(), bound: bounded(map, sum), trips: 1 }
}

/// Neither the color nor the integral leaves the hull.
fn bounded(map: &ColorMap, error: f64) -> Bound {
    Bound::Guaranteed((error as f32).min(map.widest_span()))
}

/// The most that rounding adds to the sum of the terms.
fn rounding(pieces: &Pieces, ranges: Ranges) -> f64 {
    let kink = KINK * f64::from(ranges.deviation);
    let of = |channel: usize| {
        let size = |change: [f32; 4]| f64::from(change[channel].abs());
        pieces.rounding(channel, |at| reach(ranges, at))
            + pieces.kinks.iter().map(|piece| size(piece.change) * kink).sum::<f64>()
            + pieces.ramps.iter().map(|piece| size(piece.change) * RAMP).sum::<f64>()
    };
    (0..4).map(of).fold(0.0, f64::max)
}
