// C0: the mean of a color map C over a normal variable f with the mean and deviation that a footprint covers.
//
// A piecewise-linear map is a sum of kinks max(f − t, 0), narrow ramps and steps, and the mean of a sum is the sum of
// the means: a scene writes one line a knot. `distance` is always mean − t. Deviations below 1e-6 count as 1e-6.

/// Mean of the kink max(f − t, 0).
///
/// Source: Heitz et al. 2014, "Filtering Non-Linear Transfer Functions on Surfaces", equation 9, of max(f − t, 0).
/// Domain: distance in [-1.5, 1.5], deviation log in [1e-6, 0.5].
/// Error: 2e-7 absolute; half a deviation times the error of `normal_excess`, and f32 rounding.
fn texture_kink(distance: f32, deviation: f32) -> f32 {
    let s = max(deviation, 1e-6);
    return max(distance, 0.0) + s * normal_excess(abs(distance) * (1.0 / s));
}

/// Mean of the kink max(f − t, 0), by the shorter polynomial.
///
/// Source: as `texture_kink`.
/// Domain: distance in [-1.5, 1.5], deviation log in [1e-6, 0.5].
/// Error: 6e-7 absolute; 1e-6 deviations, and f32 rounding.
fn texture_kink_fast(distance: f32, deviation: f32) -> f32 {
    let s = max(deviation, 1e-6);
    return max(distance, 0.0) + s * normal_excess_fast(abs(distance) * (1.0 / s));
}

/// Mean of the step f > t.
///
/// Source: Heitz et al. 2014, equation 9, for a unit step; the threshold of "Filtering 101", its weights summing to 1.
/// Domain: distance in [-1.5, 1.5], deviation log in [1e-6, 0.5].
/// Error: 4e-7 absolute; that of `normal_cdf`.
fn texture_step(distance: f32, deviation: f32) -> f32 {
    return normal_cdf(distance / max(deviation, 1e-6));
}

/// Mean of the step f > t, by one exponential and one reciprocal.
///
/// Source: as `texture_step`.
/// Domain: distance in [-1.5, 1.5], deviation log in [1e-6, 0.5].
/// Error: 2e-5 absolute; of the fit.
fn texture_step_fast(distance: f32, deviation: f32) -> f32 {
    return normal_cdf_fast(distance / max(deviation, 1e-6));
}

/// Mean of the ramp that rises from 0 at t to 1 at t + width: clamp((f − t)/width, 0, 1).
///
/// The difference of two kinks divided by the width, which cancels when the ramp is much narrower than the deviation:
/// there the ramp is a step at its middle, with an error of (width/deviation)²/24 · max|φ'|.
///
/// Source: Heitz et al. 2014, equation 9, for a ramp.
/// Domain: distance in [-1.5, 1.5], width log in [1e-5, 1], deviation log in [1e-6, 0.5].
/// Error: 8e-6 absolute; 4.0e-6 of the step that replaces narrow ramps, rounding before it does.
fn texture_ramp(distance: f32, width: f32, deviation: f32) -> f32 {
    let s = max(deviation, 1e-6);
    let r = 1.0 / s;
    let past = distance - width;
    if width * r < 0.02 {
        // From both ends: a compiler may fold half a width into t, which may be too far from 0 to hold it.
        return normal_cdf(0.5 * (distance + past) * r);
    }
    let excess = normal_excess(abs(distance) * r) - normal_excess(abs(past) * r);
    return clamp((clamp(distance, 0.0, width) + s * excess) / width, 0.0, 1.0);
}

/// Mean and deviation of a part of something that deviates by `whole` when all of that is drawn together about `middle`
/// until it deviates by `most`: the same where it does not deviate more.
///
/// A part that lies some of its deviations to one side of all edges still does.
///
/// Source: the definition.
/// Domain: part in [-2, 2], whole log in [0.001, 1000], middle in [-1, 1], most log in [0.001, 1].
/// Error: 4e-7 absolute; f32 rounding.
fn texture_narrowed(part: vec2f, whole: f32, middle: f32, most: f32) -> vec2f {
    let share = clamp(most / max(whole, 1e-18), 0.0, 1.0);
    return select(part, vec2f(middle + share * (part.x - middle), share * part.y), whole > most);
}

