//! Ch of a color map over percentiles: over the share P(h) of a rough surface that lies below a height.
//!
//! Of the visible heights the share p^(1 + Λ) lies below the percentile p, whatever the distribution of the heights is,
//! so that the color needs neither their mean nor their deviation, and is exact.
//!
//! Source: Heitz, Nowrouzezahrai, Poulin and Neyret 2014, "Filtering Non-Linear Transfer Functions on Surfaces",
//! sections 3 and 5.1.

use std::f64::consts::LN_2;

use super::height::surface::{lambda, share_error};
use super::height::{variation, Microsurface};
use super::knots;
use super::texture::{color, number, returned, swizzle, Filter};
use crate::accuracy::{promise, Bound};
use crate::transfer::color_map::{ColorMap, Colors};
use crate::transfer::pieces::{Pieces, Ramp, ROUNDING};
use crate::Error;

/// Segments narrower than this become ramps: the kinks of a width err by 2e-7/width.
const NARROW: f64 = 0.09;

/// Ramps that end below this are steps: what they hide is less visible than that.
const LOW: f64 = 1e-9;

/// The bits of position 0, of which no power is left.
const MOST: f64 = 1e4;

/// The filter of a map over percentiles.
///
/// # Errors
/// A position that is no share.
pub(crate) fn filter(map: &ColorMap, colors: Colors, surface: Microsurface) -> Result<Filter, Error> {
    if let Some(index) = map.knots().iter().position(|knot| !(0.0..=1.0).contains(&knot.position)) {
        let what = format!("knot {index}'s position, a share of the surface,");
        return Err(Error::value(what, map.knots()[index].position, "0 to 1"));
    }
    Ok(match colors {
        Colors::Constant => constant(map, surface),
        Colors::Dynamic => dynamic(map, surface),
    })
}

fn bits(position: f64) -> f64 {
    if position > 0.0 {
        -position.log2()
    } else {
        MOST
    }
}

/// The bits of a segment's upper end, the span of bits down to its lower end, and span ln 2 / width.
fn segment(low: f64, width: f64) -> [f64; 3] {
    let span = if low > 0.0 { (width / low).ln_1p() / LN_2 } else { MOST };
    // Beyond 1e30 the power of the upper end is 0.
    [bits(low + width), span, (span * LN_2 / width).min(1e30)]
}

/// What a ramp's weight may be off by. The shelf's promise is for a mean of powers, its weight is `ratio` times that.
/// Short ramps have a ratio of up to 1.3 over the position, which their powers make up for; of the difference of two
/// powers by at least 2 widths the ratio leaves at most the promise over that. No weight is above the upper end.
fn ramp_error(low: f64, width: f64) -> f64 {
    let [_, _, ratio] = segment(low, width);
    (promise("percentile_ramp") * ratio.min(0.5 / width).max(1.3)).min(2.0 * (low + width))
}

/// Every term falls towards 1, so that the sum begins with the last color.
fn constant(map: &ColorMap, surface: Microsurface) -> Filter {
    let pieces = Pieces::new(map, |width, _| width < NARROW);
    let negative = |change: [f32; 4]| change.map(|channel| -channel);
    let mut body = format!("    let lambda = {};\n", lambda(surface));
    body += &format!("    var c = {};\n", color(map, pieces.last()));
    for kink in pieces.kinks.iter().filter(|kink| kink.position > 0.0) {
        let change = color(map, kink.change);
        body += &format!("    c += {change} * percentile_kink({}, lambda);\n", digits(bits(kink.position.into())));
    }
    let step = |at: f64, change: [f32; 4]| {
        format!("    c += {} * percentile_step({}, lambda);\n", color(map, negative(change)), digits(bits(at)))
    };
    for ramp in &pieces.ramps {
        let (low, high) = ends(ramp);
        if high < LOW {
            body += &step(high, ramp.change);
            continue;
        }
        let [bits, span, ratio] = segment(low, high - low);
        let change = color(map, ramp.change.map(|channel| (-f64::from(channel) * ratio) as f32));
        body += &format!("    c += {change} * percentile_ramp({}, {}, lambda);\n", digits(bits), digits(span));
    }
    for piece in pieces.steps.iter().filter(|piece| piece.position > 0.0) {
        body += &step(piece.position.into(), piece.change);
    }
    body += &returned(map, "c");
    if pieces.kinks.is_empty() && pieces.ramps.is_empty() && pieces.steps.is_empty() {
        body = format!("    return {};\n", color(map, pieces.base));
    }
    let bound = Bound::Guaranteed(bound(map, &pieces, surface));
    Filter { body, tables: Vec::new(), bound, trips: 1 }
}

fn digits(value: f64) -> String {
    number(value as f32)
}

/// The lower and the upper end of a ramp.
fn ends(ramp: &Ramp) -> (f64, f64) {
    (ramp.position.into(), f64::from(ramp.position) + f64::from(ramp.width))
}

/// What Λ moves shares by, times the total variation, what the terms may be off by, and the rounding of their sum.
fn bound(map: &ColorMap, pieces: &Pieces, surface: Microsurface) -> f32 {
    let (kink, step) = (promise("percentile_kink"), promise("percentile_step"));
    let bound = |channel: usize| {
        let size = |change: [f32; 4]| f64::from(change[channel].abs());
        let mut error = pieces.misfit(channel);
        let mut sum = f64::from(pieces.last()[channel].abs());
        let mut add = |size: f64, reach: f64, promised: f64| {
            sum += size * reach;
            error += size * promised + ROUNDING * (3.0 * size * reach + sum);
        };
        for piece in &pieces.kinks {
            let at = f64::from(piece.position);
            add(size(piece.change), 0.5 * at * at, kink);
        }
        for piece in &pieces.ramps {
            let (low, high) = ends(piece);
            add(size(piece.change), high, ramp_error(low, high - low) + if high < LOW { LOW } else { 0.0 });
        }
        for piece in &pieces.steps {
            add(size(piece.change), piece.position.into(), step);
        }
        error
    };
    let own = (0..4).map(bound).fold(0.0, f64::max);
    (variation(map) * share_error(surface) + own) as f32
}

fn dynamic(map: &ColorMap, surface: Microsurface) -> Filter {
    let table = knots::table(map, |index, knot| {
        let low = f64::from(knot.position);
        let [span, ratio] = map.knots().get(index + 1).map_or([0.0; 2], |next| {
            let [_, span, ratio] = segment(low, f64::from(next.position) - low);
            [span, ratio]
        });
        [bits(low), span, ratio, 0.0].map(|value| value as f32)
    });
    let body = format!("    return percentile_knots({}, knots){};\n", lambda(surface), swizzle(map));
    let own = knots::bound(map, promise("percentile_step"), |low, high| ramp_error(low, high - low));
    let bound = variation(map) * share_error(surface) + own;
    Filter { body, tables: vec![table], bound: Bound::Guaranteed(bound as f32), trips: map.knots().len() }
}
