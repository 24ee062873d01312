//! Question 1: is the reference right? No device.

use std::f64::consts::{LN_10, LN_2, PI};

use prefilter::reference::heights::{
    cumulative, density, lambda_of_skewness, mean, moments, moments_by_parts, perturbed_cumulative, range, sum_moments,
};
use prefilter::reference::normal::{cumulative as normal_cumulative, density as normal_density, surprisal};
use prefilter::reference::perturbed;
use prefilter::reference::quadrature::integrate;
use prefilter::reference::tails::{nearest_short_tails, nearest_tails};

/// Λ with mean, deviation, skewness and excess kurtosis of the visible heights.
///
/// Source: numerics/height.md, section 1, whose authors had them from a trapezoid rule in 64 bits and from 30 digits.
const MOMENTS: [[f64; 5]; 11] = [
    [0.0, 0.0, 1.0, 0.0, 0.0],
    [0.1, 0.084794820586930, 0.972290049365779, 0.01908, 0.00585],
    [0.3, 0.227466478350249, 0.926825349898797, 0.05242, 0.01818],
    [1.0, 0.564189583547756, 0.825645271176556, 0.13695, 0.06174],
    [3.0, 1.029375373003964, 0.701224098897593, 0.26452, 0.16232],
    [10.0, 1.586436351908, 0.577275880929524, 0.42335, 0.35016],
    [30.0, 2.056464097638194, 0.493636621208347, 0.54976, 0.55397],
    [100.0, 2.511148227515478, 0.428973177902047, 0.65602, 0.76690],
    [1e3, 3.241722761984568, 0.351336810040057, 0.78647, 1.08822],
    [1e4, 3.851640410707659, 0.304154552415220, 0.86247, 1.31092],
    [1e6, 4.862897684475567, 0.248004570370223, 0.94547, 1.58858],
];

#[test]
fn moments_are_the_printed_ones_by_both_methods() {
    for [lambda, printed @ ..] in MOMENTS {
        for found in [moments(lambda), moments_by_parts(lambda)] {
            for ((found, printed), digits) in found.iter().zip(printed).zip([2e-14, 2e-14, 6e-6, 6e-6]) {
                // Cancellation within a narrow distribution far from 0.
                assert!((found - printed).abs() < digits + 2e-14 * lambda.ln_1p(), "{lambda}: {found} {printed}");
            }
        }
    }
}

#[test]
fn moments_are_those_of_order_statistics() {
    // Visible heights at a whole Λ are the largest of 1 + Λ heights; up to three have closed means.
    let root = PI.sqrt();
    for (lambda, closed, deviation) in [
        (0.0, 0.0, 1.0),
        (1.0, 1.0 / root, (1.0 - 1.0 / PI).sqrt()),
        (2.0, 1.5 / root, (1.0 + (3f64.sqrt() - 4.5) / (2.0 * PI)).sqrt()),
    ] {
        let [mean, found, ..] = moments(lambda);
        assert!((mean - closed).abs() < 1e-14 && (found - deviation).abs() < 1e-14, "{lambda}: {mean} {found}");
    }
    // The slope at 0 is ∫ φ²/Φ.
    let [slope] = integrate(-12.0, 12.0, 0.5, |z| [normal_density(z).powi(2) / normal_cumulative(z)]);
    assert!((slope - 0.903_197_285_568_625_3).abs() < 1e-13, "{slope}");
    let [near, far] = [1e-4, 2e-4].map(|lambda| moments(lambda)[0]);
    assert!(((4.0 * near - far) / 2e-4 - slope).abs() < 1e-7);
}

#[test]
fn both_methods_agree_between_the_printed_values() {
    for lambda in crate::lambdas(1e-6, 1.1e6, 331) {
        for (one, other) in moments(lambda).into_iter().zip(moments_by_parts(lambda)) {
            assert!((one - other).abs() < 1e-12, "{lambda}: {one} {other}");
        }
    }
}

