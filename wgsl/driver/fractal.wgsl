// Sums of octaves of noise, each with its own lattice and seed: what a footprint holds of the sum.
//
// Octaves are independent, so that their variances add. What their gradients tell of the variance is told together:
// slopes of several octaves add up, or cancel.

/// Octaves added so far, in units of a noise of unit variance where they are variances.
struct fractal_sum {
    /// The mean.
    mean: f32,
    /// The variance that no gradient tells of, over that of the noise.
    rest: f32,
    /// The sum of the octaves' gradients along the two vectors of the footprint, each times its coupling.
    slope: vec2f,
}

/// The sum with one more octave of the given amplitude.
///
/// `weights` are the noise's (multiplier, coupling, rest), and `slope` its derivatives along the two vectors of the
/// footprint.
///
/// Source: the sum of independent octaves.
/// Domain: sum.mean in [-1, 1], sum.rest in [0, 2], sum.slope in [-2, 2], amplitude in [0, 1], weights in [0, 1],
/// noise in [-1, 1], slope in [-2, 2].
/// Error: 3e-7 absolute; f32 rounding.
fn fractal_add(sum: fractal_sum, amplitude: f32, weights: vec3f, noise: f32, slope: vec2f) -> fractal_sum {
    let g = clamp(amplitude, -1e6, 1e6);
    let w = clamp(weights, vec3f(-1e6), vec3f(1e6));
    return fractal_sum(
        sum.mean + g * w.x * clamp(noise, -1e6, 1e6),
        sum.rest + g * g * w.z,
        sum.slope + g * w.y * clamp(slope, vec2f(-1e18), vec2f(1e18)),
    );
}

/// Mean, variance, skewness and excess kurtosis of `mean` plus `scale` times a sum of octaves of noise whose variance
/// is `variance` at amplitude 1. Skewness and kurtosis are 0.
///
/// Source: the variance of a Gaussian process given its values and gradients at a point.
/// Domain: sum.mean in [-1, 1], sum.rest in [0, 2], sum.slope in [-2, 2], mean in [-1, 1], scale in [0, 2],
/// variance in [0, 1].
/// Error: 1e-5 absolute; f32 rounding.
fn fractal_statistics(sum: fractal_sum, mean: f32, scale: f32, variance: f32) -> vec4f {
    let s = clamp(scale, -1e15, 1e15);
    let slope = clamp(s * sum.slope, vec2f(-1e18), vec2f(1e18));
    let spread = clamp(variance * sum.rest, 0.0, 1e30) * s;
    return vec4f(mean + s * sum.mean, s * spread + dot(slope, slope), 0.0, 0.0);
}

/// Weights of an octave that loses this share of its power, whatever its gradient: (multiplier, 0, rest). The mean
/// keeps the deviation that the footprint leaves it on the average, the variance is what it takes.
///
/// Source: Heitz et al. 2014, "Filtering Non-Linear Transfer Functions on Surfaces", section 4.2, for stationary noise.
/// Domain: lost in [0, 1].
/// Error: 1e-7 absolute; f32 rounding.
fn fractal_stationary(lost: f32) -> vec3f {
    let share = clamp(lost, 0.0, 1.0);
    return vec3f(sqrt(1.0 - share), 0.0, share);
}
