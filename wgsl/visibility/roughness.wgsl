// Roughness: a covariance of slopes handed to a BRDF, whose own slopes theirs are added to.
//
// Beckmann of roughness α has normal slopes of the variance α²/2 both ways. Slopes of a surface on a surface add and so
// do their covariances: with normal ones of the covariance Σ it is Beckmann again, exactly, of α² + 2 λ along each axis
// of Σ, λ the variance there. GGX has slopes of infinite variance and does not stay GGX: the same sums are a convention
// there, which leaves the peak of the distribution too high, by up to a quarter where 2 λ is about α². Mean slopes turn
// the shading normal and are no roughness.

/// Roughness α of a round BRDF with a covariance of slopes added: √(α² + tr Σ).
///
/// For Beckmann that is exact where the covariance is round, and the one of the same mean square of the slope
/// elsewhere; for GGX it is a convention.
///
/// Source: the mean square of a slope of Beckmann's distribution is α²; those of slopes that add do.
/// Domain: roughness in [0, 1], covariance psd(0.01, 1, 0.9).
/// Error: 3e-7 absolute; f32 rounding.
fn roughness_round(roughness: f32, covariance: vec3f) -> f32 {
    let alpha = clamp(roughness, 0.0, 1e18);
    return sqrt(alpha * alpha + clamp(covariance.x, 0.0, 1e36) + clamp(covariance.z, 0.0, 1e36));
}

/// Roughness α of a BRDF along both axes of a covariance of slopes that is added, whose deviations there are given as
/// `footprint_deviations` has them, with `footprint_direction` along the first: √(α² + 2 σ²).
///
/// For Beckmann that is exact, for GGX it is a convention.
///
/// Source: the variance of a component of the slope of Beckmann's distribution is α²/2; those of slopes that add do.
/// Domain: roughness in [0, 1], deviations in [0, 1].
/// Error: 3e-7 absolute; f32 rounding.
fn roughness_axes(roughness: f32, deviations: vec2f) -> vec2f {
    let alpha = clamp(roughness, 0.0, 1e18);
    let sigma = clamp(deviations, vec2f(), vec2f(1e18));
    return sqrt(alpha * alpha + 2.0 * sigma * sigma);
}
