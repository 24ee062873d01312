// Visible normals: the means of n and of n nᵀ over the slopes that a view sees, n = (−s.x, −s.y, 1) / √(1 + |s|²).
//
// Both roots are sums of four Gaussians of the slope's length, 1/√(1 + |s|²) ≈ Σ aᵢ exp(−bᵢ |s|²) and its square with
// other weights aᵢ, and a normal density times such a Gaussian is a normal density again, whose visible slopes have
// closed moments. What the sum misses at the mean visible slope is added, so that nothing is missed where all slopes
// are that one, however steep. With four terms the sums miss up to 6.6e-4 for |s| up to 3.

/// Means over visible normals, or those of a frame that they are turned to.
struct normals_means {
    /// Of n.
    first: vec3f,
    /// Of n.x n.x, n.x n.y and n.y n.y.
    level: vec3f,
    /// Of n.x n.z, n.y n.z and n.z n.z.
    upright: vec3f,
}

/// Adds to the means those of a slope's normal, times a weight for the first and one for the others.
///
/// Source: the definition, but for the factors 1/√(1 + |s|²) and 1/(1 + |s|²), which the weights hold.
/// Domain: means.first in [-1, 1], means.level in [-1, 1], means.upright in [-1, 1], slope in [-3, 3],
///   weight in [0, 1], square_weight in [0, 1].
/// Error: 2e-6 absolute; f32 rounding of products up to 9.
fn normals_plus(means: normals_means, slope: vec2f, weight: f32, square_weight: f32) -> normals_means {
    let s = clamp(slope, vec2f(-1e9), vec2f(1e9));
    let first = means.first + weight * vec3f(-s, 1.0);
    let level = means.level + square_weight * s.xxy * s.xyy;
    return normals_means(first, level, means.upright + square_weight * vec3f(-s, 1.0));
}

/// Adds to the means those of a slope's normal, times a weight.
///
/// Source: the definition.
/// Domain: means.first in [-1, 1], means.level in [-1, 1], means.upright in [-1, 1], slope in [-3, 3], weight in [0,
/// 1].
/// Error: 5e-7 absolute; f32 rounding.
fn normals_plus_one(means: normals_means, slope: vec2f, weight: f32) -> normals_means {
    let s = clamp(slope, vec2f(-1e9), vec2f(1e9));
    let z = inverseSqrt(1.0 + dot(s, s));
    return normals_plus(means, s, weight * z, weight * z * z);
}

/// Adds to the means the part of the Gaussian exp(−rate |s|²) over the slopes that are seen, `area` being that of all.
///
/// With the Gaussian, slopes of the mean s̄ and the covariance Σ have the mean (s̄ + 2 b adj(Σ) s̄) / D and the
/// covariance (Σ + 2 b det Σ) / D, D = 1 + 2 b tr Σ + 4 b² det Σ, and weigh exp(−b s̄ · mean) / √D.
///
/// Source: completing the square.
/// Domain: means.first in [-1, 1], means.level in [-1, 1], means.upright in [-1, 1], view unit upper,
///   mean_slope in [-1, 1], covariance psd(0.1, 1, 0.9), area in [1, 1], rate in [0.02, 3], weight in [0, 1],
///   square_weight in [0, 1].
/// Error: 2e-6 absolute; f32 rounding.
fn normals_gaussian(
    means: normals_means, view: vec3f, mean_slope: vec2f, covariance: vec3f, area: f32, rate: f32, weight: f32,
    square_weight: f32,
) -> normals_means {
    let s = clamp(mean_slope, vec2f(-1e4), vec2f(1e4));
    let variances = clamp(covariance.xz, vec2f(), vec2f(1e4));
    let most = sqrt(variances.x * variances.y);
    let c = vec3f(variances.x, clamp(covariance.y, -most, most), variances.y);
    let k = 2.0 * clamp(rate, 0.0, 1e2);
    let determinant = max(c.x * c.z - c.y * c.y, 0.0);
    let inverse = 1.0 / (1.0 + k * (c.x + c.z + k * determinant));
    let mean = (s + k * vec2f(c.z * s.x - c.y * s.y, c.x * s.y - c.y * s.x)) * inverse;
    let factor = slopes_factor(view, (c + vec3f(k * determinant, 0.0, k * determinant)) * inverse);
    let u = slopes_moments(slopes_parameter(view, mean, factor));
    let seen = slopes_area(view, mean, factor) / max(area, 1e-30);
    let share = exp(-0.5 * k * max(dot(s, mean), 0.0)) * sqrt(inverse) * seen;
    var sum = normals_plus(means, mean + u.x * factor.xy, share * weight, share * square_weight);
    sum.level += share * square_weight * slopes_covariance(factor, u.y);
    return sum;
}

