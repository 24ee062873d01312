// Smith's Λ: how much of a rough surface lies out of sight along a direction, for slopes of a normal distribution.
//
// Symbols: ω is a unit direction away from the surface, z up the macroscopic normal; θ its angle from there, φ its
// azimuth. Slopes s, with the normal ∝ (−s.x, −s.y, 1), have the mean s̄ and the covariance C (xx, xy, yy); s̄(φ) and
// σ(φ) are the mean and the deviation along φ.
//   a = (cot θ − s̄(φ)) / (√2 σ(φ)) = (ω.z − s̄·ω.xy) / √(2 ω.xyᵀ C ω.xy)
//   Λ = E[max(s − cot θ, 0)] / (cot θ − s̄(φ)) = exp(−a²) / (2 √π a) − erfc(a) / 2
// The right-hand side of a needs no angle and holds along the normal, where there is no azimuth. A direction at or
// below the horizon of the mean surface, ω.z ≤ s̄·ω.xy, sees nothing: its a is 0 and its Λ beyond `smith_horizon`. A
// flat surface (C = 0) hides nothing: its a is 10, where Λ is below 1e-44.

/// From this value on a Λ, or the sum of two, says that a direction is at or below the horizon. Above it the sum of two
/// is at most 1.05e6.
const smith_horizon: f32 = 1.5e6;

/// The visibility parameter a from the height that a direction wins over the mean surface and the variance of the
/// heights that slopes win, both for a unit of length along it.
///
/// Variances below 5e-38 count as 5e-38.
///
/// Source: the definition, (cot θ − s̄(φ)) / (√2 σ(φ)), both scaled by sin θ.
/// Domain: rise in [-1, 1], variance log in [1e-6, 10].
/// Error: 2e-7 relative; f32 rounding.
fn smith_ratio(rise: f32, variance: f32) -> f32 {
    return clamp(rise * inverseSqrt(max(2.0 * variance, 1e-37)), 0.0, 10.0);
}

/// The visibility parameter a of a direction, from 0 (at or below the horizon) to 10 (nothing is hidden any more).
///
/// Covariances beyond 1e30 count as 1e30; the mean slope is finite. |dΛ| / (1 + Λ) was measured as up to
/// 1.5e-7 / (1 − |ρ|) for slopes of the correlation ρ, half of which is what f32 covariances cost whoever reads them.
/// Over a tilted surface it is up to 1e-6 + 1e-7 / r, r being ω.z − s̄·ω.xy, a difference that rounds.
///
/// Source: Heitz et al. 2014, "Filtering Non-Linear Transfer Functions on Surfaces", equation 2, its argument of erfc.
/// Domain: direction unit, covariance psd(0.1, 2, 0.9), mean_slope in [-1, 1].
/// Error: 1e-6 of 1 + the result; f32 rounding of the difference over the least deviation.
fn smith_parameter(direction: vec3f, covariance: vec3f, mean_slope: vec2f) -> f32 {
    return smith_ratio(direction.z - dot(mean_slope, direction.xy), smith_variance(direction.xy, covariance));
}

/// The visibility parameter a of a direction where the mean slope is 0.
///
/// Source: as `smith_parameter`.
/// Domain: direction unit, covariance psd(0.1, 2, 0.9).
/// Error: 1.5e-6 relative; f32 rounding at the largest correlation.
fn smith_parameter_level(direction: vec3f, covariance: vec3f) -> f32 {
    return smith_ratio(direction.z, smith_variance(direction.xy, covariance));
}

/// The visibility parameter a of a direction where the mean slope is 0 and slopes have the same deviation all around.
///
/// Deviations beyond 1e15 count as 1e15.
///
/// Source: as `smith_parameter`, with C = σ² I.
/// Domain: direction unit, deviation log in [0.001, 10].
/// Error: 4e-7 relative; f32 rounding.
fn smith_parameter_round(direction: vec3f, deviation: f32) -> f32 {
    let reach = min(deviation, 1e15) * direction.xy;
    return smith_ratio(direction.z, reach.x * reach.x + reach.y * reach.y);
}

/// Variance of the height that slopes with the given covariance win over a horizontal way: wayᵀ C way.
///
/// Source: the definition.
/// Domain: way unit, covariance psd(0.1, 2, 0.9).
/// Error: 2.5e-6 relative; f32 rounding at the largest correlation.
fn smith_variance(way: vec2f, covariance: vec3f) -> f32 {
    let c = clamp(covariance, vec3f(-1e30), vec3f(1e30));
    return way.x * way.x * c.x + way.y * way.y * c.z + 2.0 * way.x * way.y * c.y;
}

/// Smith's Λ from the visibility parameter: at most 5.2e5, the value at 5.4e-7, above the horizon.
///
/// Source: Heitz et al. 2014, equation 2, as exp(−a²) P(a) / (a Q(a)) with minimax polynomials: positive and monotone.
/// Domain: parameter log in [5.4e-7, 10].
/// Error: 1e-6 of 1 + the result; fit 3e-7, the rest is f32 rounding and the device's exp2 and division.
fn smith_lambda(parameter: f32) -> f32 {
    let a = clamp(parameter, 5.4e-7, 10.0);
    let above = 1.0 + a * (0.786207037 + a * (0.306330949 + a * 0.0549253948));
    let below = a * (3.5449077 + a * (9.07027258 + a * (10.0718151
        + a * (6.19459959 + a * (2.16915158 + a * 0.389493397)))));
    return select(exp2(-1.44269504 * a * a) * above / below, 2.0 * smith_horizon, parameter <= 0.0);
}

/// Smith's Λ from the visibility parameter without an exponential; 0 from 2.2 on, with a continuous derivative.
///
/// Source: as `smith_lambda`, by (1 − a/2.2)² P(a) / (a Q(a)).
/// Domain: parameter log in [5.4e-7, 10].
/// Error: 9e-5 of 1 + the result; of the fit.
fn smith_lambda_fast(parameter: f32) -> f32 {
    let a = clamp(parameter, 5.4e-7, 2.2);
    let rest = 1.0 - a * 0.454545455;
    let above = rest * rest * (1.0 + a * (-1.00683313 + a * 0.276677117));
    let below = a * (3.5449077 + a * (-0.520585896 + a * (0.621214199 - a * 0.447606236)));
    return select(above / below, 2.0 * smith_horizon, parameter <= 0.0);
}
