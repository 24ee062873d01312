//! Moments of curves and of their slopes over normal values: what modules hold, against quadrature.

use prefilter::driver::transfer;
use prefilter::gpu::Device;
use prefilter::reference::piece::moments;
use prefilter::HeightTransfer;
use spirv_tests::fill::rounded;
use spirv_tests::kernel::Function;
use spirv_tests::random::Random;
use spirv_tests::signature::Scalar;

use crate::{curves, Outcome};

/// How far moments may be from those of the reference: means in the range of the curve or of its slope, variances in
/// the square of that.
const FIGURE: f64 = 1e-4;

/// Means from two spans below to two spans above a curve, half of them within it, and deviations from 1e-4 to 10 spans.
fn points([low, high]: [f64; 2], count: usize) -> Vec<Vec<f64>> {
    let mut random = Random::new(5);
    let span = high - low;
    let point = |index: usize| {
        let part = if index.is_multiple_of(2) { random.unit() } else { 5.0 * random.unit() - 2.0 };
        let point = [low + part * span, random.between(1e-4 * span, 10.0 * span)];
        point.map(|value| rounded(value, Scalar::Float)).to_vec()
    };
    (0..count).map(point).collect()
}

/// The range of a curve or of its slope, of one without bounds over the span and what the values reach.
fn range(of: impl Fn(f64, f64) -> (f64, f64), span: [f64; 2], point: &[f64]) -> f64 {
    let (low, high) = of(f64::NEG_INFINITY, f64::INFINITY);
    if (high - low).is_finite() {
        return high - low;
    }
    let (low, high) = of(span[0].min(point[0] - 5.0 * point[1]), span[1].max(point[0] + 5.0 * point[1]));
    high - low
}

/// The largest error of each moment in parts of the ranges.
fn errors(curve: &HeightTransfer, span: [f64; 2], points: &[Vec<f64>], results: &[Vec<f64>]) -> [f64; 4] {
    let bends = curve.bends();
    points.iter().zip(results).fold([0.0; 4], |worst: [f64; 4], (point, found)| {
        let truth = moments(&bends, |value| [curve.height(value), curve.slope(value)], point[0], point[1]);
        let height = range(|low, high| curve.range(low, high), span, point);
        let slope = range(|low, high| curve.slopes(low, high), span, point).max(1e-30);
        let units = [height, height * height, slope, slope * slope];
        std::array::from_fn(|at| {
            let error = (found[at] - truth[at]).abs() / units[at];
            if error.is_nan() {
                f64::INFINITY
            } else {
                worst[at].max(error)
            }
        })
    })
}

#[test]
fn closed_forms_are_the_moments_of_curves() -> Outcome {
    let device = Device::new()?;
    for (name, curve, span) in curves()? {
        let Some(text) = transfer::closed("judged", &curve) else {
            assert_eq!(name, "power");
            continue;
        };
        let points = points(span, 4000);
        let results = Function::in_text(&text, "judged_transferred")?.results(&device, &[], &points)?;
        let errors = errors(&curve, span, &points, &results);
        println!("{name}: {}", errors.map(|error| format!("{error:.1e}")).join(", "));
        assert!(errors.iter().all(|&error| error <= FIGURE), "{name}: {errors:?}\n{text}");
    }
    Ok(())
}
