// Moments of piecewise cubics over a normal variable x, piece by piece.
//
// What a piece adds is the integral of (q − a, (q − a)², q′ − b, (q′ − b)²) times the density of x over the piece,
// where `about` = (a, b) is one pair of numbers for all pieces. Where it is what the curve and its slope are at the
// mean, nothing cancels however narrow the distribution is. `piece_statistics` makes means and variances of the sum. A
// piece with two ends has x in [0, 1], to which the caller shifts and scales mean and deviation; slopes are by that x.
//
// About the mean, moments of a normal variable between two ends follow from one another. Between ends much less than a
// deviation apart that cancels: there the integral is by the nodes of Gauss and Legendre, of Abramowitz and Stegun
// 1964, "Handbook of Mathematical Functions", table 25.4, without what is beyond 5 deviations. Deviations below 1e-6
// count as 1e-6, and of pieces without ends values beyond 1e5 as that.

/// A cubic and its slope: q(x) = c.x + c.y x + c.z x² + c.w x³ and q′(x).
///
/// Source: the definition, by Horner's rule.
/// Domain: at in [-2, 2], coefficients in [-1, 1].
/// Error: 4e-7 of 1 + the result; f32 rounding.
fn piece_curve(at: f32, coefficients: vec4f) -> vec2f {
    let c = coefficients;
    let x = clamp(at, -1e5, 1e5);
    return vec2f(c.x + x * (c.y + x * (c.z + x * c.w)), c.y + x * (2.0 * c.z + 3.0 * x * c.w));
}

/// Probability that a standard normal variable is between two values.
///
/// Source: the definition; both ends in the lower tail, which keeps the digits of small probabilities.
/// Domain: low in [-12, 12], high in [-12, 12].
/// Error: 5e-7 absolute; that of `normal_cdf`. Where `high` is below `low` it is the negative probability.
fn piece_mass(low: f32, high: f32) -> f32 {
    let upper = 0.5 * low + 0.5 * high > 0.0;
    return normal_cdf(select(high, -low, upper)) - normal_cdf(select(low, -high, upper));
}

/// What a constant piece adds: `height` is (q − a, −b), `low` and `high` are its ends in deviations from the mean.
///
/// Source: the definition.
/// Domain: low in [-12, 12], high in [-12, 12], height in [-1, 1].
/// Error: 5e-7 absolute; that of `piece_mass`.
fn piece_flat(low: f32, high: f32, height: vec2f) -> vec4f {
    return piece_mass(low, high) * vec4f(height.x, height.x * height.x, height.y, height.y * height.y);
}

/// What the line c.x + c.y x over x in [0, 1] adds.
///
/// Source: the definition; moments about the mean up to the second between ends at least a deviation apart, else four
/// nodes.
/// Domain: mean in [-3, 4], deviation log in [1e-4, 10], coefficients in [-1, 1], about in [-1, 1].
/// Error: 9e-6 absolute; of moments between ends about a deviation apart.
fn piece_line(mean: f32, deviation: f32, coefficients: vec2f, about: vec2f) -> vec4f {
    let m = clamp(mean, -1e9, 1e9);
    let s = clamp(deviation, 1e-6, 1e9);
    let r = 1.0 / s;
    let a = clamp(-m * r, -10.0, 10.0);
    let b = clamp((1.0 - m) * r, -10.0, 10.0);
    let mass = piece_mass(a, b);
    let q = coefficients.y - about.y;
    let low = clamp(m - 5.0 * s, 0.0, 1.0);
    let high = clamp(m + 5.0 * s, 0.0, 1.0);
    if high - low < s {
        let radius = 0.5 * (high - low);
        let x = 0.5 * (high + low) + radius * vec4f(-0.861136312, -0.339981044, 0.339981044, 0.861136312);
        let z = (x - m) * r;
        let heights = coefficients.x - about.x + x * coefficients.y;
        let parts = heights * exp2(-0.7213475204 * z * z) // 1/(2 ln 2)
            * vec4f(0.347854845, 0.652145155, 0.652145155, 0.347854845);
        let scale = 0.3989422804 * radius * r; // 1/√(2π)
        let sums = scale * vec2f(dot(parts, vec4f(1.0)), dot(parts, heights));
        return vec4f(sums, q * mass, q * q * mass);
    }
    let start = 0.3989422804 * exp2(-0.7213475204 * a * a);
    let end = 0.3989422804 * exp2(-0.7213475204 * b * b);
    let p = vec2f(coefficients.x - about.x + m * coefficients.y, coefficients.y * s);
    let first = start - end;
    let v = vec2f(dot(p, vec2f(mass, first)), dot(p, vec2f(first, mass + a * start - b * end)));
    return vec4f(v.x, dot(p, v), q * mass, q * q * mass);
}

