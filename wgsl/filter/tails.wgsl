// Ch by shorter tails: the mean of a piece of a color map over visible heights, a term a knot, for fewer operations
// than those of `height.wgsl`.
//
// The mean excess over a threshold x deviations from the mean height is peak · 2^−p(x) as there, with p of degree 3 and
// coefficients that are linear in the skewness. They have the least largest error of a step for `lambda` up to 1e4:
// 1.46e-3, by linear programs; `spirv-tests` measures it against quadrature. `distance` is always mean − t, with the
// mean of the visible heights. Deviations below 1e-6 count as 1e-6.

/// Both tails of a skewed distribution: the reciprocal of its deviation, the mean excess over its mean, and what the
/// bits p(x) = x (c₁ + x (c₂ + x c₃)) that it loses with each deviation have for coefficients on either side.
struct tails_short {
    rate: f32,
    peak: f32,
    high: vec3f,
    low: vec3f,
}

/// The tails of visible heights that have the given deviation and skewness.
///
/// Source: a fit of the largest error of a step, D_h being Heitz et al. 2014, equation 15.
/// Domain: deviation log in [1e-6, 0.5], skewness in [0, 0.8624].
/// Error: 5e-2 relative; from the polynomials with the least mean square error of the excess.
fn tails_skewed(deviation: f32, skewness: f32) -> tails_short {
    let s = max(deviation, 1e-6);
    let g = clamp(skewness, 0.0, 0.87);
    let high = vec3f(1.7981295, 0.433544248, 0.0026157496) - g * vec3f(0.175407563, 0.308370695, 0.038842712);
    let low = vec3f(1.80573329, 0.410584826, 0.0160917922) + g * vec3f(0.298049079, 0.287143052, 0.343058968);
    return tails_short(1.0 / s, s * (0.399992878 - 0.0116026074 * g), high, low);
}

/// Mean of the kink max(h − t, 0), less the kink of the mean.
///
/// Source: Heitz et al. 2014, "Filtering Non-Linear Transfer Functions on Surfaces", equation 9 over D_h.
/// Domain: distance in [-1.5, 1.5], tails from tails_skewed.
/// Error: 1.1e-3 absolute; of the fit.
fn tails_excess(distance: f32, tails: tails_short) -> f32 {
    let z = distance * tails.rate;
    let x = min(abs(z), 6.0);
    let c = select(tails.high, tails.low, z > 0.0);
    return tails.peak * exp2(-x * (c.x + x * (c.y + x * c.z)));
}

/// Mean of the kink max(h − t, 0).
///
/// Source: as `tails_excess`.
/// Domain: distance in [-1.5, 1.5], tails from tails_skewed.
/// Error: 1.1e-3 absolute; of the fit.
fn tails_kink(distance: f32, tails: tails_short) -> f32 {
    return max(distance, 0.0) + tails_excess(distance, tails);
}

/// Mean of the step h > t: the derivative of the kink's mean by the distance.
///
/// Source: as `tails_excess`, of a step.
/// Domain: distance in [-1.5, 1.5], tails from tails_skewed.
/// Error: 1.5e-3 absolute; of the fit.
fn tails_step(distance: f32, tails: tails_short) -> f32 {
    let z = distance * tails.rate;
    let x = min(abs(z), 6.0);
    let c = select(tails.high, tails.low, z > 0.0);
    let q = c.y + x * c.z;
    let slope = c.x + x * (2.0 * q + x * c.z);
    let tail = 0.69314718 * tails.rate * tails.peak * slope * exp2(-x * (c.x + x * q)); // ln 2
    return select(tail, 1.0 - tail, z > 0.0);
}

/// Mean of the ramp that rises from 0 at t to 1 at t + width: clamp((h − t)/width, 0, 1).
///
/// Where it is much narrower than the deviation, a difference of kinks cancels: it is a step at its middle there.
///
/// Source: as `tails_excess`, of a ramp.
/// Domain: distance in [-1.5, 1.5], width log in [1e-5, 1], tails from tails_skewed.
/// Error: 1.5e-3 absolute; that of `tails_step`.
fn tails_ramp(distance: f32, width: f32, tails: tails_short) -> f32 {
    let past = distance - width;
    if width * tails.rate < 0.02 {
        // From both ends: a compiler may fold half a width into t, which may be too far from 0 to hold it.
        return tails_step(0.5 * (distance + past), tails);
    }
    let excess = tails_excess(distance, tails) - tails_excess(past, tails);
    return clamp((clamp(distance, 0.0, width) + excess) / width, 0.0, 1.0);
}
