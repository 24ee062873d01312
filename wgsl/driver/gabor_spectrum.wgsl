// Spectra of solid Gabor noise: the frequencies of its kernels, and what a footprint leaves of the noise's variance.
//
// With V the variance of the noise filtered over a footprint of covariance t Σ, in variances of the noise itself:
//
//     V = √|M| E exp(−(2π/a²) ωᵀ(I − M)ω), the mean being over the frequencies,
//     −dV/d ln t = E[∇f̄ᵀ Σ ∇f̄], the mean being over places: what the gradient of the filtered noise f̄ says of the
//     variance within a footprint beyond 1 − V.
//
// Frequencies are in cycles a cell, angles in radians.

/// The frequencies of a noise's kernels: ω = f (√(1 − h²) cos α, √(1 − h²) sin α, h), each of f, α and h spread evenly.
struct gabor_spectrum {
    /// Least f and how far it goes beyond.
    frequency: vec2f,
    /// First α and how far it goes beyond.
    azimuth: vec2f,
    /// Least h and how far it goes beyond: −1 and 2 for the whole sphere.
    height: vec2f,
}

/// The frequency of a kernel by its random words.
///
/// Azimuth and height have 16 bits each of the first word, the length the low 16 of the second.
///
/// Source: Lagae and Drettakis 2011, "Filtering Solid Gabor Noise", section 3.3, with ranges.
/// Domain: words integer in [0, 4294967295], spectrum.frequency in [0, 2], spectrum.azimuth in [-3, 3],
/// spectrum.height in [-0.5, 0.5].
/// Error: 2e-6 absolute; f32 rounding.
fn gabor_spectrum_frequency(words: vec2u, spectrum: gabor_spectrum) -> vec3f {
    let parts = (vec3f(vec3u(words.x >> 16u, words.x & 65535u, words.y & 65535u)) + 0.5) * 1.52587890625e-5;
    let azimuth = clamp(spectrum.azimuth.x + parts.x * spectrum.azimuth.y, -10.0, 10.0);
    let height = clamp(spectrum.height.x + parts.y * spectrum.height.y, -1.0, 1.0);
    let length = clamp(spectrum.frequency.x + parts.z * spectrum.frequency.y, -1e6, 1e6);
    let level = length * sqrt(1.0 - height * height);
    return vec3f(level * cos(azimuth), level * sin(azimuth), length * height);
}

/// What a footprint leaves of the variance of kernels of one frequency: (V, −dV/d ln t).
///
/// Source: the power spectrum of the filtered noise, integrated; with I − M = l lᵀ and M (I − M) = l LᵀL lᵀ.
/// Domain: frequency in [-4, 4], footprint from gabor_covered.
/// Error: 6e-7 absolute; f32 rounding.
fn gabor_spectrum_retained(frequency: vec3f, footprint: gabor_footprint) -> vec2f {
    let w = clamp(frequency, vec3f(-1e6), vec3f(1e6));
    let along = vec2f(dot(footprint.first, w), dot(footprint.second, w));
    let left = vec2f(dot(footprint.factor.xy, along), footprint.factor.z * along.y);
    // 2π/a², and that in bits.
    let retained = footprint.density * exp2(-14.1636254 * dot(along, along));
    let spread = 0.5 * (dot(footprint.first, footprint.first) + dot(footprint.second, footprint.second));
    return retained * vec2f(1.0, spread + min(9.81747704 * dot(left, left), 1e30));
}

/// The same of kernels whose frequencies have one length and directions spread evenly over the sphere.
///
/// With x and y the eigenvalues of (2π/a²) f² (I − M) in the footprint's plane, p = x + y and q = x y, the mean over
/// directions E exp(−x u² − y v²) is √(d/n) with polynomials n and d of p and q.
///
/// Source: the mean of `gabor_spectrum_retained`; for a round footprint D(√x)/√x with Dawson's function D, for a line
/// √π erf(√x)/(2√x). The polynomials are a least squares fit to quadrature over x from 0.01 to 3000 and all y below.
/// Domain: length in [0, 4], footprint from gabor_covered.
/// Error: 2e-3 absolute; of the fit.
fn gabor_spectrum_retained_evenly(length: f32, footprint: gabor_footprint) -> vec2f {
    let scale = 9.81747704 * min(length * length, 1e5); // (2π/a²) f²
    let normal = cross(footprint.first, footprint.second);
    let trace = dot(footprint.first, footprint.first) + dot(footprint.second, footprint.second);
    let area = dot(normal, normal);
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
    let mean = sqrt(d / n);
    let rate = 0.5 * ((n_by_p * p_rate + n_by_q * q_rate) / n - (d_by_p * p_rate + d_by_q * q_rate) / d);
    return footprint.density * mean * vec2f(1.0, 0.5 * trace + rate);
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
