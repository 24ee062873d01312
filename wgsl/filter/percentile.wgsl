// Ch of maps that are written over percentiles: over the share p = P(h) of a rough surface that lies below a height h.
//
// Of the visible heights the share p^n lies below the percentile p, n = 1 + Λ, whatever the distribution of the heights
// is: neither mean nor deviation matters. `lambda` is the sum of Smith's Λ of view and light; above 1e6 it counts as
// that. A position t of the map comes as its `bits`, −log2 t: a difference 1 − p^n is lost to a t near 1 long before n
// is 1e6. A piecewise-linear map is its last color and, from there down, a sum of kinks max(t − p, 0), ramps and steps.

/// Mean of the step p < t: t^(1 + lambda).
///
/// Source: Heitz et al. 2014, "Filtering Non-Linear Transfer Functions on Surfaces", equation 15, integrated.
/// Domain: bits in [0, 40], lambda log in [1e-4, 1e6].
/// Error: 3e-7 absolute; f32 rounding and the device's exp2.
fn percentile_step(bits: f32, lambda: f32) -> f32 {
    let n = 1.0 + clamp(lambda, 0.0, 1e6);
    return exp2(-min(n * clamp(bits, 0.0, 1e9), 200.0));
}

/// Mean of the kink max(t − p, 0): t^(2 + lambda) / (2 + lambda).
///
/// With it a map that is linear in p has equation 3 of the source without its visibility.
///
/// Source: Heitz et al. 2014, equation 15, of max(t − p, 0).
/// Domain: bits in [0, 40], lambda log in [1e-4, 1e6].
/// Error: 2e-7 absolute; f32 rounding and the device's exp2 and division.
fn percentile_kink(bits: f32, lambda: f32) -> f32 {
    let m = 2.0 + clamp(lambda, 0.0, 1e6);
    return exp2(-min(m * clamp(bits, 0.0, 1e9), 200.0)) / m;
}

/// Mean of t^(2 + lambda) over positions t with bits in [bits, bits + span], evenly. Times span ln 2 / width it is the
/// mean of a ramp that falls from 1 at the lower end to 0 at the upper one.
///
/// The difference of two kinks over the span, and where that would cancel its hyperbolic sine by a series.
///
/// Source: Heitz et al. 2014, equation 15, of the ramp.
/// Domain: bits in [0, 20], span log in [1e-7, 20], lambda log in [1e-4, 1e6].
/// Error: 3e-7 absolute; f32 rounding and the device's exp2 and division.
fn percentile_ramp(bits: f32, span: f32, lambda: f32) -> f32 {
    let m = 2.0 + clamp(lambda, 0.0, 1e6);
    let high = clamp(bits, 0.0, 1e9);
    let wide = clamp(span, 0.0, 1e9);
    let fall = 0.34657359 * (m * wide); // half of ln 2
    if fall < 0.5 {
        let u = fall * fall;
        let series = 1.0 + u * (0.16666667 + u * (0.0083333333 + u * 0.00019841270)); // 1/3!, 1/5!, 1/7!
        return exp2(-min(m * (high + 0.5 * wide), 200.0)) * series;
    }
    let difference = exp2(-min(m * high, 200.0)) - exp2(-min(m * (high + wide), 200.0));
    return 0.5 * difference / fall;
}

/// Mean of the map whose knots are the texels of a texture: rows of left colors, right colors and positions, by
/// position. A position is its bits, the span of bits to the next one, and span ln 2 / width, 1e4 where bits are more.
///
/// Segment by segment and edge by edge, each a weight times a difference of colors, so that the knots may change
/// without the text; the result is clamped to the knots' colors. Costs a ramp a segment and a step a hard edge.
///
/// Source: Heitz et al. 2014, equation 15, of a piecewise-linear map.
/// Domain: lambda log in [1e-4, 1e6].
/// Error: 2e-6 absolute; a ramp's and a sum's, for up to 32 knots with colors in [0, 1].
fn percentile_knots(lambda: f32, knots: texture_2d<f32>) -> vec4f {
    let last = i32(textureDimensions(knots).x) - 1;
    var left = textureLoad(knots, vec2i(0, 0), 0);
    var sum = left;
    var low = left;
    var high = left;
    for (var i = 0; i <= last; i++) {
        let right = textureLoad(knots, vec2i(i, 1), 0);
        let position = textureLoad(knots, vec2i(i, 2), 0);
        if any(right != left) {
            sum += (right - left) * (1.0 - percentile_step(position.x, lambda));
        }
        low = min(low, min(left, right));
        high = max(high, max(left, right));
        if i < last {
            left = textureLoad(knots, vec2i(i + 1, 0), 0);
            let next = textureLoad(knots, vec2i(i + 1, 2), 0).x;
            let below = clamp(position.z * percentile_ramp(next, position.y, lambda), 0.0, 1.0);
            sum += (left - right) * (1.0 - below);
        }
    }
    return clamp(sum, low, high);
}
