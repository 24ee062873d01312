//! Cs of a map of the steepness |s|, such as rock on cliffs: one read from a table over the distributions of Rice, of
//! which one has the mean and the variance of |s|² over the slopes that a view sees.

use super::height::variation;
use super::shared::{statements, Shared};
use super::texture::{bends, color_type, number, swizzle, Filter};
use crate::accuracy::{Bound, Ranges};
use crate::table::grid::{Axis, Spacing};
use crate::table::rice::Plan;
use crate::transfer::color_map::{ColorMap, Colors};

/// Nodes along ν and along σ.
const NODES: [usize; 2] = [256, 32];

/// The largest error of a step for views above the horizon of the mean surface, whose slopes' covariance has axes of
/// ratios up to 2; `steps_of_steepness_keep_their_figures` in `spirv-tests/tests/slope/steepness.rs` measures it on the
/// device.
pub(crate) const STEP: f64 = 0.105;

/// The smallest σ that bounds hold from, as a part of the largest ν.
const FLOOR: f64 = 1e-3;

/// How far ν may lie beyond the mean slope's length, and how large σ may be, in deviations of the widest axis: 1.334
/// and 1.218, as the same test finds.
const REACH: f32 = 1.35;
const WIDTH: f32 = 1.25;

/// The smallest deviation that a bound holds from.
pub(crate) fn floor(ranges: Ranges) -> f32 {
    (FLOOR as f32 * highest(ranges)).max(1e-5)
}

fn highest(ranges: Ranges) -> f32 {
    ranges.mean.1.max(0.0) + REACH * ranges.deviation
}

/// The filter of a map of |s|.
pub(crate) fn filter(map: &ColorMap, colors: Colors, ranges: Ranges) -> Filter {
    let highest = f64::from(highest(ranges));
    let centers = match colors {
        Colors::Constant => Axis::fitted(0.0, highest, NODES[0], &bends(map)).in_f32(),
        Colors::Dynamic => Axis::round(0.0, highest, NODES[0]).in_f32(),
    };
    let widest = WIDTH * ranges.deviation;
    let deviations = Axis { low: 0.0, high: widest.into(), count: NODES[1], spacing: Spacing::CubeRoot };
    let reference = map.reference();
    let table = Plan { map: &reference, centers, deviations, highest, floor: floor(ranges).into() }.table("table");
    let body = format!(
        "    return texture_table(rice.x, rice.y, {}, {}, {}, table, table_sampler){};
",
        number(centers.low as f32),
        number(centers.high as f32),
        number(widest),
        swizzle(map)
    );
    let bound = 2.0 * f64::from(table.error) + STEP * variation(map);
    Filter { body, bound: Bound::Estimated(bound as f32), tables: vec![table], trips: 1 }
}

/// The distribution of Rice of the lengths that are seen.
pub(crate) fn shared() -> Vec<Shared> {
    let square = "steepness_moments(view, mean_slope, slope_covariance)";
    let rice = "steepness_rice(square.x, square.y)";
    vec![Shared::new("square", "vec2f", square), Shared::new("rice", "vec2f", rice)]
}

/// What `NAME_steepness` takes between the slopes' statistics and the tables, behind a comma.
pub(crate) const GIVEN: &str = ", view: vec3f";

/// `NAME_steepness` with a body.
pub(crate) fn glue(name: &str, map: &ColorMap, parameters: &str, body: &str) -> String {
    format!(
        "/// Mean color of `{name}` over the slopes that are seen.
///
/// Positions of the map are steepnesses, lengths of slopes: the tangent of a facet's angle with the plane across z.
/// Slopes have a mean and a covariance, xx, xy, yy.
///
/// `view` is a unit vector away from the surface, z along its normal; (0, 0, 1) counts all slopes alike, as over a flat
/// mesh with a map of normals. Below the horizon of the mean surface the color is that of the slopes that rise above
/// it.
fn {name}_steepness(mean_slope: vec2f, slope_covariance: vec3f{GIVEN}{parameters}) -> {} {{
{}{body}}}
",
        color_type(map),
        statements(&shared())
    )
}
