//! Question 1: is the reference right? No device.

use prefilter::reference::normal::cumulative;
use prefilter::reference::rounds::nearest;
use prefilter::reference::slopes::Visible;
use prefilter::SlopeDomain;
use spirv_tests::random::Random;

use crate::{edges, seen, turned, Outcome};

/// Over y given x, and along lines across a view along the normal, which turns them.
#[test]
fn two_orders_of_quadrature_agree() -> Outcome {
    let mut random = Random::new(11);
    let map = edges(12, SlopeDomain::Within(1.0), 0.4)?.reference();
    let mut worst = 0.0f64;
    for _ in 0..30 {
        let mean = [0, 1].map(|_| 3.0 * (random.unit() - 0.5));
        let covariance = turned(random.between(0.05, 0.7), random.between(1.0, 4.0), 6.3 * random.unit());
        let found = map.mean(mean, covariance);
        let whole = Visible { view: [0.0, 0.0, 1.0], covariance, mean };
        let swapped = [covariance[2], covariance[1], covariance[0]];
        let mut mirrored = map.clone();
        mirrored.colors = (0..144).map(|at| map.colors[at % 12 * 12 + at / 12]).collect();
        for other in [map.mean_visible(&whole), mirrored.mean([mean[1], mean[0]], swapped)] {
            for (one, other) in found.iter().zip(other) {
                assert!((one - other).abs() < 4e-5, "{mean:?} {covariance:?}: {one} {other}");
                worst = worst.max((one - other).abs());
            }
        }
    }
    println!("largest difference {worst:.1e}");
    Ok(())
}

/// By the two-dimensional quadrature of visible slopes, which hardly sees the bends of a map of wide cells.
#[test]
fn the_mean_is_that_over_all_visible_slopes() -> Outcome {
    let mut random = Random::new(12);
    let map = edges(5, SlopeDomain::Within(2.0), 1.1)?.reference();
    for _ in 0..20 {
        let visible = seen(&mut random, 0.4, 1.7, 0.5);
        let (plain, found) = (visible.average(|slope| map.value(slope)), map.mean_visible(&visible));
        for (plain, found) in plain.iter().zip(found) {
            assert!((plain - found).abs() < 1e-3, "{visible:?}: {plain} {found}");
        }
    }
    Ok(())
}

#[test]
fn values_are_bilinear_and_constant_beyond() -> Outcome {
    let map = edges(4, SlopeDomain::Within(1.0), 0.0)?.reference();
    // Nodes at ±0.25 and ±0.75: the half plane from x = 0.17, the disc of the four in the middle.
    assert_eq!(map.value([0.25, -9.0])[..3], [1.0, 0.0, 0.0]);
    assert_eq!(map.value([0.0, 0.25])[..3], [0.5, 1.0, 0.5]);
    assert_eq!(map.value([0.125, 0.5])[..3], [0.75, 0.5, 0.75]);
    assert_eq!(map.value([7.0, 0.5])[..3], [1.0, 0.0, 1.0]);
    assert_eq!(map.mean([0.125, 0.5], [0.0; 3])[..3], [0.75, 0.5, 0.75]);
    // A ramp between two nodes in the middle of a wide distribution is half seen.
    assert!((map.mean([0.0, 30.0], [1e-4, 0.0, 1e-4])[0] - 0.5).abs() < 1e-11);
    Ok(())
}

/// No sum near it has a smaller largest error of a step.
#[test]
fn sums_of_rounds_have_the_least_error() {
    let largest = |part: f64, [x, y, v, w]: [f64; 4]| {
        let below = |at: f64, place: f64| cumulative((at - place) / part);
        let error = |at: f64| {
            let pairs = v * (below(at, x) + below(at, -x)) + w * (below(at, y) + below(at, -y));
            ((1.0 - 2.0 * v - 2.0 * w) * below(at, 0.0) + pairs - cumulative(at)).abs()
        };
        (0..600).map(|place| error(0.01 * f64::from(place))).fold(0.0, f64::max)
    };
    let mut random = Random::new(13);
    let mut from = [0.807, 1.754, 0.246, 0.0885];
    for part in [0.3, 0.25, 0.2] {
        let best = nearest(part, from);
        from = best;
        let least = largest(part, best);
        println!("{part}: {best:?} errs by {least:.2e}");
        assert!(least < 0.022);
        for _ in 0..2000 {
            let near = best.map(|number| number * (1.0 + 0.05 * (random.unit() - 0.5)));
            let there = largest(part, near);
            assert!(there > least * (1.0 - 1e-3), "{part}: {near:?} errs by {there:.3e}");
        }
    }
}
