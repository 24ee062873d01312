// Shares of a footprint on an image where the image's bilinear reconstruction f is above each of a map's edges, read
// from a pyramid of such shares: of a map of bands the mean color, whatever the distribution of f.
//
// A texel of level l holds the shares of the area that it covers, that of level 0, too: shares of areas add, so that a
// level read bilinearly is a box of a texel's width w with a tent of the same width, of variance w²/4, and two levels
// are mixed so that the variance is the footprint's. Footprints of less than level 0's kernel see f as a plane.
//
// Positions are texture coordinates, covariances (xx, xy, yy) in texels² of level 0. Texels are read at their centers:
// the address mode says how the image goes on, and a nearest sampler reads the same as a filtering one, which texels of
// 32 bits a channel may not have in WebGPU and WebGL2.

/// Variance of the kernel that reading a level bilinearly applies, in texels² of level 0.
///
/// Source: box and tent of one width w: w²/12 + w²/6; where the sides differ, of the wider one.
/// Domain: level integer in [0, 9].
/// Error: 1.9e-7 relative; f32 rounding.
fn indicators_kernel(shares: texture_2d<f32>, level: i32) -> f32 {
    let width = vec2f(textureDimensions(shares, 0)) / moments_size(shares, level);
    let widest = max(width.x, width.y);
    return 0.25 * widest * widest;
}

/// Shares of a level at a position, between the centers of its texels.
///
/// Source: the definition of bilinear filtering.
/// Domain: position in [-1, 2], level integer in [0, 9].
/// Error: 2e-6 absolute; from the rounding of position times size: in proportion to the size, up to 16.
fn indicators_bilinear(shares: texture_2d<f32>, shares_sampler: sampler, position: vec2f, level: i32) -> vec4f {
    let size = moments_size(shares, level);
    let at = position * size - 0.5;
    let corner = floor(at);
    let low = (corner + 0.5) / size;
    let high = (corner + 1.5) / size;
    let a = textureSampleLevel(shares, shares_sampler, low, f32(level));
    let b = textureSampleLevel(shares, shares_sampler, vec2f(high.x, low.y), f32(level));
    let c = textureSampleLevel(shares, shares_sampler, vec2f(low.x, high.y), f32(level));
    let d = textureSampleLevel(shares, shares_sampler, high, f32(level));
    let f = clamp(at - corner, vec2f(), vec2f(1.0));
    let above = a + f.x * (b - a);
    let below = c + f.x * (d - c);
    return above + f.y * (below - above);
}

/// Shares over a footprint that is about round. The pyramid must reach 1×1.
///
/// The two levels whose kernels enclose half the covariance's trace are mixed; footprints of less than a deviation of
/// half a texel read level 0, those wider than the last level the whole image.
///
/// Source: Heitz et al. 2014, section 4.1, histograms of few values; the mixture of kernels above.
/// Domain: position in [-1, 2], covariance psd(0.001, 100, 0.9).
/// Error: 2e-6 absolute; for sizes up to 16: position times size is rounded.
fn indicators_shares(
    shares: texture_2d<f32>,
    shares_sampler: sampler,
    position: vec2f,
    covariance: vec3f,
) -> vec4f {
    let wanted = clamp(0.5 * (covariance.x + covariance.z), 0.0, 1e36);
    // A texel of level l is 2^l wide or wider, but less than twice that: one step back is enough.
    var level = i32(0.5 * log2(max(4.0 * wanted, 1.0)));
    level -= select(0, 1, level > 0 && indicators_kernel(shares, level) > wanted);
    let low = indicators_kernel(shares, level);
    let high = indicators_kernel(shares, level + 1);
    let fine = indicators_bilinear(shares, shares_sampler, position, level);
    let coarse = indicators_bilinear(shares, shares_sampler, position, level + 1);
    return fine + clamp((wanted - low) / max(high - low, 1e-30), 0.0, 1.0) * (coarse - fine);
}

/// How much of a footprint's color is that of f as a plane: all up to a deviation of a quarter of a texel, nothing from
/// half a texel, the deviation of the kernel of level 0.
///
/// Source: linear in the logarithm of the deviation.
/// Domain: covariance psd(0.1, 1, 0.9).
/// Error: 3e-7 absolute; f32 rounding of the logarithm.
fn indicators_plane(covariance: vec3f) -> f32 {
    let wanted = clamp(0.5 * (covariance.x + covariance.z), 0.0, 1e36);
    return 1.0 - clamp(0.5 * log2(max(16.0 * wanted, 1.0)), 0.0, 1.0);
}

/// Mean and deviation of f as a plane: at the position, and by the gradient there.
///
/// Source: as `moments_planar`.
/// Domain: position in [-1, 2], covariance psd(0.001, 1, 0.9).
/// Error: 1.2e-6 absolute; for values in [0, 1] and sizes up to 16: position times size is rounded.
fn indicators_value(image: texture_2d<f32>, image_sampler: sampler, position: vec2f, covariance: vec3f) -> vec2f {
    let cell = moments_texels(image, image_sampler, position, 0);
    return vec2f(moments_mixed(cell).x, sqrt(moments_planar(cell, covariance)));
}
