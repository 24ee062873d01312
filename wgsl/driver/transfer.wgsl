// Height transfers h = g(f) between a driver and a filter: from what a footprint holds of f to what it holds of h.

/// What a footprint holds of h = g(f) and of its slopes. `moments` are mean and variance of h and of g′(f); `slope` and
/// `slope_covariance` are mean and covariance of the slopes of f.
///
/// A Gaussian f and its gradient are independent at a point, and the slopes of h are g′(f) times those of f: their mean
/// is ⟨g′⟩ s, their covariance ⟨g′²⟩ Λ + Var(g′) s sᵀ. Skewness and excess kurtosis of h are not known.
///
/// Source: Heitz et al. 2014, "Filtering Non-Linear Transfer Functions on Surfaces", equations 24 to 26.
/// Domain: moments in [0, 1], slope in [-2, 2], slope_covariance psd(0.01, 1, 0.95).
/// Error: 2e-7 of 1 + the result; f32 rounding.
fn transfer_surface(moments: vec4f, slope: vec2f, slope_covariance: vec3f) -> statistics_surface {
    let variance = max(moments.w, 0.0);
    let square = variance + moments.z * moments.z;
    let tilt = vec3f(slope.x * slope.x, slope.x * slope.y, slope.y * slope.y);
    return statistics_surface(
        vec4f(moments.xy, 0.0, 0.0), moments.z * slope, square * slope_covariance + variance * tilt,
    );
}
