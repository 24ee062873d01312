// Lattices of whole numbers in the plane: which points stand about a position, and how their parts are blended.

/// The lattice points below and above a position along both axes: (x, y, x + 1, y + 1), wrapped to a period.
///
/// `period` is in whole lattice points; 0 wraps nothing. Blend by `fract` of the very same clamped position: a device
/// may flush a subnormal one in either.
///
/// Source: the definition, floor and remainder.
/// Domain: position in [-1000, 1000], period integer in [0, 300].
/// Error: exact.
fn lattice_corners(position: vec2f, period: vec2f) -> vec4f {
    let tile = clamp(floor(period), vec2f(), vec2f(1e9));
    let low = clamp(floor(position), vec2f(-1e9), vec2f(1e9));
    // Half a point keeps quotients off whole numbers: a device may divide 2.5 units in the last place too low.
    let wrapped = low - tile * floor((low + 0.5) / max(tile, vec2f(1.0)));
    let near = select(low, wrapped, tile >= vec2f(1.0));
    let far = near + 1.0;
    return vec4f(near, select(far, vec2f(), far == tile));
}

/// The blend 6t⁵ − 15t⁴ + 10t³ along both axes, behind it its derivative.
///
/// Source: Perlin 2002, "Improving Noise", ACM Transactions on Graphics 21(3).
/// Domain: t in [0, 1].
/// Error: 1.5e-6 absolute; f32 rounding.
fn lattice_fade(t: vec2f) -> vec4f {
    let p = clamp(t, vec2f(-1e3), vec2f(1e3));
    let steep = p * (1.0 - p);
    return vec4f(p * p * p * (p * (p * 6.0 - 15.0) + 10.0), 30.0 * steep * steep);
}

/// The second derivative of that blend along both axes, 60 t (1 − t) (1 − 2t).
///
/// Source: as `lattice_fade`.
/// Domain: t in [0, 1].
/// Error: 3e-6 absolute; f32 rounding.
fn lattice_fade_bend(t: vec2f) -> vec2f {
    let p = clamp(t, vec2f(-1e3), vec2f(1e3));
    return 60.0 * p * (1.0 - p) * (1.0 - 2.0 * p);
}

/// A random word of a lattice point, of a field of its own for every seed.
///
/// Source: `hash_pair` of the point, moved by the seed times two odd numbers: ⌊2³²/φ⌋ and one of MurmurHash3's.
/// Domain: place in [-1000, 1000], seed integer in [0, 4294967295].
/// Error: exact.
fn lattice_word(place: vec2f, seed: u32) -> u32 {
    let whole = vec2i(clamp(place, vec2f(-1e9), vec2f(1e9)));
    // The high bits of the other word are not independent of those one point below.
    return hash_pair(bitcast<vec2u>(whole) + seed * vec2u(2654435769u, 2246822507u)).y;
}