/// Means over the normals of the slopes that a view sees; where it sees none, those of the mean of what it sees last.
/// For views from 5 degrees above the plane and the mean surface on, and deviations up to 1 along any axis: others see
/// slopes beyond 3. Covariances are scaled to variances of 1e4 at most, for all that is seen and for each Gaussian's.
///
/// Source: Heitz et al. 2014, "Filtering Non-Linear Transfer Functions on Surfaces", section 5.3, for order 2.
/// Domain: view unit upper, mean_slope in [-0.3, 0.3], covariance psd(0.05, 1, 0.9).
/// Error: 7e-4 absolute; of the four Gaussians.
fn normals_visible(view: vec3f, mean_slope: vec2f, covariance: vec3f) -> normals_means {
    let finite = clamp(covariance, vec3f(-3e38), vec3f(3e38));
    let c = finite * (2.5e3 / max(0.25 * max(finite.x, finite.z), 2.5e3));
    let factor = slopes_factor(view, c);
    let area = slopes_area(view, mean_slope, factor);
    let u = slopes_moments(slopes_parameter(view, mean_slope, factor));
    let mean = clamp(mean_slope + u.x * factor.xy, vec2f(-1e9), vec2f(1e9));
    let squared = dot(mean, mean);
    let z = inverseSqrt(1.0 + squared);
    let none = normals_means(vec3f(), vec3f(), vec3f());
    if area < 1e-30 {
        return normals_plus(none, mean, z, z * z);
    }
    let rates = vec4f(0.02683, 0.26268, 0.95868, 2.79078);
    let w = vec4f(0.36239, 0.33308, 0.24746, 0.05708);
    let q = vec4f(0.08936, 0.3169, 0.41236, 0.18138);
    let found = exp(-rates * min(squared, 4e3)); // 0 there, whatever multiplies it
    var m = normals_plus(none, mean, z - dot(w, found), z * z - dot(q, found));
    m = normals_gaussian(m, view, mean_slope, c, area, rates.x, w.x, q.x);
    m = normals_gaussian(m, view, mean_slope, c, area, rates.y, w.y, q.y);
    m = normals_gaussian(m, view, mean_slope, c, area, rates.z, w.z, q.z);
    return normals_gaussian(m, view, mean_slope, c, area, rates.w, w.w, q.w);
}

/// The same by three Gaussians, which miss up to 3.5e-3 for |s| up to 2.5; for the same views and deviations.
///
/// Source: as `normals_visible`.
/// Domain: view unit upper, mean_slope in [-0.3, 0.3], covariance psd(0.05, 1, 0.9).
/// Error: 5.5e-3 absolute; of the three Gaussians.
fn normals_visible_fast(view: vec3f, mean_slope: vec2f, covariance: vec3f) -> normals_means {
    let finite = clamp(covariance, vec3f(-3e38), vec3f(3e38));
    let c = finite * (2.5e3 / max(0.25 * max(finite.x, finite.z), 2.5e3));
    let factor = slopes_factor(view, c);
    let area = slopes_area(view, mean_slope, factor);
    let u = slopes_moments(slopes_parameter(view, mean_slope, factor));
    let mean = clamp(mean_slope + u.x * factor.xy, vec2f(-1e9), vec2f(1e9));
    let squared = dot(mean, mean);
    let z = inverseSqrt(1.0 + squared);
    let none = normals_means(vec3f(), vec3f(), vec3f());
    if area < 1e-30 {
        return normals_plus(none, mean, z, z * z);
    }
    let rates = vec3f(0.05083, 0.46504, 1.89618);
    let w = vec3f(0.48203, 0.35231, 0.16913);
    let q = vec3f(0.15483, 0.47035, 0.37135);
    let found = exp(-rates * min(squared, 4e3)); // 0 there, whatever multiplies it
    var m = normals_plus(none, mean, z - dot(w, found), z * z - dot(q, found));
    m = normals_gaussian(m, view, mean_slope, c, area, rates.x, w.x, q.x);
    m = normals_gaussian(m, view, mean_slope, c, area, rates.y, w.y, q.y);
    return normals_gaussian(m, view, mean_slope, c, area, rates.z, w.z, q.z);
}

/// The same by five slopes: the mean of the visible ones and, with a sixth of the weight each, those √3 deviations off.
/// For the same views, and deviations up to 0.3 along any axis.
///
/// Source: Julier and Uhlmann 1997, "A New Extension of the Kalman Filter to Nonlinear Systems", for two variables.
/// Domain: view unit upper, mean_slope in [-0.3, 0.3], covariance psd(0.05, 0.3, 0.9).
/// Error: 7.5e-3 absolute; of five slopes.
fn normals_visible_points(view: vec3f, mean_slope: vec2f, covariance: vec3f) -> normals_means {
    let factor = slopes_factor(view, covariance);
    let u = slopes_moments(slopes_parameter(view, mean_slope, factor));
    let mean = mean_slope + u.x * factor.xy;
    let e = sqrt(3.0 * u.y) * factor.xy;
    let f = sqrt(3.0) * factor.zw;
    var m = normals_plus_one(normals_means(vec3f(), vec3f(), vec3f()), mean, 1.0 / 3.0);
    m = normals_plus_one(m, mean + e, 1.0 / 6.0);
    m = normals_plus_one(m, mean - e, 1.0 / 6.0);
    m = normals_plus_one(m, mean + f, 1.0 / 6.0);
    return normals_plus_one(m, mean - f, 1.0 / 6.0);
}
