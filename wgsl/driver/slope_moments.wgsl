// Mean and covariance of slopes over a footprint, read from a pyramid of (mean x, mean y, F.xx, F.yy) and one of F.yx:
// the covariance is F Fᵀ, a covariance whatever the rounding.
//
// Level 0 holds the slopes themselves, with no covariance. Levels and kernels are those of `moments_read`. Factors do
// not interpolate and central covariances do so only with what the means vary: within a level and between levels the
// covariance is the mean of the covariances and the covariance of the means.
//
// Positions are texture coordinates, covariances of footprints (xx, xy, yy) in texels² of level 0.

/// The four texels around a position: (x, y), (x + 1, y), (x, y + 1), (x + 1, y + 1).
struct slope_moments_cell {
    means_x: vec4f,
    means_y: vec4f,
    factors_xx: vec4f,
    factors_yx: vec4f,
    factors_yy: vec4f,
    fraction: vec2f,
}

/// Mean slope and covariance (xx, xy, yy) of slopes.
struct slope_moments {
    mean: vec2f,
    covariance: vec3f,
}

/// Reads the four texels of a level around a position, with the position's place between their centers.
///
/// Where rounding moves the position over a texel's center, the cell is the one on the other side.
///
/// Source: the definition of bilinear filtering.
/// Domain: position in [-1, 2], level integer in [0, 9].
/// Error: 2e-6 absolute; the fraction, from the rounding of position times size: in proportion to the size, up to 16.
fn slope_moments_texels(
    slopes: texture_2d<f32>,
    slopes_cross: texture_2d<f32>,
    slopes_sampler: sampler,
    position: vec2f,
    level: i32,
) -> slope_moments_cell {
    let size = moments_size(slopes, level);
    let at = position * size - 0.5;
    let corner = floor(at);
    let low = (corner + 0.5) / size;
    let high = (corner + 1.5) / size;
    let l = f32(level);
    let a = textureSampleLevel(slopes, slopes_sampler, low, l);
    let b = textureSampleLevel(slopes, slopes_sampler, vec2f(high.x, low.y), l);
    let c = textureSampleLevel(slopes, slopes_sampler, vec2f(low.x, high.y), l);
    let d = textureSampleLevel(slopes, slopes_sampler, high, l);
    let yx = vec4f(
        textureSampleLevel(slopes_cross, slopes_sampler, low, l).x,
        textureSampleLevel(slopes_cross, slopes_sampler, vec2f(high.x, low.y), l).x,
        textureSampleLevel(slopes_cross, slopes_sampler, vec2f(low.x, high.y), l).x,
        textureSampleLevel(slopes_cross, slopes_sampler, high, l).x,
    );
    return slope_moments_cell(
        vec4f(a.x, b.x, c.x, d.x),
        vec4f(a.y, b.y, c.y, d.y),
        vec4f(a.z, b.z, c.z, d.z),
        yx,
        vec4f(a.w, b.w, c.w, d.w),
        at - corner,
    );
}

/// Mean and covariance of four texels mixed by their bilinear weights.
///
/// Means are taken relative to the first texel: equal means are returned unchanged and add no covariance.
///
/// Source: law of total covariance.
/// Domain: cell.means_x in [-1, 1], cell.means_y in [-1, 1], cell.factors_xx in [0, 0.5],
/// cell.factors_yx in [-0.5, 0.5], cell.factors_yy in [0, 0.5], cell.fraction in [0, 1].
/// Error: 4e-7 absolute; f32 rounding.
fn slope_moments_mixed(cell: slope_moments_cell) -> slope_moments {
    let f = clamp(cell.fraction, vec2f(), vec2f(1.0));
    let weights = vec4f((1.0 - f.x) * (1.0 - f.y), f.x * (1.0 - f.y), (1.0 - f.x) * f.y, f.x * f.y);
    let mean = vec2f(
        cell.means_x.x + dot(weights, cell.means_x - cell.means_x.x),
        cell.means_y.x + dot(weights, cell.means_y - cell.means_y.x),
    );
    let x = cell.means_x - mean.x;
    let y = cell.means_y - mean.y;
    let xx = cell.factors_xx * cell.factors_xx + x * x;
    let xy = cell.factors_xx * cell.factors_yx + x * y;
    let yy = cell.factors_yx * cell.factors_yx + cell.factors_yy * cell.factors_yy + y * y;
    return slope_moments(mean, vec3f(dot(weights, xx), dot(weights, xy), dot(weights, yy)));
}

/// Mean and covariance of slopes over a footprint that is about round. The pyramid must reach 1×1.
///
/// The two levels whose kernels enclose half the footprint's trace are mixed; footprints wider than the last level read
/// the whole map. A footprint of zero returns the slope at the position and no covariance, a map of one slope that and
/// none. The covariance is positive semi-definite in f32, too: its correlation is at most 1 - 5e-7.
///
/// Source: law of total covariance over the mixture of kernels of `moments_read`.
/// Domain: position in [-1, 2], footprint psd(0.001, 100, 0.9).
/// Error: 2e-6 absolute; for slopes in [-1, 1] and sizes up to 16: position times size is rounded.
fn slope_moments_read(
    slopes: texture_2d<f32>,
    slopes_cross: texture_2d<f32>,
    slopes_sampler: sampler,
    position: vec2f,
    footprint: vec3f,
) -> slope_moments {
    let variance = clamp(0.5 * (footprint.x + footprint.z), 0.0, 1e36);
    // A texel of level l is 2^l wide or wider, but less than twice that: one step back is enough.
    var level = i32(0.5 * log2(max(4.0 * variance, 1.0)));
    level -= select(0, 1, moments_kernel(slopes, level) > variance);
    let low = moments_kernel(slopes, level);
    let high = moments_kernel(slopes, level + 1);
    let weight = clamp((variance - low) / max(high - low, 1e-30), 0.0, 1.0);

    let fine = slope_moments_mixed(slope_moments_texels(slopes, slopes_cross, slopes_sampler, position, level));
    let coarse = slope_moments_mixed(slope_moments_texels(slopes, slopes_cross, slopes_sampler, position, level + 1));
    let apart = coarse.mean - fine.mean;
    let own = fine.covariance * f32(level > 0); // at level 0 the slope itself, a single value
    let between = weight * (1.0 - weight) * vec3f(apart.x * apart.x, apart.x * apart.y, apart.y * apart.y);
    let sum = mix(own, coarse.covariance, weight) + between;
    // Subnormal variances go along with nothing: their product has no digits.
    let most = max(0.9999995 * sqrt(max(sum.x, 0.0)) * sqrt(max(sum.z, 0.0)) - 1.2e-38, 0.0);
    return slope_moments(fine.mean + weight * apart, vec3f(sum.x, clamp(sum.y, -most, most), sum.z));
}
