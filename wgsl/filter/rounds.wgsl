// Normal distributions of slopes as sums of round ones, for filters that read tables over those.
//
// A long distribution is a sum of round ones on its major axis, all of the deviation s of its minor one: with the part
// q = s / a of the major deviation a and z = √(1 − q²), they stand at multiples of z a from the mean.

/// The smallest part of three round distributions, which widen the minor axis of longer ones to that.
const rounds_three_least = 0.294;

/// The smallest part of five.
const rounds_five_least = 0.16;

/// The smallest part of seven.
const rounds_seven_least = 0.12;

/// The smallest part of nine.
const rounds_nine_least = 0.09;

/// Multiple of z a at which a round distribution stands on either side of a third on the mean, and the weight of each.
///
/// A step is off by up to 3.8e-2, 9.6e-3 for half and 2e-3 for two thirds of the major deviation.
///
/// Source: a fit of the least largest error of a step, found for each part by exchange.
/// Domain: part in [0.294, 0.6].
/// Error: 1e-2 absolute; from the pair with that error.
fn rounds_three(part: f32) -> vec2f {
    let q = clamp(part, rounds_three_least, 1.0);
    let place = 0.87520325 + q * (1.2362045 + q * (0.037185849 * q - 0.44130012));
    let weight = 0.34342829 + q * (q * (0.0060524207 * q + 0.074985462) - 0.25107048);
    return vec2f(place, weight);
}

/// Multiples of z a at which the inner and the outer pair of five round distributions stand, and the weights of each of
/// both.
///
/// A step is off by up to 3e-2, 1.3e-2 for a quarter and 1.3e-3 for half of the major deviation.
///
/// Source: as `rounds_three`, fit where the error is within 5e-4 of the least.
/// Domain: part in [0.16, 0.35].
/// Error: 6e-3 absolute; from the pairs with that error; above 0.35 many share it nearly.
fn rounds_five(part: f32) -> vec4f {
    let q = clamp(part, rounds_five_least, 1.0);
    let inner = 0.54051134 + q * (0.85673044 + q * (1.0010218 - 1.4592677 * q));
    let outer = 1.2564517 + q * (1.6980425 + q * (1.5227531 - 2.3572259 * q));
    let near = 0.19046403 + q * (0.34467645 + q * (0.36469951 * q - 0.64947629));
    let far = 0.20401432 + q * (q * (0.4133928 - 0.057390819 * q) - 0.50296293);
    return vec4f(inner, outer, near, far);
}

/// Multiples of z a at which the three pairs of seven round distributions stand, outwards.
///
/// A step is off by up to 2.1e-2, 3.9e-3 for a quarter and 5e-4 for half of the major deviation.
///
/// Source: as `rounds_three`, fit to the nearest pairs.
/// Domain: part in [0.12, 0.33].
/// Error: 1e-3 absolute; from the pairs with the least error; above 0.33 many share it nearly.
fn rounds_seven_places(part: f32) -> vec3f {
    // From 0.35 on the same pairs serve all parts.
    let q = clamp(part, rounds_seven_least, 0.35);
    let first = 0.35266306 + q * (1.3632156 + q * (0.23153491 * q - 0.83414257));
    let second = 0.76667944 + q * (2.5395816 - q * (1.0055705 + 0.25437884 * q));
    let third = 1.4435297 + q * (2.6773886 + q * (2.2902396 - 4.7462202 * q));
    return vec3f(first, second, third);
}

/// The weights of each distribution of the three pairs of seven.
///
/// Source: as `rounds_seven_places`.
/// Domain: part in [0.12, 0.33].
/// Error: 3e-4 absolute; as `rounds_seven_places`.
fn rounds_seven_weights(part: f32) -> vec3f {
    let q = clamp(part, rounds_seven_least, 0.35);
    let first = 0.13910007 + q * (0.42283788 + q * (0.25211022 * q - 0.56792309));
    let second = 0.14634 + q * (q * (0.39213239 * q - 0.4050056) - 0.026919915);
    let third = 0.1454808 + q * (q * (1.1387509 - 0.68609903 * q) - 0.66796767);
    return vec3f(first, second, third);
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
fn rounds_longer_first(factor: vec4f, pair: vec4f) -> vec4f {
    let e = dot(factor.xy, factor.xy);
    let f = dot(factor.zw, factor.zw);
    return select(pair.zwxy, pair, f * f > e * e * pair.y * pair.w);
}

/// Multiples of z a at which the four pairs of nine round distributions stand, outwards.
///
/// A step is off by up to 1.7e-2, 1.3e-3 for a quarter and 1e-4 for half of the major deviation.
///
/// Source: as `rounds_three`, fit to the nearest pairs where the error is within 1e-4 of the least.
/// Domain: part in [0.09, 0.3].
/// Error: 3e-3 absolute; from the pairs with that error; above 0.3 many share it nearly.
fn rounds_nine_places(part: f32) -> vec4f {
    // From 0.35 on the same pairs serve all parts.
    let q = clamp(part, rounds_nine_least, 0.35);
    let first = 0.27498172 + q * (1.367855 + q * (0.71693102 * q - 1.1236824));
    let second = 0.56382383 + q * (2.8466312 + q * (2.3285233 * q - 2.8236313));
    let third = 0.95999447 + q * (3.4013202 + q * (0.56379369 - 4.8250152 * q));
    let fourth = 1.5850893 + q * (3.4713958 + q * (3.932108 - 9.0827023 * q));
    return vec4f(first, second, third, fourth);
}

/// The weights of each distribution of the four pairs of nine.
///
/// Source: as `rounds_nine_places`.
/// Domain: part in [0.09, 0.3].
/// Error: 1.5e-3 absolute; as `rounds_nine_places`.
fn rounds_nine_weights(part: f32) -> vec4f {
    let q = clamp(part, rounds_nine_least, 0.35);
    let first = 0.11002985 + q * (0.45660192 + q * (0.36142855 * q - 0.59631301));
    let second = 0.10901629 + q * (0.24839114 + q * (0.6821724 * q - 0.9079861));
    let third = 0.11815465 + q * (q * (0.12006839 * q + 0.11908548) - 0.28200042);
    let fourth = 0.10974697 + q * (q * (1.6847122 - 1.3863326 * q) - 0.71461452);
    return vec4f(first, second, third, fourth);
}
