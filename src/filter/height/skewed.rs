//! The tier that reads a table over mean, deviation and skewness of the visible heights.

use super::surface::{clamped, lambda, step_error, visible, Microsurface};
use super::tier::{self, HeightTier, REACH};
use super::variation;
use crate::accuracy::{Bound, Ranges};
use crate::filter::texture::{bends, number, swizzle, Filter};
use crate::table::bake::Plan;
use crate::table::grid::{Axis, Spacing};
use crate::transfer::color_map::{ColorMap, Colors};

/// Nodes along the mean.
pub(crate) const COLUMNS: usize = 256;

/// Those from which an accuracy chooses.
pub(crate) const SIZES: [usize; 3] = [128, COLUMNS, 512];

/// Nodes along the deviation: they stand in `wgsl/filter/height.wgsl` too.
const ROWS: usize = 32;

/// The filter by the table, for any map; it is not baked where its bound is sure to be above `most`.
pub(crate) fn skewed(
    map: &ColorMap,
    colors: Colors,
    surface: Microsurface,
    columns: usize,
    ranges: Ranges,
    most: f32,
) -> Filter {
    let step = step_error(HeightTier::Skewed, surface, tier::rounded(HeightTier::Skewed, ranges)) * variation(map);
    let means = means(map, colors, surface, columns, ranges);
    let deviations = Axis { low: 0.0, high: ranges.deviation.into(), count: ROWS, spacing: Spacing::SquareRoot };
    let floor = tier::floor(HeightTier::Skewed, ranges);
    let judged = (means.low as f32, means.high as f32);
    let most = 0.5 * (most - step as f32);
    let table = Plan { map: &map.reference(), means, deviations, judged }.of_heights("table", floor.into(), most);
    // Texel centers: the first node half a texel inside, the last as far from the other edge.
    let [per_mean, per_root] = [(means, means.high - means.low), (deviations, deviations.high.sqrt())]
        .map(|(axis, span)| (1.0 - 1.0 / axis.count as f64) / span);
    let origin = 0.5 / means.count as f64 - per_mean * means.low;
    let [origin, per_mean, per_root] = [origin, per_mean, per_root].map(|value| number(value as f32));
    let (statement, [mean, width]) = visible(&format!("heights_moments({})", lambda(surface)), surface);
    let body = format!(
        "{}{statement}    return height_table({mean}, {width}, visible.z, {origin}, {per_mean}, {per_root}, table, \
         table_sampler){};\n",
        clamped(surface, ranges),
        swizzle(map)
    );
    let bound = 2.0 * f64::from(table.error) + step;
    Filter { body, bound: Bound::Estimated(bound as f32), tables: vec![table], trips: 1 }
}

/// An axis of all means that a scene's ranges can ask for, but for those where the color is that of the map's end. That
/// of constant colors fits the map; that of dynamic ones is the same for all maps.
fn means(map: &ColorMap, colors: Colors, surface: Microsurface, columns: usize, ranges: Ranges) -> Axis {
    let (low, high) = (f64::from(ranges.mean.0), f64::from(ranges.mean.1));
    let (deviation, knots) = (f64::from(ranges.deviation), map.knots());
    let highest = high + f64::from(REACH) * deviation;
    if colors == Colors::Dynamic {
        return Axis::round(low, highest, columns).in_f32();
    }
    let [first, last] = [knots[0], knots[knots.len() - 1]].map(|knot| f64::from(knot.position));
    // Four deviations of all heights from the map the color is that of its end. Visible heights whose mean is two of
    // them above that of all have at most half the deviation, and need to lie 2.5 of them beyond; with noise they may
    // have more.
    let skewed = (last + 2.5 * deviation).max(high + 2.0 * deviation).min(highest);
    let above = if surface.perturbed { highest } else { skewed };
    let far = above.min(last + 4.0 * deviation).max(low + deviation);
    let near = low.max(first - 4.0 * deviation).min(high);
    Axis::fitted(near, far, columns, &bends(map)).in_f32()
}
