// Four moments of an image's bilinear reconstruction f over a Gaussian footprint, read from a pyramid of (mean,
// deviation, skewness, excess kurtosis): enough for two normal distributions, where values come in two heaps.
//
// Levels and kernels are those of `moments_read`. Texels hold standardized moments, which keep their digits in 16 bits;
// they mix as central ones, moved to the mean of the mixture: exact, and no difference of large powers. Values and
// deviations count up to 1e7, so that fourth powers stay in 32 bits.

/// Mean and central moments of a distribution.
struct four_moments {
    mean: f32,
    variance: f32,
    third: f32,
    fourth: f32,
}

/// Central moments from a texel: mean, deviation, skewness and excess kurtosis.
///
/// Source: the definition of skewness and kurtosis.
/// Domain: texel in [0, 1].
/// Error: 8e-7 absolute; f32 rounding.
fn four_moments_central(texel: vec4f) -> four_moments {
    let deviation = clamp(texel.y, 0.0, 1e7);
    let variance = deviation * deviation;
    let third = clamp(texel.z, -1e4, 1e4) * deviation * variance;
    return four_moments(texel.x, variance, third, (clamp(texel.w, -2.0, 1e8) + 3.0) * variance * variance);
}

/// Second, third and fourth moment of a distribution about any center.
///
/// Source: the binomial theorem.
/// Domain: part.mean in [-1, 1], part.variance in [0, 1], part.third in [-1, 1], part.fourth in [0, 3],
/// origin in [-1, 1].
/// Error: 1.2e-5 absolute; f32 rounding of moments up to 50.
fn four_moments_about(part: four_moments, origin: f32) -> vec3f {
    let apart = clamp(part.mean - origin, -2e7, 2e7);
    let square = apart * apart;
    let variance = min(part.variance, 1e14);
    return vec3f(
        variance + square,
        part.third + apart * (3.0 * variance + square),
        part.fourth + apart * (4.0 * part.third + apart * (6.0 * variance + square)),
    );
}

/// Moments of a mixture of two distributions, `weight` of the second.
///
/// Source: law of total variance and its likes for higher moments.
/// Domain: first.mean in [0, 1], first.variance in [0, 0.25], first.third in [-0.1, 0.1], first.fourth in [0, 0.2],
/// second.mean in [0, 1], second.variance in [0, 0.25], second.third in [-0.1, 0.1], second.fourth in [0, 0.2],
/// weight in [0, 1].
/// Error: 4e-7 absolute; f32 rounding.
fn four_moments_pair(first: four_moments, second: four_moments, weight: f32) -> four_moments {
    let w = clamp(weight, 0.0, 1.0);
    let mean = first.mean + w * clamp(second.mean - first.mean, -2e7, 2e7);
    let own = four_moments_about(first, mean);
    let sum = own + w * (four_moments_about(second, mean) - own);
    return four_moments(mean, sum.x, sum.y, sum.z);
}

/// Mean, variance, skewness and excess kurtosis; a deviation of less than 1e-9 has neither.
///
/// No distribution has a kurtosis of less than the squared skewness and 1: rounded moments are held to that.
///
/// Source: the definition of skewness and kurtosis.
/// Domain: moments.mean in [-1, 1], moments.variance in [0.05, 1], moments.third in [-0.1, 0.1],
/// moments.fourth in [3, 6].
/// Error: 8e-7 relative; f32 rounding, and a division of 2.5 units that devices may have.
fn four_moments_standard(moments: four_moments) -> vec4f {
    let variance = clamp(moments.variance, 0.0, 1e15);
    if variance < 1e-18 {
        return vec4f(moments.mean, variance, 0.0, 0.0);
    }
    let skewness = clamp(moments.third / (variance * sqrt(variance)), -1e4, 1e4);
    let kurtosis = min(moments.fourth / (variance * variance) - 3.0, 1e8);
    return vec4f(moments.mean, variance, skewness, max(kurtosis, skewness * skewness - 2.0));
}

/// Moments that a level has at a position, between the centers of its texels.
///
/// Where rounding moves the position over a texel's center, the texels are those of the other side.
///
/// Source: bilinear filtering of distributions, whose moments about any center mix as they do.
/// Domain: position in [-1, 2], level integer in [0, 9].
/// Error: 1e-6 absolute; from the rounding of position times size: in proportion to the size, up to 16.
fn four_moments_bilinear(
    moments: texture_2d<f32>,
    moments_sampler: sampler,
    position: vec2f,
    level: i32,
) -> four_moments {
    let size = moments_size(moments, level);
    let at = position * size - 0.5;
    let corner = floor(at);
    let low = (corner + 0.5) / size;
    let high = (corner + 1.5) / size;
    let a = textureSampleLevel(moments, moments_sampler, low, f32(level));
    let b = textureSampleLevel(moments, moments_sampler, vec2f(high.x, low.y), f32(level));
    let c = textureSampleLevel(moments, moments_sampler, vec2f(low.x, high.y), f32(level));
    let d = textureSampleLevel(moments, moments_sampler, high, f32(level));
    let f = at - corner;
    let above = four_moments_pair(four_moments_central(a), four_moments_central(b), f.x);
    let below = four_moments_pair(four_moments_central(c), four_moments_central(d), f.x);
    return four_moments_pair(above, below, f.y);
}

/// Moments of f over a footprint that is about round, central ones. The pyramid must reach 1×1.
///
/// The mixture of `moments_read`. Below a deviation of one texel the plane of the four texels takes over by and by,
/// over which a footprint has a normal distribution, and alone below a quarter.
///
/// Source: Heitz et al. 2014, section 4.2, for tabulated f; the mixture of kernels of `moments_read`.
/// Domain: position in [-1, 2], covariance psd(0.001, 100, 0.9).
/// Error: 1e-6 absolute; for values in [0, 1] and sizes up to 16: position times size is rounded.
fn four_moments_read(
    moments: texture_2d<f32>,
    moments_sampler: sampler,
    position: vec2f,
    covariance: vec3f,
) -> four_moments {
    let wanted = clamp(0.5 * (covariance.x + covariance.z), 0.0, 1e36);
    // A texel of level l is 2^l wide or wider, but less than twice that: one step back is enough.
    var level = i32(0.5 * log2(max(4.0 * wanted, 1.0)));
    level -= select(0, 1, moments_kernel(moments, level) > wanted);
    let low = moments_kernel(moments, level);
    let high = moments_kernel(moments, level + 1);

    var fine = four_moments_bilinear(moments, moments_sampler, position, level);
    if level <= 0 {
        fine = four_moments(fine.mean, 0.0, 0.0, 0.0); // f itself, a single value
    }
    let coarse = four_moments_bilinear(moments, moments_sampler, position, level + 1);
    let mixed = four_moments_pair(fine, coarse, clamp((wanted - low) / max(high - low, 1e-30), 0.0, 1.0));
    if wanted >= 1.0 {
        return mixed;
    }
    let planar = moments_planar(moments_texels(moments, moments_sampler, position, level), covariance);
    let normal = four_moments(mixed.mean, planar, 0.0, 3.0 * planar * planar);
    return four_moments_pair(normal, mixed, 0.25 * log2(max(16.0 * wanted, 1.0)));
}
