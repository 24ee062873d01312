// Visible slopes as two normal distributions, for maps of the whole slope: those of `slopes_pair` keep steps near,
// these keep kinks near too, as colors of maps that are smooth err by what a kink does.

/// From this parameter on there is one normal distribution: with `slopes_moments` it is within 2.1e-3 of every step.
const split_single = 4.0;

/// Two normal distributions of equal shares that stand for u, the scalar of `slopes.wgsl`, with its mean and variance
/// together: mean and variance of the lower one, then of the higher one; from 3 to `split_single` they become one.
///
/// A step's mean is off by up to 1.3e-2 for parameters above 0, and a kink's by 6e-3 of the deviation of u, which
/// `slopes_pair` has at 6.9e-3; at 2.5 it is 9e-4 in place of 5e-3.
///
/// Source: a fit of the least sum of eighth powers of a step's errors, and of twice those of a kink in deviations, to
///   the pairs that have it.
/// Domain: parameter in [-12, 3].
/// Error: 5e-3 absolute; from the pair with that sum.
fn split_pair(parameter: f32) -> vec4f {
    let m = slopes_moments(parameter);
    let r = m.x;
    let single = clamp(parameter + (1.0 - split_single), 0.0, 1.0);
    let two = 1.0 - single * single;
    let apart = two * r * (0.37655901 + r) / (0.16410946 + r * (0.01696145 + 0.9324848 * r));
    let uneven = two * r * (0.80084068 * r - 0.06126622) / (0.82413356 + r * (0.24923575 + r));
    let shift = 0.5 * apart * sqrt(m.y);
    let rest = m.y - shift * shift;
    return vec4f(r - shift, rest * (1.0 - uneven), r + shift, rest * (1.0 + uneven));
}

/// Means and variances along the first of two vectors of two distributions of slopes that vary alike along the second,
/// the lower variance first: that of the longer distribution first.
///
/// The determinant of v e eᵀ + f fᵀ, in squares of its trace, is smaller for the lower variance where |f|² exceeds |e|²
/// √(v₁ v₂).
///
/// Source: the definition.
/// Domain: factor in [-2, 2], pair in [0.01, 1].
/// Error: exact.
fn split_longer_first(factor: vec4f, pair: vec4f) -> vec4f {
    let e = dot(factor.xy, factor.xy);
    let f = dot(factor.zw, factor.zw);
    return select(pair.zwxy, pair, f * f > e * e * pair.y * pair.w);
}
