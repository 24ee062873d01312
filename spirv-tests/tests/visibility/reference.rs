//! Question 1: is the reference right? Two methods, identities, the definitions' limits. No device.

use std::f64::consts::{PI, SQRT_2};

use prefilter::reference::normal::cumulative;
use prefilter::reference::quadrature::integrate;
use prefilter::reference::smith::{lambda, lambda_by_parts, Along};
use prefilter::reference::visibility::{azimuth, independence, masking, shadowing};

use crate::{direction, Random};

/// Smith's Λ as Walter et al. 2007 write it, "Microfacet Models for Refraction through Rough Surfaces", section 5.2:
/// 1/G1 − 1 with the rational G1 below 1.6.
fn walter(a: f64) -> f64 {
    let g = if a < 1.6 { (3.535 * a + 2.181 * a * a) / (1.0 + 2.276 * a + 2.577 * a * a) } else { 1.0 };
    1.0 / g - 1.0
}

#[test]
fn two_methods_give_the_same_lambda() {
    for step in 0..=400 {
        let a = 5.4e-7 * (10.0 / 5.4e-7f64).powf(f64::from(step) / 400.0);
        let (one, other) = (lambda(a), lambda_by_parts(a));
        assert!((one - other).abs() < 1e-14 * (1.0 + one), "{a}: {one} and {other}");
        assert!(a > 4.0 || (one - other).abs() < 1e-12 * one, "{a}: {one} and {other}");
    }
    // Towards the horizon half of the slopes are steeper, by 1/√(2π) deviations in the mean.
    assert!((1e-9 * lambda(1e-9) * 2.0 * PI.sqrt() - 1.0).abs() < 1e-8);
}

#[test]
fn lambda_follows_its_differential_equation() {
    // By the definition d(aΛ)/da = −erfc(a)/2 = −Φ(−√2 a): no closed form of Λ takes part.
    for a in [0.01, 0.3, 1.0, 2.2, 3.7] {
        let step = 1e-4;
        let slope = ((a + step) * lambda(a + step) - (a - step) * lambda(a - step)) / (2.0 * step);
        assert!((slope + cumulative(-SQRT_2 * a)).abs() < 1e-8, "{a}: {slope}");
    }
}

#[test]
fn a_mean_slope_moves_the_slopes_and_the_direction_together() {
    let mut random = Random::new(3);
    let mut cases = 0;
    for _ in 0..2_000 {
        let toward = direction(random.unit(), 2.0 * PI * random.unit());
        let [x, y] = [random.between(0.1, 1.0), random.between(0.1, 1.0)];
        let covariance = [x * x, 0.9 * (2.0 * random.unit() - 1.0) * x * y, y * y];
        let mean_slope = [random.unit() - 0.5, random.unit() - 0.5];
        let along = Along::new(toward, covariance, mean_slope);
        let a = along.parameter();
        // The mean surface's normal is (−s, 1): the horizon is where a direction is across to it.
        let rise = toward[2] - mean_slope[0] * toward[0] - mean_slope[1] * toward[1];
        assert_eq!(a > 0.0, rise > 0.0, "{along:?}");
        if a > 1e-4 && a < 5.0 {
            assert!((along.lambda() - lambda(a)).abs() < 1e-9 * (1.0 + lambda(a)), "{along:?}");
            cases += 1;
        }
    }
    assert!(cases > 1_000, "{cases}");
}

#[test]
fn shares_are_those_of_the_paper() {
    for view in [0.0, 1e-3, 0.3, 1.0, 7.0, 150.0, 5.2e5] {
        assert!((masking(view) * (1.0 + view) - 1.0).abs() < 1e-12, "{view}: {}", masking(view));
        for light in [0.0, 0.02, 0.9, 3.0, 40.0, 5.2e5] {
            let (share, printed) = (shadowing(view, light), (1.0 + view) / (1.0 + view + light));
            assert!((share / printed - 1.0).abs() < 1e-12, "{view}, {light}: {share} and {printed}");
            assert!((share * masking(view) / masking(view + light) - 1.0).abs() < 1e-12);
        }
    }
}

#[test]
fn azimuths_are_angles_between() {
    for (one, other, angle) in [(0.3, 0.3, 0.0), (0.2, 1.0, 0.8), (3.0, -3.0, 2.0 * PI - 6.0), (-2.0, PI - 2.0, PI)] {
        let apart = azimuth(direction(0.4, one), direction(-0.2, other));
        assert!((apart - angle).abs() < 1e-6, "{one}, {other}: {apart}");
    }
    assert!((independence(PI) - 4.41 * PI / (4.41 * PI + 1.0)).abs() < 1e-15 && independence(0.0) == 0.0);
}

#[test]
fn the_second_integral_of_equation_twelve_needs_the_density() {
    // As printed, ∫ P^Λ dh, it grows with the range by 1 for each further deviation.
    let printed = |to: f64| integrate(-9.0, to, 0.5, |h| [cumulative(h).powf(0.7)])[0];
    assert!((printed(20.0) - printed(10.0) - 10.0).abs() < 1e-9);
}

#[test]
fn the_usual_rational_lights_more_than_there_is() {
    let negative = (0..10_000).map(|step| 1.5 + 1e-5 * f64::from(step)).filter(|&a| walter(a) < 0.0);
    let negative: Vec<f64> = negative.collect();
    assert!(negative.first().is_some_and(|&a| (1.54..1.56).contains(&a)) && negative.last() > Some(&1.599));
    for a in negative {
        assert!(1.0 / (1.0 + walter(a)) > 1.0 && 1.0 / (1.0 + lambda(a)) < 1.0, "{a}");
    }
}