/// What c.x + c.y x + c.z x² over all x above 0 adds; `distance` is the mean.
///
/// Source: the definition; moments about the mean up to the fourth above an end.
/// Domain: distance in [-2, 2], deviation log in [1e-4, 1], coefficients in [-1, 1], about in [-1, 1].
/// Error: 5e-5 absolute; f32 rounding of squares up to 100.
fn piece_half(distance: f32, deviation: f32, coefficients: vec3f, about: vec2f) -> vec4f {
    let d = clamp(distance, -1e5, 1e5);
    let s = clamp(deviation, 1e-6, 1e5);
    let a = clamp(-d / s, -10.0, 10.0);
    let mass = select(normal_cdf(-a), 0.0, a > 8.0); // where the normal distribution of the shelf ends
    let c = coefficients;
    let first = select(0.3989422804 * exp2(-0.7213475204 * a * a), 0.0, a > 8.0);
    let second = mass + a * first;
    let third = (2.0 + a * a) * first;
    let fourth = 3.0 * second + a * a * a * first;
    let limit = vec3f(1e17);
    let p = clamp(vec3f(c.x - about.x + d * (c.y + d * c.z), (c.y + 2.0 * d * c.z) * s, c.z * s * s), -limit, limit);
    let q = clamp(vec2f(c.y - about.y + 2.0 * d * c.z, 2.0 * c.z * s), -limit.xy, limit.xy);
    let v = vec3f(
        dot(p, vec3f(mass, first, second)), dot(p, vec3f(first, second, third)), dot(p, vec3f(second, third, fourth)),
    );
    let w = vec2f(dot(q, vec2f(mass, first)), dot(q, vec2f(first, second)));
    return vec4f(v.x, dot(p, v), w.x, dot(q, w));
}

/// Mean and variance of a cubic, and of its slope, over all x.
///
/// Source: the definition, by the moments 1, 0, 1, 0, 3, 0, 15 of a standard normal variable.
/// Domain: mean in [-2, 2], deviation log in [1e-4, 1], coefficients in [-1, 1].
/// Error: 1e-6 of 1 + the result; f32 rounding.
fn piece_whole(mean: f32, deviation: f32, coefficients: vec4f) -> vec4f {
    let m = clamp(mean, -1e5, 1e5);
    let s = clamp(deviation, 1e-6, 1e5);
    let limit = vec3f(1e17);
    let value = piece_curve(m, coefficients);
    let bend = coefficients.z + 3.0 * m * coefficients.w;
    let p = clamp(vec3f(value.y * s, bend * s * s, coefficients.w * s * s * s), -limit, limit);
    let q = clamp(vec2f(2.0 * bend * s, 3.0 * coefficients.w * s * s), -limit.xy, limit.xy);
    return vec4f(
        value.x + p.y, p.x * p.x + 6.0 * p.x * p.z + 15.0 * p.z * p.z + 2.0 * p.y * p.y,
        value.y + q.y, q.x * q.x + 2.0 * q.y * q.y,
    );
}

/// Mean and variance of the curve, and of its slope, from what all pieces add.
///
/// Source: the definition; variances about `about` less the squared distance of the mean to it.
/// Domain: sum in [-1, 1], about in [-1, 1].
/// Error: 1.5e-7 absolute; f32 rounding.
fn piece_statistics(sum: vec4f, about: vec2f) -> vec4f {
    let variances = max(sum.yw - sum.xz * sum.xz, vec2f(0.0));
    return vec4f(about.x + sum.x, variances.x, about.y + sum.z, variances.y);
}
