// Noise on visible heights: their sum is no distribution of visible heights of another Λ, though it has the mean, the
// deviation and the skewness of one.

/// The tails of visible heights with normal noise on them, where the sum has the given deviation and skewness.
///
/// The tails' coefficients are moved in proportion to the square of the skewness times the noise's share of the
/// variance, as the excess kurtosis is off to first order. A step errs by 7.6e-4 then, by 4.1e-3 with the tails of the
/// skewness alone. The product reaches 0.079, at a share of 1/4 and the skewness that a Λ of 1e4 has without noise.
///
/// Source: a fit of the largest error of a step, as `height_skewed`, by the convolution of D_h with the noise.
/// Domain: deviation log in [0.1, 0.5], skewness in [0, 0.8624], noise_deviation in [0, 0.5].
/// Error: 2e-2 relative; as `height_skewed`, for what noise leaves of a skewness up to 0.8624.
fn perturbed_tails(deviation: f32, skewness: f32, noise_deviation: f32) -> height_tails {
    let tails = height_skewed(deviation, skewness);
    let part = clamp(noise_deviation * tails.rate, 0.0, 1.0) * clamp(skewness, 0.0, 0.87);
    let off = min(part * part, 0.08);
    let high = tails.high + off * vec4f(0.2643012, 0.16769826, -0.22031983, 0.02010427);
    let low = tails.low + off * vec4f(0.07099437, -0.15442243, -0.1466347, -0.13825196);
    return height_tails(tails.rate, tails.peak * (1.0 - 0.09412705 * off), high, low);
}
