// Visible slopes: the distribution D_s(s) ∝ max(t, 0) p_s(s) of the slopes s of a rough surface as a view v sees them.
//
// Slopes, with normals ∝ (−s.x, −s.y, 1), have a normal distribution p_s of mean s̄ and covariance Σ (xx, xy, yy). The
// weight t = v.z − v.xy · s is the area of a facet in the picture for a unit of area of the mean plane: n · v of the
// facet's own area, 1/n.z. With s = s̄ + e u + f w, where e eᵀ + f fᵀ = Σ and f is across the view,
//   t = m + τ u,   m = v.z − v.xy · s̄ (the rise),   τ = −e · v.xy (the reach),   a = m / τ (the parameter),
// and only u is weighted: its density is ∝ max(u + a, 0) φ(u), w stays standard normal. Mean R and variance V of u are
// functions of a alone. Visible slopes have the mean s̄ + R e and the covariance V e eᵀ + f fᵀ, without a difference. A
// flat mesh with a map of normals foreshortens no facet: its slopes are p_s, seen along the normal, R = 0 and V = 1.

/// From this parameter on one normal distribution with `slopes_moments` is within 5.1e-3 of every step.
const slopes_single = 3.0;

/// What lower parameters count as, where 2e-34 of the reach is in the picture.
const slopes_lowest = -12.0;

/// The factors (e, f) of the covariance, e against the view and f across it to its left: s = s̄ + e u + f w.
///
/// Views within 1e-18 of the normal count as it, where e is along −x; covariances are scaled to variances of 1e18 at
/// most. e eᵀ + f fᵀ is within 2e-4 tr Σ of every Σ; for a correlation of ρ, f is within 1e-7 / (1 − ρ²) of itself.
///
/// Source: the Cholesky factor of Σ along the view: e = −Σ v̂ / √(v̂ᵀ Σ v̂), |f| = √(det Σ / v̂ᵀ Σ v̂).
/// Domain: view unit, covariance psd(0.1, 2, 0.9).
/// Error: 1e-6 relative; f32 rounding at the largest correlation.
fn slopes_factor(view: vec3f, covariance: vec3f) -> vec4f {
    let v = clamp(view.xy, vec2f(-1.0), vec2f(1.0));
    let squared = dot(v, v);
    let toward = select(vec2f(1.0, 0.0), v * inverseSqrt(max(squared, 1e-36)), squared > 1e-36);
    let scaled = covariance * (2.5e17 / clamp(0.25 * max(covariance.x, covariance.z), 2.5e17, 8e37)); // to 2¹²⁶
    let c = clamp(scaled.xz, vec2f(), vec2f(1e18));
    let most = sqrt(c.x) * sqrt(c.y);
    let both = clamp(scaled.y, -most, most);
    let product = vec2f(c.x * toward.x + both * toward.y, both * toward.x + c.y * toward.y);
    let whole = c.x + c.y;
    // v̂ᵀ Σ v̂, with what its terms leave where they cancel, and not below |Σ v̂|² / tr Σ: |e|² is at most tr Σ.
    let terms = dot(c, toward * toward);
    let along = dot(toward, product);
    let least = max(2e-7 * terms, dot(product, product) / max(whole, 1e-36));
    let inverse = inverseSqrt(max(max(along, least), 1e-36));
    let e = product * -inverse;
    // |f|² is det Σ / v̂ᵀ Σ v̂ and tr Σ − |e|²: the former loses its digits where hardly any slope is along the view.
    let determinant = max(c.x * c.y - both * both, 0.0) * inverse * inverse;
    let certain = along > 1e-3 * terms && along * whole > c.x * c.y;
    let across = sqrt(select(max(whole - dot(e, e), 0.0), determinant, certain));
    return vec4f(e, vec2f(-toward.y, toward.x) * across);
}

/// The parameter a of visible slopes: how many deviations the mean slope is from facing away; large along the normal.
///
/// Source: the definition, m / τ.
/// Domain: view unit, mean_slope in [-1, 1], factor in [-2, 2].
/// Error: 2e-6 of 1 + the result; f32 rounding where the reach is 0.1.
fn slopes_parameter(view: vec3f, mean_slope: vec2f, factor: vec4f) -> f32 {
    let rise = clamp(view.z - dot(view.xy, mean_slope), -1e18, 1e18);
    let reach = clamp(-dot(view.xy, factor.xy), 1e-18, 1e18);
    return max(rise / reach, slopes_lowest);
}

/// Mean and variance of u for a view `depth` deviations below the horizon, and the mean weight E[max(u − depth, 0)].
///
/// Source: V by a rational fit of the notes behind the crate; R from V = 2 − R (R + a), the weight φ / (1 + depth R).
/// Domain: depth in [0, 12].
/// Error: 1e-6 relative; fit and f32 rounding. Variance and weight are within 5e-6 and 1e-5 of themselves.
fn slopes_tail(depth: f32) -> vec3f {
    let x = clamp(depth, 0.0, 12.0);
    let above = 0.429204609 + x * (0.192759664 + x * (0.0430011988 + x * 0.00512777183));
    let below = 1.0 + x * (0.862643903 + x * (0.403904939 + x * (0.119602567
        + x * (0.0214988881 + x * 0.00256388592))));
    let variance = above / below;
    let mean = 0.5 * (x + sqrt(x * x + (8.0 - 4.0 * variance)));
    return vec3f(mean, variance, 0.3989422804 * exp(-0.5 * x * x) / (1.0 + x * mean)); // φ(0) = 1/√(2π)
}

