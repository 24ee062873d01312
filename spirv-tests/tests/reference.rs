//! Question 1: is the reference right? Printed tables, identities, a second quadrature. No device.

use prefilter::reference::normal::{cumulative, density, excess};
use prefilter::reference::quadrature::integrate;
use prefilter::reference::texture::{mean, mean_by_parts, PiecewiseLinear};

/// x, P(x), Z(x) of the standard normal distribution to 15 decimals.
///
/// Source: Abramowitz and Stegun 1964, "Handbook of Mathematical Functions", table 26.1.
const TABLE: [(f64, f64, f64); 7] = [
    (0.0, 0.500_000_000_000_000, 0.398_942_280_401_433),
    (0.5, 0.691_462_461_274_013, 0.352_065_326_764_300),
    (1.0, 0.841_344_746_068_543, 0.241_970_724_519_143),
    (1.5, 0.933_192_798_731_142, 0.129_517_595_665_892),
    (2.0, 0.977_249_868_051_821, 0.053_990_966_513_188),
    (2.5, 0.993_790_334_674_224, 0.017_528_300_493_569),
    (3.0, 0.998_650_101_968_370, 0.004_431_848_411_938),
];

#[test]
fn the_normal_distribution_is_the_printed_one() {
    for (x, below, z) in TABLE {
        assert!((cumulative(x) - below).abs() < 1e-15, "P({x}) = {:.15}", cumulative(x));
        assert!((density(x) - z).abs() < 1e-15, "Z({x}) = {:.15}", density(x));
        assert!((cumulative(-x) - (1.0 - below)).abs() < 1e-15, "P(−{x})");
    }
}

#[test]
fn the_cumulative_function_is_the_integral_of_the_density() {
    for x in [-7.3, -2.1, -0.4, 0.0, 0.9, 3.3, 8.0] {
        let [below] = integrate(-14.0, x, 0.5, |z| [density(z)]);
        assert!((below - cumulative(x)).abs() < 1e-14, "{x}: {below}");
    }
}

#[test]
fn the_excess_obeys_its_identity() {
    // E[max(z − t, 0)] = φ(t) − t Φ(−t), by parts.
    for t in [-9.0f64, -1.3, 0.0, 0.2, 1.0, 2.7, 6.0, 11.0] {
        let identity = density(t) - t * cumulative(-t);
        assert!((excess(t) - identity).abs() < 1e-14 * t.abs().max(1.0), "{t}: {} and {identity}", excess(t));
    }
}

#[test]
fn quadrature_is_exact_for_high_powers_and_empty_for_empty_intervals() {
    let [high] = integrate(-1.0, 2.0, 3.0, |x| [x.powi(31)]);
    assert!((high / ((2f64.powi(32) - 1.0) / 32.0) - 1.0).abs() < 1e-13, "{high}");
    assert_eq!(integrate(1.0, 1.0, 1.0, |_| [1.0]), [0.0]);
    assert_eq!(integrate(2.0, 1.0, 1.0, |_| [1.0]), [0.0]);
    // Panels without a width come to an end.
    for width in [0.0, -1.0, f64::MIN_POSITIVE, f64::NAN] {
        let [square] = integrate(0.0, 1.0, width, |x| [3.0 * x * x]);
        assert!((square - 1.0).abs() < 1e-9, "{width}: {square}");
    }
}

fn gray(knots: &[(f64, f64, f64)]) -> PiecewiseLinear {
    let color = |value: f64| [value, 1.0 - value, 0.5 * value, 1.0];
    PiecewiseLinear { knots: knots.iter().map(|&(at, left, right)| (at, color(left), color(right))).collect() }
}

/// Hard cases: ramps and stripes far narrower and wider than the deviation, jumps, a single knot, far knots.
fn maps() -> Vec<PiecewiseLinear> {
    let stairs = (0..17).map(|step| (f64::from(step) / 16.0, f64::from(step) / 17.0, f64::from(step + 1) / 17.0));
    vec![
        gray(&[(0.3, 0.2, 0.9)]),
        gray(&[(0.0, 0.1, 0.1), (1.0, 0.8, 0.8)]),
        gray(&[(0.4, 0.0, 0.0), (0.40001, 1.0, 1.0)]),
        gray(&[(0.4, 0.0, 1.0), (0.400_001, 1.0, 0.0)]),
        gray(&[(0.1, 0.5, 0.3), (0.2, 0.9, 0.0), (0.2001, 1.0, 1.0), (0.7, 0.1, 0.6)]),
        gray(&[(-40.0, 0.0, 0.0), (60.0, 1.0, 0.0)]),
        gray(&stairs.collect::<Vec<_>>()),
    ]
}

#[test]
fn two_quadratures_agree() {
    let mut cases = 0;
    for map in maps() {
        for deviation in [1e-6, 1e-5, 3e-4, 0.01, 0.07, 0.5, 4.0] {
            for center in [-0.6, 0.0, 0.199_99, 0.2, 0.3, 0.400_004, 0.47, 1.0, 1.4] {
                let (one, other) = (mean(&map, center, deviation), mean_by_parts(&map, center, deviation));
                for (one, other) in one.into_iter().zip(other) {
                    assert!((one - other).abs() < 1e-12, "{center}, {deviation}: {one} and {other} of {map:?}");
                    cases += 1;
                }
            }
        }
    }
    assert_eq!(cases, 7 * 7 * 9 * 4);
}

#[test]
fn means_obey_the_invariants_of_means() {
    for map in maps() {
        // A deviation of zero gives the value, and small ones approach it away from jumps.
        assert_eq!(mean(&map, 0.55, 0.0), map.value(0.55));
        for (near, value) in mean(&map, 0.551, 1e-7).into_iter().zip(map.value(0.551)) {
            assert!((near - value).abs() < 1e-6, "{near} and {value} of {map:?}");
        }
        // The mean of a mean is the mean over the sum of the variances.
        let (first, second) = (0.03, 0.04);
        let twice: [f64; 4] = integrate(-0.5, 0.5, 0.04, |offset| {
            let weight = density(offset / first) / first;
            mean(&map, 0.37 + offset, second).map(|value| weight * value)
        });
        for (twice, once) in twice.into_iter().zip(mean(&map, 0.37, 0.05)) {
            assert!((twice - once).abs() < 1e-11, "{twice} and {once} of {map:?}");
        }
    }
    let constant = gray(&[(0.2, 0.7, 0.7), (0.8, 0.7, 0.7)]);
    for (mean, value) in mean(&constant, 0.1, 0.3).into_iter().zip(constant.value(0.0)) {
        assert!((mean - value).abs() < 1e-14);
    }
}
