//! Question 1: is the reference of the standard form right? No device.

use std::f64::consts::{FRAC_PI_2, PI};

use prefilter::reference::normal::{cumulative as normal_cumulative, excess};
use prefilter::reference::slopes::standard::{cumulative, moments, nearest_pair, weight};

/// The weight's logarithmic derivatives by its parameter are the mean, and the variance less 1.
#[test]
fn moments_are_derivatives_of_the_weight() {
    for a in [-9.0, -4.3, -1.0, 0.0, 0.7, 2.5, 6.0, 30.0] {
        let step = 2e-4;
        let [low, middle, high] = [-step, 0.0, step].map(|by| weight(a + by).ln());
        let [mean, variance, skewness] = moments(a);
        let slope = (high - low) / (2.0 * step);
        assert!((slope - mean).abs() < 1e-6 * (1.0 + mean.abs()), "{a}: {slope} {mean}");
        let bend = 1.0 + (high - 2.0 * middle + low) / (step * step);
        assert!((bend - variance).abs() < 3e-5, "{a}: {bend} {variance}");
        let third = (moments(a + step)[1] - moments(a - step)[1]) / (2.0 * step);
        assert!((third - skewness * variance.powf(1.5)).abs() < 1e-6, "{a}: {third}");
    }
}

#[test]
fn moments_have_their_limits() {
    let [mean, variance, skewness] = moments(0.0);
    assert!((mean - FRAC_PI_2.sqrt()).abs() < 1e-13 && (variance - 2.0 + FRAC_PI_2).abs() < 1e-13);
    assert!((skewness - 2.0 * PI.sqrt() * (PI - 3.0) / (4.0 - PI).powf(1.5)).abs() < 1e-12);
    // Nearly all weights are the same: the density turns by u/a.
    let [mean, variance, skewness] = moments(1e3);
    assert!((mean - 1e-3).abs() < 1e-12 && (variance - 1.0 + 1e-6).abs() < 1e-11 && (skewness - 2e-9).abs() < 1e-11);
    // Far below the horizon the gamma distribution with the shape 2 is left.
    let [mean, variance, skewness] = moments(-200.0);
    assert!((200.0 * (mean - 200.0) - 2.0).abs() < 2e-4, "{mean}");
    assert!((200f64.powi(2) * variance - 2.0).abs() < 1e-3 && (skewness - 2f64.sqrt()).abs() < 1e-3);
}

#[test]
fn the_weight_is_a_mean_excess() {
    for a in [-8.0, -3.0, 0.0, 1.5, 5.0] {
        assert!((weight(a) / excess(-a) - 1.0).abs() < 1e-12, "{a}");
    }
}

/// The largest error of a step by a pair of distributions.
fn error(a: f64, [low, low_variance, high, high_variance]: [f64; 4]) -> f64 {
    let [mean, variance, _] = moments(a);
    let edges: Vec<f64> = (-500..=700).map(|index| mean + 1e-2 * f64::from(index) * variance.sqrt()).collect();
    let side = |edge: f64, mean: f64, variance: f64| 0.5 * normal_cumulative((edge - mean) / variance.sqrt());
    let pair = |edge: f64| side(edge, low, low_variance) + side(edge, high, high_variance);
    edges.iter().zip(cumulative(a, &edges)).map(|(&edge, truth)| (pair(edge) - truth).abs()).fold(0.0, f64::max)
}

/// Parameters with the largest error of a step by a fitted pair, which the nearest one cannot exceed by definition.
///
/// Source: numerics/slope.md, section 3, whose last digit may be rounded down by a half.
const FITTED: [(f64, f64); 8] = [
    (-3.0, 0.0225),
    (-1.0, 0.0165),
    (0.0, 0.01185),
    (0.5, 0.00945),
    (1.0, 0.00695),
    (1.5, 0.00445),
    (2.0, 0.00275),
    (3.0, 0.00095),
];

#[test]
fn the_nearest_pair_has_the_moments_and_no_nearer_neighbor() {
    for (a, fitted) in FITTED {
        let [mean, variance, _] = moments(a);
        let pair = nearest_pair(a);
        let middle = 0.5 * (pair[0] + pair[2]);
        let second = 0.5 * (pair[1] + pair[3]) + 0.25 * (pair[2] - pair[0]).powi(2);
        assert!((middle - mean).abs() < 1e-12 && (second - variance).abs() < 1e-12, "{a}: {pair:?}");
        let least = error(a, pair);
        println!("{a}: {pair:.4?} has a largest error of {least:.5}");
        assert!(least < fitted && least > 0.75 * fitted, "{a}: {least}");
        // Neighbors with the same moments are farther off: the two move apart, or one widens for the other.
        let deviation = variance.sqrt();
        for [apart, wider] in [[0.02, 0.0], [-0.02, 0.0], [0.0, 0.02], [0.0, -0.02], [0.02, 0.02], [-0.02, -0.02]] {
            let half = 0.5 * (pair[2] - pair[0]) + apart * deviation;
            let (rest, share) = (variance - half * half, (pair[3] - pair[1]) / (pair[3] + pair[1]) + wider);
            let near = [mean - half, rest * (1.0 - share), mean + half, rest * (1.0 + share)];
            assert!(error(a, near) > least, "{a}: {near:?} is nearer than {pair:?}");
        }
    }
}