#[test]
fn probabilities_are_the_integral_of_the_density() {
    for lambda in [0.0, 0.017, 0.8, 5.3, 117.0, 2.3e4, 1e6] {
        let [from, to] = range(lambda);
        let [whole] = mean(lambda, |_| [1.0]);
        assert!((whole - 1.0).abs() < 1e-13, "{lambda}: {whole}");
        for part in [0.13, 0.31, 0.44, 0.58, 0.87] {
            let height = from + part * (to - from);
            let [below] = integrate(from, height, 0.1, |height| [density(height, lambda)]);
            let closed = cumulative(height, lambda);
            assert!((below - closed).abs() < 1e-12, "{height}, {lambda}: {below} {closed}");
        }
    }
    assert_eq!((cumulative(-1e300, 0.0), cumulative(1e300, 1e6)), (0.0, 1.0));
}

/// −log₁₀ Q(x) of the standard normal distribution.
///
/// Source: Abramowitz and Stegun 1964, "Handbook of Mathematical Functions", table 26.2.
const TAILS: [(f64, f64); 4] = [(5.0, 6.54265), (6.0, 9.00586), (8.0, 15.20614), (10.0, 23.11805)];

#[test]
fn the_surprisal_is_the_printed_one_and_the_integral_of_its_slope() {
    for (x, digits) in TAILS {
        assert!((surprisal(-x) * LN_2 / LN_10 - digits).abs() < 6e-6, "{x}");
    }
    // d(−ln Φ)/dx = −φ/Φ.
    for x in [-13.0, -6.2, -0.3, 0.0, 0.9, 3.7, 7.5, 12.0] {
        let [nats] = integrate(x, x + 30.0, 0.5, |z| [normal_density(z) / normal_cumulative(z)]);
        assert!((surprisal(x) * LN_2 / nats - 1.0).abs() < 1e-12, "{x}: {nats}");
    }
}

#[test]
fn means_of_powers_are_closed() {
    for lambda in [0.0, 0.3, 2.7, 41.0, 1.7e3, 1e6] {
        for power in [0.0, 0.5, 1.0, 3.0, 7.0, 16.0] {
            let [found] = mean(lambda, |height| [normal_cumulative(height).powf(power)]);
            let closed = (1.0 + lambda) / (1.0 + lambda + power);
            assert!((found - closed).abs() < 1e-12, "{lambda}, {power}: {found} {closed}");
        }
    }
}

/// Maps that are waves: the characteristic function of the visible heights, by the density and by parts.
#[test]
fn means_of_waves_agree() {
    for wave in [0.5, 1.0, 2.0, 4.0f64] {
        let both = |height: f64| [(wave * height).cos(), (wave * height).sin()];
        let [cosine, sine] = mean(0.0, both);
        // That of a normal distribution.
        assert!((cosine - (-0.5 * wave * wave).exp()).abs() < 1e-13 && sine.abs() < 1e-13, "{wave}: {cosine} {sine}");
        for lambda in [0.013, 0.7, 9.0, 160.0, 1e4] {
            let [from, to] = range(lambda);
            let below = integrate(from, to, 0.05, |height| {
                let share = wave * cumulative(height, lambda);
                [share * (wave * height).sin(), -share * (wave * height).cos()]
            });
            for (at, by_density) in mean(lambda, both).into_iter().enumerate() {
                let by_parts = both(to)[at] + below[at];
                assert!((by_density - by_parts).abs() < 1e-12, "{wave}, {lambda}: {by_density} {by_parts}");
            }
        }
    }
}

/// Mean, deviation and skewness of visible heights plus noise, from the convolution's probabilities by parts.
fn convolved(lambda: f64, noise: f64) -> [f64; 3] {
    let [from, to] = range(lambda).map(|end| end + 9.0 * noise * if end < moments(lambda)[0] { -1.0 } else { 1.0 });
    let about = |center: f64| -> [f64; 3] {
        let areas: [f64; 3] = integrate(from, to, 0.25, |height| {
            let (z, below) = (height - center, perturbed_cumulative(height, lambda, noise));
            [below, 2.0 * z * below, 3.0 * z * z * below]
        });
        std::array::from_fn(|index| (to - center).powi(index as i32 + 1) - areas[index])
    };
    let mean = about(0.0)[0];
    let [_, second, third] = about(mean);
    [mean, second.sqrt(), third / second.powf(1.5)]
}

