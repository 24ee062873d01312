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
    /// The sum of the octaves' gradients, each times its coupling; in the end along the two vectors of the footprint.
    slope: vec2f,
}

/// Octaves added so far, with their slopes along the major and the minor axis of the footprint.
struct fractal_surface {
    /// As of a `fractal_sum`.
    mean: f32,
    /// As of a `fractal_sum`.
    rest: f32,
    /// The sum of the octaves' gradients, each times its coupling.
    coupled: vec2f,
    /// The mean slope.
    slope: vec2f,
    /// The variances of slopes about that, over that of the noise's slopes.
    lost: vec2f,
}

/// Deviations along the major and the minor axis of the footprint whose covariance is across acrossᵀ + along alongᵀ.
///
/// Vectors beyond 1e9 count as 1e9. Those of a footprint without width have the minor deviation 0.
///
/// Source: the singular values of a 2×2 matrix, the lesser by the determinant.
/// Domain: across in [-8, 8], along in [-8, 8].
/// Error: 2e-6 absolute; f32 rounding.
fn fractal_deviations(across: vec2f, along: vec2f) -> vec2f {
    let a = clamp(across, vec2f(-1e9), vec2f(1e9));
    let b = clamp(along, vec2f(-1e9), vec2f(1e9));
    let squares = vec2f(dot(a, a), dot(b, b));
    let split = length(vec2f(0.5 * (squares.x - squares.y), dot(a, b)));
    let major = sqrt(0.5 * (squares.x + squares.y) + split);
    return vec2f(major, abs(a.x * b.y - a.y * b.x) / max(major, 1e-18));
}

/// The sum with one more octave of the given amplitude.
///
/// `weights` are the noise's (multiplier, coupling, rest). Slopes are along the axes along which the sum has them: the
/// two vectors of the footprint, or the octave's own, to which the caller turns the sum's from octave to octave.
///
/// Source: the sum of independent octaves.
/// Domain: sum.mean in [-1, 1], sum.rest in [0, 2], sum.slope in [-2, 2], amplitude in [0, 1], weights in [0, 1],
/// noise in [-1, 1], slope in [-2, 2].
/// Error: 3e-7 absolute; f32 rounding.
fn fractal_add(sum: fractal_sum, amplitude: f32, weights: vec3f, noise: f32, slope: vec2f) -> fractal_sum {
    return fractal_sum(
        sum.mean + amplitude * weights.x * noise,
        sum.rest + amplitude * amplitude * weights.z,
        sum.slope + amplitude * weights.y * slope,
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

/// The sum with one more octave of the given amplitude, and with its slopes.
///
/// `weights` are the noise's (multiplier, coupling, rest), `leveled` is as `perlin_leveled` has it, `noise` is (noise,
/// gradient), and `axis` the footprint's major axis in the octave, as long there as 1 is in the first.
///
/// Source: the sum of independent octaves; the chain rule.
/// Domain: sum.mean in [-1, 1], sum.rest in [0, 2], sum.coupled in [-2, 2], sum.slope in [-2, 2], sum.lost in [0, 2],
/// amplitude in [0, 1], weights in [0, 1], leveled in [0, 1], noise in [-2, 2], axis in [-4, 4].
/// Error: 6e-6 absolute; f32 rounding.
fn fractal_tilt(
    sum: fractal_surface, amplitude: f32, weights: vec3f, leveled: vec2f, noise: vec3f, axis: vec2f,
) -> fractal_surface {
    let slope = amplitude * vec2f(dot(axis, noise.yz), axis.x * noise.z - axis.y * noise.y);
    let square = amplitude * amplitude;
    return fractal_surface(
        sum.mean + amplitude * weights.x * noise.x,
        sum.rest + square * weights.z,
        sum.coupled + weights.y * slope,
        sum.slope + (1.0 - leveled) * slope,
        sum.lost + square * dot(axis, axis) * leveled * (2.0 - leveled),
    );
}

/// Moments of heights, `mean` plus `scale` times a sum of octaves of noise, and mean and covariance of their slopes.
///
/// At amplitude 1 the noise has the variance `variance` and slopes of `steepness` times that along either axis. The
/// footprint is across acrossᵀ + along alongᵀ, and `axis` the unit vector along its major axis.
///
/// Source: as `fractal_statistics`; the covariance has the footprint's axes, along which an octave is symmetric.
/// Domain: sum.mean in [-1, 1], sum.rest in [0, 2], sum.coupled in [-2, 2], sum.slope in [-2, 2], sum.lost in [0, 2],
/// axis unit, across in [-1, 1], along in [-1, 1], mean in [-1, 1], scale in [0, 2], variance in [0, 1],
/// steepness in [0, 30].
/// Error: 6e-5 absolute; f32 rounding.
fn fractal_slopes(
    sum: fractal_surface, axis: vec2f, across: vec2f, along: vec2f, mean: f32, scale: f32, variance: f32,
    steepness: f32,
) -> statistics_surface {
    let u = clamp(axis, vec2f(-1.0), vec2f(1.0));
    let v = vec2f(-u.y, u.x);
    let limit = vec2f(1e9);
    let s = clamp(scale, -1e9, 1e9);
    let coupled = sum.coupled.x * u + sum.coupled.y * v;
    let rises = vec2f(dot(clamp(across, -limit, limit), coupled), dot(clamp(along, -limit, limit), coupled));
    let moments = fractal_statistics(fractal_sum(sum.mean, sum.rest, rises), mean, s, variance);
    let lost = s * s * clamp(variance * steepness * sum.lost, vec2f(), vec2f(1e18));
    let squares = lost.x * u.xxy * u.xyy + lost.y * v.xxy * v.xyy;
    return statistics_surface(moments, s * (sum.slope.x * u + sum.slope.y * v), squares);
}
