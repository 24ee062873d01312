// One kernel of solid Gabor noise: where it is in its cell, and what a footprint makes of it.

/// The random words of a cell; a seed moves all cells by many.
///
/// Source: the definition; kernels hash them on, one after the other.
/// Domain: cell integer in [-1000, 1000], seed integer in [0, 4294967295].
/// Error: exact.
fn gabor_kernel_words(cell: vec3i, seed: u32) -> vec3u {
    return bitcast<vec3u>(cell) + seed * vec3u(2654435769u, 2246822507u, 3266489909u);
}

/// The place of a kernel in its cell, by 11, 11 and 10 bits of one word from the highest down.
///
/// Source: the definition, the middle of each share.
/// Domain: word integer in [0, 4294967295].
/// Error: exact.
fn gabor_kernel_place(word: u32) -> vec3f {
    let parts = vec3f(vec3u(word >> 21u, (word >> 10u) & 2047u, word & 1023u));
    return (parts + 0.5) * vec3f(4.8828125e-4, 4.8828125e-4, 9.765625e-4);
}

/// A sum of filtered kernels over √|M| with one more, where a point is `apart` from it, in cells: (value, Nᵀg).
///
/// `words` are the kernel's random ones; beyond its reach it adds nothing. The gradient of the value is −2π M g.
/// Errors grow in proportion to frequencies beyond four cycles a cell, five bandwidths.
///
/// Source: Lagae and Drettakis 2011, "Filtering Solid Gabor Noise", equations 6 and 10 without the approximation of 10.
/// Domain: sum in [-1, 1], apart in [-1.2, 1.2], words integer in [0, 4294967295], spectrum from gabor_spectrum_of,
/// footprint from gabor_covered.
/// Error: 3.2e-6 absolute; f32 rounding of the phase.
fn gabor_kernel(
    sum: vec3f,
    apart: vec3f,
    words: vec2u,
    spectrum: gabor_spectrum,
    footprint: gabor_footprint,
) -> vec3f {
    var all = sum;
    let square = dot(apart, apart);
    if square < footprint.farthest {
        let place = vec2f(dot(footprint.first, apart), dot(footprint.second, apart.xy));
        let distance = max(square - dot(place, place), 0.0);
        if distance < gabor_reach * gabor_reach {
            let frequency = gabor_spectrum_frequency(words, spectrum);
            let turned = vec2f(dot(footprint.first, frequency), dot(footprint.second, frequency.xy));
            // π a²/ln 2 and π/(a² ln 2): the exponent in bits.
            let bits = -2.90071049 * distance - 7.08181272 * dot(turned, turned);
            let turns = dot(frequency, apart) - dot(place, turned) + f32(words.y >> 16u) * 1.52587890625e-5;
            let angle = 6.28318531 * fract(turns);
            let wave = exp2(bits) * vec2f(cos(angle), sin(angle));
            all += vec3f(wave.x, 0.64 * wave.x * place + wave.y * turned); // a² = 0.64
        }
    }
    return all;
}
