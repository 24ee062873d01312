//! The body of a filter that adds up the means of a map's pieces, a statement each.

use super::texture::{color, number, returned, Filter, REACH};
use crate::accuracy::{Bound, Ranges};
use crate::transfer::color_map::ColorMap;
use crate::transfer::pieces::Pieces;

/// `mean - 0.45` or `mean + 0.45`.
pub(super) fn distance(mean: &str, position: f32) -> String {
    if position == 0.0 {
        return mean.to_owned();
    }
    let sign = if position < 0.0 { '+' } else { '-' };
    format!("{mean} {sign} {}", number(position.abs()))
}

/// The filter of one color.
pub(super) fn constant(map: &ColorMap, base: [f32; 4]) -> Filter {
    let body = format!("    return {};\n", color(map, base));
    Filter { body, tables: Vec::new(), bound: Bound::Guaranteed(0.0), trips: 1 }
}

/// A mean that multiplies no slope out of bounds, infinite ones included: far outside the knots the map is constant.
pub(super) fn placed(map: &ColorMap, ranges: Ranges, mean: &str) -> String {
    let knots = map.knots();
    let far = REACH * ranges.deviation;
    let ends = (number(knots[0].position - far), number(knots[knots.len() - 1].position + far));
    format!("clamp({mean}, {}, {})", ends.0, ends.1)
}

/// The sum of the pieces' means by the functions of a kink, a ramp and a step, with what they take last.
pub(super) fn terms(map: &ColorMap, pieces: &Pieces, functions: [&str; 3], last: &str) -> String {
    let [of_kink, of_ramp, of_step] = functions;
    let mut body = format!("    var c = {};\n", color(map, pieces.base));
    for kink in &pieces.kinks {
        let at = distance("m", kink.position);
        body += &format!("    c += {} * {of_kink}({at}, {last});\n", color(map, kink.change));
    }
    for ramp in &pieces.ramps {
        let (at, width) = (distance("m", ramp.position), number(ramp.width));
        body += &format!("    c += {} * {of_ramp}({at}, {width}, {last});\n", color(map, ramp.change));
    }
    for step in &pieces.steps {
        let at = distance("m", step.position);
        body += &format!("    c += {} * {of_step}({at}, {last});\n", color(map, step.change));
    }
    body + &returned(map, "c")
}
