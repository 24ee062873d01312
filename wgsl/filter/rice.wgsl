// Cs of maps of the steepness |s|: means over normal distributions of slopes, from a table of means over distributions
// of Rice.
//
// The lengths of slopes of a round normal distribution of the deviation σ, whose mean is ν long, have the distribution
// of Rice of ν and σ: one read. A long one is a sum of round ones on its major axis, as in `rounds.wgsl`.

/// Mean of a map over the lengths of slopes of a normal distribution, by five distributions of Rice from a table of
/// means: over ν from `low` to `high` and over the cube root of σ from 0 to `reach`.
///
/// Source: `rounds_five`.
/// Domain: mean in [-1, 1], covariance psd(0.15, 0.3, 0.5), low in [0, 0], high in [2.125, 2.125], reach in [0.4, 0.4].
/// Error: 2e-3 absolute; of the table and the shape, for a ramp and axes of ratios up to 3.
fn rice_five(
    mean: vec2f, covariance: vec3f, low: f32, high: f32, reach: f32, table: texture_2d<f32>, table_sampler: sampler,
) -> vec4f {
    let m = clamp(mean, vec2f(-1e18), vec2f(1e18));
    let stretch = footprint_stretched(clamp(covariance, vec3f(-1e18), vec3f(1e18)), rounds_five_least);
    let arms = rounds_five(stretch.part);
    let s = stretch.deviation;
    let middle = texture_table(length(m), s, low, high, reach, table, table_sampler);
    var near = vec4f();
    var far = vec4f();
    for (var side = -1.0; side < 2.0; side += 2.0) {
        near += texture_table(length(m + side * arms.x * stretch.away), s, low, high, reach, table, table_sampler);
        far += texture_table(length(m + side * arms.y * stretch.away), s, low, high, reach, table, table_sampler);
    }
    return mix(middle, 0.5 * near, 2.0 * arms.z) + arms.w * (far - 2.0 * middle);
}

/// Three parts of slopes: the middle one, then the one before it along `footprint_direction` and the one behind it.
struct rice_parts {
    /// The mean of |s|² over each.
    squares: vec3f,
    /// The variance of |s|² over the square of that mean.
    shares: vec3f,
    /// The weight of either of the two outer ones.
    weight: f32,
}

/// The smallest part of the major deviation that the parts of `rice_split` are narrowed to.
const rice_split_least = 0.55;

/// Three parts of the slopes that a view sees, for whose lengths distributions of Rice stand.
///
/// The visible slopes, a normal distribution with their mean and covariance, are cut across their major axis into three
/// parts, narrower along it by the factor q but not below the minor deviation. Skewness along the major axis moves the
/// middle part against the others by as much as keeps the third moment, up to a fifth of their distance; that across it
/// is in the variances of |s|²:
///   B = 2 (V² + F²) + 4 (p² V + r² F + r κ),
/// with the part's mean (p, r) and variances V and F along and across the axis, and the third moment κ across it.
///
/// Covariances are scaled to variances of 1e12 at most; components of mean slopes beyond 1e6 count as that.
///
/// Source: `rounds_three`; the least part and the limit of the shift are those with the least largest
/// error of a step for axes of ratios up to 2, which `spirv-tests/tests/slope/steepness.rs` measures.
/// Domain: view unit upper, mean_slope in [-0.2, 0.2], covariance psd(0.15, 0.3, 0.5).
/// Error: 8e-3 absolute; of `rounds_three`, where the deviations of the visible slopes differ by more than a tenth.
fn rice_split(view: vec3f, mean_slope: vec2f, covariance: vec3f) -> rice_parts {
    let limited = covariance * (2.5e11 / clamp(0.25 * max(covariance.x, covariance.z), 2.5e11, 8e37));
    let factor = slopes_factor(view, limited);
    let slope = clamp(mean_slope, vec2f(-1e6), vec2f(1e6));
    let parameter = slopes_parameter(view, slope, factor);
    let m = slopes_moments(parameter);
    let visible = slopes_covariance(factor, m.y);
    let d = footprint_deviations(visible);
    let along = footprint_direction(visible);
    let aside = vec2f(-along.y, along.x);
    let p = slope + m.x * factor.xy;
    let place = vec2f(dot(along, p), dot(aside, p));
    let lean = vec2f(dot(along, factor.xy), dot(aside, factor.xy));
    let third = slopes_skewness(parameter) * m.y * sqrt(m.y) * lean * lean * lean;
    let part = clamp(d.y / max(d.x, 1e-30), rice_split_least, 1.0);
    let sides = rounds_three(part);
    let away = sqrt(1.0 - part * part) * sides.x * d.x;
    // Nearly round slopes are hardly cut: no shift keeps a third moment there.
    let lever = max(max(sides.y * away * away, 0.02 * d.x * d.x), 1e-36);
    let shift = clamp(third.x / (6.0 * lever), -0.2 * away, 0.2 * away);
    let back = shift * 2.0 * sides.y / (1.0 - 2.0 * sides.y);
    let whole = part * part * d.x * d.x;
    // Less what the shift adds.
    let v = vec2f(max(whole - shift * back, 0.25 * whole), d.y * d.y);
    let at = place.x + vec3f(-back, shift - away, shift + away);
    let mean = at * at + (place.y * place.y + v.x + v.y);
    let spread = 4.0 * v.x * at * at + (2.0 * dot(v, v) + 4.0 * place.y * (place.y * v.y + third.y));
    let inverse = 1.0 / max(mean, vec3f(1e-18));
    return rice_parts(mean, spread * inverse * inverse, sides.y);
}

/// Mean of a map over the lengths of slopes that a view sees, by three distributions of Rice from a table of means as
/// in `rice_five`.
///
/// Source: `rice_split` and `steepness_rice`.
/// Domain: view unit upper, mean_slope in [-0.2, 0.2], covariance psd(0.15, 0.3, 0.5), low in [0, 0],
///   high in [1.8214285, 1.8214285], reach in [0.4, 0.4].
/// Error: 3e-2 absolute; of the shape, for a ramp and axes of ratios up to 3.
fn rice_three(
    view: vec3f, mean_slope: vec2f, covariance: vec3f, low: f32, high: f32, reach: f32, table: texture_2d<f32>,
    table_sampler: sampler,
) -> vec4f {
    let parts = rice_split(view, mean_slope, covariance);
    let m = steepness_rice(parts.squares.x, parts.shares.x);
    let b = steepness_rice(parts.squares.y, parts.shares.y);
    let c = steepness_rice(parts.squares.z, parts.shares.z);
    let outer = texture_table(b.x, b.y, low, high, reach, table, table_sampler)
        + texture_table(c.x, c.y, low, high, reach, table, table_sampler);
    return mix(texture_table(m.x, m.y, low, high, reach, table, table_sampler), 0.5 * outer, 2.0 * parts.weight);
}
