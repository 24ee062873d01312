//! Question 1: is the reference of visible slopes right? No device.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use prefilter::reference::normal::cumulative;
use prefilter::reference::quadrature::integrate;
use prefilter::reference::slopes::Visible;
use prefilter::reference::smith::Along;

use crate::{any, Random};

/// Mean and covariance by the two-dimensional quadrature.
fn moments(visible: &Visible) -> [f64; 5] {
    let mean = visible.average(|slope| slope);
    let [xx, xy, yy] = visible.average(|slope| {
        let [x, y] = [slope[0] - mean[0], slope[1] - mean[1]];
        [x * x, x * y, y * y]
    });
    [mean[0], mean[1], xx, xy, yy]
}

fn flat(([x, y], [xx, xy, yy]): ([f64; 2], [f64; 3])) -> [f64; 5] {
    [x, y, xx, xy, yy]
}

#[test]
fn two_quadratures_agree() {
    let mut random = Random::new(1);
    let (mut below, mut worst) = (0, 0.0f64);
    for _ in 0..1500 {
        let visible = any(&mut random);
        let a = visible.parameter();
        if !(-12.0..1e3).contains(&a) {
            continue;
        }
        below += usize::from(a < 0.0);
        let scale = visible.covariance[0].max(visible.covariance[2]).sqrt();
        let (principal, along) = (moments(&visible), flat(visible.moments()));
        for ((one, other), power) in principal.into_iter().zip(along).zip([1, 1, 2, 2, 2]) {
            let error = (one - other).abs() / scale.powi(power);
            assert!(error < 1e-10, "{visible:?}, {a}: {principal:?} {along:?}");
            worst = worst.max(error);
        }
        let [third] = visible.average(|[x, y]| [(0.6 * (x - principal[0]) + 0.8 * (y - principal[1])).powi(3)]);
        let [mean, deviation, skewness] = visible.moments_along([0.6, 0.8]);
        assert!((mean - 0.6 * principal[0] - 0.8 * principal[1]).abs() < 1e-10 * scale);
        assert!((third - skewness * deviation.powi(3)).abs() < 1e-9 * scale.powi(3), "{visible:?}, {a}");
    }
    println!("largest difference {worst:.1e}, {below} below the horizon");
    assert!(below > 100, "{below}");
}

#[test]
fn along_the_normal_all_slopes_are_visible() {
    let visible = Visible { view: [0.0, 0.0, 1.0], covariance: [0.36, -0.1, 0.09], mean: [0.3, -0.7] };
    for found in [moments(&visible), flat(visible.moments())] {
        for (found, all) in found.into_iter().zip([0.3, -0.7, 0.36, -0.1, 0.09]) {
            assert!((found - all).abs() < 1e-13, "{found} {all}");
        }
    }
    assert!((visible.area() - 1.0).abs() < 1e-13);
    assert!((visible.below([0.6, 0.8], 0.2) - cumulative(0.58 / 0.0912f64.sqrt())).abs() < 1e-13);
}

#[test]
fn at_the_horizon_slopes_along_the_view_have_the_distribution_of_rayleigh() {
    let visible = Visible { view: [0.0, -1.0, 0.0], covariance: [0.04, 0.0, 0.25], mean: [0.0; 2] };
    let found = moments(&visible);
    let rayleigh = [0.0, 0.5 * FRAC_PI_2.sqrt(), 0.04, 0.0, 0.25 * (2.0 - FRAC_PI_2)];
    for (found, closed) in found.into_iter().zip(rayleigh) {
        assert!((found - closed).abs() < 1e-13, "{found} {closed}");
    }
    let skewness = 2.0 * PI.sqrt() * (PI - 3.0) / (4.0 - PI).powf(1.5);
    assert!((visible.moments_along([0.0, 1.0])[2] - skewness).abs() < 1e-12);
    assert!(visible.moments_along([1.0, 0.0])[2].abs() < 1e-12);
    assert!((visible.area() - 0.5 / TAU.sqrt()).abs() < 1e-13);
    for slope in [0.1, 0.5, 1.3] {
        let below = 1.0 - (-0.5 * (slope / 0.5f64).powi(2)).exp();
        assert!((visible.below([0.0, 1.0], slope) - below).abs() < 1e-13, "{slope}");
    }
}

/// With Smith's masking 1/(1 + Λ) the seen area is that of the mean plane: the Jacobian belongs to the weight.
#[test]
fn the_area_is_that_of_the_mean_plane_over_the_masking() {
    let mut random = Random::new(2);
    let mut count = 0;
    for _ in 0..400 {
        let visible = Visible { mean: [0.0; 2], ..any(&mut random) };
        if visible.view[2] > 1e-3 {
            let lambda = Along::new(visible.view, visible.covariance, visible.mean).lambda();
            let plane = visible.view[2] * (1.0 + lambda);
            assert!((visible.area() / plane - 1.0).abs() < 1e-7, "{visible:?}: {} {plane}", visible.area());
            count += 1;
        }
    }
    assert!(count > 200, "{count}");
}

