// Ch: the distribution of visible heights, D_h(h) = (1 + Λ) Φ(h)^Λ φ(h), for standard normal heights.
//
// `lambda` is the sum of Smith's Λ of the view and of the light, 0 where nothing is hidden. The moments are rational
// functions of t = log2(1 + lambda) over a common denominator, exact at 0, the mean with its slope. Their
// coefficients are minimax fits of the notes behind the crate; `spirv-tests` measures them against quadrature. Larger
// values of `lambda` than 1e4, of the fast moments and of probabilities 1e6, count as these.

/// Mean, deviation and skewness of visible heights.
///
/// Source: Heitz et al. 2014, "Filtering Non-Linear Transfer Functions on Surfaces", equations 15 to 17, by quadrature.
/// Domain: lambda log in [1e-4, 1e4].
/// Error: 1.6e-3 absolute; of the skewness. Mean and deviation: 7e-5.
fn heights_moments(lambda: f32) -> vec3f {
    let t = log2(1.0 + clamp(lambda, 0.0, 1e4));
    let q = 1.0 + t * (0.27056558 + t * (0.030296157 + t * 0.0010040182));
    let mean = t * (0.62604865 + t * (0.10038940 + t * (0.0080702985 + t * 7.6912371e-5)));
    let deviation = 1.0 + t * (0.063914364 + t * (0.010908597 - t * 1.4943288e-5));
    let skewness = t * (0.13926165 + t * (0.039943899 + t * 0.00071883245));
    return vec3f(mean, deviation, skewness) * (1.0 / q);
}

/// Mean, deviation and skewness of visible heights, by shorter polynomials.
///
/// Source: as `heights_moments`.
/// Domain: lambda log in [1e-4, 1e4].
/// Error: 1.9e-3 absolute; of the skewness. Mean and deviation: 9.5e-4, which they keep up to 1e6, where the skewness
/// is 2.2e-2 too low.
fn heights_moments_fast(lambda: f32) -> vec3f {
    let t = log2(1.0 + clamp(lambda, 0.0, 1e6));
    let q = 1.0 + t * (0.32372991 + t * (0.036115665 + t * 0.00042276520));
    let mean = t * (0.62604865 + t * (0.13523097 + t * 0.0070806581));
    let deviation = 1.0 + t * (0.11443047 + t * 0.0074989065);
    let skewness = t * (0.13572248 + t * 0.051691998);
    return vec3f(mean, deviation, skewness) * (1.0 / q);
}

/// Mean and deviation of visible heights by the paper's fits, to compare with.
///
/// Source: Heitz et al. 2014, equations 16 and 17, with the natural logarithm. The paper names no base; with 2 and 10
/// its mean would be off by 0.96 and 1.47. Its equation 17 gives the deviation about the mean, not the raw moment that
/// it is set equal to.
/// Domain: lambda log in [1e-4, 100].
/// Error: 0.14 absolute; of the paper's mean, 0.131 too high at 0.56. At 1e4 it is 0.35 too high, and grows on.
fn heights_moments_paper(lambda: f32) -> vec2f {
    let l = clamp(lambda, 0.0, 1e6);
    return vec2f(0.39 * log(max(4.75 * l + 1.0, 1.0)), 1.0 / (1.0 + 0.26 * log(max(1.13 * l + 1.0, 1.0))));
}

/// Probability that a visible height is below `height`: Φ(height)^(1 + lambda).
///
/// Source: Heitz et al. 2014, equation 15, integrated; by the surprisal, because a power of Φ loses the upper tail.
/// Domain: height in [-8, 8], lambda log in [1e-4, 1e6].
/// Error: 1e-6 absolute; 0.37 of the relative error of `normal_surprisal`, and f32 rounding.
fn heights_cdf(height: f32, lambda: f32) -> f32 {
    let bits = (1.0 + clamp(lambda, 0.0, 1e6)) * normal_surprisal(height);
    return exp2(-min(bits, 200.0));
}

/// Mean of the power Φ(h)^power over visible heights h: maps that are polynomials in Φ need no more.
///
/// Source: Heitz et al. 2014, equation 3 without its visibility for the power 1; the integral of Φ^(power + lambda) φ.
/// Domain: power in [0, 16], lambda log in [1e-4, 1e6].
/// Error: 2e-7 absolute; f32 rounding and the device's division.
fn heights_power(power: f32, lambda: f32) -> f32 {
    let n = 1.0 + clamp(lambda, 0.0, 1e6);
    return n / (n + clamp(power, 0.0, 1e6));
}

/// Mean, deviation and skewness of heights of the given mean and deviation plus independent normal noise, when
/// `moments` are those of the heights in their own deviations: means, variances and third cumulants add.
///
/// Source: Heitz et al. 2014, section 5.1, for mean and variance; cumulants of independent variables add.
/// Domain: moments in [0.1, 4], mean in [-2, 2], deviation log in [0.01, 2], noise_mean in [-2, 2],
/// noise_deviation in [0, 2].
/// Error: 2e-6 absolute; f32 rounding of means up to 12.
fn heights_perturbed(moments: vec3f, mean: f32, deviation: f32, noise_mean: f32, noise_deviation: f32) -> vec3f {
    let scale = clamp(deviation, 0.0, 1e9);
    let own = clamp(moments, vec3f(-1e3, 0.0, -1e3), vec3f(1e3));
    let visible = scale * own.y;
    let noise = clamp(noise_deviation, 0.0, 1e9);
    let total = sqrt(visible * visible + noise * noise);
    let share = visible / max(total, 1e-18);
    let sum = clamp(mean, -1e18, 1e18) + scale * own.x + clamp(noise_mean, -1e18, 1e18);
    return vec3f(sum, total, own.z * (share * share * share));
}
