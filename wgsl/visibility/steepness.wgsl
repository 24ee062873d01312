// Steepness: the length |s| of the slopes that a view sees, as a distribution of Rice. That is the one of the length of
// a vector whose components are normal, of the same deviation σ, about a mean that is ν long.
//
// With s = s̄ + e u + f w of `slopes.wgsl`, p = s̄ + R e, the variance V, skewness γ and kurtosis κ of u, E = |e|² and
// F = |f|², the mean of |s|² is A = |p|² + V E + F and its variance, exactly,
//   B = 4 (p · e)² V + 4 (p · e) E γ V^(3/2) + E² V² (κ − 1) + 4 (p · f)² + 4 (e · f)² V + 2 F².
// The distribution of Rice that has both has ν⁴ = A² − B and σ² = (A − ν²) / 2. There is none where B exceeds A², as
// over ridges: the one with ν = 0 keeps A there.

/// Variance of the square of u's distance from its mean, in squares of its variance: its kurtosis less 1.
///
/// Source: 2 V (1 − V) − (a + 2 R) κ₃ over V², plus 2, with κ₃ = (a + 2 R) (1 − V) − R; below 0 a rational fit with the
/// limit 5 of a gamma distribution.
/// Domain: parameter in [-12, 20].
/// Error: 4e-4 absolute; of parameters beyond 12, which count as 12.
fn steepness_spread(parameter: f32) -> f32 {
    let a = clamp(parameter, -12.0, 12.0);
    let x = max(-a, 0.0);
    let above = 2.2450373 + x * (0.84734435 + x * (0.29550836 + x * 0.02461411));
    let below = 1.0 + x * (0.1955232 + x * (0.059377542 + x * 0.0049228221));
    let m = slopes_moments(a);
    let lever = a + 2.0 * m.x;
    let third = lever * (1.0 - m.y) - m.x;
    let fourth = 2.0 * m.y * (1.0 - m.y) - lever * third;
    return select(2.0 + fourth / (m.y * m.y), above / below, a < 0.0);
}

/// Mean of |s|² over the slopes that a view sees, and its variance over the square of that mean.
///
/// Covariances are scaled to variances of 1e12 at most; components of mean slopes beyond 1e6 count as that.
///
/// Source: the expansion above.
/// Domain: view unit, mean_slope in [-1, 1], covariance psd(0.1, 2, 0.9).
/// Error: 2e-4 relative; of the fits, f32 rounding where a mean slope is many deviations.
fn steepness_moments(view: vec3f, mean_slope: vec2f, covariance: vec3f) -> vec2f {
    let limited = covariance * (2.5e11 / clamp(0.25 * max(covariance.x, covariance.z), 2.5e11, 8e37));
    let factor = slopes_factor(view, limited);
    let slope = clamp(mean_slope, vec2f(-1e6), vec2f(1e6));
    let parameter = slopes_parameter(view, slope, factor);
    let m = slopes_moments(parameter);
    let p = slope + m.x * factor.xy;
    let along = m.y * dot(factor.xy, factor.xy);
    let across = dot(factor.zw, factor.zw);
    let lean = sqrt(m.y) * dot(p, factor.xy);
    let aside = vec2f(dot(p, factor.zw), sqrt(m.y) * dot(factor.xy, factor.zw));
    let mean = dot(p, p) + along + across;
    let variance = 4.0 * (lean * (lean + along * slopes_skewness(parameter)) + dot(aside, aside))
        + along * along * steepness_spread(parameter) + 2.0 * across * across;
    let inverse = 1.0 / max(mean, 1e-18);
    return vec2f(mean, max(variance * inverse * inverse, 0.0));
}

/// The distribution of Rice of a length whose square has a mean, and `part` of the square of that for a variance: the
/// length ν of its mean vector and the deviation σ of either component. A part beyond 1 counts as 1.
///
/// Source: the moments 2 σ² + ν² and 4 σ⁴ + 4 σ² ν², solved.
/// Domain: mean log in [1e-6, 100], part log in [1e-6, 1].
/// Error: 3e-7 relative; f32 rounding.
fn steepness_rice(mean: f32, part: f32) -> vec2f {
    let varied = clamp(part, 0.0, 1.0);
    let kept = sqrt(1.0 - varied);
    let square = clamp(mean, 0.0, 1e30);
    return sqrt(square * vec2f(kept, 0.5 * varied / (1.0 + kept)));
}
