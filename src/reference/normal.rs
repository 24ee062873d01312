//! The standard normal distribution.

use super::quadrature::integrate;

/// Beyond this many deviations the density is below 1e-30 and integrals stop.
pub const REACH: f64 = 12.0;

/// The density φ(x) of a standard normal variable.
pub fn density(x: f64) -> f64 {
    (-0.5 * x * x).exp() / (2.0 * std::f64::consts::PI).sqrt()
}

/// The probability Φ(x) that a standard normal variable is below `x`, from libm's complementary error function.
pub fn cumulative(x: f64) -> f64 {
    0.5 * libm::erfc(-x * std::f64::consts::FRAC_1_SQRT_2)
}

/// The surprisal −log₂ Φ(x) of finding a standard normal variable below `x`, in bits. Infinite below −38.
pub fn surprisal(x: f64) -> f64 {
    // Next to 1 the logarithm takes the probability above, which keeps its digits.
    let bits = if x > 0.0 { libm::log1p(-cumulative(-x)) } else { libm::log(cumulative(x)) };
    -bits * std::f64::consts::LOG2_E
}

/// The mean excess E[max(z − threshold, 0)] of a standard normal variable, by quadrature of its definition.
pub fn excess(threshold: f64) -> f64 {
    let from = threshold.max(-REACH);
    let [mean] = integrate(from, (from + 2.0).max(REACH), 1.0, |z| [(z - threshold) * density(z)]);
    mean
}
