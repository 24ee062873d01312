//! The tier that reads a table over mean, deviation and skewness of the visible heights.

use super::surface::{clamped, step_error, visible, Microsurface};
use super::tier::{self, HeightTier, REACH};
use super::variation;
use crate::accuracy::{Bound, Ranges};
use crate::filter::texture::{bends, number, swizzle, Filter};
use crate::table::grid::{Axis, Spacing};
use crate::table::volume::{bake, Axes};
use crate::transfer::color_map::{ColorMap, Colors};

/// Nodes along mean, deviation and skewness. Rows and slices stand in `wgsl/filter/height.wgsl` too.
const NODES: [usize; 3] = [256, 32, 4];

/// The skewness of heights at a Λ of 1e4, up to which the moments are promised.
const SKEWEST: f64 = 0.862467;

/// The filter by the table, for any map.
pub(crate) fn skewed(map: &ColorMap, colors: Colors, surface: Microsurface, ranges: Ranges) -> Filter {
    let axes = axes(map, colors, surface, ranges);
    let floor = tier::floor(HeightTier::Skewed, ranges);
    let table = bake("table", &map.reference(), axes, floor.into());
    let Axes { means, deviations, .. } = axes;
    // Texel centers: the first node half a texel inside, the last as far from the other edge.
    let [per_mean, per_root] = [(means, means.high - means.low), (deviations, deviations.high.sqrt())]
        .map(|(axis, span)| (1.0 - 1.0 / axis.count as f64) / span);
    let origin = 0.5 / means.count as f64 - per_mean * means.low;
    let [origin, per_mean, per_root] = [origin, per_mean, per_root].map(|value| number(value as f32));
    let (statement, [mean, width]) = visible("heights_moments(seen + lit)", surface);
    let body = format!(
        "{}{statement}    return height_table({mean}, {width}, visible.z, {origin}, {per_mean}, {per_root}, table, \
         table_sampler){};\n",
        clamped(surface, ranges),
        swizzle(map)
    );
    let bound = 2.0 * f64::from(table.error) + step_error(HeightTier::Skewed, surface) * variation(map);
    Filter { body, bound: Bound::Estimated(bound as f32), tables: vec![table], trips: 1 }
}

/// Axes that hold what a scene's ranges can ask for. The means' axis of constant colors fits the map; that of dynamic
/// ones is the same for all maps.
fn axes(map: &ColorMap, colors: Colors, surface: Microsurface, ranges: Ranges) -> Axes {
    let (low, high) = (f64::from(ranges.mean.0), f64::from(ranges.mean.1));
    let (deviation, knots) = (f64::from(ranges.deviation), map.knots());
    let [first, last] = [knots[0], knots[knots.len() - 1]].map(|knot| f64::from(knot.position));
    let [count, rows, slices] = NODES;
    let means = match colors {
        // Noise may widen what is far above all else: the axis holds every mean that the ranges allow, or all colors.
        Colors::Constant if surface.perturbed => {
            let far = (high + f64::from(REACH) * deviation).min(last + 4.0 * deviation);
            let near = low.max(first - 4.0 * deviation);
            Axis::fitted(near.min(high), far.max(low + deviation), count, &bends(map))
        }
        // Where means lie more than 2 deviations of all heights above these, the visible ones have at most half that
        // deviation, and 2.5 of all heights or, where Λ is 0, 4 beyond the map's end the color is that of the end.
        Colors::Constant => {
            let far = (last + 2.5 * deviation).max(high + 2.0 * deviation).min(last + 4.0 * deviation);
            let near = low.max(first - 4.0 * deviation);
            Axis::fitted(near.min(high), far.max(low + deviation), count, &bends(map))
        }
        Colors::Dynamic => Axis::round(low, high + f64::from(REACH) * deviation, count),
    };
    let axis = |high: f64, count: usize, spacing: Spacing| Axis { low: 0.0, high, count, spacing };
    Axes {
        means: means.in_f32(),
        deviations: axis(deviation, rows, Spacing::SquareRoot),
        skewnesses: axis(SKEWEST, slices, Spacing::Linear),
    }
}