/// Mean R and variance V of u.
///
/// Source: R = Φ(a) / (φ(a) + a Φ(a)), V = 2 − R (R + a), which cancel below 0, where `slopes_tail` takes their place.
/// Domain: parameter in [-12, 20].
/// Error: 1e-6 of 1 + the result; fit and f32 rounding.
fn slopes_moments(parameter: f32) -> vec2f {
    let a = clamp(parameter, slopes_lowest, 1e18);
    let x = abs(a);
    let tail = slopes_tail(x);
    let mean = (1.0 - tail.x * tail.z) / (x + tail.z);
    return select(vec2f(mean, 2.0 - mean * (mean + x)), tail.xy, a < 0.0);
}

/// Skewness of u, positive: of the visible slopes along the view it is as much against the view.
///
/// Source: (a + 2 R) (1 − V) − R over V^(3/2); below 0 a rational fit with the limit √2 of a gamma distribution.
/// Domain: parameter in [-12, 20].
/// Error: 4e-5 absolute; of the fit, and of parameters beyond 40, which count as 40.
fn slopes_skewness(parameter: f32) -> f32 {
    let a = clamp(parameter, slopes_lowest, 40.0);
    let x = max(-a, 0.0);
    let above = 0.63108766 + x * (0.45874601 + x * (0.12286144 + x * 0.015524246));
    let below = 1.0 + x * (0.36044467 + x * (0.08730179 + x * 0.0109773));
    let m = slopes_moments(a);
    return select(((a + 2.0 * m.x) * (1.0 - m.y) - m.x) / (m.y * sqrt(m.y)), above / below, a < 0.0);
}

/// Area of the surface in the picture, hidden or not, for a unit of area of the mean plane: E[max(t, 0)].
/// Over a level surface it is v.z (1 + Λ) with Smith's Λ of the view: times the masking the mean plane's own.
///
/// Source: the definition, max(m, 0) + τ E[max(u − |a|, 0)].
/// Domain: view unit, mean_slope in [-1, 1], factor in [-2, 2].
/// Error: 4e-7 absolute; f32 rounding.
fn slopes_area(view: vec3f, mean_slope: vec2f, factor: vec4f) -> f32 {
    let rise = clamp(view.z - dot(view.xy, mean_slope), -1e18, 1e18);
    let reach = clamp(-dot(view.xy, factor.xy), 0.0, 1e18);
    return max(rise, 0.0) + reach * slopes_tail(abs(slopes_parameter(view, mean_slope, factor))).z;
}

/// Two normal distributions of equal shares that stand for u, with its mean and variance together: mean and variance of
/// the lower one, then of the higher one; from 2 to `slopes_single` they become one. A step's mean is off by up to
/// 1.2e-2 for parameters above 0 and 2.5e-2 above −3, by a single one with `slopes_moments` 4.7e-2 and 8.5e-2.
///
/// Source: a fit of the largest error of a step, of the notes behind the crate.
/// Domain: parameter in [-12, 2].
/// Error: 6e-3 absolute; from the pair with the least largest error of a step.
fn slopes_pair(parameter: f32) -> vec4f {
    let m = slopes_moments(parameter);
    let r = m.x;
    let two = clamp(slopes_single - parameter, 0.0, 1.0);
    let apart = two * r * (2.18622 + 5.5444 * r) / (1.0 + r * (0.13134 + 5.07137 * r));
    let uneven = two * 0.55785 * r * r / (1.0 + r * (0.75157 * r - 0.05676));
    let shift = 0.5 * apart * sqrt(m.y);
    let rest = m.y - shift * shift;
    return vec4f(r - shift, rest * (1.0 - uneven), r + shift, rest * (1.0 + uneven));
}

/// Covariance of slopes when u has the given variance: variance · e eᵀ + f fᵀ.
///
/// Source: the definition.
/// Domain: factor in [-2, 2], variance in [0, 1].
/// Error: 1e-6 absolute; f32 rounding of sums up to 8.
fn slopes_covariance(factor: vec4f, variance: f32) -> vec3f {
    return clamp(variance, 0.0, 1.0) * factor.xxy * factor.xyy + factor.zzw * factor.zww;
}

/// Mean and deviation of the slopes' component along a direction when u has the given mean and variance.
///
/// Source: the definition, d · s̄ + mean · d · e and √(variance (d · e)² + (d · f)²).
/// Domain: direction unit, mean_slope in [-1, 1], factor in [-2, 2], mean in [-1, 12], variance in [0, 1].
/// Error: 6e-6 absolute; f32 rounding of sums up to 36.
fn slopes_along(direction: vec2f, mean_slope: vec2f, factor: vec4f, mean: f32, variance: f32) -> vec2f {
    let d = clamp(direction, vec2f(-1.0), vec2f(1.0));
    let part = vec2f(dot(d, factor.xy), dot(d, factor.zw));
    let both = clamp(variance, 0.0, 1.0) * part.x * part.x + part.y * part.y;
    return vec2f(dot(d, mean_slope) + clamp(mean, -1e9, 1e9) * part.x, sqrt(both));
}
