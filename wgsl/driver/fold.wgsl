// Octaves of noise folded at 0, |n|: turbulence, and ridges where it is taken off.
//
// Over a footprint an octave is taken for normal, with the mean and the variance that a point of it tells, so that |n|
// has a folded normal distribution. With r for the mean over the deviation, and g(r) for the mean excess of a standard
// normal variable over r, its mean is |m| + 2 σ g(r) and its variance σ² (1 − 4 g (r + g)): neither loses its digits
// where nothing is folded.

/// Weights of an octave that is folded, for `fractal_add` with a noise of 1: (mean, coupling, rest).
///
/// `weights` are the noise's (multiplier, coupling, rest), `slope` its derivatives along the two vectors of the
/// footprint, `variance` its variance over the plane and `share` its mean of |n| over the plane over its deviation.
/// What the folded octave shares with others, its slope, is that of the noise times the mean of its sign. As no octave
/// is normal over the plane, mean and variance of one of which nothing is resolved are moved to those of |n|, and of
/// others in proportion to the square of the rest.
///
/// Source: the folded normal distribution, Leone, Nelson and Nottingham 1961, Technometrics 3(4); the covariance of
/// folded variables to first order by Price's theorem.
/// Domain: weights in [0, 1], noise in [-1, 1], slope in [-2, 2], variance in [0.04, 0.21], share in [0.8, 0.87].
/// Error: 4e-6 of 1 + the result; f32 rounding, of the rest over the variance.
fn fold_octave(weights: vec3f, noise: f32, slope: vec2f, variance: f32, share: f32) -> vec3f {
    let w = clamp(weights, vec3f(), vec3f(1e6));
    let mean = w.x * clamp(noise, -1e6, 1e6);
    let tilt = w.y * clamp(slope, vec2f(-1e12), vec2f(1e12));
    let told = dot(tilt, tilt);
    let most = clamp(variance, 1e-12, 1e12);
    let all = most * w.z + told;
    let s = sqrt(max(all, 1e-30));
    let r = min(abs(mean) / s, 12.0);
    let g = normal_excess(r);
    let sign = 1.0 - 2.0 * normal_cdf(-r);
    let apart = w.z * w.z;
    // 0.797884561 is √(2/π).
    let folded = abs(mean) + 2.0 * s * g + apart * (share - 0.797884561) * sqrt(most);
    let rest = max(all * (1.0 - 4.0 * g * (r + g)) - sign * sign * told, 0.0) / most;
    let lost = apart * (0.636619772 - share * share); // 2/π
    return vec3f(folded, select(sign, -sign, mean < 0.0) * w.y, max(rest + lost, 0.0));
}
