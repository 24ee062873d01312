// Sums of cosines over a Gaussian footprint, a term a wave: waves on water, or any band-limited function.
//
// A wave is a cos θ with θ = 2π (k·p + phase), given as (k.x, k.y, a, phase): k in cycles a unit, phase in turns. A
// footprint of covariance across acrossᵀ + along alongᵀ fades it by E = exp(−L/2) with L = 4π² kᵀ Σ k. Means are exact.
// Variances are the exact ones of single waves and, between waves, those of the plane that touches the mean: what waves
// of other lengths do not have in common is what a plane misses. Slopes likewise, with the second derivatives.

/// Sums over waves: the filtered function, its first and second derivatives, and what single waves vary beyond those.
struct cosines_sum {
    /// Mean of the function.
    mean: f32,
    /// Variance of single waves beyond that of the mean's plane.
    variance: f32,
    /// Gradient of the mean, the mean slope.
    gradient: vec2f,
    /// Second derivatives of the mean: xx, xy, yy.
    curvature: vec3f,
    /// Covariance of single waves' slopes beyond that of the mean's curvature: xx, xy, yy.
    slope_covariance: vec3f,
}

/// What a footprint takes of the square of a wave, 1 − exp(−L), and how far that is below L.
///
/// Source: the definition; Taylor's series where L is small.
/// Domain: exponent log in [1e-6, 100].
/// Error: 1e-6 relative; f32 rounding and the device's exp.
fn cosines_lost(exponent: f32) -> vec2f {
    let x = clamp(exponent, 0.0, 1e9);
    if x < 0.25 {
        let rest = x * x * (0.5 - x * (1.0 / 6.0 - x * (1.0 / 24.0 - x * (1.0 / 120.0 - x * (1.0 / 720.0)))));
        return vec2f(x - rest, rest);
    }
    let lost = 1.0 - exp(-min(x, 80.0));
    return vec2f(lost, x - lost);
}

/// One wave of a sum.
///
/// Angles are reduced to a turn first; their rounding is that of k·p, which positions far from the origin feel: a mean
/// is within 1.2e-6 (|k.x p.x| + |k.y p.y| + |phase|) + 1e-6 amplitudes, whatever the footprint.
///
/// Source: transform of a Gaussian; E[cos²] − E[cos]² and E[sin²] − E[sin]² of one wave, less the part of first order.
/// Domain: position in [-4, 4], across in [-0.5, 0.5], along in [-0.5, 0.5], wave in [-1, 1].
/// Error: 4e-5 relative; rounding of k·p.
fn cosines_wave(position: vec2f, across: vec2f, along: vec2f, wave: vec4f) -> cosines_sum {
    let limit = vec2f(1e9);
    let k = clamp(wave.xy, -limit, limit);
    let turns = dot(k, clamp(position, -limit, limit)) + wave.w;
    let angle = 6.28318531 * (turns - round(turns)); // 2π
    let sine = sin(angle);
    let cosine = cos(angle);
    let u = dot(k, clamp(across, -limit, limit));
    let v = dot(k, clamp(along, -limit, limit));
    let exponent = 39.4784176 * min(u * u + v * v, 1e9); // 4π²
    let fade = exp(-min(0.5 * exponent, 80.0));
    let lost = cosines_lost(exponent);
    // Of the squares of sine and cosine what is left of first order, and what stays when all is lost.
    let even = 0.5 * lost.x * lost.x;
    let odd = fade * fade * lost.y;
    let a = wave.z;
    let square = a * a;
    let slopes = 39.4784176 * vec3f(k.x * k.x, k.x * k.y, k.y * k.y); // 4π²
    return cosines_sum(
        a * fade * cosine,
        square * max(even - odd * sine * sine, 0.0),
        -6.28318531 * a * fade * sine * k,
        -a * fade * cosine * slopes,
        square * max(even - odd * cosine * cosine, 0.0) * slopes,
    );
}

/// Two sums together.
///
/// Source: the definition, member by member.
/// Domain: sum.mean in [-1, 1], sum.variance in [0, 1], sum.gradient in [-1, 1], sum.curvature in [-1, 1],
/// sum.slope_covariance in [-1, 1], wave.mean in [-1, 1], wave.variance in [0, 1], wave.gradient in [-1, 1],
/// wave.curvature in [-1, 1], wave.slope_covariance in [-1, 1].
/// Error: 2e-7 absolute; f32 rounding.
fn cosines_with(sum: cosines_sum, wave: cosines_sum) -> cosines_sum {
    return cosines_sum(
        sum.mean + wave.mean,
        sum.variance + wave.variance,
        sum.gradient + wave.gradient,
        sum.curvature + wave.curvature,
        sum.slope_covariance + wave.slope_covariance,
    );
}

/// Mean, variance, skewness and excess kurtosis of a sum over its footprint; the last two are not known and 0.
///
/// Source: variance of a plane over a Gaussian, ∇fᵀ Σ ∇f, and what single waves vary beyond it.
/// Domain: sum.mean in [-1, 1], sum.variance in [0, 1], sum.gradient in [-1, 1], sum.curvature in [-1, 1],
/// sum.slope_covariance in [-1, 1], across in [-1, 1], along in [-1, 1].
/// Error: 2e-6 absolute; f32 rounding.
fn cosines_moments(sum: cosines_sum, across: vec2f, along: vec2f) -> vec4f {
    let limit = vec2f(1e9);
    let u = dot(sum.gradient, clamp(across, -limit, limit));
    let v = dot(sum.gradient, clamp(along, -limit, limit));
    return vec4f(sum.mean, sum.variance + u * u + v * v, 0.0, 0.0);
}

/// Moments of a sum as of heights, with mean and covariance of its slopes, over its footprint.
///
/// The covariance is one: a sum of squares.
///
/// Source: as `cosines_moments`, of the gradient: H Σ H with the second derivatives H.
/// Domain: sum.mean in [-1, 1], sum.variance in [0, 1], sum.gradient in [-1, 1], sum.curvature in [-1, 1],
/// sum.slope_covariance in [-1, 1], across in [-1, 1], along in [-1, 1].
/// Error: 3e-6 absolute; f32 rounding.
fn cosines_surface(sum: cosines_sum, across: vec2f, along: vec2f) -> statistics_surface {
    let limit = vec2f(1e9);
    let a = clamp(across, -limit, limit);
    let b = clamp(along, -limit, limit);
    let u = vec2f(dot(sum.curvature.xy, a), dot(sum.curvature.yz, a));
    let v = vec2f(dot(sum.curvature.xy, b), dot(sum.curvature.yz, b));
    let bent = vec3f(u.x * u.x + v.x * v.x, u.x * u.y + v.x * v.y, u.y * u.y + v.y * v.y);
    return statistics_surface(cosines_moments(sum, across, along), sum.gradient, sum.slope_covariance + bent);
}
