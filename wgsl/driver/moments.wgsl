// The tabulated driver: mean and deviation of an image's bilinear reconstruction f over a Gaussian footprint, read
// from a pyramid of (mean, deviation).
//
// Level 0 of the pyramid holds the image, with deviation 0: read bilinearly it is f itself, a kernel of no width. A
// texel of level l > 0 holds the moments of f over the area that it covers, so that reading the level bilinearly
// weights f by a box of the texel's width w with a tent of the same width: variance w²/12 + w²/6 = w²/4. Two levels
// are mixed so that the variance of the mixed kernel is the footprint's. Within a level and between levels moments
// combine by the law of total variance: the mean of the variances and the variance of the means.
//
// Positions are texture coordinates, covariances (xx, xy, yy) in texels² of level 0. Texels are read at their centers:
// the address mode says how the image goes on, and a nearest sampler reads the same as a filtering one, which texels of
// 32 bits a channel may not have in WebGPU and WebGL2.

/// The four texels around a position: (x, y), (x + 1, y), (x, y + 1), (x + 1, y + 1).
struct moments_cell {
    means: vec4f,
    deviations: vec4f,
    fraction: vec2f,
}

/// Number of texels of a level, across and down; levels beyond the last are the last, as for samplers.
///
/// By shifts of the first level's size: Mesa's software rasterizer answers `textureDimensions` for one level a group of
/// invocations, not for each invocation's own.
///
/// Source: levels halve and round down, to at least one texel.
/// Domain: level integer in [0, 9].
/// Error: exact.
fn moments_size(moments: texture_2d<f32>, level: i32) -> vec2f {
    let halvings = u32(clamp(level, 0, 31));
    return vec2f(max(textureDimensions(moments, 0) >> vec2u(halvings), vec2u(1u)));
}

/// Variance of the kernel that reading a level bilinearly applies to f, in texels² of level 0.
///
/// Where a size is no power of two texels widen as levels round down; the wider side counts.
///
/// Source: box and tent of one width w: w²/12 + w²/6; none at level 0.
/// Domain: level integer in [0, 9].
/// Error: 1.9e-7 relative; f32 rounding.
fn moments_kernel(moments: texture_2d<f32>, level: i32) -> f32 {
    let width = vec2f(textureDimensions(moments, 0)) / moments_size(moments, level);
    let widest = max(width.x, width.y);
    return select(0.25 * widest * widest, 0.0, level <= 0);
}

/// Reads the four texels of a level around a position, with the position's place between their centers.
///
/// Where rounding moves the position over a texel's center, the cell is the one on the other side.
///
/// Source: the definition of bilinear filtering.
/// Domain: position in [-1, 2], level integer in [0, 9].
/// Error: 2e-6 absolute; the fraction, from the rounding of position times size: in proportion to the size, up to 16.
fn moments_texels(moments: texture_2d<f32>, moments_sampler: sampler, position: vec2f, level: i32) -> moments_cell {
    let size = moments_size(moments, level);
    let at = position * size - 0.5;
    let corner = floor(at);
    let low = (corner + 0.5) / size;
    let high = (corner + 1.5) / size;
    let a = textureSampleLevel(moments, moments_sampler, low, f32(level)).xy;
    let b = textureSampleLevel(moments, moments_sampler, vec2f(high.x, low.y), f32(level)).xy;
    let c = textureSampleLevel(moments, moments_sampler, vec2f(low.x, high.y), f32(level)).xy;
    let d = textureSampleLevel(moments, moments_sampler, high, f32(level)).xy;
    return moments_cell(vec4f(a.x, b.x, c.x, d.x), vec4f(a.y, b.y, c.y, d.y), at - corner);
}

