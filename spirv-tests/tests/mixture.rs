//! Two normal distributions in place of one: the reference against its moments and a quadrature of its density, the
//! shelf on a device against the moments that it was given, and inputs that no distribution has.

use prefilter::gpu::Device;
use prefilter::reference::mixture::Pair;
use prefilter::reference::normal::density;
use prefilter::reference::quadrature::integrate;
use spirv_tests::any::number;
use spirv_tests::kernel::Function;
use spirv_tests::random::Random;

type Outcome = Result<(), String>;

/// Skewness and excess kurtosis of distributions: the excess kurtosis is that of two values and some more.
fn possible(count: usize) -> Vec<[f64; 2]> {
    let mut random = Random::new(11);
    let point = |_| {
        let skewness = 4.0 * random.unit() - 2.0;
        [skewness, skewness * skewness - 2.0 + random.between(0.01, 6.0)].map(|moment| f64::from(moment as f32))
    };
    (0..count).map(point).collect()
}

fn moments(result: &[f64]) -> [f64; 4] {
    let &[higher, lower, first, second, deviation] = result else { return [f64::NAN; 4] };
    Pair { offsets: [higher, lower], weights: [first, second], deviation }.moments()
}

fn run(points: &[Vec<f64>]) -> Result<Vec<Vec<f64>>, String> {
    let device = Device::new().map_err(|error| error.to_string())?;
    let text = "fn asked(skewness: f32, kurtosis: f32) -> mixture { return mixture_pair(skewness, kurtosis); }";
    let results = Function::in_text(text, "asked")?.results(&device, &[], points)?;
    assert!(!points.is_empty() && results.len() == points.len());
    Ok(results)
}

/// Against the moments asked for, and against the integrals of powers times the density.
#[test]
fn the_reference_has_the_moments_that_it_is_given() {
    for [skewness, kurtosis] in possible(60) {
        let pair = Pair::with(skewness, kurtosis);
        let [mean, variance, third, fourth] = pair.moments();
        let error = [mean, variance - 1.0, third - skewness, fourth - kurtosis].map(f64::abs);
        assert!(error.iter().all(|error| *error < 1e-7), "{skewness}, {kurtosis}: {error:?}");
        let reach = pair.offsets[0] - pair.offsets[1] + 12.0;
        let raw: [f64; 5] = integrate(-reach, reach, 2.0 * pair.deviation, |x| {
            let parts = [0, 1].map(|part| {
                let standard = (x - pair.offsets[part]) / pair.deviation;
                pair.weights[part] * density(standard) / pair.deviation
            });
            std::array::from_fn(|power| (parts[0] + parts[1]) * x.powi(power as i32))
        });
        let error = [raw[0] - 1.0, raw[1], raw[2] - 1.0, raw[3] - skewness, raw[4] - 3.0 - kurtosis].map(f64::abs);
        assert!(error.iter().all(|error| *error < 1e-6), "{skewness}, {kurtosis}: {error:?}");
    }
}

/// A value that is 1 with probability p and else 0 has skewness (1 − 2 p)/√(p (1 − p)) and excess kurtosis
/// (1 − 6 p (1 − p))/(p (1 − p)): the limit of two normal distributions that are infinitely narrow.
#[test]
fn two_values_are_two_narrow_distributions() {
    for p in [0.1, 0.35, 0.5, 0.8_f64] {
        let spread = (p * (1.0 - p)).sqrt();
        let pair = Pair::with((1.0 - 2.0 * p) / spread, (1.0 - 6.0 * p * (1.0 - p)) / (p * (1.0 - p)));
        assert!((pair.deviation - 0.001f64.sqrt()).abs() < 1e-9, "{pair:?}");
        let values = [(1.0 - p) / spread, -p / spread];
        assert!((0..2).all(|of| (pair.offsets[of] / values[of] - 1.0).abs() < 2e-3), "{pair:?} {values:?}");
        assert!((pair.weights[0] - p).abs() < 5e-4, "{pair:?} {p}");
    }
}

#[test]
fn a_device_returns_the_moments_that_it_is_given() -> Outcome {
    let points: Vec<Vec<f64>> = possible(20_000).into_iter().map(|point| point.to_vec()).collect();
    // Two that are 32 apart have an excess kurtosis of 32 times the skewness, less 2/32² of its square.
    let near = |point: &Vec<f64>| point[1] < 31.9 * point[0].abs();
    let points: Vec<Vec<f64>> = points.into_iter().filter(near).collect();
    let mut worst = [0.0_f64; 4];
    for (point, got) in points.iter().zip(run(&points)?) {
        let moments = moments(&got);
        let errors = [moments[0], moments[1] - 1.0, moments[2] - point[0], moments[3] - point[1]];
        // Rounding of an offset moves its nth power by n times that.
        let apart = got[0] - got[1];
        for (power, (worst, error)) in worst.iter_mut().zip(errors).enumerate() {
            let error = error.abs() / apart.max(1.0).powi(power as i32);
            *worst = if error.is_nan() { f64::INFINITY } else { worst.max(error) };
        }
    }
    println!("mean, variance, skewness, excess kurtosis, over powers of what is between the two: {worst:?}");
    assert!(worst.iter().all(|error| *error < 1e-6), "{worst:?}");
    Ok(())
}

/// Whatever the numbers, the two are finite, weigh 1 together and have a mean of 0 and a variance of 1.
#[test]
fn impossible_moments_leave_mean_and_variance() -> Outcome {
    let mut random = Random::new(5);
    let any = |_| {
        let numbers = [number(&mut random), number(&mut random)];
        numbers.map(|number| f64::from(number.clamp(f32::MIN, f32::MAX))).to_vec()
    };
    let given = [[0.0, 0.0], [3.0, -2.0], [-0.5, -1.9], [0.0, -5.0], [40.0, -1e9], [1e-4, 1e9]];
    let points: Vec<Vec<f64>> = given.iter().map(|point| point.to_vec()).chain((0..50_000).map(any)).collect();
    let results = run(&points)?;
    assert_eq!(results[0], [0.0, 0.0, 0.5, 0.5, 1.0]);
    for (point, got) in points.iter().zip(results) {
        assert!(got.iter().all(|number| number.is_finite()), "{point:?}: {got:?}");
        assert!((got[2] + got[3] - 1.0).abs() < 2e-7 && got[2] >= 0.0 && got[3] >= 0.0, "{point:?}: {got:?}");
        let [mean, variance, ..] = moments(&got);
        // Squares of offsets beyond 1e3 times weights are below what is left of 1.
        let apart = got[0] - got[1];
        assert!(mean.abs() < 1e-6 * apart.max(1.0), "{point:?}: {got:?}");
        assert!(apart > 1e3 || (variance - 1.0).abs() < 1e-5, "{point:?}: {got:?} {variance}");
    }
    Ok(())
}
