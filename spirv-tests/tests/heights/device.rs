//! Question 2: moments, probabilities and sums with noise on the device against quadrature.

use prefilter::gpu::Device;
use prefilter::reference::heights::{cumulative, mean, moments, perturbed_cumulative, sum_moments};
use prefilter::reference::normal::{cumulative as normal_cumulative, surprisal};
use spirv_tests::kernel::Function;

use crate::lambdas;

type Outcome = Result<(), String>;

/// Runs a function of a text at points that are rounded as its parameters hold them.
pub fn run(text: &str, name: &str, points: &[Vec<f64>]) -> Result<Vec<Vec<f64>>, String> {
    let device = Device::new().map_err(|error| error.to_string())?;
    let results = Function::in_text(text, name)?.results(&device, &[], points)?;
    assert!(!points.is_empty() && results.len() == points.len());
    Ok(results)
}

/// A text whose function `asked` hands its parameters to a function of the shelf.
fn asks(parameters: &str, result: &str, call: &str) -> String {
    format!("fn asked({parameters}) -> {result} {{ return {call}; }}")
}

pub fn f32s(values: impl IntoIterator<Item = f64>) -> Vec<f64> {
    values.into_iter().map(|value| f64::from(value as f32)).collect()
}

/// The larger of two errors; a NaN is larger than everything.
pub fn worse(worst: f64, error: f64) -> f64 {
    if error.is_nan() {
        f64::INFINITY
    } else {
        worst.max(error)
    }
}

/// The largest errors of mean, deviation and skewness by a function of the shelf.
fn moment_errors(name: &str, lambdas: impl Iterator<Item = f64>) -> Result<[f64; 3], String> {
    let points: Vec<Vec<f64>> = lambdas.map(|lambda| f32s([lambda])).collect();
    let got = run(&asks("lambda: f32", "vec3f", &format!("{name}(lambda)")), "asked", &points)?;
    let mut worst = [0.0; 3];
    for (point, got) in points.iter().zip(&got) {
        for ((worst, got), truth) in worst.iter_mut().zip(got).zip(moments(point[0])) {
            *worst = worse(*worst, (got - truth).abs());
        }
    }
    println!("{name}: mean {:.2e}, deviation {:.2e}, skewness {:.2e}", worst[0], worst[1], worst[2]);
    Ok(worst)
}

#[test]
fn moments_keep_their_figures() -> Outcome {
    for (name, figure, skewed) in [("heights_moments", 7e-5, 1.6e-3), ("heights_moments_fast", 9.5e-4, 1.9e-3)] {
        let worst = moment_errors(name, [0.0].into_iter().chain(lambdas(1e-6, 1e4, 20_001)))?;
        assert!(worst[0] <= figure && worst[1] <= figure && worst[2] <= skewed, "{name}: {worst:?}");
    }
    let far = moment_errors("heights_moments_fast", lambdas(1e4, 1e6, 2001))?;
    assert!(far[0] <= 9.5e-4 && far[1] <= 9.5e-4 && far[2] <= 2.2e-2, "{far:?}");
    Ok(())
}

#[test]
fn moments_end_where_their_domains_do() -> Outcome {
    for (name, end) in [("heights_moments", 1e4), ("heights_moments_fast", 1e6)] {
        let asked = asks("lambda: f32", "vec3f", &format!("{name}(lambda)"));
        let got = run(&asked, "asked", &[end, 2.0 * end, 1e30, 0.0, -1.0, -1e30].map(|lambda| vec![lambda]))?;
        assert!(got[1] == got[0] && got[2] == got[0], "{name}: {got:?}");
        assert!(got[3..].iter().all(|got| got[..] == [0.0, 1.0, 0.0]), "{name}: {got:?}");
    }
    Ok(())
}

#[test]
fn probabilities_keep_their_figure_at_any_height() -> Outcome {
    let far = [-1e30, -1e9, -50.0, -20.0, 9.0, 14.0, 50.0, 1e30];
    let heights: Vec<f64> = (-900..=900).map(|index| 1e-2 * f64::from(index) + 3e-3).chain(far).collect();
    let points: Vec<Vec<f64>> = [0.0]
        .into_iter()
        .chain(lambdas(1e-5, 1e6, 89))
        .flat_map(|lambda| heights.iter().map(move |&height| f32s([height, lambda])).collect::<Vec<_>>())
        .collect();
    let got = run(&asks("height: f32, lambda: f32", "f32", "heights_cdf(height, lambda)"), "asked", &points)?;
    let error = |(point, got): (&Vec<f64>, &Vec<f64>)| (got[0] - cumulative(point[0], point[1])).abs();
    let worst = points.iter().zip(&got).map(error).fold(0.0, worse);
    println!("heights_cdf: {worst:.2e}");
    assert!(worst <= 1e-6, "{worst}");
    assert!(got.iter().all(|got| (0.0..=1.0).contains(&got[0])));
    // What a power of the cumulative function loses, even one with an error of 2e-7.
    let naive = asks("height: f32, lambda: f32", "f32", "pow(max(normal_cdf(height), 1e-30), 1.0 + lambda)");
    let naive = run(&naive, "asked", &points)?;
    let lost = points.iter().zip(&naive).map(error).fold(0.0, worse);
    println!("a power of normal_cdf: {lost:.2e}");
    assert!(lost > 2e-2, "{lost}");
    Ok(())
}