/// Mean and variance of four texels mixed by their bilinear weights.
///
/// Both are taken relative to the first texel: equal texels return their mean and variance unchanged.
///
/// Source: law of total variance.
/// Domain: cell.means in [0, 1], cell.deviations in [0, 0.5], cell.fraction in [0, 1].
/// Error: 2e-7 absolute; f32 rounding.
fn moments_mixed(cell: moments_cell) -> vec2f {
    let f = clamp(cell.fraction, vec2f(), vec2f(1.0));
    let weights = vec3f(f.x * (1.0 - f.y), (1.0 - f.x) * f.y, f.x * f.y);
    let mean = cell.means.x + dot(weights, cell.means.yzw - cell.means.x);
    let apart = cell.means - mean;
    let variances = cell.deviations * cell.deviations + apart * apart;
    return vec2f(mean, max(variances.x + dot(weights, variances.yzw - variances.x), 0.0));
}

/// Variance of a cell's bilinear surface over a footprint of less than a texel, as of a plane: ∇fᵀ Σ ∇f.
///
/// At most what values between the cell's smallest and largest can have, a quarter of the squared range.
///
/// Source: the definition, with the analytic gradient of the bilinear surface.
/// Domain: cell.means in [0, 1], cell.deviations in [0, 0.5], cell.fraction in [0, 1], covariance psd(0.001, 1, 0.99).
/// Error: 2e-7 absolute; f32 rounding.
fn moments_planar(cell: moments_cell, covariance: vec3f) -> f32 {
    let m = cell.means;
    let f = clamp(cell.fraction, vec2f(), vec2f(1.0));
    let gradient = vec2f(mix(m.y - m.x, m.w - m.z, f.y), mix(m.z - m.x, m.w - m.y, f.x));
    let squares = vec3f(gradient.x * gradient.x, 2.0 * gradient.x * gradient.y, gradient.y * gradient.y);
    let range = max(max(m.x, m.y), max(m.z, m.w)) - min(min(m.x, m.y), min(m.z, m.w));
    return clamp(dot(clamp(covariance, vec3f(-1.0), vec3f(2.0)), squares), 0.0, 0.25 * range * range);
}

/// Mean and deviation of f over a footprint that is about round: (mean, deviation). The pyramid must reach 1×1.
///
/// The two levels whose kernels enclose half the covariance's trace are mixed; footprints wider than the last level
/// read the whole image. Below a deviation of one texel the plane of the four texels takes over by and by, and alone
/// below a quarter. A footprint of zero returns the value of f and deviation 0, a constant image itself and deviation
/// 0. The deviation is at most half the range of the image.
///
/// Source: Heitz et al. 2014, section 4.2, for tabulated f, with central moments; the mixture of kernels above.
/// Domain: position in [-1, 2], covariance psd(0.001, 100, 0.9).
/// Error: 1e-6 absolute; for values in [0, 1] and sizes up to 16: position times size is rounded.
fn moments_read(moments: texture_2d<f32>, moments_sampler: sampler, position: vec2f, covariance: vec3f) -> vec2f {
    let variance = clamp(0.5 * (covariance.x + covariance.z), 0.0, 1e36);
    // A texel of level l is 2^l wide or wider, but less than twice that: one step back is enough.
    var level = i32(0.5 * log2(max(4.0 * variance, 1.0)));
    level -= select(0, 1, moments_kernel(moments, level) > variance);
    let low = moments_kernel(moments, level);
    let high = moments_kernel(moments, level + 1);
    let weight = clamp((variance - low) / max(high - low, 1e-30), 0.0, 1.0);

    let cell = moments_texels(moments, moments_sampler, position, level);
    let coarse = moments_mixed(moments_texels(moments, moments_sampler, position, level + 1));
    let fine = moments_mixed(cell) * vec2f(1.0, f32(level > 0)); // at level 0 f itself, a single value
    let apart = coarse.x - fine.x;
    var within = mix(fine.y, coarse.y, weight) + weight * (1.0 - weight) * apart * apart;
    if variance < 1.0 {
        let planar = moments_planar(cell, covariance);
        within = mix(planar, within, clamp(0.25 * log2(max(16.0 * variance, 1.0)), 0.0, 1.0));
    }
    return vec2f(fine.x + weight * apart, sqrt(max(within, 0.0)));
}
