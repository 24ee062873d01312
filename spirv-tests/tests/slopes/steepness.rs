//! Lengths of visible slopes: the reference against plain sums and against itself, no device.

use std::f64::consts::TAU;

use prefilter::reference::quadrature::integrate;
use prefilter::reference::slopes::Visible;
use prefilter::reference::steepness::{below, mean, moments, rice_density, rice_mean};
use prefilter::reference::texture::PiecewiseLinear;

use crate::{any, Random};

/// The probability of lengths below one by rings about the slope 0, which the other method never sees.
fn by_rings(visible: &Visible, length: f64) -> f64 {
    let [xx, xy, yy] = visible.covariance;
    let determinant = xx * yy - xy * xy;
    let ring = |radius: f64| {
        let steps = 2048;
        let density = |step: i32| {
            let (sin, cos) = (TAU * f64::from(step) / f64::from(steps)).sin_cos();
            let [x, y] = [radius * cos, radius * sin];
            let [p, q] = [x - visible.mean[0], y - visible.mean[1]];
            let seen = (visible.view[2] - visible.view[0] * x - visible.view[1] * y).max(0.0);
            seen * (-0.5 * (yy * p * p - 2.0 * xy * p * q + xx * q * q) / determinant).exp()
        };
        radius * (0..steps).map(density).sum::<f64>() * TAU / f64::from(steps)
    };
    let [sum] = integrate(0.0, length, 0.03, |radius| [ring(radius)]);
    sum / (visible.area() * TAU * determinant.sqrt())
}

fn views(seed: u32, count: usize) -> Vec<Visible> {
    let mut random = Random::new(seed);
    let wide = |visible: &Visible| {
        let [xx, xy, yy] = visible.covariance;
        visible.parameter() > -4.0 && xx * yy - xy * xy > 0.02 * (xx + yy) && xx.min(yy) > 0.03
    };
    std::iter::repeat_with(|| any(&mut random)).filter(wide).take(count).collect()
}

#[test]
fn rings_and_lines_agree() {
    let mut worst = 0.0f64;
    for visible in views(91, 20) {
        for length in [0.05, 0.3, 0.8, 2.0] {
            let [lines, rings] = [below(&visible, length), by_rings(&visible, length)];
            assert!((lines - rings).abs() < 2e-6, "{visible:?}, {length}: {lines} {rings}");
            worst = worst.max((lines - rings).abs());
        }
    }
    println!("largest difference {worst:.1e}");
}

/// E[|s|²] is the integral of 2 r (1 − P(|s| < r)), E[|s|⁴] that of 4 r³ (1 − P).
#[test]
fn probabilities_have_the_moments_of_squares() {
    for visible in views(92, 12) {
        let [first, part] = moments(&visible);
        let [square, fourth] = integrate(0.0, 20.0 * first.sqrt(), 0.1 * first.sqrt(), |r| {
            let rest = 1.0 - below(&visible, r);
            [2.0 * r * rest, 4.0 * r.powi(3) * rest]
        });
        let found = fourth / (square * square) - 1.0;
        assert!((square / first - 1.0).abs() < 1e-7 && (found - part).abs() < 1e-6, "{visible:?}: {found} {part}");
    }
}

/// Along the normal, where all slopes are visible, a round covariance gives the distribution of Rice.
#[test]
fn along_the_normal_lengths_are_those_of_rice() {
    let (black, white) = ([0.0, 0.3, 1.0, 1.0], [1.0, 0.4, 0.0, 1.0]);
    let knots = vec![(0.1, black, black), (0.3, white, black), (0.6, black, white), (0.9, black, black)];
    let map = PiecewiseLinear { knots };
    for (center, deviation) in [(0.0, 0.2), (0.25, 0.05), (0.5, 0.4), (0.9, 1.0), (1.1, 0.01), (0.02, 0.3)] {
        let variance = deviation * deviation;
        let mean_slope = [0.6 * center, -0.8 * center];
        let visible = Visible { view: [0.0, 0.0, 1.0], covariance: [variance, 0.0, variance], mean: mean_slope };
        let (found, rice) = (mean(&map, &visible), rice_mean(&map, center, deviation));
        for channel in 0..4 {
            let apart = (found[channel] - rice[channel]).abs();
            assert!(apart < 1e-8, "{center}, {deviation}: {found:?} {rice:?}");
        }
    }
}

/// Without a center it is the distribution of Rayleigh, with one far away a normal distribution.
#[test]
fn the_density_of_rice_has_its_limits() {
    for length in [0.01, 0.3, 1.0, 2.0] {
        let rayleigh = length / 0.25 * (-0.5 * length * length / 0.25f64).exp();
        assert!((rice_density(length, 0.0, 0.5) - rayleigh).abs() < 1e-13, "{length}");
    }
    let normal = (-0.5f64 * 0.25).exp() / (TAU.sqrt() * 1e-4);
    assert!((rice_density(1.0 + 0.5e-4, 1.0, 1e-4) / normal - 1.0).abs() < 1e-4);
}
