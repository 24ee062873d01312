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
/// A step is off by up to 2.3e-2, 4.7e-3 for a quarter and 2e-4 for half of the major deviation.
///
/// Source: a fit of the least sum of eighth powers of a step's errors, and of twice those of a kink in major
///   deviations, to the pairs that have it: colors of smooth maps err by what a kink does.
/// Domain: part in [0.12, 0.38].
/// Error: 1.5e-3 absolute; from the pairs with that sum.
fn rounds_seven_places(part: f32) -> vec3f {
    // From 0.4 on the same pairs serve all parts.
    let q = clamp(part, rounds_seven_least, 0.4);
    let first = 0.36246737 + q * (1.3490436 + q * (0.2874197 * q - 0.83041524));
    let second = 0.79213918 + q * (2.5019318 - q * (1.0198141 + 0.068874608 * q));
    let third = 1.5124758 + q * (2.6502697 + q * (1.6418904 - 3.2640372 * q));
    return vec3f(first, second, third);
}

/// The weights of each distribution of the three pairs of seven.
///
/// Source: as `rounds_seven_places`.
/// Domain: part in [0.12, 0.38].
/// Error: 2e-4 absolute; as `rounds_seven_places`.
fn rounds_seven_weights(part: f32) -> vec3f {
    let q = clamp(part, rounds_seven_least, 0.4);
    let first = 0.14276846 + q * (0.41010243 + q * (0.24823012 * q - 0.54959783));
    let second = 0.15003026 + q * (q * (0.33379501 * q - 0.33483769) - 0.058153002);
    let third = 0.13714188 + q * (q * (1.0775828 - 0.66677489 * q) - 0.6296803);
    return vec3f(first, second, third);
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
