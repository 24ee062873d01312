// What second derivatives of noise tell of a footprint, beside its value and its gradient.
//
// About a point a noise is n + g·x + ½ xᵀHx, of which a footprint keeps the more the smaller it is beside the cells. Of
// the second derivatives H one number counts, the trace of ΣH: the mean has half of it, the variance half its square.

/// How a point of a noise stands for a footprint.
struct bend_weights {
    /// What of the noise its mean has.
    multiplier: f32,
    /// What of the gradient its variance has.
    coupling: f32,
    /// The variance that no derivative tells of, over that of the noise.
    rest: f32,
    /// What of the trace its mean has.
    share: f32,
    /// What of the trace its variance has.
    bend: f32,
}

/// Octaves added so far, in units of a noise of unit variance where they are variances.
struct bend_sum {
    /// The mean.
    mean: f32,
    /// The variance that no derivative tells of, over that of the noise.
    rest: f32,
    /// The sum of the octaves' gradients, each times its coupling; in the end along the two vectors of the footprint.
    slope: vec2f,
    /// The sum of the octaves' traces of ΣH, each times what of it the variance has.
    bend: f32,
}

/// How a point of a noise stands for a footprint where second derivatives are known, from how it does where they are
/// not.
///
/// `weights` are the (multiplier, coupling, rest) of `perlin_filter`, `share` is what of the trace the mean has; the
/// variance has the share times the given multiplier of it, which is near the regression of what bends over the whole
/// footprint. `slopes` is the variance of a derivative along an axis over that of the noise; `bends` are the variance
/// of a second derivative along an axis, and the covariance of those along both.
///
/// Source: the regression of the footprint's mean on noise and trace; the rest by the mean of all squares, which is 1.
/// Domain: weights in [0, 1], share in [0, 1], deviations in [0, 1], slopes in [0, 30], bends in [0, 1000].
/// Error: 5e-7 of 1 + the result; f32 rounding.
fn bend_filter(weights: vec3f, share: f32, deviations: vec2f, slopes: f32, bends: vec2f) -> bend_weights {
    let s = clamp(deviations, vec2f(), vec2f(1e3));
    let u = s * s;
    let part = clamp(share, 0.0, 1.0);
    let bend = part * clamp(weights.x, 0.0, 1.0);
    // Minus the covariance of noise and trace, and the variance of the trace.
    let level = clamp(slopes, 0.0, 1e3) * (u.x + u.y);
    let limited = clamp(bends, vec2f(), vec2f(1e6));
    let trace = limited.x * dot(u, u) + 2.0 * limited.y * u.x * u.y;
    let told = 0.25 * part * part * (trace - level * level) + 0.5 * bend * bend * trace;
    return bend_weights(weights.x + 0.5 * part * level, weights.y, max(weights.z - told, 0.0), part, bend);
}

/// The sum with one more octave of the given amplitude, on the footprint whose covariance along the octave's axes is
/// `footprint`: xx, xy, yy.
///
/// Slopes are along the axes along which the sum has them.
///
/// Source: the sum of independent octaves.
/// Domain: sum.mean in [-1, 1], sum.rest in [0, 2], sum.slope in [-2, 2], sum.bend in [-2, 2], amplitude in [0, 1],
/// weights.multiplier in [0, 1], weights.coupling in [0, 1], weights.rest in [0, 1], weights.share in [0, 1],
/// weights.bend in [0, 1], noise in [-1, 1], slope in [-2, 2], bends in [-20, 20], footprint psd(0.01, 1, 0.99).
/// Error: 1e-6 of 1 + the result; f32 rounding.
fn bend_add(
    sum: bend_sum,
    amplitude: f32,
    weights: bend_weights,
    noise: f32,
    slope: vec2f,
    bends: vec3f,
    footprint: vec3f,
) -> bend_sum {
    let trace = dot(footprint, vec3f(1.0, 2.0, 1.0) * bends);
    return bend_sum(
        sum.mean + amplitude * (weights.multiplier * noise + 0.5 * weights.share * trace),
        sum.rest + amplitude * amplitude * weights.rest,
        sum.slope + amplitude * weights.coupling * slope,
        sum.bend + amplitude * weights.bend * trace,
    );
}

/// Mean, variance, skewness and excess kurtosis of `mean` plus `scale` times a sum of octaves of noise whose variance
/// is `variance` at amplitude 1. Skewness and kurtosis are 0.
///
/// Source: the variance of a quadratic form of normal numbers, of which one axis has all.
/// Domain: sum.mean in [-1, 1], sum.rest in [0, 2], sum.slope in [-2, 2], sum.bend in [-2, 2], mean in [-1, 1],
/// scale in [0, 2], variance in [0, 1].
/// Error: 1e-5 absolute; f32 rounding.
fn bend_statistics(sum: bend_sum, mean: f32, scale: f32, variance: f32) -> vec4f {
    let s = clamp(scale, -1e15, 1e15);
    let told = clamp(s * vec3f(sum.slope, 0.707106781 * sum.bend), vec3f(-1e18), vec3f(1e18));
    let spread = clamp(variance * sum.rest, 0.0, 1e30) * s;
    return vec4f(mean + s * sum.mean, s * spread + dot(told, told), 0.0, 0.0);
}
