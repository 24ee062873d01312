// Ch: the mean of a color map over visible heights, a term a knot, or read from a table.
//
// For a threshold x deviations above or below the mean height, the mean excess over it, where it lies above, or what
// falls short of it, where it lies below, is peak · 2^−p(x), with a polynomial p for each side. For normal heights both
// are the same; of skewed ones the higher side falls off slower. A kink's mean needs no more than one exp2, and a step
// is its derivative, so that both belong to one distribution and a map errs by its total variation times the step error
// at most. `distance` is always mean − t, with the mean of the visible heights. Deviations below 1e-6 count as 1e-6.
//
// The coefficients are polynomials of the skewness, exact at 0, fitted to the largest error of a step by D_h of
// Heitz et al. 2014 over `lambda` up to 1e4; `spirv-tests` measures them against quadrature.

/// Both tails of a skewed distribution: the reciprocal of its deviation, the mean excess over its mean, and what the
/// bits p(x) = x (c₁ + x (c₂ + x (c₃ + x c₄))) that it loses with each deviation have for coefficients on either side.
struct height_tails {
    rate: f32,
    peak: f32,
    high: vec4f,
    low: vec4f,
}

/// The tails of visible heights that have the given deviation and skewness.
///
/// Source: a fit of the largest error of a step, D_h being Heitz et al. 2014, equation 15.
/// Domain: deviation log in [1e-6, 0.5], skewness in [0, 0.8624].
/// Error: 2e-2 relative; from the polynomials with the least mean square error of the excess.
fn height_skewed(deviation: f32, skewness: f32) -> height_tails {
    let s = max(deviation, 1e-6);
    let g = clamp(skewness, 0.0, 0.87);
    let normal = vec4f(1.80815009, 0.411667033, 0.0430004075, -0.00331234344);
    let high = normal + g * (vec4f(-0.22897391, -0.31533554, -0.19565634, -0.0059924)
        + g * (vec4f(0.03152959, 0.08519961, 0.15860017, 0.05047951)
            + g * vec4f(0.01493108, -0.02829854, -0.03864926, -0.03998497)));
    let low = normal + g * (vec4f(0.2693587, 0.29067212, 0.15251818, -0.04190442)
        + g * vec4f(0.02466925, 0.08755416, 0.02842733, 0.16013811));
    let peak = 0.39894228 - g * (0.00385772 + g * 0.0080717); // φ(0) = 1/√(2π)
    return height_tails(1.0 / s, s * peak, high, low);
}

/// Mean of the kink max(h − t, 0), less the kink of the mean.
///
/// Source: Heitz et al. 2014, "Filtering Non-Linear Transfer Functions on Surfaces", equation 9 over D_h.
/// Domain: distance in [-1.5, 1.5], tails from height_skewed.
/// Error: 1e-4 absolute; 1.7e-4 deviations of the fit.
fn height_excess(distance: f32, tails: height_tails) -> f32 {
    let z = distance * tails.rate;
    let x = min(abs(z), 6.0);
    let c = select(tails.high, tails.low, z > 0.0);
    return tails.peak * exp2(-x * (c.x + x * (c.y + x * (c.z + x * c.w))));
}

/// Mean of the kink max(h − t, 0).
///
/// Source: as `height_excess`.
/// Domain: distance in [-1.5, 1.5], tails from height_skewed.
/// Error: 1e-4 absolute; 1.7e-4 deviations of the fit.
fn height_kink(distance: f32, tails: height_tails) -> f32 {
    return max(distance, 0.0) + height_excess(distance, tails);
}

/// Mean of the step h > t: the derivative of the kink's mean by the distance.
///
/// Source: as `height_excess`, of a step.
/// Domain: distance in [-1.5, 1.5], tails from height_skewed.
/// Error: 2e-4 absolute; of the fit.
fn height_step(distance: f32, tails: height_tails) -> f32 {
    let z = distance * tails.rate;
    let x = min(abs(z), 6.0);
    let c = select(tails.high, tails.low, z > 0.0);
    let q = c.y + x * (c.z + x * c.w);
    let bits = x * (c.x + x * q);
    let slope = c.x + x * (2.0 * q + x * (c.z + x * (2.0 * c.w)));
    let tail = 0.69314718 * tails.rate * tails.peak * slope * exp2(-bits); // ln 2
    return select(tail, 1.0 - tail, z > 0.0);
}

