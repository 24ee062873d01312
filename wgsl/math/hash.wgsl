// Hashes of integers: the same on every device and in every language, bit for bit.

/// Two well mixed words for a pair of words, such as the coordinates of a lattice point.
///
/// Source: pcg2d of Jarzynski and Olano 2020, "Hash Functions for GPU Rendering", JCGT 9(3), listing 20.
/// Domain: pair integer in [0, 4294967295].
/// Error: exact.
fn hash_pair(pair: vec2u) -> vec2u {
    var v = pair * 1664525u + 1013904223u;
    v.x += v.y * 1664525u;
    v.y += v.x * 1664525u;
    v ^= v >> vec2u(16u);
    v.x += v.y * 1664525u;
    v.y += v.x * 1664525u;
    return v ^ (v >> vec2u(16u));
}

/// Three well mixed words for three words, such as the coordinates of a lattice point.
///
/// Source: pcg3d of Jarzynski and Olano 2020, "Hash Functions for GPU Rendering", JCGT 9(3), section 4.2.
/// Domain: triple integer in [0, 4294967295].
/// Error: exact.
fn hash_triple(triple: vec3u) -> vec3u {
    var v = triple * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v ^= v >> vec3u(16u);
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    return v;
}
