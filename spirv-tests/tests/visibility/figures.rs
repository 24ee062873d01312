//! Question 2: how far is the device's Λ from the integral, from parameters and from directions?

use std::f64::consts::PI;

use prefilter::reference::smith::{lambda, Along};
use prefilter::reference::visibility::{azimuth, independence, shadowing};

use crate::{direction, results, single, Random};

const POINTS: u32 = 200_000;

const FROM_DIRECTIONS: &str = "
fn judged(direction: vec3f, covariance: vec3f, mean_slope: vec2f) -> vec2f {
    let parameter = smith_parameter(direction, covariance, mean_slope);
    return vec2f(smith_lambda(parameter), smith_lambda_fast(parameter));
}";

/// Λ in the range of parameters that the shelf keeps.
fn kept(parameter: f64) -> f64 {
    lambda(parameter.clamp(5.4e-7, 10.0))
}

/// The largest |dΛ|/(1 + Λ) of the fine and of the fast grade.
fn worst(text: &str, points: &[Vec<f64>], parameter: impl Fn(&[f64]) -> f64) -> [f64; 2] {
    assert!(points.len() >= 1_000);
    let mut worst = [0.0f64; 2];
    for (point, got) in points.iter().zip(results(text, points)) {
        let truth = kept(parameter(point));
        for (worst, got) in worst.iter_mut().zip(got) {
            let error = (got - truth).abs() / (1.0 + truth);
            assert!(error.is_finite(), "{point:?}: {got} and {truth}");
            *worst = worst.max(error);
        }
    }
    worst
}

/// The parameter behind a point of [`FROM_DIRECTIONS`].
fn along(point: &[f64]) -> f64 {
    let &[x, y, z, xx, xy, yy, sx, sy] = point else { return f64::NAN };
    Along::new([x, y, z], [xx, xy, yy], [sx, sy]).parameter()
}

/// Directions of the upper half, a third of them within 1e-6 to 0.1 of the horizon.
fn upper(random: &mut Random) -> [f64; 3] {
    let (grazing, even) = (random.between(1e-6, 0.1), random.unit());
    direction(random.pick([grazing, even, even]), 2.0 * PI * random.unit())
}

/// A covariance with deviations in [0.05, 2] and the correlation.
fn covariance(random: &mut Random, correlation: f64) -> [f64; 3] {
    let [x, y] = [random.between(0.05, 2.0), random.between(0.05, 2.0)];
    single([x * x, correlation * x * y, y * y])
}

#[test]
fn lambda_from_parameters() {
    let text = "fn judged(parameter: f32) -> vec2f {
        return vec2f(smith_lambda(parameter), smith_lambda_fast(parameter));
    }";
    let mut random = Random::new(1);
    let mut values: Vec<f64> = (0..POINTS).map(|_| 10.0 * random.unit()).collect();
    values.extend((0..POINTS).map(|_| random.between(5.4e-7, 10.0)));
    values.sort_by(f64::total_cmp);
    let points: Vec<Vec<f64>> = values.into_iter().map(|value| single([value]).to_vec()).collect();
    let [fine, fast] = worst(text, &points, |point| point[0]);
    println!("|dΛ|/(1 + Λ) for a in [5.4e-7, 10]: fine {fine:.2e}, fast {fast:.2e}");
    assert!(fine <= 2e-6 && fast <= 1e-4);
    // Both fall with the parameter, up to rounding, and never below 0.
    for pair in results(text, &points).windows(2) {
        for (before, after) in pair[0].iter().zip(&pair[1]) {
            assert!(*after >= 0.0 && *after <= before * (1.0 + 1e-6) + 1e-8, "{pair:?}");
        }
    }
}

#[test]
fn lambda_from_directions() {
    let mut random = Random::new(2);
    let points = (0..POINTS).map(|_| {
        let correlation = 0.96 * (2.0 * random.unit() - 1.0);
        [&upper(&mut random)[..], &covariance(&mut random, correlation), &[0.0; 2]].concat()
    });
    let [fine, fast] = worst(FROM_DIRECTIONS, &points.collect::<Vec<_>>(), along);
    println!("|dΛ|/(1 + Λ) from directions, |ρ| ≤ 0.96: fine {fine:.2e}, fast {fast:.2e}");
    assert!(fine <= 1e-5 && fast <= 1e-4);
}

