//! The tier without a table: a term a knot over skewed heights.

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

/// The filter of a map by the tails of the visible heights.
///
/// # Errors
/// Those of C0 for the same colors.
pub(crate) fn tails(map: &ColorMap, colors: Colors, surface: Microsurface, ranges: Ranges) -> Result<Filter, Error> {
    let below = texture_ranges(ranges);
    let (statement, [mean, width]) = visible(&format!("heights_moments({})", lambda(surface)), surface);
    let mut body = clamped(surface, ranges) + &statement;
    body += &if surface.perturbed {
        format!("    let tails = perturbed_tails({width}, visible.z, n);\n")
    } else {
        format!("    let tails = height_skewed({width}, visible.z);\n")
    };
    let (rounding, tables, trips) = if colors == Colors::Dynamic {
        let texture = filter(map, colors, Tier::ClosedForm(Kernel::Exact), NODES, below, f32::INFINITY)?;
        body += &format!("    return height_knots({mean}, tails, knots){};\n", swizzle(map));
        (variation(map) * RAMP + f64::from(texture.bound.value()), texture.tables, texture.trips)
    } else {
        let pieces = pieces(map, Kernel::Exact, below);
        if pieces.is_constant() {
            return Ok(constant(map, pieces.base));
        }
        body += &format!("    let m = {};\n", placed(map, below, mean));
        body += &terms(map, &pieces, ["height_kink", "height_ramp", "height_step"], "tails");
        (rounding(&pieces, below), Vec::new(), 1)
    };
    let tier = HeightTier::ClosedForm;
    let sum = variation(map) * step_error(tier, surface, rounded(tier, ranges)) + rounding;
    // Neither the color nor the integral leaves the hull.
    Ok(Filter { body, tables, bound: Bound::Guaranteed((sum as f32).min(map.widest_span())), trips })
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
