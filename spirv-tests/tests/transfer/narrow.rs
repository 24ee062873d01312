//! Heights over narrow footprints, by four values of f, against quadrature.

use prefilter::driver::transfer;
use prefilter::gpu::Device;
use prefilter::reference::piece::moments;
use prefilter::HeightTransfer;
use spirv_tests::fill::rounded;
use spirv_tests::kernel::Function;
use spirv_tests::random::Random;
use spirv_tests::signature::Scalar;

use crate::{curves, Outcome};

/// What the shelf says of mean and deviation at a crease, in deviations of f for a change of the slope by 1.
const CREASE: [f64; 2] = [0.06, 0.08];

/// The same where only the second derivative changes, in squared deviations for a change by 1.
const BEND: [f64; 2] = [0.015, 0.035];

/// How far h is from the truth, in units of the span of heights over the values, where the curve does not bend.
const SMOOTH: f64 = 2e-5;

/// By how much the slope and the second derivative change at a bend, a cubic on either side.
fn changes(curve: &HeightTransfer, bend: f64, step: f64) -> [f64; 2] {
    let slope = |at: f64| curve.slope(bend + at * step);
    let bent = |side: f64| (slope(2.0 * side) - slope(side)) / (side * step);
    // Straight on from two values on either side.
    let end = |side: f64| 2.0 * slope(side) - slope(2.0 * side);
    [end(1.0) - end(-1.0), bent(1.0) - bent(-1.0)].map(f64::abs)
}

#[test]
fn heights_are_those_of_quadrature_but_at_creases() -> Outcome {
    let device = Device::new()?;
    for (name, curve, [low, high]) in curves()?.into_iter().filter(|curve| curve.0 != "power") {
        let mut random = Random::new(8);
        let span = high - low;
        let (least, most) = curve.range(low, high);
        let points: Vec<Vec<f64>> = (0..3000)
            .map(|_| [low + span * random.unit(), span * random.between(1e-3, 0.01)])
            .map(|point| point.map(|value| rounded(value, Scalar::Float)).to_vec())
            .collect();
        let text = transfer::narrow("judged", &curve);
        let results = Function::in_text(&text, "judged_narrow")?.results(&device, &[], &points)?;
        let bends = curve.bends();
        let (mut worst, mut smooth) = ([0.0f64; 2], 0);
        for (point, found) in points.iter().zip(&results) {
            let [mean, deviation] = [point[0], point[1]];
            let [height, variance, ..] =
                moments(&bends, |value| [curve.height(value), curve.slope(value)], mean, deviation);
            let near = bends.iter().filter(|bend| (*bend - mean).abs() < 5.0 * deviation);
            let changes: Vec<[f64; 2]> = near.map(|bend| changes(&curve, *bend, 1e-5 * span)).collect();
            smooth += usize::from(changes.is_empty());
            let [crease, bend] = [0, 1].map(|at| changes.iter().map(|change| change[at]).sum::<f64>());
            let rounding = SMOOTH * (most - least).max(1e-3);
            let of = |at: usize| deviation * (CREASE[at] * crease + BEND[at] * deviation * bend) + rounding;
            let allowed = [0, 1].map(of);
            let apart = [(found[0] - height).abs(), (found[1] - variance.max(0.0).sqrt()).abs()];
            for at in 0..2 {
                let part = apart[at] / allowed[at];
                // Written so that NaN is the worst.
                worst[at] = if part <= worst[at] { worst[at] } else { part };
            }
        }
        println!("{name}: {:.2} and {:.2} of what is allowed, {smooth} without a bend", worst[0], worst[1]);
        assert!(worst.iter().all(|&part| part <= 1.0), "{name}: {worst:?}\n{text}");
    }
    Ok(())
}
