// Spectra of solid Gabor noise: the frequencies of its kernels, and what a footprint leaves of the noise's variance.
//
// With V the variance of the noise filtered over a footprint of covariance t Σ, in variances of the noise itself:
//
//     V = √|M| E exp(−(2π/a²) ωᵀ(I − M)ω), the mean being over the frequencies,
//     −dV/d ln t = E[∇f̄ᵀ Σ ∇f̄], the mean being over places: what the gradient of the filtered noise f̄ says of the
//     variance within a footprint beyond 1 − V.
//
// Frequencies are in cycles a cell, angles in radians.

/// The frequencies of a noise's kernels: ω = f (√(1 − h²) cos α, √(1 − h²) sin α, h), each of f, α and h spread evenly
/// over 65536 shares: in the first of them, and how far the next is. By `gabor_spectrum_of`.
struct gabor_spectrum {
    frequency: vec2f,
    azimuth: vec2f,
    height: vec2f,
}

/// The frequencies of f, α and h from the given numbers to so far beyond them: height −1 and 2 is the whole sphere.
///
/// f is kept within 1e6, α within 10 and h within 1.
///
/// Source: the definition, the middle of each share.
/// Domain: frequency in [0, 2], azimuth in [-3, 3], height in [-0.5, 0.5].
/// Error: 3e-7 absolute; f32 rounding.
fn gabor_spectrum_of(frequency: vec2f, azimuth: vec2f, height: vec2f) -> gabor_spectrum {
    let most = vec3f(1e6, 10.0, 1.0);
    let low = clamp(vec3f(frequency.x, azimuth.x, height.x), -most, most);
    let high = clamp(low + vec3f(frequency.y, azimuth.y, height.y), -most, most);
    let share = (high - low) * 1.52587890625e-5;
    let middle = low + 0.5 * share;
    return gabor_spectrum(
        vec2f(middle.x, share.x),
        vec2f(middle.y, share.y),
        vec2f(middle.z, share.z),
    );
}

/// The frequency of a kernel by its random words.
///
/// Azimuth and height have 16 bits each of the first word, the length the low 16 of the second.
///
/// Source: Lagae and Drettakis 2011, "Filtering Solid Gabor Noise", section 3.3, with ranges.
/// Domain: words integer in [0, 4294967295], spectrum from gabor_spectrum_of.
/// Error: 4e-6 absolute; f32 rounding.
fn gabor_spectrum_frequency(words: vec2u, spectrum: gabor_spectrum) -> vec3f {
    let parts = vec3f(vec3u(words.x >> 16u, words.x & 65535u, words.y & 65535u));
    let azimuth = spectrum.azimuth.x + parts.x * spectrum.azimuth.y;
    let height = spectrum.height.x + parts.y * spectrum.height.y;
    let length = spectrum.frequency.x + parts.z * spectrum.frequency.y;
    let level = length * sqrt(max(1.0 - height * height, 0.0));
    return vec3f(level * cos(azimuth), level * sin(azimuth), length * height);
}

/// What a footprint leaves of the variance of kernels of one frequency: (V, −dV/d ln t).
///
/// Source: the power spectrum of the filtered noise, integrated; with I − M = N Nᵀ and M (I − M) = N FᵀF Nᵀ/(2π a²).
/// Domain: frequency in [-4, 4], footprint from gabor_covered.
/// Error: 6e-7 absolute; f32 rounding.
fn gabor_spectrum_retained(frequency: vec3f, footprint: gabor_footprint) -> vec2f {
    let w = clamp(frequency, vec3f(-1e6), vec3f(1e6));
    let along = vec2f(dot(footprint.first, w), dot(footprint.second, w.xy));
    let left = footprint.factor.xy * along.x + footprint.factor.zw * along.y;
    // 2π/a² in bits, and 1/a⁴.
    let retained = footprint.density * exp2(-14.1636254 * dot(along, along));
    return retained * vec2f(1.0, 0.5 * footprint.trace + min(2.44140625 * dot(left, left), 1e30));
}

/// The same of kernels whose frequencies have one length and directions spread evenly over the sphere.
///
/// With x and y the eigenvalues of (2π/a²) f² (I − M) in the footprint's plane, p = x + y and q = x y, the mean over
/// directions E exp(−x u² − y v²) is √(d/n) with polynomials n and d of p and q. Lengths beyond 20 count as 20.
///
/// Source: the mean of `gabor_spectrum_retained`; for a round footprint D(√x)/√x with Dawson's function D, for a line
/// √π erf(√x)/(2√x). The polynomials are a least squares fit to quadrature over x from 0.01 to 3000 and all y below.
/// Domain: length in [0, 4], footprint from gabor_covered.
/// Error: 2e-3 absolute; of the fit.
fn gabor_spectrum_retained_evenly(length: f32, footprint: gabor_footprint) -> vec2f {
    let scale = 9.81747704 * min(length * length, 400.0); // (2π/a²) f²
    let trace = footprint.trace;
    let area = footprint.area;
    let p = scale * trace;
    let q = scale * scale * area;
    // Derivatives by ln t: of an eigenvalue k of I − M that is k (1 − k).
    let p_rate = scale * (trace * (1.0 - trace) + 2.0 * area);
    let q_rate = q * (2.0 - trace);
    let mixed = 0.27083964 + p * (0.221167706 + p * 0.120112626);
    let n = 1.0 + p * (0.90299436 + p * (0.344583963 + p * 0.071535069))
        + q * (mixed + q * (0.012743194 + p * 0.0542881067 + q * 0.0702069496));
    let n_by_p = 0.90299436 + p * (0.689167926 + p * 0.214605207)
        + q * (0.221167706 + p * 0.240225252 + q * 0.0542881067);
    let n_by_q = mixed + q * (0.025486388 + p * 0.108576213 + q * 0.210620849);
    let d = 1.0 + p * (0.235986263 + p * 0.0574586926) + q * (p * 0.0295971957 + q * 0.0155927469);
    let d_by_p = 0.235986263 + p * 0.114917385 + q * 0.0295971957;
    let d_by_q = p * 0.0295971957 + q * 0.0311854938;
    let inverse = inverseSqrt(n * d);
    let rates = (n_by_p * p_rate + n_by_q * q_rate) * d - (d_by_p * p_rate + d_by_q * q_rate) * n;
    return footprint.density * d * inverse * vec2f(1.0, 0.5 * (trace + rates * inverse * inverse));
}

/// Variance of the noise within a footprint, from what it leaves, by `gabor_spectrum_retained`, and from the filtered
/// noise's derivatives along the footprint's two vectors.
///
/// Source: the mean of the variance over places is 1 − V; the derivatives say how far this place is from the mean.
/// Domain: retained in [0, 1], slopes in [-1, 1].
/// Error: 3e-7 absolute; f32 rounding.
fn gabor_spectrum_variance(retained: vec2f, slopes: vec2f) -> f32 {
    let s = clamp(slopes, vec2f(-1e18), vec2f(1e18));
    return max(1.0 - retained.x - retained.y + dot(s, s), 0.0);
}