#[test]
fn sums_with_noise_have_the_moments_of_the_convolution() {
    for lambda in [0.2, 3.0, 64.0, 1e4] {
        let [mean, deviation, skewness, _] = moments(lambda);
        for noise in [0.1, 0.5, 1.3] {
            let summed = sum_moments([mean, deviation, skewness], [0.0, noise]);
            for (summed, convolved) in summed.into_iter().zip(convolved(lambda, noise)) {
                assert!((summed - convolved).abs() < 1e-10, "{lambda}, {noise}: {summed} {convolved}");
            }
        }
    }
}

#[test]
fn skewness_gives_its_lambda() {
    for lambda in [0.0, 1e-3, 0.4, 6.0, 90.0, 1e4] {
        let [_, _, skewness, _] = moments(lambda);
        let found = lambda_of_skewness(skewness);
        assert!((found - lambda).abs() <= 1e-10 * (1.0 + lambda), "{lambda}: {found}");
    }
}

/// The tails' peak is the mean excess over the mean, and no polynomials are nearer in the mean square.
#[test]
fn the_nearest_tails_have_the_peak_and_no_nearer_neighbor() {
    for lambda in [1e-3, 0.4, 6.0, 90.0, 1e4] {
        let [center, own, ..] = moments(lambda);
        let tails = nearest_tails(2.5, lambda);
        let [_, end] = range(lambda);
        let excess = |x: f64| {
            let [excess] = integrate(center + own * x, end, 0.3 * own, |height| {
                [(height - center - own * x) * density(height, lambda)]
            });
            excess / own
        };
        assert!((tails[0] - 0.4).abs() < 1e-15 && (tails[1] / 2.5 - excess(0.0)).abs() < 1e-12, "{lambda}: {tails:?}");
        let short = nearest_short_tails(2.5, lambda);
        assert!(short[..2] == tails[..2], "{lambda}: {short:?} {tails:?}");
        let sides = [(1.0, &tails[2..6]), (-1.0, &tails[6..]), (1.0, &short[2..5]), (-1.0, &short[5..])];
        for (sign, own) in sides {
            let compared: Vec<(f64, f64)> =
                (1..=32).map(|at| 0.125 * f64::from(at)).map(|x| (x, excess(sign * x))).collect();
            let distance = |c: &[f64]| {
                let terms = compared.iter().map(|&(x, excess)| {
                    // Below the mean what falls short of the threshold is the excess less the distance.
                    let excess = if sign < 0.0 { excess - x } else { excess };
                    let bits = (tails[1] / 2.5 / excess).log2();
                    let polynomial = c.iter().rev().fold(0.0, |sum, coefficient| x * (coefficient + sum));
                    (excess * (bits - polynomial)).powi(2)
                });
                terms.filter(|term| term.is_finite()).sum::<f64>()
            };
            for at in 0..own.len() {
                for step in [1e-3, -1e-3] {
                    let mut near = own.to_vec();
                    near[at] += step;
                    assert!(distance(&near) > distance(own), "{lambda}: {near:?} is nearer than {own:?}");
                }
            }
        }
    }
}

/// Of a noise of no deviation the tails are those of the heights, of much noise those of normal heights.
#[test]
fn the_nearest_tails_follow_the_noise() {
    for lambda in [0.4, 90.0] {
        let (alone, without) = (nearest_tails(0.7, lambda), perturbed::nearest_tails(0.7, lambda, 0.0));
        let normal = nearest_tails(0.7, 0.0);
        let noisy = perturbed::nearest_tails(0.7, lambda, 3.0);
        for at in 0..10 {
            assert!((alone[at] - without[at]).abs() < 1e-6, "{lambda}: {alone:?} {without:?}");
            assert!((normal[at] - noisy[at]).abs() < 2e-3, "{lambda}: {normal:?} {noisy:?}");
        }
        assert!((alone[2] - normal[2]).abs() > 1e-2);
    }
}
