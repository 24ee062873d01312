// Cs of maps of the whole slope: means over normal distributions of slopes, from a table of those over round ones.
//
// The table's columns and rows are the components of the mean slope, evenly in s / (1 + bend |s|), with `per_slope` of
// the texture a unit of that: denser about 0, so that they may reach all slopes. Its 20 slices are deviations,
// from 0 on evenly in the logarithm of 1 + deviation · per_deviation, with `per_octave` of the texture a doubling of
// that. Means and deviations beyond read the border. The sampler is linear and clamps at the edges.
//
// A long distribution is a sum of round ones on its major axis, all of the deviation s of its minor one: with the part
// q = s / a of the major deviation a and z = √(1 − q²), they stand at multiples of z a from the mean.

/// The smallest part of three round distributions, which widen the minor axis of longer ones to that.
const slope_map_sides_least = 0.294;

/// The smallest part of five.
const slope_map_arms_least = 0.16;

/// Mean of a map over a round normal distribution of slopes, from its table.
///
/// Source: Heitz et al. 2014, "Filtering Non-Linear Transfer Functions on Surfaces", section 5.2, with an axis for the
/// deviation in place of a pyramid.
/// Domain: mean in [-1.5, 1.5], deviation log in [0.1, 0.5], per_slope in [0.396875, 0.396875], bend in [0.4, 0.4],
///   per_deviation in [24, 24], per_octave in [0.25672624, 0.25672624].
/// Error: 2e-3 absolute; trilinear interpolation of 128 × 128 × 20 nodes for a random map of 2 × 2 cells.
fn slope_map_read(
    mean: vec2f, deviation: f32, per_slope: f32, bend: f32, per_deviation: f32, per_octave: f32,
    table: texture_3d<f32>, table_sampler: sampler,
) -> vec4f {
    let m = clamp(mean, vec2f(-1e18), vec2f(1e18));
    let at = clamp(0.5 + per_slope * m / (1.0 + bend * abs(m)), vec2f(), vec2f(1.0));
    // From the center of the first slice, ½/20.
    let slice = 0.025 + per_octave * log2(1.0 + per_deviation * clamp(deviation, 0.0, 1e18));
    return textureSampleLevel(table, table_sampler, vec3f(at, min(slice, 1.0)), 0.0);
}

/// Multiple of z a at which a round distribution stands on either side of a third on the mean, and the weight of each.
///
/// A step is off by up to 3.8e-2, 9.6e-3 for half and 2e-3 for two thirds of the major deviation.
///
/// Source: a fit of the least largest error of a step, found for each part by exchange.
/// Domain: part in [0.294, 0.6].
/// Error: 1e-2 absolute; from the pair with that error.
fn slope_map_sides(part: f32) -> vec2f {
    let q = clamp(part, slope_map_sides_least, 1.0);
    let place = 0.87520325 + q * (1.2362045 + q * (0.037185849 * q - 0.44130012));
    let weight = 0.34342829 + q * (q * (0.0060524207 * q + 0.074985462) - 0.25107048);
    return vec2f(place, weight);
}

/// Multiples of z a at which the inner and the outer pair of five round distributions stand, and the weights of each of
/// both.
///
/// A step is off by up to 3e-2, 1.3e-2 for a quarter and 1.3e-3 for half of the major deviation.
///
/// Source: as `slope_map_sides`, fit where the error is within 5e-4 of the least.
/// Domain: part in [0.16, 0.35].
/// Error: 6e-3 absolute; from the pairs with that error; above 0.35 many share it nearly.
fn slope_map_arms(part: f32) -> vec4f {
    let q = clamp(part, slope_map_arms_least, 1.0);
    let inner = 0.54051134 + q * (0.85673044 + q * (1.0010218 - 1.4592677 * q));
    let outer = 1.2564517 + q * (1.6980425 + q * (1.5227531 - 2.3572259 * q));
    let near = 0.19046403 + q * (0.34467645 + q * (0.36469951 * q - 0.64947629));
    let far = 0.20401432 + q * (q * (0.4133928 - 0.057390819 * q) - 0.50296293);
    return vec4f(inner, outer, near, far);
}

