// Solid random-phase Gabor noise, filtered over a footprint in space: a sum of Gaussians times waves at random places.
//
//     a   bandwidth: a kernel is exp(−π a² |r|²) cos(2π ω·r + φ), r from the kernel to the point
//     ω   frequency of a kernel, φ its phase
//     Σ   covariance of the footprint, across acrossᵀ + along alongᵀ
//     M   (I + 2π a² Σ)⁻¹
//
// Slicing a kernel by the surface and filtering the slice is one convolution in space by a Gaussian of rank two:
//
//     √|M| exp(−π a² rᵀM r − (π/a²) ωᵀ(I − M)ω) cos(2π ωᵀM r + φ)
//
// No tangent frame, no normal, and the value is the same on both sides of an edge where the footprints are. I − M is
// l lᵀ + m mᵀ with two vectors (`first` and `second`): what M does to r and ω takes their products with these alone.
//
// Lengths are in cells, whose side is `gabor_bandwidth` of 1/a. A kernel counts where rᵀM r is below the square of
// `gabor_reach`; the 4³ cells about a point hold all of them for a point footprint, and cut what a long footprint
// stretches beyond. The noise has the mean 0, the variance 1 but 4e-4 that the reach cuts, and steps of 1 % of a
// deviation where kernels end.

/// The bandwidth a, in 1/cells.
const gabor_bandwidth = 0.8;

/// How far a kernel reaches, in cells: exp(−π a² reach²) = 0.011.
const gabor_reach = 1.5;

/// What the sum of kernels needs of a footprint, by `gabor_covered`.
struct gabor_footprint {
    /// l and m of I − M = l lᵀ + m mᵀ.
    first: vec3f,
    second: vec3f,
    /// The factor L = (x, y; 0, z) of (I + 2π a² JᵀJ)⁻¹ = L Lᵀ, J having the columns across and along.
    factor: vec3f,
    /// √|M|.
    density: f32,
    /// Square of how far from the point a kernel can count.
    farthest: f32,
}

/// What the sum of kernels needs of the footprint of covariance across acrossᵀ + along alongᵀ, in cells.
///
/// Vectors beyond 1e8 cells count as 1e8.
///
/// Source: Woodbury's identity, I − M = 2π a² J (I + 2π a² JᵀJ)⁻¹ Jᵀ, with the Cholesky factor of the inverse.
/// Domain: across in [-1, 1], along in [-1, 1].
/// Error: 5e-7 of 1 + the result; f32 rounding.
fn gabor_covered(across: vec3f, along: vec3f) -> gabor_footprint {
    let width = 2.00530262; // √(2π) a
    let a = clamp(across, vec3f(-1e8), vec3f(1e8)) * width;
    let b = clamp(along, vec3f(-1e8), vec3f(1e8)) * width;
    let normal = cross(a, b);
    // The determinant of I + JᵀJ as a sum of squares: the product of its diagonal less a square would lose it.
    let squares = vec2f(dot(a, a), dot(b, b));
    let determinant = 1.0 + squares.x + squares.y + dot(normal, normal);
    let grown = 1.0 + squares.x;
    let shear = dot(a, b) / grown;
    let ends = vec2f(inverseSqrt(grown), sqrt(grown) * inverseSqrt(determinant));
    let longest = 0.5 * (squares.x + squares.y + length(vec2f(squares.x - squares.y, 2.0 * dot(a, b))));
    return gabor_footprint(
        a * ends.x,
        (b - shear * a) * ends.y,
        vec3f(ends.x, -shear * ends.y, ends.y),
        inverseSqrt(determinant),
        gabor_reach * gabor_reach * (1.0 + longest),
    );
}

/// The kernels of one cell, added up, as a point sees them that is `apart` from the cell's low corner: (value, g).
///
/// `words` are the cell's own, by `gabor_kernel_words`.
///
/// Source: as `gabor_kernel`, with a fixed number of kernels a cell: it varies less than Poisson's.
/// Domain: apart in [-1, 2], words integer in [0, 4294967295], kernels integer in [1, 4], spectrum.frequency in [0, 2],
/// spectrum.azimuth in [-3, 3], spectrum.height in [-0.5, 0.5], footprint from gabor_covered.
/// Error: 2e-6 absolute; f32 rounding of phases.
fn gabor_cell(
    apart: vec3f,
    words: vec3u,
    kernels: u32,
    spectrum: gabor_spectrum,
    footprint: gabor_footprint,
) -> vec4f {
    var next = words;
    var sum = vec4f();
    for (var number = 0u; number < min(kernels, 64u); number++) {
        next = hash_triple(next);
        sum += gabor_kernel(apart - gabor_kernel_place(next.x), next.yz, spectrum, footprint);
    }
    return sum;
}

/// Noise filtered over a footprint about a point, and its gradient, both in cells: (value, gradient).
///
/// A cell has `kernels` kernels, whose places, frequencies and phases are hashed from the cell and `seed`. Positions
/// beyond 1e9 cells count as 1e9.
///
/// Source: Lagae and Drettakis 2011, equation 11.
/// Domain: position in [-1000, 1000], kernels integer in [1, 2], seed integer in [0, 4294967295],
/// spectrum.frequency in [0, 2], spectrum.azimuth in [-3, 3], spectrum.height in [-0.5, 0.5],
/// footprint from gabor_covered.
/// Error: 2e-5 absolute; f32 rounding of gradients up to 10.
fn gabor_noise(
    position: vec3f,
    kernels: u32,
    seed: u32,
    spectrum: gabor_spectrum,
    footprint: gabor_footprint,
) -> vec4f {
    let p = clamp(position, vec3f(-1e9), vec3f(1e9));
    let corner = floor(p - 0.5) - 1.0;
    var sum = vec4f();
    for (var index = 0u; index < 64u; index++) {
        let offset = vec3u(index & 3u, (index >> 2u) & 3u, index >> 4u);
        let apart = p - corner - vec3f(offset);
        let outside = max(max(apart - 1.0, -apart), vec3f());
        if dot(outside, outside) < footprint.farthest {
            let words = gabor_kernel_words(vec3i(corner), offset, seed);
            sum += gabor_cell(apart, words, kernels, spectrum, footprint);
        }
    }
    // Over all places and phases a kernel has the mean square ½ (2a²)^(-3/2).
    let scale = 1.70185469 * inverseSqrt(f32(clamp(kernels, 1u, 64u)));
    let g = sum.yzw;
    let fall = g - footprint.first * dot(footprint.first, g) - footprint.second * dot(footprint.second, g);
    return scale * vec4f(sum.x, -6.28318531 * fall);
}
