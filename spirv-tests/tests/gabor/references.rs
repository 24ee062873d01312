//! Is the reference right? Integrals by quadrature over the footprint and over space, and Dawson's function.

use std::f64::consts::{PI, TAU};

use prefilter::reference::gabor::power;
use prefilter::reference::gabor_kernel::{convolved, kernel, Wave, BANDWIDTH};
use prefilter::reference::gabor_spectrum::{retained, retained_evenly};
use prefilter::reference::quadrature::integrate;
use spirv_tests::random::Random;

use crate::{place, plane};

fn wave(random: &mut Random, phase: f64) -> Wave {
    Wave { bandwidth: BANDWIDTH, frequency: place(random, 1.2), phase }
}

#[test]
fn filtered_kernels_are_means_over_the_footprint() {
    let mut random = Random::new(3);
    for _ in 0..60 {
        let wave = wave(&mut random, 5.0);
        let long = random.between(0.02, 1.5);
        let footprint = plane(&mut random, [long, long * 0.3]);
        let apart = place(&mut random, 1.0);
        let weight = |u: f64| libm::exp(-0.5 * u * u) / TAU.sqrt();
        let [mean] = integrate(-8.0, 8.0, 1.0, |u| {
            let [row] = integrate(-8.0, 8.0, 1.0, |v| {
                let at = [0, 1, 2].map(|axis| apart[axis] + u * footprint[0][axis] + v * footprint[1][axis]);
                [weight(v) * kernel(&wave, at)]
            });
            [weight(u) * row]
        });
        let found = convolved(&wave, apart, footprint);
        assert!((found - mean).abs() < 1e-10, "{wave:?} {footprint:?}: {found} is not {mean}");
    }
}

/// The mean square of a filtered kernel over all places and phases, over that of the kernel itself.
#[test]
fn what_is_left_is_the_mean_square_of_filtered_kernels() {
    let mut random = Random::new(4);
    for long in [0.1, 0.3, 0.6] {
        let (frequency, footprint) = (place(&mut random, 1.2), plane(&mut random, [long, long * 0.4]));
        let square = |apart: [f64; 3]| {
            let waves = [0.0, 0.5 * PI].map(|phase| Wave { bandwidth: BANDWIDTH, frequency, phase });
            0.5 * waves.iter().map(|wave| convolved(wave, apart, footprint).powi(2)).sum::<f64>()
        };
        // A Gaussian of a deviation of 0.28 and more: the trapezoidal rule has converged at steps of 0.2.
        let steps = || (-30..=30).map(|step| 0.2 * f64::from(step));
        let total: f64 =
            steps().flat_map(|x| steps().flat_map(move |y| steps().map(move |z| [x, y, z]))).map(square).sum();
        let expected = total * 0.2f64.powi(3) / power();
        let [found, _] = retained(frequency, footprint);
        assert!((found - expected).abs() < 1e-9, "{long}: {found} is not {expected}");
    }
}

/// Round footprints leave D(x)/x / (1 + 2π a² σ²), x² = 4π² σ² f²/(1 + 2π a² σ²), and lines √π erf(x)/(2x) for D(x)/x.
#[test]
fn round_footprints_leave_what_dawson_says() {
    for (length, deviation) in [(0.3, 0.2), (1.3, 0.1), (1.3, 0.4), (2.0, 1.0)] {
        let grown = 1.0 + TAU * (BANDWIDTH * deviation).powi(2);
        let x = TAU * deviation * length / grown.sqrt();
        let [dawson] = integrate(0.0, x, 0.25, |t| [libm::exp(t * t - x * x)]);
        let cases = [(deviation, dawson / x / grown), (0.0, PI.sqrt() * libm::erf(x) / (2.0 * x) / grown.sqrt())];
        for (other, expected) in cases {
            let [found, _] = retained_evenly(length, [[0.0, 0.6 * deviation, 0.8 * deviation], [other, 0.0, 0.0]]);
            assert!((found - expected).abs() < 1e-9, "{length} {deviation} {other}: {found} is not {expected}");
        }
    }
}
