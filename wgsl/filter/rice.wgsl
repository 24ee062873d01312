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
    let d = min(footprint_deviations(covariance), vec2f(1e18));
    let part = clamp(d.y / max(d.x, 1e-30), rounds_five_least, 1.0);
    let arms = rounds_five(part);
    let away = sqrt(1.0 - part * part) * d.x * footprint_direction(covariance);
    let s = part * d.x;
    let middle = texture_table(length(m), s, low, high, reach, table, table_sampler);
    var near = vec4f();
    var far = vec4f();
    for (var side = -1.0; side < 2.0; side += 2.0) {
        near += texture_table(length(m + side * arms.x * away), s, low, high, reach, table, table_sampler);
        far += texture_table(length(m + side * arms.y * away), s, low, high, reach, table, table_sampler);
    }
    return mix(middle, 0.5 * near, 2.0 * arms.z) + arms.w * (far - 2.0 * middle);
}
