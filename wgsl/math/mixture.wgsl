// Two normal distributions of one deviation that have a given mean, variance, skewness and excess kurtosis together.
//
// In units of the deviation about the mean the two are at x > 0 and −y < 0, which the mean weighs y/(x + y) and
// x/(x + y). The share u = x y of the variance lies between them and 1 − u within each, so that the skewness is
// u (x − y) and the excess kurtosis u (x − y)² − 2 u².

/// Two normal distributions: how far from the common mean and how wide each is, in units of the common deviation, and
/// how much of the whole each is.
struct mixture {
    offsets: vec2f,
    weights: vec2f,
    deviation: f32,
}

/// The two normal distributions of one deviation with the given skewness and excess kurtosis, the higher one first.
///
/// Both are the one of mean 0 and deviation 1 where skewness and excess kurtosis are 0, as where they are not known;
/// below 1e-6 they count as 0. The skewness is always that of the two. The excess kurtosis is, too, where that makes
/// them at most 32 deviations apart and at least 0.0316 deviations wide, and the nearest otherwise: no distribution has
/// one below the squared skewness less 2, and two that are wide enough have 0.004 more.
///
/// Source: Pearson 1894, "Contributions to the Mathematical Theory of Evolution", with equal variances, where the
/// nonic is the cubic 2 u³ + kurtosis u = skewness²; three steps of Newton's method from a start within 8%.
/// Domain: skewness in [-3, 3], kurtosis in [-2, 10].
/// Error: 1e-6 of 1 + the result; f32 rounding.
fn mixture_pair(skewness: f32, kurtosis: f32) -> mixture {
    let a = select(clamp(skewness, -1e9, 1e9), 0.0, abs(skewness) < 1e-6);
    let b = select(clamp(kurtosis, -1e9, 1e9), 0.0, abs(kurtosis) < 1e-6);
    let square = a * a;
    let cube_root = exp2(log2(max(0.5 * square, 1e-30)) * (1.0 / 3.0)); // the root where the kurtosis is 0
    let t = cube_root * cube_root;
    var u = select(0.5 * square * inverseSqrt(max(t * t + 0.25 * b * b, 1e-30)), sqrt(t - 0.5 * b), b < 0.0);
    u = (4.0 * u * u * u + square) / max(6.0 * u * u + b, 1e-30);
    u = (4.0 * u * u * u + square) / max(6.0 * u * u + b, 1e-30);
    u = (4.0 * u * u * u + square) / max(6.0 * u * u + b, 1e-30);
    u = min(max(u, abs(a) / 32.0), 0.999);
    let apart = a / max(u, 1e-30);
    let far = 0.5 * (abs(apart) + sqrt(apart * apart + 4.0 * u));
    let near = u / max(far, 1e-30);
    let light = select(near / (far + near), 0.5, u == 0.0); // of the far one
    let higher = apart >= 0.0;
    return mixture(
        select(vec2f(near, -far), vec2f(far, -near), higher),
        select(vec2f(1.0 - light, light), vec2f(light, 1.0 - light), higher),
        sqrt(1.0 - u),
    );
}
