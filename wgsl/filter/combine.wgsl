// Colors and light that depend on the same slopes, averaged together.
//
// The mean of a product is the product of the means and a covariance. That is found from five nodes of the visible
// slopes, s = s̄ + e u + f w of `slopes.wgsl`: one in the middle and two on either axis, each a normal distribution of
// 0.7 of the deviations along e and f. Together they have the mean and the covariance of all slopes, of which the
// nodes' places hold 1 − 0.7² = 0.51: a color and a light that are linear in the slope have the covariance of their
// means over the nodes, divided by that. Along e they are as skewed as 0.75 of what is seen: means over the nodes would
// have all of it, covariances that are divided 0.51.

/// How many nodes there are.
const combine_nodes = 5;

/// Place of a node along e and along f, in deviations of the visible slopes there, and its weight, by u's skewness.
///
/// A skewness beyond 1, which views from below the horizon of the mean surface see, counts as that.
///
/// Source: places a ± b of the weight 0.12 along e and −0.24/0.76 a of all others, whose third moment of 0.75 of the
/// skewness is 1.53 a − 0.731301939 a³, by two of Newton's steps; √(0.51 / (2 · 0.12)) along f. Of layouts of five to
/// nine nodes this one has the fewest for the covariance that it leaves of steps with a cosine, which
/// `src/filter/combine.rs` states.
/// Domain: node integer in [0, 4], skewness in [0, 1].
/// Error: 4e-6 absolute; of Newton's steps.
fn combine_node(node: f32, skewness: f32) -> vec3f {
    let third = 0.75 * clamp(skewness, 0.0, 1.0);
    var a = third * (0.653594771 + 0.17 * third * third);
    a -= (a * (1.53 - 0.731301939 * a * a) - third) / (1.53 - 2.19390582 * a * a);
    a -= (a * (1.53 - 0.731301939 * a * a) - third) / (1.53 - 2.19390582 * a * a);
    let side = 1.0 - 4.0 * fract(0.5 * node);
    let along = vec2f(a + side * sqrt(2.125 - 1.31578947 * a * a), 0.0);
    let middle = vec2f(-0.315789474 * a, 0.0);
    let aside = vec3f(select(middle + vec2f(0.0, 1.45773797 * side), along, node < 2.5), 0.12);
    return select(aside, vec3f(middle, 0.52), node < 0.5);
}

/// Mean slope of a node, `moments` being mean and variance of u.
///
/// Source: the definition.
/// Domain: node in [-2, 2], mean_slope in [-1, 1], factor in [-2, 2], moments in [0, 1].
/// Error: 1e-6 absolute; f32 rounding of sums up to 9.
fn combine_slope(node: vec3f, mean_slope: vec2f, factor: vec4f, moments: vec2f) -> vec2f {
    let along = clamp(moments.x, -1e9, 1e9) + sqrt(clamp(moments.y, 0.0, 1.0)) * node.x;
    return mean_slope + along * factor.xy + node.y * factor.zw;
}

/// Covariance of the slopes of a node, the same for all.
///
/// Source: the definition, 0.7² of that of all slopes.
/// Domain: factor in [-2, 2], moments in [0, 1].
/// Error: 6e-7 absolute; f32 rounding of sums up to 4.
fn combine_covariance(factor: vec4f, moments: vec2f) -> vec3f {
    return slopes_covariance(0.7 * factor, moments.y);
}

/// Mean of a color times light from their means and what of them the nodes have: weighted sums over the nodes of the
/// color's difference from a mean, of that of light from its, and of the product of both differences, and the lowest
/// and the highest color that there is.
///
/// The mean is within the hull: that light times a color between the lowest and the highest.
///
/// Source: the covariance of means over the nodes, over the 0.51 that their places hold of the whole.
/// Domain: color in [0, 1], light in [0, 4], moved in [-0.2, 0.2], turned in [-1, 1], both in [-1, 1], low in [0, 0.5],
///   high in [0.5, 1].
/// Error: 1e-6 absolute; f32 rounding of sums up to 4.
fn combine_joint(
    color: vec3f, light: vec3f, moved: vec3f, turned: vec3f, both: vec3f, low: vec3f, high: vec3f,
) -> vec3f {
    let covariance = (both - moved * turned) * 1.96078431; // 1 / 0.51
    return clamp(color * light + covariance, low * light, high * light);
}