/// Mean of the ramp that rises from 0 at t to 1 at t + width: clamp((h − t)/width, 0, 1).
///
/// Where it is much narrower than the deviation, a difference of kinks cancels: it is a step at its middle there.
///
/// Source: as `height_excess`, of a ramp.
/// Domain: distance in [-1.5, 1.5], width log in [1e-5, 1], tails from height_skewed.
/// Error: 2e-4 absolute; that of `height_step`.
fn height_ramp(distance: f32, width: f32, tails: height_tails) -> f32 {
    let past = distance - width;
    if width * tails.rate < 0.02 {
        // From both ends: a compiler may fold half a width into t, which may be too far from 0 to hold it.
        return height_step(0.5 * (distance + past), tails);
    }
    let excess = height_excess(distance, tails) - height_excess(past, tails);
    return clamp((clamp(distance, 0.0, width) + excess) / width, 0.0, 1.0);
}

/// Mean of the map whose knots are the texels of a texture, as `texture_knots` has them, over visible heights.
///
/// Source: as `height_excess`, of a piecewise-linear map.
/// Domain: mean in [-0.5, 1.5], tails from height_skewed.
/// Error: 5e-4 absolute; for 32 knots with colors in [0, 1], and at most that of `height_step` times the total
/// variation.
fn height_knots(mean: f32, tails: height_tails, knots: texture_2d<f32>) -> vec4f {
    let last = i32(textureDimensions(knots).x) - 1;
    var left = textureLoad(knots, vec2i(0, 0), 0);
    var position = textureLoad(knots, vec2i(0, 2), 0).x;
    var sum = left;
    var low = left;
    var high = left;
    for (var i = 0; i <= last; i++) {
        let right = textureLoad(knots, vec2i(i, 1), 0);
        let distance = mean - position;
        if any(right != left) {
            sum += (right - left) * height_step(distance, tails);
        }
        low = min(low, min(left, right));
        high = max(high, max(left, right));
        if i < last {
            left = textureLoad(knots, vec2i(i + 1, 0), 0);
            let next = textureLoad(knots, vec2i(i + 1, 2), 0).x;
            sum += (left - right) * height_ramp(distance, next - position, tails);
            position = next;
        }
    }
    return clamp(sum, low, high);
}

/// Mean of a map over visible heights of the given mean, deviation and skewness, from a table of means.
///
/// `origin` is the texture coordinate of the mean 0, `per_mean` and `per_root` are how much of the texture a unit of
/// the mean and of the root of the deviation are. Skewnesses reach from 0 to 0.862467, that of a Λ of 1e4. The sampler
/// clamps at the edges: values outside read the table's border.
///
/// Source: Heitz et al. 2014, section 5.1, with an axis for the skewness, which its normal distribution has not.
/// Domain: mean in [-0.25, 1.25], deviation log in [0.05, 0.5], skewness in [0, 0.862467],
///   origin in [0.072265625, 0.072265625], per_mean in [0.2734375, 0.2734375], per_root in [1.3700194, 1.3700194].
/// Error: 2e-3 absolute; trilinear interpolation of 256 × 32 × 4 nodes for matplotlib's terrain.
fn height_table(
    mean: f32, deviation: f32, skewness: f32, origin: f32, per_mean: f32, per_root: f32, table: texture_3d<f32>,
    table_sampler: sampler,
) -> vec4f {
    // Ends on the centers of the first and the last row and slice: ½/32, ½/4 and (4 − 1)/4 of the skewness' range.
    let x = clamp(origin + per_mean * mean, 0.0, 1.0);
    let at = vec3f(x, 0.015625 + per_root * sqrt(max(deviation, 0.0)), 0.125 + 0.869598 * skewness);
    return textureSampleLevel(table, table_sampler, at, 0.0);
}