#[test]
fn surprisals_keep_their_digits() -> Outcome {
    let points: Vec<Vec<f64>> = (-60_000..60_000).map(|index| f32s([1e-4 * (f64::from(index) + 0.37)])).collect();
    let got = run(&asks("x: f32", "f32", "normal_surprisal(x)"), "asked", &points)?;
    let error = |(point, got): (&Vec<f64>, &Vec<f64>)| (got[0] / surprisal(point[0]) - 1.0).abs();
    let worst = points.iter().zip(&got).map(error).fold(0.0, worse);
    println!("normal_surprisal within 6 deviations: {worst:.2e} relative");
    // The notes have 2.1e-6 of an exp2 that rounds correctly; the driver's is off by 3 units in the last place.
    assert!(worst <= 2.3e-6, "{worst}");
    Ok(())
}

#[test]
fn powers_are_those_of_the_quadrature() -> Outcome {
    let points: Vec<Vec<f64>> = [0.0]
        .into_iter()
        .chain(lambdas(1e-3, 1e6, 40))
        .flat_map(|lambda| [1.0, 2.0, 3.0, 8.5].map(|power| f32s([power, lambda])))
        .collect();
    let got = run(&asks("power: f32, lambda: f32", "f32", "heights_power(power, lambda)"), "asked", &points)?;
    for (point, got) in points.iter().zip(&got) {
        let [truth] = mean(point[1], |height| [normal_cumulative(height).powf(point[0])]);
        assert!((got[0] - truth).abs() <= 2e-7, "{point:?}: {got:?} {truth}");
    }
    Ok(())
}

/// The largest error of a step when heights with noise are taken for normal with the perturbed mean and deviation.
///
/// Source: numerics/height.md, section 3.3: Λ, the noise's deviation, the error.
const NORMAL: [[f64; 3]; 8] = [
    [1.0, 0.25, 8.2e-3],
    [1.0, 0.5, 5.8e-3],
    [1.0, 1.0, 2.4e-3],
    [10.0, 0.25, 2.2e-2],
    [10.0, 1.0, 3.5e-3],
    [100.0, 0.1, 4.0e-2],
    [100.0, 0.5, 1.2e-2],
    [1e4, 0.1, 4.8e-2],
];

#[test]
fn perturbed_heights_have_the_cumulants_of_the_convolution() -> Outcome {
    let parameters = "lambda: f32, mean: f32, deviation: f32, noise_mean: f32, noise_deviation: f32";
    let call = "heights_perturbed(heights_moments(lambda), mean, deviation, noise_mean, noise_deviation)";
    let mut points: Vec<Vec<f64>> =
        NORMAL.iter().map(|&[lambda, noise, _]| f32s([lambda, 0.0, 1.0, 0.0, noise])).collect();
    for lambda in lambdas(1e-2, 1e4, 60) {
        let placed = [[0.3, 0.8, -0.2, 0.4], [-1.1, 0.05, 0.7, 0.02], [0.0, 2.0, 0.1, 0.0]];
        points.extend(placed.map(|[a, b, c, d]| f32s([lambda, a, b, c, d])));
    }
    let got = run(&asks(parameters, "vec3f", call), "asked", &points)?;
    for (point, got) in points.iter().zip(&got) {
        let [mean, deviation, skewness, _] = moments(point[0]);
        let truth = sum_moments([point[1] + point[2] * mean, point[2] * deviation, skewness], [point[3], point[4]]);
        // The moments' own errors, scaled, and rounding.
        for ((got, truth), bound) in got.iter().zip(truth).zip([7e-5 * point[2] + 1e-6, 7e-5 * point[2] + 1e-6, 2e-3]) {
            assert!((got - truth).abs() <= bound, "{point:?}: {got} {truth}");
        }
    }
    for ([lambda, noise, known], got) in NORMAL.into_iter().zip(&got) {
        let error = |height: f64| {
            let below = normal_cumulative((height - got[0]) / got[1]);
            (below - perturbed_cumulative(height, lambda, noise)).abs()
        };
        let worst = (-300..=300).map(|index| error(got[0] + 1e-2 * f64::from(index))).fold(0.0, worse);
        println!("lambda {lambda}, noise {noise}: a step is off by {worst:.2e}");
        assert!((worst / known - 1.0).abs() < 0.05, "{lambda}, {noise}: {worst}");
    }
    Ok(())
}