/// E[(s − s̄) t⁺] = Σ E[∇t⁺] for normal slopes: the mean moves by −Σ v.xy P(t > 0) / E[t⁺].
#[test]
fn the_mean_moves_against_the_view() {
    let mut random = Random::new(3);
    for _ in 0..200 {
        let visible = any(&mut random);
        let (a, [xx, xy, yy], [x, y, _]) = (visible.parameter(), visible.covariance, visible.view);
        if a > -8.0 {
            let share = cumulative(a) / visible.area();
            let moved = [-share * (xx * x + xy * y), -share * (xy * x + yy * y)];
            for (i, found) in visible.moments().0.into_iter().enumerate() {
                let closed = visible.mean[i] + moved[i];
                assert!((found - closed).abs() < 1e-9 * (1.0 + closed.abs()), "{visible:?}: {found} {closed}");
            }
        }
    }
}

/// The definition over directions n of normals, not over slopes: (n · v)⁺ p_s(s) / n.z⁴, of which 1/n.z³ turns solid
/// angles into slopes and 1/n.z the mean plane's area into the facet's. Without that one the mean is another.
#[test]
fn an_integral_over_normals_has_the_same_mean() {
    let visible = Visible { view: [0.48, -0.6, 0.64], covariance: [0.16, 0.03, 0.09], mean: [0.1, 0.2] };
    let [xx, xy, yy] = visible.covariance;
    let determinant = xx * yy - xy * xy;
    let sums = |power: i32| {
        let [whole, x, y] = integrate(0.0, FRAC_PI_2 - 1e-9, 0.01, |theta| {
            let (sin, cos) = theta.sin_cos();
            let steps = 720;
            let mut ring = [0.0; 3];
            for step in 0..steps {
                let azimuth = TAU * (f64::from(step) + 0.5) / f64::from(steps);
                let normal = [sin * azimuth.cos(), sin * azimuth.sin(), cos];
                let seen: f64 = normal.iter().zip(visible.view).map(|(n, v)| n * v).sum();
                let slope = [-normal[0] / cos, -normal[1] / cos];
                let [p, q] = [slope[0] - visible.mean[0], slope[1] - visible.mean[1]];
                let density = (-0.5 * (yy * p * p - 2.0 * xy * p * q + xx * q * q) / determinant).exp();
                let weight = seen.max(0.0) * density * cos.powi(-power) * sin;
                for (sum, value) in ring.iter_mut().zip([weight, weight * slope[0], weight * slope[1]]) {
                    *sum += value;
                }
            }
            ring
        });
        [x / whole, y / whole]
    };
    let (found, mean) = (sums(4), visible.moments().0);
    println!("over normals {found:?}, over slopes {mean:?}, without the facet's area {:?}", sums(3));
    assert!((found[0] - mean[0]).abs() < 2e-6 && (found[1] - mean[1]).abs() < 2e-6, "{found:?} {mean:?}");
    assert!((sums(3)[0] - mean[0]).abs() > 5e-3);
}

#[test]
fn a_plain_sum_over_a_grid_of_slopes_is_near() {
    let visible = Visible { view: [-0.768, 0.576, 0.28], covariance: [0.25, -0.15, 0.36], mean: [-0.2, 0.1] };
    let [xx, xy, yy] = visible.covariance;
    let determinant = xx * yy - xy * xy;
    let (mut sums, mut under) = ([0.0; 6], 0.0);
    for row in 0..1500 {
        for column in 0..1500 {
            let [x, y] = [row, column].map(|step| -6.0 + 12.0 * (f64::from(step) + 0.5) / 1500.0);
            let [p, q] = [x - visible.mean[0], y - visible.mean[1]];
            let density = (-0.5 * (yy * p * p - 2.0 * xy * p * q + xx * q * q) / determinant).exp();
            let seen = (visible.view[2] - visible.view[0] * x - visible.view[1] * y).max(0.0) * density;
            for (sum, value) in sums.iter_mut().zip([1.0, x, y, x * x, x * y, y * y]) {
                *sum += seen * value;
            }
            under += if 0.6 * x + 0.8 * y < 0.4 { seen } else { 0.0 };
        }
    }
    let [whole, x, y, xx, xy, yy] = sums;
    let [x, y, xx, xy, yy] = [x, y, xx, xy, yy].map(|sum| sum / whole);
    let (mean, covariance) = visible.moments();
    for (sum, exact) in [
        (x, mean[0]),
        (y, mean[1]),
        (xx - x * x, covariance[0]),
        (xy - x * y, covariance[1]),
        (yy - y * y, covariance[2]),
    ] {
        assert!((sum - exact).abs() < 1e-5, "{sum} {exact}");
    }
    let area = whole * (12.0f64 / 1500.0).powi(2) / (TAU * determinant.sqrt());
    assert!((area / visible.area() - 1.0).abs() < 1e-5);
    // Cells on the edge count whole.
    assert!((under / whole - visible.below([0.6, 0.8], 0.4)).abs() < 3e-4);
}

/// The mean of a component is the integral of its cumulative function, by parts.
#[test]
fn probabilities_have_the_moments() {
    let mut random = Random::new(4);
    for _ in 0..60 {
        let visible = any(&mut random);
        if visible.parameter() < -8.0 {
            continue;
        }
        let along = f64::atan2(visible.view[1], visible.view[0]);
        let angle = random.pick([0.0, 0.3, 1.0, FRAC_PI_2, 1e-4]) + along;
        let direction = [angle.cos(), angle.sin()];
        let [mean, deviation, _] = visible.moments_along(direction);
        let [from, to] = [mean - 14.0 * deviation, mean + 14.0 * deviation];
        let [area] = integrate(from, to, 0.05 * deviation, |at| [visible.below(direction, at)]);
        assert!((to - area - mean).abs() < 1e-7 * deviation, "{visible:?}, {angle}: {} {mean}", to - area);
    }
}