/// Mean of a map over a normal distribution of slopes, by the round one of the same area.
///
/// Source: the definition, √(a s).
/// Domain: mean in [-1.5, 1.5], covariance psd(0.2, 0.4, 0.5), per_slope in [0.396875, 0.396875], bend in [0.4, 0.4],
///   per_deviation in [24, 24], per_octave in [0.25672624, 0.25672624].
/// Error: 8e-2 absolute; of the shape, for a random map of 2 × 2 cells and axes of ratios up to 3.
fn slope_map_one(
    mean: vec2f, covariance: vec3f, per_slope: f32, bend: f32, per_deviation: f32, per_octave: f32,
    table: texture_3d<f32>, table_sampler: sampler,
) -> vec4f {
    let d = footprint_deviations(covariance);
    let s = sqrt(d.x) * sqrt(d.y);
    return slope_map_read(mean, s, per_slope, bend, per_deviation, per_octave, table, table_sampler);
}

/// Mean of a map over a normal distribution of slopes, by three round ones on its major axis.
///
/// Source: `slope_map_sides`.
/// Domain: mean in [-1.5, 1.5], covariance psd(0.2, 0.4, 0.5), per_slope in [0.396875, 0.396875], bend in [0.4, 0.4],
///   per_deviation in [24, 24], per_octave in [0.25672624, 0.25672624].
/// Error: 6e-3 absolute; of the shape, for a random map of 2 × 2 cells and axes of ratios up to 3.
fn slope_map_three(
    mean: vec2f, covariance: vec3f, per_slope: f32, bend: f32, per_deviation: f32, per_octave: f32,
    table: texture_3d<f32>, table_sampler: sampler,
) -> vec4f {
    let d = footprint_deviations(covariance);
    let part = clamp(d.y / max(d.x, 1e-30), slope_map_sides_least, 1.0);
    let sides = slope_map_sides(part);
    let away = sqrt(1.0 - part * part) * sides.x * d.x * footprint_direction(covariance);
    let s = part * d.x;
    let middle = slope_map_read(mean, s, per_slope, bend, per_deviation, per_octave, table, table_sampler);
    let left = slope_map_read(mean - away, s, per_slope, bend, per_deviation, per_octave, table, table_sampler);
    let right = slope_map_read(mean + away, s, per_slope, bend, per_deviation, per_octave, table, table_sampler);
    return mix(middle, 0.5 * (left + right), 2.0 * sides.y);
}

/// Mean of a map over a normal distribution of slopes, by five round ones on its major axis.
///
/// Source: `slope_map_arms`.
/// Domain: mean in [-1.5, 1.5], covariance psd(0.2, 0.4, 0.5), per_slope in [0.396875, 0.396875], bend in [0.4, 0.4],
///   per_deviation in [24, 24], per_octave in [0.25672624, 0.25672624].
/// Error: 2e-3 absolute; of the shape, for a random map of 2 × 2 cells and axes of ratios up to 3.
fn slope_map_five(
    mean: vec2f, covariance: vec3f, per_slope: f32, bend: f32, per_deviation: f32, per_octave: f32,
    table: texture_3d<f32>, table_sampler: sampler,
) -> vec4f {
    let d = footprint_deviations(covariance);
    let part = clamp(d.y / max(d.x, 1e-30), slope_map_arms_least, 1.0);
    let arms = slope_map_arms(part);
    let away = sqrt(1.0 - part * part) * d.x * footprint_direction(covariance);
    let s = part * d.x;
    let middle = slope_map_read(mean, s, per_slope, bend, per_deviation, per_octave, table, table_sampler);
    var near = vec4f();
    var far = vec4f();
    for (var side = -1.0; side < 2.0; side += 2.0) {
        let inner = mean + side * arms.x * away;
        let outer = mean + side * arms.y * away;
        near += slope_map_read(inner, s, per_slope, bend, per_deviation, per_octave, table, table_sampler);
        far += slope_map_read(outer, s, per_slope, bend, per_deviation, per_octave, table, table_sampler);
    }
    return mix(middle, 0.5 * near, 2.0 * arms.z) + arms.w * (far - 2.0 * middle);
}
