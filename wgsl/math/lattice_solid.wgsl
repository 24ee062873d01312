// Lattices of whole numbers in space: which points stand about a position, and what is hashed from them.

/// A lattice point's place in a tile; a period of 0 wraps nothing. Coordinates beyond 1e9 count as 1e9.
///
/// Source: the definition, floor and remainder.
/// Domain: place in [-1000, 1000], period integer in [0, 300].
/// Error: exact.
fn lattice_solid_wrapped(place: vec3f, period: vec3f) -> vec3f {
    let tile = clamp(floor(period), vec3f(), vec3f(1e9));
    let whole = clamp(floor(place), vec3f(-1e9), vec3f(1e9));
    // Half a point keeps quotients off whole numbers: a device may divide 2.5 units in the last place too low.
    let wrapped = whole - tile * floor((whole + 0.5) / max(tile, vec3f(1.0)));
    return select(whole, wrapped, tile >= vec3f(1.0));
}

/// A random word of a lattice point, of a field of its own for every seed.
///
/// Source: `hash_triple` of the point, moved by the seed times three odd numbers: ⌊2³²/φ⌋ and two of MurmurHash3's.
/// Domain: place in [-1000, 1000], seed integer in [0, 4294967295].
/// Error: exact.
fn lattice_solid_word(place: vec3f, seed: u32) -> u32 {
    let whole = vec3i(clamp(place, vec3f(-1e9), vec3f(1e9)));
    return hash_triple(bitcast<vec3u>(whole) + seed * vec3u(2654435769u, 2246822507u, 3266489909u)).z;
}
