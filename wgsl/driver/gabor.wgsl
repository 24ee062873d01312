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
// N Nᵀ with a matrix N of two columns (`first` and `second`): what M does to r and ω takes their products with these
// alone, and what the noise's gradient is along the footprint follows from its products with them, too.
//
// Lengths are in cells, whose side is `gabor_bandwidth` of 1/a. A kernel counts where rᵀM r is below the square of
// `gabor_reach`; the 4³ cells about a point hold all of them for a point footprint, and cut what a long footprint
// stretches beyond. The noise has the mean 0, the variance 1 but 4e-4 that the reach cuts, and steps of 1 % of a
// deviation where kernels end.

/// The bandwidth a, in 1/cells.
const gabor_bandwidth = 0.8;

/// How far a kernel reaches, in cells: exp(−π a² reach²) = 0.011.
const gabor_reach = 1.5;

/// What the noise needs of a footprint, by `gabor_covered`.
struct gabor_footprint {
    /// The columns of N, of which I − M = N Nᵀ; the third number of the second is 0.
    first: vec3f,
    second: vec2f,
    /// F by its columns: (across along)ᵀ M = F Nᵀ/(2π a²).
    factor: vec4f,
    /// Sum and product of the two eigenvalues of I − M.
    trace: f32,
    area: f32,
    /// √|M|.
    density: f32,
    /// Square of how far from the point a kernel can count.
    farthest: f32,
}

/// What the noise needs of the footprint of covariance across acrossᵀ + along alongᵀ, in cells.
///
/// Vectors beyond 1e8 cells count as 1e8, third numbers that are both below 1e-15 as 0.
///
/// Source: Woodbury's identity, I − M = 2π a² J (I + 2π a² JᵀJ)⁻¹ Jᵀ, J having the columns across and along, turned
/// until the second is level, with the Cholesky factor of the inverse.
/// Domain: across in [-1, 1], along in [-1, 1].
/// Error: 5e-7 of 1 + the result; f32 rounding.
fn gabor_covered(across: vec3f, along: vec3f) -> gabor_footprint {
    let u = clamp(across, vec3f(-1e8), vec3f(1e8));
    let v = clamp(along, vec3f(-1e8), vec3f(1e8));
    let steep = vec2f(u.z, v.z);
    let square = dot(steep, steep);
    // √(2π) a times a turn.
    let turn = 2.00530262 * select(vec2f(1.0, 0.0), steep * inverseSqrt(square), square > 1e-30);
    let a = turn.x * u + turn.y * v;
    let b = turn.x * v.xy - turn.y * u.xy;
    let squares = vec2f(dot(a, a), dot(b, b));
    let both = dot(a.xy, b);
    let sum = squares.x + squares.y;
    // The determinant of JᵀJ as a sum of squares: the product of its diagonal less a square would lose it.
    let level = a.x * b.y - a.y * b.x;
    let area = a.z * a.z * squares.y + level * level;
    let density = inverseSqrt(1.0 + sum + area);
    let share = density * density;
    let grown = 1.0 + squares.y;
    let end = inverseSqrt(grown);
    let start = grown * end * density;
    let shear = both * end * end;
    let longest = 0.5 * (sum + length(vec2f(squares.x - squares.y, 2.0 * both)));
    return gabor_footprint(
        start * (a - vec3f(shear * b, 0.0)),
        end * b,
        vec4f(start * vec2f(turn.x + shear * turn.y, turn.y - shear * turn.x), end * vec2f(-turn.y, turn.x)),
        share * (sum + 2.0 * area),
        share * area,
        density,
        gabor_reach * gabor_reach * (1.0 + longest),
    );
}

/// A sum of kernels with those of one cell, as a point sees them that is `apart` from the cell's low corner:
/// (value, Nᵀg), by `gabor_kernel`.
///
/// `words` are the cell's own, by `gabor_kernel_words`.
///
/// Source: as `gabor_kernel`, with a fixed number of kernels a cell: it varies less than Poisson's.
/// Domain: sum in [-1, 1], apart in [-1, 2], words integer in [0, 4294967295], kernels integer in [1, 4],
/// spectrum from gabor_spectrum_of, footprint from gabor_covered.
/// Error: 1e-5 absolute; f32 rounding of phases.
fn gabor_cell(
    sum: vec3f,
    apart: vec3f,
    words: vec3u,
    kernels: u32,
    spectrum: gabor_spectrum,
    footprint: gabor_footprint,
) -> vec3f {
    var next = words;
    var all = sum;
    for (var number = 0u; number < min(kernels, 64u); number++) {
        next = hash_triple(next);
        all = gabor_kernel(all, apart - gabor_kernel_place(next.x), next.yz, spectrum, footprint);
    }
    return all;
}

/// Noise filtered over a footprint about a point, in cells, and its derivatives along the footprint's two vectors:
/// (value, derivatives).
///
/// A cell has `kernels` kernels, whose places, frequencies and phases are hashed from the cell and `seed`. Positions
/// beyond 1e9 cells count as 1e9. Errors grow in proportion to frequencies beyond four cycles a cell, five bandwidths.
///
/// Source: Lagae and Drettakis 2011, equation 11.
/// Domain: position in [-1000000, 1000000], kernels integer in [1, 2], seed integer in [0, 4294967295],
/// spectrum from gabor_spectrum_of, footprint from gabor_covered.
/// Error: 6e-6 absolute; f32 rounding of phases.
fn gabor_noise(
    position: vec3f,
    kernels: u32,
    seed: u32,
    spectrum: gabor_spectrum,
    footprint: gabor_footprint,
) -> vec3f {
    let p = clamp(position, vec3f(-1e9), vec3f(1e9));
    let corner = floor(p - 0.5) - 1.0;
    let within = p - corner;
    let words = gabor_kernel_words(vec3i(corner), seed);
    var sum = vec3f();
    for (var index = 0u; index < 64u; index++) {
        let offset = vec3u(index & 3u, (index >> 2u) & 3u, index >> 4u);
        let apart = within - vec3f(offset);
        let outside = apart - saturate(apart);
        if dot(outside, outside) < footprint.farthest {
            sum = gabor_cell(sum, apart, words + offset, kernels, spectrum, footprint);
        }
    }
    // Over all places and phases a kernel has the mean square ½ (2a²)^(-3/2).
    sum *= footprint.density * 1.70185469 * inverseSqrt(f32(clamp(kernels, 1u, 64u)));
    return vec3f(sum.x, -1.5625 * (footprint.factor.xy * sum.y + footprint.factor.zw * sum.z)); // 1/a²
}
