// Domain warps f(p + g(p)): a footprint carried along by what displaces its positions.

/// Two vectors whose squares sum to the covariance of displaced positions: (first, second), the second along y.
///
/// A footprint with the vectors `across` and `along` is displaced by g: `x_slope` and `y_slope` are the derivatives of
/// g's components along the two vectors, and `rest` is the variance within the footprint, of either component, that no
/// derivative tells of. The covariance is (J + D)(J + D)ᵀ + rest I, J having the vectors as columns and D what g adds;
/// of its determinant all terms are positive.
///
/// Source: affine image of a Gaussian, plus an independent one; the Cholesky factor.
/// Domain: across in [-2, 2], along in [-2, 2], x_slope in [-2, 2], y_slope in [-2, 2], rest in [0, 1].
/// Error: 5e-7 of 1 + the result; f32 rounding, where a vector is 1e-3 or longer.
fn warp_vectors(across: vec2f, along: vec2f, x_slope: vec2f, y_slope: vec2f, rest: f32) -> vec4f {
    let limit = vec2f(1e9);
    let a = clamp(across + vec2f(x_slope.x, y_slope.x), -limit, limit);
    let b = clamp(along + vec2f(x_slope.y, y_slope.y), -limit, limit);
    let r = clamp(rest, 0.0, 1e18);
    let area = a.x * b.y - a.y * b.x;
    let first = sqrt(a.x * a.x + b.x * b.x + r);
    let shear = (a.x * a.y + b.x * b.y) / max(first, 1e-18);
    let second = sqrt(area * area + r * (dot(a, a) + dot(b, b) + r)) / max(first, 1e-18);
    // A footprint along y alone has no first component to divide by.
    return select(vec4f(first, shear, 0.0, second), vec4f(0.0, length(vec2f(a.y, b.y)), 0.0, 0.0), first < 1e-18);
}