/// Mean of the map whose knots are the texels of a texture: rows of left colors, right colors and positions, by
/// position.
///
/// Segment by segment and edge by edge, each a weight times a difference of colors, so that the knots may change
/// without the text; the result is clamped to the knots' colors. Costs a ramp a segment and a step a hard edge.
///
/// Source: Heitz et al. 2014, equation 9, for a piecewise-linear map.
/// Domain: mean in [-0.5, 1.5], deviation log in [1e-6, 0.5].
/// Error: 1.2e-5 absolute; that of `texture_ramp`, for up to 32 knots with colors in [0, 1].
fn texture_knots(mean: f32, deviation: f32, knots: texture_2d<f32>) -> vec4f {
    let last = i32(textureDimensions(knots).x) - 1;
    var left = textureLoad(knots, vec2i(0, 0), 0);
    var position = textureLoad(knots, vec2i(0, 2), 0).x;
    var sum = left;
    var low = left;
    var high = left;
    for (var i = 0; i <= last; i++) {
        let right = textureLoad(knots, vec2i(i, 1), 0);
        let distance = mean - position;
        if any(right != left) {
            sum += (right - left) * texture_step(distance, deviation);
        }
        low = min(low, min(left, right));
        high = max(high, max(left, right));
        if i < last {
            left = textureLoad(knots, vec2i(i + 1, 0), 0);
            let next = textureLoad(knots, vec2i(i + 1, 2), 0).x;
            sum += (left - right) * texture_ramp(distance, next - position, deviation);
            position = next;
        }
    }
    return clamp(sum, low, high);
}

/// Mean of a map from a table of means: over the mean from `low` to `high` and over the cube root of the deviation from
/// 0 to `reach`. Values outside read the table's border.
///
/// Source: Heitz et al. 2014, section 4.2, with the deviation's axis by its cube root.
/// Domain: mean in [-0.25, 1.25], deviation in [0, 0.5], low in [-0.25, -0.25], high in [1.4533333, 1.4533333],
/// reach in [0.5, 0.5].
/// Error: 4e-3 absolute; bilinear interpolation of 512 × 16 nodes for matplotlib's terrain.
fn texture_table(
    mean: f32, deviation: f32, low: f32, high: f32, reach: f32, table: texture_2d<f32>, table_sampler: sampler,
) -> vec4f {
    let size = vec2f(textureDimensions(table));
    let at = vec2f(grid_linear(mean, low, high, size.x), grid_cube_root(deviation, reach, size.y));
    return textureSampleLevel(table, table_sampler, at, 0.0);
}

/// Mean of a map from a table of means over distributions between the ends `low` and `high`: over the mean between
/// these, and over the square root of the deviation's share of the largest that values there have. Means outside read
/// the border, larger deviations the last row.
///
/// Source: Heitz et al. 2014, section 4.2, with the variance over that of values at both ends, (mean − low)(high −
/// mean).
/// Domain: mean in [-0.25, 1.25], deviation in [0, 0.6], low in [0, 0], high in [1, 1].
/// Error: 5e-3 absolute; bilinear interpolation of 512 × 16 nodes for matplotlib's terrain over Beta distributions.
fn texture_bounded_table(
    mean: f32, deviation: f32, low: f32, high: f32, table: texture_2d<f32>, table_sampler: sampler,
) -> vec4f {
    let size = vec2f(textureDimensions(table));
    let m = clamp(mean, low, high);
    let largest = sqrt(max((m - low) * (high - m), 1e-30));
    let part = sqrt(clamp(deviation / largest, 0.0, 1.0));
    let at = vec2f(grid_linear(m, low, high, size.x), grid_linear(part, 0.0, 1.0, size.y));
    return textureSampleLevel(table, table_sampler, at, 0.0);
}
