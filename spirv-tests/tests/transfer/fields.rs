//! Question 3: heights and slopes of sampled Gaussian fields under curves, against what modules say of them.

use prefilter::driver::transfer;
use prefilter::gpu::Device;
use prefilter::HeightTransfer;
use spirv_tests::gap::field::{Field, Spectrum};
use spirv_tests::kernel::Function;

use crate::Outcome;

/// Nodes a row, of which every third is taken, and the length over which the fields forget, in nodes.
const SIZE: usize = 1024;
const GRAIN: f64 = 12.0;
const EVERY: usize = 3;

/// The part of a node's distance to the next over which heights are told apart, along the tangent plane of the field:
/// values differ by less than a hundredth of their deviation over it, which is little against all that curves do.
const STEP: f64 = 1.0 / 64.0;

/// How far a covariance may be from that of the fields, in parts of its largest entry, and a variance of heights.
const FIGURE: f64 = 0.03;

/// A curve, and mean and deviation of the field under it.
type Case = (&'static str, HeightTransfer, [f64; 2]);

/// A linear map of the plane, which stretches and shears, and the slope of a plane under the field, in units of the
/// deviation of f a grain.
const MAP: [[f64; 2]; 2] = [[1.5, 0.4], [-0.2, 0.8]];
const TILT: [f64; 2] = [0.8, -0.5];

/// Samples: f, and its slopes along both coordinates.
fn samples(field: &Field, [mean, deviation]: [f64; 2]) -> Vec<[f64; 3]> {
    let at = |row: usize, column: usize| field.heights[row % SIZE * SIZE + column % SIZE];
    let places = (0..SIZE).step_by(EVERY).flat_map(|row| (0..SIZE).step_by(EVERY).map(move |column| (row, column)));
    let sample = |(row, column): (usize, usize)| {
        let x = 0.5 * deviation * (at(row, column + 1) - at(row, column + SIZE - 1));
        let y = 0.5 * deviation * (at(row + 1, column) - at(row + SIZE - 1, column));
        let slope = MAP.map(|[across, along]| across * x + along * y);
        [
            mean + deviation * at(row, column),
            slope[0] + TILT[0] * deviation / GRAIN,
            slope[1] + TILT[1] * deviation / GRAIN,
        ]
    };
    places.map(sample).collect()
}

/// Means of two components, and their covariance (xx, xy, yy).
fn statistics(slopes: impl Iterator<Item = [f64; 2]> + Clone) -> [f64; 5] {
    let count = slopes.clone().count() as f64;
    let mean = |of: &dyn Fn([f64; 2]) -> f64| slopes.clone().map(of).sum::<f64>() / count;
    let (x, y) = (mean(&|slope| slope[0]), mean(&|slope| slope[1]));
    let about = |slope: [f64; 2]| [slope[0] - x, slope[1] - y];
    let product = |one: usize, other: usize| mean(&|slope| about(slope)[one] * about(slope)[other]);
    [x, y, product(0, 0), product(0, 1), product(1, 1)]
}

/// Mean and variance of the height, and mean and covariance of its slopes, of one field under a curve.
fn sampled(curve: &HeightTransfer, samples: &[[f64; 3]]) -> [f64; 7] {
    let heights = samples.iter().map(|&[value, ..]| [curve.height(value), 0.0]);
    let slope = |value: f64, slope: f64| {
        (curve.height(value + STEP * slope) - curve.height(value - STEP * slope)) / (2.0 * STEP)
    };
    let slopes = samples.iter().map(|&[value, x, y]| [slope(value, x), slope(value, y)]);
    let ([mean, _, variance, ..], [x, y, xx, xy, yy]) = (statistics(heights), statistics(slopes));
    [mean, variance, x, y, xx, xy, yy]
}

#[test]
fn surfaces_are_those_of_sampled_fields() -> Outcome {
    let device = Device::new()?;
    let cases: [Case; 4] = [
        ("smoothstep(-1, 1)", HeightTransfer::smoothstep(-1.0, 1.0)?, [0.1, 1.0]),
        ("smoothstep(0, 1.2)", HeightTransfer::smoothstep(0.0, 1.2)?, [0.0, 1.0]),
        ("|f|", HeightTransfer::absolute(), [0.3, 0.7]),
        ("terraces(4, 0.5)", HeightTransfer::terraces(4, 0.5)?, [0.45, 0.3]),
    ];
    let fields: Vec<Field> = (1..=4).flat_map(|seed| Field::pair(Spectrum::Gaussian, SIZE, GRAIN, seed)).collect();
    for (name, curve, [mean, deviation]) in cases {
        let text = transfer::closed("judged", &curve).ok_or("the curve has pieces")?
            + "
fn judged_surface(mean: f32, deviation: f32, slope: vec2f, slope_covariance: vec3f) -> statistics_surface {
    return transfer_surface(judged_transferred(mean, deviation), slope, slope_covariance);
}
";
        let samples: Vec<_> = fields.iter().map(|field| samples(field, [mean, deviation])).collect();
        // What a driver would say of each field: its own mean slope and covariance.
        let point = |samples: &Vec<[f64; 3]>| {
            [mean, deviation].into_iter().chain(statistics(samples.iter().map(|&[_, x, y]| [x, y]))).collect()
        };
        let points: Vec<Vec<f64>> = samples.iter().map(point).collect();
        let results = Function::in_text(&text, "judged_surface")?.results(&device, &[], &points)?;
        let pairs: Vec<_> =
            samples.iter().zip(&results).map(|(samples, result)| (sampled(&curve, samples), result)).collect();
        // Mean and variance of h, then mean and covariance of the slopes, each in parts of what is largest of its kind.
        let errors = |(truth, found): &([f64; 7], &Vec<f64>)| -> [f64; 7] {
            let found = [0, 1, 4, 5, 6, 7, 8].map(|at| found[at]);
            let deviations = [truth[1].sqrt(), truth[4].max(truth[6]).sqrt()];
            let largest = truth[4].max(truth[6]);
            let units = [deviations[0], truth[1], deviations[1], deviations[1], largest, largest, largest];
            std::array::from_fn(|at| (found[at] - truth[at]) / units[at])
        };
        let errors: Vec<[f64; 7]> = pairs.iter().map(errors).collect();
        let count = errors.len() as f64;
        for (at, what) in ["mean", "variance", "slope x", "slope y", "xx", "xy", "yy"].into_iter().enumerate() {
            let mean = errors.iter().map(|error| error[at]).sum::<f64>() / count;
            let spread = errors.iter().map(|error| (error[at] - mean).powi(2)).sum::<f64>() / (count - 1.0);
            let standard = (spread / count).sqrt();
            println!("{name}: {what} {mean:+.4} ± {standard:.4}");
            assert!(mean.abs() <= FIGURE, "{name}: {what} is off by {mean}");
            assert!(standard <= FIGURE / 3.0, "{name}: {what} is known to {standard} only");
        }
    }
    Ok(())
}
