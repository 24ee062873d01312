// Taps: points about the major axis of a footprint, each with a smaller and rounder footprint of its own, whose colors
// are averaged with Gaussian weights. Averaging colors keeps what one mean and one deviation cannot say.
//
// The mixture of the taps' footprints has the covariance of the whole footprint: along the major axis its variance a²
// is the variance of the taps' places, a² − s², plus that of one tap, s². Along the minor axis all of b² is a tap's
// while s is longer; where the footprint is so round that taps lie closer than that, they step aside in turn, in two
// rows.

/// Most taps of one footprint.
const taps_most = 8;

/// For 1 to 8 taps: 1/deviation of the places 2 (2i + 1 − k)/k under the weights exp(−place²/2); 1/sum of the weights;
/// and scale and slope that make the rows +1, −1, +1, … of unit deviation and uncorrelated with the places.
///
/// Evaluated from this definition to 9 digits; the test of `taps_place` evaluates it again. Two taps and odd numbers of
/// taps have one row.
const taps_norms = array<vec4f, taps_most>(
    vec4f(0.0, 1.0, 0.0, 0.0),
    vec4f(1.0, 0.824360635, 0.0, 0.0),
    vec4f(1.11652123, 0.548779777, 0.0, 0.0),
    vec4f(1.12659853, 0.414198949, 1.00091198, -0.0426787548),
    vec4f(1.1307142, 0.332405625, 0.0, 0.0),
    vec4f(1.13274247, 0.277493757, 1.00307093, -0.0781900703),
    vec4f(1.13389793, 0.238108591, 0.0, 0.0),
    vec4f(1.13462158, 0.20849219, 1.00189667, -0.0615025668),
);

/// For 1 to 8 taps: the smallest deviation of a tap in minor deviations of the footprint.
///
/// Found by the errors that the driver's tests measure: smaller taps leave gaps between two rows.
const taps_narrowest = array<f32, taps_most>(1.0, 1.0, 1.0, 0.9, 1.0, 0.75, 1.0, 0.75);

/// Place of a tap along the major and the minor axis, in deviations of all places, and its weight: (along, across,
/// weight).
///
/// Places are spaced evenly over two deviations of a Gaussian on either side and weighted by it. Over all taps the
/// weights sum to one, the weighted places to zero, and their weighted products to the identity: to zero for a single
/// tap, and across where there is one row.
///
/// Source: the trapezoidal rule for a Gaussian, normalized.
/// Domain: tap integer in [0, 7], taps integer in [1, 8].
/// Error: 1e-6 absolute; f32 rounding, of places up to 16 beyond the last tap.
fn taps_place(tap: f32, taps: f32) -> vec3f {
    let k = clamp(taps, 1.0, f32(taps_most));
    let place = 2.0 * (2.0 * tap + 1.0 - k) / k;
    let norm = taps_norms[u32(k) - 1u];
    let along = place * norm.x;
    let row = 1.0 - 4.0 * fract(0.5 * tap);
    return vec3f(along, norm.z * (row - norm.w * along), exp(-0.5 * place * place) * norm.y);
}

/// Deviation of one tap along the major axis, s: 1.2/taps of the footprint's, and at least 0.75 to 1 of its minor one.
///
/// The measured error of 2, 4 and 8 taps at aspects 2 to 16 is smallest there: smaller taps leave gaps, larger ones
/// blur across, because a tap is read as if it were round.
///
/// Source: fit to measured errors on a photograph and on elevations, which the driver's tests measure again.
/// Domain: major in [0, 16], minor in [0, 16], taps integer in [1, 8].
/// Error: 2e-6 absolute; f32 rounding.
fn taps_deviation(major: f32, minor: f32, taps: f32) -> f32 {
    let k = clamp(taps, 1.0, f32(taps_most));
    return min(max(min(1.2 / k, 1.0) * major, taps_narrowest[u32(k) - 1u] * minor), major);
}

/// Variances of the taps' places along the major and the minor axis: a² − s² and b² − s², 0 where s is longer.
///
/// Source: the covariance of the mixture is the footprint's.
/// Domain: major in [0, 16], minor in [0, 16], taps integer in [1, 8].
/// Error: 6e-5 absolute; f32 rounding of variances up to 256.
fn taps_spread(major: f32, minor: f32, taps: f32) -> vec2f {
    let s = taps_deviation(major, minor, taps);
    let deviations = vec2f(major, minor);
    return max(deviations - s, vec2f()) * max(deviations + s, vec2f());
}

/// Covariance of one tap's footprint, with the deviation s along `direction`, the footprint's major axis.
///
/// Source: the definition, m² I + (s² − m²) d dᵀ, with m the smaller of s and the minor deviation.
/// Domain: direction unit, major in [0, 16], minor in [0, 16], taps integer in [1, 8].
/// Error: 1e-4 absolute; f32 rounding of variances up to 256.
fn taps_covariance(direction: vec2f, major: f32, minor: f32, taps: f32) -> vec3f {
    let s = taps_deviation(major, minor, taps);
    let round = min(minor, s);
    let longer = (s - round) * (s + round);
    let d = clamp(direction, vec2f(-1.0), vec2f(1.0));
    return vec3f(longer * d.x * d.x + round * round, longer * d.x * d.y, longer * d.y * d.y + round * round);
}

/// What one tap has of a footprint, and what its place has: (deviation along the major axis, along the minor axis,
/// variance of the places along the major axis, along the minor axis), each in those of the footprint: from 0 to 1.
///
/// For footprints that are given by the vectors of their axes; a minor deviation of 0 is kept whole.
///
/// Source: `taps_deviation` and `taps_spread`, divided by the footprint's deviations and variances.
/// Domain: major in [0, 16], minor in [0, 16], taps integer in [1, 8].
/// Error: 6e-7 absolute; f32 rounding.
fn taps_shares(major: f32, minor: f32, taps: f32) -> vec4f {
    let k = clamp(taps, 1.0, f32(taps_most));
    let roundness = minor / max(major, 1e-30);
    let major_share = clamp(max(1.2 / k, taps_narrowest[u32(k) - 1u] * roundness), 0.0, 1.0);
    let own = vec2f(major_share, min(major_share / max(roundness, 1e-30), 1.0));
    return vec4f(own, (1.0 - own) * (1.0 + own));
}