#[test]
fn lambda_from_nearly_singular_covariances() {
    let mut random = Random::new(4);
    for power in 1..=7 {
        let rest = 10f64.powi(-power);
        let mut storing = 0.0f64;
        let points = (0..POINTS / 4).map(|_| {
            let sign = random.pick([-1.0, 1.0]);
            let [x, y] = single([random.between(0.05, 2.0), random.between(0.05, 2.0)]);
            let exact = [x * x, sign * (1.0 - rest) * x * y, y * y];
            // Half of the directions lie along the ridges, where hardly any slope is left.
            let (near, anywhere) = (random.pick([-1.0, 1.0]) * random.between(1e-7, 1.0), 2.0 * PI * random.unit());
            let azimuth = random.pick([x.atan2(-sign * y) + near, anywhere]);
            let toward = direction(upper(&mut random)[2], azimuth);
            let stored = single(exact);
            let [truth, kept] = [exact, stored].map(|c| kept(Along::new(toward, c, [0.0; 2]).parameter()));
            storing = storing.max((kept - truth).abs() / (1.0 + truth));
            [&toward[..], &stored, &[0.0; 2]].concat()
        });
        let points: Vec<Vec<f64>> = points.collect();
        let [fine, _] = worst(FROM_DIRECTIONS, &points, along);
        println!("|dΛ|/(1 + Λ) for 1 − |ρ| = 1e-{power}: {fine:.2e}; f32 covariances alone cost {storing:.2e}");
        // What the documentation of `smith_parameter` says.
        assert!(fine <= (1.5e-7 / rest).max(2e-6), "{fine}");
        assert!(fine <= 4.0 * storing, "{fine}");
    }
}

#[test]
fn lambda_over_tilted_surfaces() {
    let mut random = Random::new(5);
    for least in [0.1, 1e-2, 1e-3] {
        let mut points = Vec::new();
        while points.len() < POINTS as usize / 4 {
            let mean_slope = single([2.0 * random.unit() - 1.0, 2.0 * random.unit() - 1.0]);
            let [x, y, z] = direction(2.0 * random.unit() - 1.0, 2.0 * PI * random.unit());
            let rise = z - x * mean_slope[0] - y * mean_slope[1];
            if rise > least && rise < 100.0 * least {
                let correlation = 0.9 * (2.0 * random.unit() - 1.0);
                points.push([&[x, y, z][..], &covariance(&mut random, correlation), &mean_slope].concat());
            }
        }
        let [fine, _] = worst(FROM_DIRECTIONS, &points, along);
        println!("|dΛ|/(1 + Λ) at least {least} above a tilted horizon: {fine:.2e}");
        // What the documentation of `smith_parameter` says.
        assert!(fine <= 1e-6 + 1e-7 / least, "{fine}");
    }
}

#[test]
fn shadowing_from_directions() {
    let text = "
fn judged(view: vec3f, light: vec3f, covariance: vec3f) -> vec4f {
    let a = vec2f(smith_parameter_level(view, covariance), smith_parameter_level(light, covariance));
    let fine = vec2f(smith_lambda(a.x), smith_lambda(a.y));
    let left = visibility_correlated(fine.x, fine.y, visibility_independence(view, light));
    let fast = visibility_shadowing(smith_lambda_fast(a.x), smith_lambda_fast(a.y));
    return vec4f(visibility_shadowing(fine.x, fine.y), visibility_shadowing(fine.x, left), fast, 0.0);
}";
    let mut random = Random::new(8);
    let points = (0..POINTS / 10).map(|_| {
        let correlation = 0.9 * (2.0 * random.unit() - 1.0);
        [upper(&mut random), upper(&mut random), covariance(&mut random, correlation)].concat()
    });
    let points: Vec<Vec<f64>> = points.collect();
    let mut worst = [0.0f64; 3];
    for (point, got) in points.iter().zip(results(text, &points)) {
        let [view, light, covariance] = [0, 3, 6].map(|at| [point[at], point[at + 1], point[at + 2]]);
        let [seen, lit] = [view, light].map(|toward| kept(Along::new(toward, covariance, [0.0; 2]).parameter()));
        let combined = seen.max(lit) + independence(azimuth(view, light)) * seen.min(lit);
        let (sum, correlated) = (shadowing(seen, lit), shadowing(seen, combined - seen));
        for ((worst, got), truth) in worst.iter_mut().zip(got).zip([sum, correlated, sum]) {
            assert!(got.is_finite(), "{point:?}");
            *worst = worst.max((got - truth).abs());
        }
    }
    println!("|dV̄| from directions: fine {:.2e}, with the hotspot {:.2e}, fast {:.2e}", worst[0], worst[1], worst[2]);
    assert!(worst[0] <= 5e-7 && worst[1] <= 8e-6 && worst[2] <= 1e-4, "{worst:?}");
}
