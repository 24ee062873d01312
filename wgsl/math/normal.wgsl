// The standard normal distribution: its cumulative function and its mean excess.
//
// The precise forms are 1/(1 + q(x))^(2^n) with a positive polynomial q: monotone, without exp, and free of overflow
// once x is clamped. Squaring goes by (1 + q)² − 1 = q (2 + q), which keeps the digits of a small q: rounding 1 + q
// first would cost eight times the error. The coefficients are minimax fits of the notes behind the crate;
// `spirv-tests` measures every one of them against quadrature, and the promise below each function is what those tests
// enforce.

/// Probability that a standard normal variable is below `x`.
///
/// Source: the definition, Φ(x) = ∫ φ from −∞ to x; a degree-6 polynomial to the power −16 for the lower tail.
/// Domain: x in [-12, 12].
/// Error: 4e-7 absolute; fit 1.3e-7, the rest is f32 rounding and the device's division.
fn normal_cdf(x: f32) -> f32 {
    let y = min(abs(x), 8.0);
    var q = y * (0.049867348 + y * (0.0211409967 + y * (0.00327765089
        + y * (3.79774955e-5 + y * (4.89024893e-5 + y * 5.38107038e-6)))));
    q *= 2.0 + q;
    q *= 2.0 + q;
    q *= 2.0 + q;
    q *= 2.0 + q;
    let tail = 0.5 / (1.0 + q);
    return select(1.0 - tail, tail, x < 0.0);
}

/// Probability that a standard normal variable is below `x`, by one exponential and one reciprocal.
///
/// Source: the definition; logistic function of an odd quintic.
/// Domain: x in [-12, 12].
/// Error: 2e-5 absolute; of the fit.
fn normal_cdf_fast(x: f32) -> f32 {
    let z = clamp(x, -6.0, 6.0);
    let u = z * z;
    return 1.0 / (1.0 + exp(-z * (1.59543565 + u * (0.0735965337 - 0.000631618467 * u))));
}

/// Mean excess of a standard normal variable z over a threshold: E[max(z − threshold, 0)].
///
/// Source: the definition, φ(t) − t Φ(−t) for t ≥ 0; φ(0) to the bits that it loses, a minimax polynomial of degree 6.
/// Domain: threshold in [0, 12].
/// Error: 2e-7 absolute; fit 4.9e-8, the rest is f32 rounding and the device's exp2. Beyond 6 it stays 1.2e-10.
fn normal_excess(threshold: f32) -> f32 {
    let x = clamp(threshold, 0.0, 6.0);
    let bits = x * (1.80815711 + x * (0.411663591 + x * (0.0429469204 + x * (-0.00313502151
        + x * (-0.000149233981 + x * 3.98099812e-5)))));
    return 0.3989422804 * exp2(-bits); // φ(0) = 1/√(2π)
}

/// Mean excess of a standard normal variable over a threshold, by a shorter polynomial.
///
/// Source: as `normal_excess`, with degree 4.
/// Domain: threshold in [0, 12].
/// Error: 1e-6 absolute; fit 6.8e-7.
fn normal_excess_fast(threshold: f32) -> f32 {
    let x = clamp(threshold, 0.0, 6.0);
    let bits = x * (1.80810752 + x * (0.411901127 + x * (0.0427071737 - x * 0.00320086619)));
    return 0.3989422804 * exp2(-bits); // φ(0) = 1/√(2π)
}

/// Surprisal −log₂ Φ(x) of finding a standard normal variable below `x`, in bits.
///
/// Powers of Φ are exp2(−n · surprisal) with an error of 0.37 times the relative one for every n, where pow(Φ, n) loses
/// all digits at the upper end. Arguments below −1e9 count as −1e9.
///
/// Source: the definition; Φ(−y) = exp(−y²/2) R(y) with a rational R, and −log₂(1 − q) = q S(q) with a rational S.
/// Domain: x in [-14, 12].
/// Error: 1e-5 relative; rounding of y² before exp2, and that of the device. 2.3e-6 for x in [-6, 6].
fn normal_surprisal(x: f32) -> f32 {
    let y = min(abs(x), 1e9);
    let n = 1.0 + y * (0.72191467 + y * (0.23781540 + y * 0.033766046));
    let d = 1.0 + y * (1.5197863 + y * (0.95055303 + y * (0.29784971 + y * 0.042324610)));
    let r = max(0.5 * n / d, 1e-12);
    let bits = 0.72134752 * (y * y);
    let q = exp2(-min(bits, 200.0)) * r;
    let s = (1.4426958 + q * (-1.1578648 + q * 0.078196992)) / (1.0 + q * (-1.3025332 + q * 0.37169260));
    return select(q * s, bits - log2(r), x < 0.0);
}
