// Solid Gabor noise as its paper filters it: envelopes are round in the surface's plane, of the same area as M makes
// them, a |M|^¼. Kept to compare: rᵀM r costs less than what the approximation saves, and is exact.
//
// Where the footprint's vectors are parallel they span no plane, and envelopes are round in space.

/// The unit normal of a footprint's plane.
///
/// Source: the definition; the vectors of I − M span the plane of across and along.
/// Domain: footprint from gabor_covered.
/// Error: 1.2e-6 absolute; f32 rounding, where the sine of the angle between the vectors is 0.1 or more.
fn gabor_paper_normal(footprint: gabor_footprint) -> vec3f {
    let normal = cross(footprint.first, vec3f(footprint.second, 0.0));
    return normal * inverseSqrt(max(dot(normal, normal), 1e-30));
}

/// A filtered kernel of amplitude 1 where a point is `apart` from it, in cells.
///
/// Source: Lagae and Drettakis 2011, "Filtering Solid Gabor Noise", equations 6 and 10.
/// Domain: apart in [-1.2, 1.2], words integer in [0, 4294967295], spectrum from gabor_spectrum_of,
/// footprint from gabor_covered.
/// Error: 5e-7 absolute; f32 rounding of the phase.
fn gabor_paper_kernel(apart: vec3f, words: vec2u, spectrum: gabor_spectrum, footprint: gabor_footprint) -> f32 {
    let r = clamp(apart, vec3f(-1e9), vec3f(1e9));
    let depth = dot(gabor_paper_normal(footprint), r);
    let distance = mix(depth * depth, dot(r, r), footprint.density);
    if distance >= gabor_reach * gabor_reach {
        return 0.0;
    }
    let frequency = gabor_spectrum_frequency(words, spectrum);
    let place = vec2f(dot(footprint.first, r), dot(footprint.second, r.xy));
    let turned = vec2f(dot(footprint.first, frequency), dot(footprint.second, frequency.xy));
    let bits = 2.90071049 * distance + 7.08181272 * dot(turned, turned); // as in `gabor_kernel`
    let turns = dot(frequency, r) - dot(place, turned) + f32(words.y >> 16u) * 1.52587890625e-5;
    return footprint.density * exp2(-bits) * cos(6.28318531 * fract(turns));
}

/// The kernels of one cell, added up, as a point sees them that is `apart` from the cell's low corner.
///
/// Source: as `gabor_cell`.
/// Domain: apart in [-1, 2], words integer in [0, 4294967295], kernels integer in [1, 4],
/// spectrum from gabor_spectrum_of, footprint from gabor_covered.
/// Error: 1e-6 absolute; f32 rounding of phases.
fn gabor_paper_cell(
    apart: vec3f,
    words: vec3u,
    kernels: u32,
    spectrum: gabor_spectrum,
    footprint: gabor_footprint,
) -> f32 {
    var next = words;
    var sum = 0.0;
    for (var number = 0u; number < min(kernels, 64u); number++) {
        next = hash_triple(next);
        sum += gabor_paper_kernel(apart - gabor_kernel_place(next.x), next.yz, spectrum, footprint);
    }
    return sum;
}

/// Noise filtered over a footprint about a point, in cells.
///
/// Source: Lagae and Drettakis 2011, equation 11.
/// Domain: position in [-1000, 1000], kernels integer in [1, 2], seed integer in [0, 4294967295],
/// spectrum from gabor_spectrum_of, footprint from gabor_covered.
/// Error: 2e-6 absolute; f32 rounding of phases.
fn gabor_paper_noise(
    position: vec3f,
    kernels: u32,
    seed: u32,
    spectrum: gabor_spectrum,
    footprint: gabor_footprint,
) -> f32 {
    let p = clamp(position, vec3f(-1e9), vec3f(1e9));
    let corner = floor(p - 0.5) - 1.0;
    let within = p - corner;
    let words = gabor_kernel_words(vec3i(corner), seed);
    var sum = 0.0;
    for (var index = 0u; index < 64u; index++) {
        let offset = vec3u(index & 3u, (index >> 2u) & 3u, index >> 4u);
        let apart = within - vec3f(offset);
        let outside = apart - saturate(apart);
        if dot(outside, outside) * footprint.density < gabor_reach * gabor_reach {
            sum += gabor_paper_cell(apart, words + offset, kernels, spectrum, footprint);
        }
    }
    return sum * 1.70185469 * inverseSqrt(f32(clamp(kernels, 1u, 64u))); // as in `gabor_noise`
}
