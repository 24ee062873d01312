//! The distribution of visible heights, D_h(h) = (1 + Λ) Φ(h)^Λ φ(h) for standard normal heights, where Λ is the sum of
//! Smith's Λ of the view and of the light: equation 15 of Heitz et al. 2014.

use super::normal::{density as normal_density, surprisal, REACH};
use super::quadrature::integrate;

/// Panels over the range of visible heights.
const PANELS: f64 = 16.0;

/// The density D_h of visible heights.
pub fn density(height: f64, lambda: f64) -> f64 {
    (1.0 + lambda) * (-lambda * surprisal(height) * std::f64::consts::LN_2).exp() * normal_density(height)
}

/// The probability that a visible height is below `height`: the integral of D_h, which is Φ^(1+Λ).
pub fn cumulative(height: f64, lambda: f64) -> f64 {
    (-(1.0 + lambda) * surprisal(height) * std::f64::consts::LN_2).exp()
}

/// Where visible heights lie, but for 1e-18 of them on each side; to 4e-4, which is all that panels need.
pub fn range(lambda: f64) -> [f64; 2] {
    let bits = [62.0, 1e-19].map(|bits| bits / (1.0 + lambda));
    bits.map(|bits| {
        let (mut low, mut high) = (-REACH, REACH);
        for _ in 0..16 {
            let middle = 0.5 * (low + high);
            if surprisal(middle) > bits {
                low = middle;
            } else {
                high = middle;
            }
        }
        0.5 * (low + high)
    })
}

/// The mean of a function over the visible heights, by quadrature of the function times the density.
pub fn mean<const N: usize>(lambda: f64, function: impl Fn(f64) -> [f64; N]) -> [f64; N] {
    let [from, to] = range(lambda);
    integrate(from, to, (to - from) / PANELS, |height| {
        let density = density(height, lambda);
        function(height).map(|value| density * value)
    })
}

/// Mean, deviation, skewness and excess kurtosis of the visible heights, by quadrature of the density. Error below
/// 1e-12 for Λ in [0, 1e6].
pub fn moments(lambda: f64) -> [f64; 4] {
    let [mean_height] = mean(lambda, |height| [height]);
    let [second, third, fourth] = mean(lambda, |height| {
        let z = height - mean_height;
        [z * z, z * z * z, z * z * z * z]
    });
    standardized(mean_height, second, third, fourth)
}

/// The same by parts: from the integrals of the cumulative function alone.
pub fn moments_by_parts(lambda: f64) -> [f64; 4] {
    let [from, to] = range(lambda);
    // E[(h − c)^k] = ∫ k (h − c)^(k−1) (1 − F) above c minus ∫ k (h − c)^(k−1) F below.
    let about = |center: f64| -> [f64; 4] {
        let areas = |from: f64, to: f64, share: fn(f64) -> f64| -> [f64; 4] {
            integrate(from, to, (to - from) / PANELS, |height| {
                let z = height - center;
                let share = share(-(1.0 + lambda) * surprisal(height) * std::f64::consts::LN_2);
                [1, 2, 3, 4].map(|power| f64::from(power) * z.powi(power - 1) * share)
            })
        };
        let (above, below) = (areas(center, to, |log| -log.exp_m1()), areas(from, center, f64::exp));
        std::array::from_fn(|index| above[index] - below[index])
    };
    let middle = 0.5 * (from + to);
    let mean_height = middle + about(middle)[0];
    let [_, second, third, fourth] = about(mean_height);
    standardized(mean_height, second, third, fourth)
}

fn standardized(mean: f64, second: f64, third: f64, fourth: f64) -> [f64; 4] {
    let deviation = second.sqrt();
    [mean, deviation, third / (second * deviation), fourth / (second * second) - 3.0]
}

/// The Λ whose visible heights have a skewness, which rises with Λ: by bisection over log₂(1 + Λ) up to 20.
pub fn lambda_of_skewness(skewness: f64) -> f64 {
    let (mut low, mut high) = (0.0, 20.0);
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        let [_, _, found, _] = moments(f64::exp2(middle) - 1.0);
        if found < skewness {
            low = middle;
        } else {
            high = middle;
        }
    }
    f64::exp2(0.5 * (low + high)) - 1.0
}

/// The probability that a visible height plus independent normal noise of mean 0 is below `height`: the convolution of
/// Φ^(1+Λ) with the noise's density.
pub fn perturbed_cumulative(height: f64, lambda: f64, noise_deviation: f64) -> f64 {
    let [below] = integrate(-9.0, 9.0, 0.5, |z| [normal_density(z) * cumulative(height - noise_deviation * z, lambda)]);
    below
}

/// Mean, deviation and skewness of the sum of two independent variables, one with the given mean, deviation and
/// skewness, one normal: by enumeration of a variable of two values and one of three that have these moments.
pub fn sum_moments(first: [f64; 3], normal: [f64; 2]) -> [f64; 3] {
    let [mean, deviation, skewness] = first;
    let root = (skewness * skewness + 4.0).sqrt();
    let values = [0.5 * (skewness + root), 0.5 * (skewness - root)];
    let two = [(values[0], -values[1] / root), (values[1], values[0] / root)];
    let three = [(0.0, 2.0 / 3.0), (3f64.sqrt(), 1.0 / 6.0), (-3f64.sqrt(), 1.0 / 6.0)];
    let outcomes = two.into_iter().flat_map(|(z, weight)| {
        three.map(|(r, share)| (mean + deviation * z + normal[0] + normal[1] * r, weight * share))
    });
    let outcomes: Vec<(f64, f64)> = outcomes.collect();
    let center: f64 = outcomes.iter().map(|(value, weight)| value * weight).sum();
    let central = |power| outcomes.iter().map(|(value, weight)| (value - center).powi(power) * weight).sum::<f64>();
    let [mean, deviation, skewness, _] = standardized(center, central(2), central(3), 0.0);
    [mean, deviation, skewness]
}
