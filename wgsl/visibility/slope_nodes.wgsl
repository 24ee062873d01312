// Slopes of transferred heights h = g(f): up to four nodes, normal distributions of different scales that stand for
// them together, of which a view sees different shares.
//
// A slope of h is g′(f) times that of f, which is independent of f: given f it is normal, with the mean g′ s̄ and the
// covariance g′² Σ of those of f. The nodes, one a component of a vec4f, stand for values of g′: a node's `scales` is
// g′, its `weights` the share of the surface, 0 of a node that is not used. Its surface is at heights of which
// (1 + Λ spread)^(−rate / spread) are not hidden, Λ being that of all nodes together. `factor` is that of the slopes of
// f, by `slopes_factor`; that of a node is `scale` times as long. `rise` is v.z − v.xy · s̄ of a node.

/// Area of each node's facets that face away from the view, for a unit of area of the mean plane: E[max(−t, 0)]. That
/// of facets that face it, E[max(t, 0)], is larger by the rise.
///
/// Source: the definition, max(−m, 0) + τ E[max(u − |a|, 0)] by `slopes_tail`.
/// Domain: view unit, mean_slope in [-1, 1], factor in [-2, 2], scales in [-2, 2].
/// Error: 1e-6 absolute; f32 rounding of rises up to 4, which the parameter takes.
fn slope_nodes_averted(view: vec3f, mean_slope: vec2f, factor: vec4f, scales: vec4f) -> vec4f {
    let rises = slope_nodes_rises(view, mean_slope, scales);
    let reaches = clamp(-dot(view.xy, factor.xy), 0.0, 1e9) * min(abs(scales), vec4f(1e9));
    let depths = abs(rises) / max(reaches, vec4f(1e-18));
    let tails = vec4f(
        slopes_tail(depths.x).z, slopes_tail(depths.y).z, slopes_tail(depths.z).z, slopes_tail(depths.w).z,
    );
    return max(-rises, vec4f()) + reaches * tails;
}

/// v.z − v.xy · s̄ of each node: the area of its mean plane in the picture, negative where that faces away.
///
/// Source: the definition.
/// Domain: view unit, mean_slope in [-1, 1], scales in [-2, 2].
/// Error: 6e-7 absolute; f32 rounding of sums up to 4.
fn slope_nodes_rises(view: vec3f, mean_slope: vec2f, scales: vec4f) -> vec4f {
    let along = clamp(dot(view.xy, mean_slope), -1e9, 1e9);
    return view.z - along * clamp(scales, vec4f(-1e9), vec4f(1e9));
}

/// Smith's Λ of a direction over all nodes: the area of facets that face away over the area of the mean plane in the
/// picture. Beyond `smith_horizon` where the direction is at or below the horizon of the mean surface, 5.2e5 at most
/// above it.
///
/// `averted` is by `slope_nodes_averted`, of the same direction.
///
/// Source: Smith 1967, "Geometrical shadowing of a random rough surface": facets that are hidden make up for those that
///   face away, E[max(t, 0)] = E[t] (1 + Λ), whatever the distribution of slopes.
/// Domain: view unit, mean_slope in [-1, 1], scales in [-2, 2], weights in [0.01, 1], averted in [0, 4].
/// Error: 2e-6 of 1 + the result; f32 rounding of a sum over one that is a tenth of its terms.
fn slope_nodes_lambda(view: vec3f, mean_slope: vec2f, scales: vec4f, weights: vec4f, averted: vec4f) -> f32 {
    let rise = dot(weights, slope_nodes_rises(view, mean_slope, scales));
    let lambda = min(dot(weights, averted) / max(rise, 1e-18), 5.2e5);
    return select(lambda, 2.0 * smith_horizon, rise <= 0.0);
}

/// How little of each node is not hidden, in bits: the share 2^−bits of it is in sight, or in sight and lit where
/// `lambda` is the sum of the Λ of view and light.
///
/// Source: the mean of P(h)^Λ over a node's heights when −ln P has a gamma distribution of mean `rates` and variance
///   `rates` · `spreads`. Spreads below 0.02 count as 0.02.
/// Domain: lambda log in [1e-4, 1e6], rates in [0, 8], spreads in [0.02, 64].
/// Error: 9e-5 of 1 + the result; f32 rounding of 1 + Λ spread next to 1, and the device's log2 there.
fn slope_nodes_bits(lambda: f32, rates: vec4f, spreads: vec4f) -> vec4f {
    let spread = clamp(spreads, vec4f(0.02), vec4f(1e3));
    return clamp(rates, vec4f(), vec4f(1e5)) / spread * log2(1.0 + clamp(lambda, 0.0, 2e6) * spread);
}

/// Share of each node in what is seen of the surface: weights · areas · 2^−bits, made to sum to 1.
///
/// Of a surface that is out of sight, shares are those of what is hidden least; where nothing faces the view, weights.
///
/// Source: the definition, E[max(t, 0)] being the rise plus the area that faces away.
/// Domain: view unit, mean_slope in [-1, 1], scales in [-2, 2], weights in [0.01, 1], averted in [0, 4],
///   bits in [0, 40].
/// Error: 1e-4 absolute; f32 rounding of areas that are differences, over a sum as small as 1e-2.
fn slope_nodes_shares(
    view: vec3f, mean_slope: vec2f, scales: vec4f, weights: vec4f, averted: vec4f, bits: vec4f,
) -> vec4f {
    let whole = max(weights, vec4f());
    let facing = whole * max(slope_nodes_rises(view, mean_slope, scales) + averted, vec4f());
    let each = select(vec4f(1e9), clamp(bits, vec4f(), vec4f(1e9)), facing > vec4f(1e-12));
    let least = min(min(each.x, each.y), min(each.z, each.w));
    let shares = select(facing * exp2(-min(each - least, vec4f(120.0))), whole, least >= 1e9);
    return shares / max(dot(shares, vec4f(1.0)), 1e-18);
}

/// The visibility parameter of a direction over slopes that have no mean, by their covariance at the scale 1: 0 at or
/// below the horizon.
///
/// At most 1e9.
///
/// Source: as `smith_parameter_level`, whose limit of 10 a steep node would divide.
/// Domain: direction unit, covariance psd(0.1, 2, 0.9).
/// Error: 1.5e-6 relative; f32 rounding at the largest correlation.
fn slope_nodes_ratio(direction: vec3f, covariance: vec3f) -> f32 {
    let variance = clamp(smith_variance(direction.xy, covariance), 5e-38, 1e30);
    return clamp(direction.z * inverseSqrt(2.0 * variance), 0.0, 1e9);
}

/// What a node of such slopes adds to Smith's Λ of all nodes, for a unit of its weight.
///
/// `ratio` is by `slope_nodes_ratio`. At or below the horizon it is beyond `smith_horizon`.
///
/// Source: the definition, averted area over the rise, by `smith_lambda_fast`.
/// Domain: ratio log in [1e-3, 100], scale in [0.01, 10].
/// Error: 9e-5 of 1 + the result; that of `smith_lambda_fast`.
fn slope_nodes_hiding(ratio: f32, scale: f32) -> f32 {
    return smith_lambda_fast(ratio / max(abs(scale), 1e-18));
}
