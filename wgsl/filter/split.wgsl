// Visible slopes as normal distributions, for maps of the whole slope: two of equal weights, of which a narrow third is
// taken away. It lies where slopes turn away from the view, whose density ends at once and not in a tail.

/// From this parameter on there is one normal distribution: with `slopes_moments` it is within 6e-4 of every step.
const split_single = 6.0;

/// The part of two normal distributions and a third that stands for u, the scalar of `slopes.wgsl`: all, but from 5 to
/// `split_single` less and less, until there is one.
///
/// Source: the definition.
/// Domain: parameter in [-12, 6].
/// Error: 1e-7 absolute; f32 rounding.
fn split_part(parameter: f32) -> f32 {
    let single = clamp(parameter + (1.0 - split_single), 0.0, 1.0);
    return 1.0 - single * single;
}

/// The narrow distribution that is taken away: mean and variance of u, and the weight, from 0.13 to 0.
///
/// Its place and its width, in deviations of u, are chosen; they matter little.
///
/// Source: a fit of the least sum of eighth powers of a step's errors, and of twice those of a kink in deviations, to
///   the weights that have it.
/// Domain: parameter in [-12, 5].
/// Error: 5e-3 absolute; from the weight with that sum.
fn split_less(parameter: f32) -> vec3f {
    let m = slopes_moments(parameter);
    let r = m.x;
    let near = 1.0 / max(r, 0.48);
    let weight = r * r * r * (0.12211397 * r - 0.0068828068)
        / (0.00079519045 + r * (0.7601275 + r * (0.25706 + r * (r - 0.31967437))));
    let mean = r - sqrt(m.y) * (1.7 + 0.347 * near);
    return vec3f(mean, m.y * (0.17 + 0.03 * near), split_part(parameter) * max(weight, 0.0));
}

/// The two normal distributions of equal weights that have, less the third, the mean and variance of u: mean and
/// variance of the lower one, then of the higher one.
///
/// A step's mean is off by up to 3e-3 for parameters above 0 and 8e-4 above 1.2, where two alone have 1.3e-2 and
/// 6.8e-3; at -12 by 1.5e-2.
///
/// Source: as `split_less`.
/// Domain: parameter in [-12, 2.5].
/// Error: 5e-2 absolute; from the pair with that sum; above 2.5 many share it nearly.
fn split_pair(parameter: f32) -> vec4f {
    let m = slopes_moments(parameter);
    let r = m.x;
    let less = split_less(parameter);
    let two = split_part(parameter);
    let apart = two * r * (0.39785449 + 0.78292782 * r) / (0.33503702 + r * (r - 0.07789819));
    let uneven = two * r * r * (1.0547913 + 0.70046813 * r)
        / (1.3125127 + r * (4.4908827 + r * (1.1254578 + r)));
    // Of what is left over, in variances of u: of the third about the mean, and of both about the middle between them.
    let away = less.x - r;
    let both = 1.0 / (1.0 + less.z);
    let middle = both * less.z * away;
    let shift = 0.5 * apart * sqrt(m.y);
    let rest = both * (m.y + less.z * (less.y + away * away)) - middle * middle - shift * shift;
    let mean = r + middle;
    return vec4f(mean - shift, rest * (1.0 - uneven), mean + shift, rest * (1.0 + uneven));
}
