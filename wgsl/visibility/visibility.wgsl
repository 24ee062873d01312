// Shares of a rough surface that are seen and lit, from the Λ of the view and of the light (`smith_lambda`).
//
// A point at the height h is seen with the probability P(h)^Λ, P being the cumulative distribution of the heights.
// The sum of both Λ goes on to what is colored by height. Λ are not negative; one or a sum beyond `smith_horizon`, of a
// direction at or below the horizon, makes every share 0.

/// Share of the surface's points that are seen from a direction, or lit from it: the masking or shadowing of one
/// direction alone. With the sum of both Λ, the share that is seen and lit.
///
/// Source: Heitz et al. 2014, "Filtering Non-Linear Transfer Functions on Surfaces", below the line of equation 12,
///   with the density that its second integral lacks: ∫ p P^Λ dh = 1 / (1 + Λ).
/// Domain: lambda log in [1e-6, 1e6].
/// Error: 2e-7 absolute; f32 rounding and the device's division.
fn visibility_masking(lambda: f32) -> f32 {
    // The quotient of 1 may round to more, as in `visibility_shadowing`.
    return select(min(1.0 / (1.0 + max(lambda, 0.0)), 1.0), 0.0, lambda >= smith_horizon);
}

/// Share of the seen points that are lit, V̄, from the Λ of view and light: 1 without shadows, never more.
///
/// `light_lambda` is the light's own, or what `visibility_correlated` leaves of it. V̄ times the view's masking is the
/// share that is seen and lit.
///
/// Source: Heitz et al. 2014, equation 12, (1 + Λo) / (1 + Λo + Λi).
/// Domain: view_lambda log in [1e-6, 5e5], light_lambda log in [1e-6, 5e5].
/// Error: 2e-7 absolute; f32 rounding and the device's division.
fn visibility_shadowing(view_lambda: f32, light_lambda: f32) -> f32 {
    let seen = 1.0 + max(view_lambda, 0.0);
    let both = seen + max(light_lambda, 0.0);
    // A quotient of equal numbers may round to more than 1: division is off by up to 2.5 units in the last place.
    return select(min(seen / both, 1.0), 0.0, both >= smith_horizon);
}

/// What is left of the light's Λ for points that are seen, where view and light come from similar azimuths.
///
/// It takes the place of the light's Λ, also in the sum: seen along the light, every point is lit (the hotspot). The
/// independence is that of `visibility_independence`; 1 returns the light's own Λ, and no independence more than
/// that.
///
/// Source: Heitz 2014, "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs", its form correlated by
///   heights and directions: max(Λo, Λi) + λ min(Λo, Λi), less Λo.
/// Domain: view_lambda log in [1e-6, 5e5], light_lambda log in [1e-6, 5e5], independence in [0, 1].
/// Error: 2e-7 of 1 + the result; f32 rounding.
fn visibility_correlated(view_lambda: f32, light_lambda: f32, independence: f32) -> f32 {
    return max(light_lambda - view_lambda, 0.0) + independence * min(view_lambda, light_lambda);
}

/// How independent the visibilities of view and light are by their azimuths: from 0 for the same one to 0.933 for
/// opposite ones. 0 where a direction is the normal, whose Λ is 0 anyway.
///
/// Source: van Ginneken et al. 1998, "Diffuse and specular reflectance from rough surfaces", as in Heitz 2014:
///   4.41 Δφ / (4.41 Δφ + 1). Δφ is 2 atan q, by an odd polynomial in q, of the acute angle between the azimuths.
/// Domain: view unit, light unit.
/// Error: 6e-6 absolute; fit 4.5e-6, the rest is f32 rounding.
fn visibility_independence(view: vec3f, light: vec3f) -> f32 {
    let along = dot(view.xy, light.xy);
    let across = abs(view.x * light.y - view.y * light.x);
    let whole = length(view.xy) * length(light.xy) + abs(along);
    let q = min(across / max(whole, 1e-37), 1.0);
    let u = q * q;
    let acute = q * (1.99995146 + u * (-0.66393392 + u * (0.37318503 + u * (-0.18828553 + u * 0.04994264))));
    let angle = select(acute, 3.14159265 - acute, along < 0.0);
    return 4.41 * angle / (4.41 * angle + 1.0);
}
