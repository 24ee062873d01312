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

/// The smallest part of ten and of eleven.
const rounds_eleven_least = 0.07;

/// Below this part eleven err by more than 5e-4 of a step, and the mean of ten and eleven by less on average: where the
/// ones sum to too much the others sum to too little.
const rounds_eleven_long = 0.25;

/// From this part on ten and eleven are six and seven, which do as well: the same three pairs for all such parts.
const rounds_eleven_short = 0.45;

/// Up to five pairs of round distributions.
struct rounds_pairs {
    /// Multiples of z a at which the inner four stand on either side of the mean, outwards.
    places: vec4f,
    /// The weights of each of both.
    weights: vec4f,
    /// Place and weight of the outermost, of no weight where there are three pairs.
    outermost: vec2f,
}

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

/// The five pairs of ten round distributions, or the three of six.
///
/// A step is off by up to 1.9e-2, 8e-4 for a quarter and 3e-4 for half of the major deviation.
///
/// Source: as `rounds_seven_places`.
/// Domain: part in [0.07, 0.9].
/// Error: 3e-3 absolute; from the pairs with that sum.
fn rounds_ten(part: f32) -> rounds_pairs {
    if part >= rounds_eleven_short {
        let places = vec4f(0.44749219, 1.3783832, 2.4698069, 0.0);
        return rounds_pairs(places, vec4f(0.32498438, 0.15095083, 0.024064786, 0.0), vec2f());
    }
    // From 0.3 on the same pairs serve.
    let q = clamp(part, rounds_eleven_least, 0.3);
    let first = 0.12430033 + q * (0.67855414 + q * (0.21186911 * q - 0.55352698));
    let second = 0.38073396 + q * (2.0233649 + q * (0.5708793 * q - 1.5990234));
    let third = 0.67004515 + q * (3.2405171 + q * (0.077048769 * q - 2.0306851));
    let fourth = 1.0425333 + q * (4.1185367 - q * (1.0427762 + 2.240866 * q));
    let fifth = 1.6977537 + q * (3.76351 + q * (4.187406 - 9.5723351 * q));
    let next = 0.099516853 + q * (0.40487866 + q * (0.53993476 * q - 0.82456751));
    let middle = 0.10239067 + q * (0.11457099 + q * (0.95088357 * q - 0.85356995));
    let far = 0.10561944 + q * (q * (0.20572663 + 0.2743557 * q) - 0.33889532);
    let farthest = 0.093645419 + q * (q * (1.9715915 - 1.9710716 * q) - 0.70889071);
    let near = 0.5 - (next + middle + far + farthest);
    return rounds_pairs(vec4f(first, second, third, fourth), vec4f(near, next, middle, far), vec2f(fifth, farthest));
}

/// The five pairs of eleven round distributions, or the three of seven.
///
/// A step is off by up to 1.6e-2, 5e-4 for a quarter and 1e-4 for half of the major deviation.
///
/// Source: as `rounds_seven_places`.
/// Domain: part in [0.07, 0.9].
/// Error: 3e-3 absolute; from the pairs with that sum.
fn rounds_eleven(part: f32) -> rounds_pairs {
    if part >= rounds_eleven_short {
        let places = vec4f(0.82781739, 1.7065889, 2.7472183, 0.0);
        return rounds_pairs(places, vec4f(0.23873968, 0.086455851, 0.011144364, 0.0), vec2f());
    }
    let q = clamp(part, rounds_eleven_least, 0.3);
    let first = 0.2245709 + q * (1.4065388 + q * (1.012057 * q - 1.4849745));
    let second = 0.46305539 + q * (2.7633903 + q * (1.6346476 * q - 2.7020794));
    let third = 0.73611904 + q * (3.9939917 + q * (1.3876253 * q - 3.293338));
    let fourth = 1.0928792 + q * (4.8694965 - q * (2.3492228 + 0.87950893 * q));
    let fifth = 1.7317022 + q * (4.4098173 + q * (3.4581308 - 9.2070218 * q));
    let near = 0.08918045 + q * (0.50987127 + q * (0.51599345 * q - 0.76040066));
    let next = 0.090734959 + q * (0.33947409 + q * (0.91186451 * q - 1.0372647));
    let middle = 0.094126028 + q * (0.019000528 + q * (1.0869298 * q - 0.77535093));
    let far = 0.097206182 + q * (q * (0.6241718 - 0.21934856 * q) - 0.42865383);
    let farthest = 0.084427426 + q * (q * (2.2508688 - 2.5035835 * q) - 0.72167525);
    return rounds_pairs(vec4f(first, second, third, fourth), vec4f(near, next, middle, far), vec2f(fifth, farthest));
}
