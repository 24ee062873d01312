//! Heights over narrow footprints, by four values of f, against quadrature.

use prefilter::driver::transfer;
use prefilter::gpu::{Address, Device};
use prefilter::reference::piece::moments;
use prefilter::HeightTransfer;
use spirv_tests::fill::rounded;
use spirv_tests::kernel::Function;
use spirv_tests::random::Random;
use spirv_tests::signature::Scalar;

use crate::{curves, Curve, Outcome};

/// What the shelf says of mean and deviation at a crease, in deviations of f for a change of the slope by 1:
/// `a_bend_costs_as_much_as_is_allowed` finds no more.
const CREASE: [f64; 2] = [0.06, 0.08];

/// The same where only the second derivative changes, in squared deviations for a change by 1.
const BEND: [f64; 2] = [0.015, 0.035];

/// How far h of a power is from the truth, by its table, in units of the span of heights over the values: what
/// `NAME_transferred` promises.
const TABLE: f64 = 1e-4;

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

/// The errors of mean and deviation by Gauss and Hermite's rule of four, for p z + q z²/2 over a standard normal z, to
/// which the part of (z − c)ⁿ/n beyond the bend c is added.
fn at_a_bend([slope, square]: [f64; 2], bend: f64, power: i32) -> [f64; 2] {
    let beyond = |z: f64| if z > bend { (z - bend).powi(power) / f64::from(power) } else { 0.0 };
    let height = |z: f64| slope * z + 0.5 * square * z * z + beyond(z);
    // The roots of z⁴ − 6 z² + 3 and their weights.
    let far = [3.0 - 6f64.sqrt(), 3.0 + 6f64.sqrt()].map(|square: f64| [square.sqrt(), (6.0 - square) / 12.0]);
    let rule = far.into_iter().flat_map(|[z, weight]| [[-z, weight], [z, weight]]);
    let found = rule.fold([0.0; 2], |[mean, second], [z, weight]| {
        [mean + weight * height(z), second + weight * height(z) * height(z)]
    });
    let [mean, variance, ..] = moments(&[bend], |z| [height(z), 0.0], 0.0, 1.0);
    let deviation = (found[1] - found[0] * found[0]).max(0.0).sqrt();
    [(found[0] - mean).abs(), (deviation - variance.sqrt()).abs()]
}

/// The largest errors over where the bend is and how the curve runs before it.
#[test]
fn a_bend_costs_as_much_as_is_allowed() {
    for (power, squares, figures) in [(1, &[0.0][..], CREASE), (2, &[0.0, -0.25, -0.5, -0.75, -1.0, 0.5], BEND)] {
        let mut worst = [0.0f64; 2];
        for bend in (-60..=60).map(|bend| 0.05 * f64::from(bend)) {
            for (slope, square) in (-8..=8).flat_map(|slope| squares.iter().map(move |&square| (slope, square))) {
                let errors = at_a_bend([0.25 * f64::from(slope), square], bend, power);
                worst = [0, 1].map(|at| worst[at].max(errors[at]));
            }
        }
        println!("where derivative {power} changes: {worst:?} of {figures:?}");
        for (found, figure) in worst.into_iter().zip(figures) {
            assert!(found <= figure && 1.15 * found >= figure, "derivative {power}: {found} of {figure}");
        }
    }
}

/// Means and narrow deviations.
fn points(low: f64, span: f64) -> Vec<Vec<f64>> {
    let mut random = Random::new(8);
    let point = |_| [low + span * random.unit(), span * random.between(1e-3, 0.01)];
    (0..3000).map(point).map(|point| point.map(|value| rounded(value, Scalar::Float)).to_vec()).collect()
}

/// The larger, where what is no number is larger than all.
fn larger(one: f64, other: f64) -> f64 {
    if other <= one {
        one
    } else {
        other
    }
}

#[test]
fn heights_are_those_of_quadrature_but_at_creases() -> Outcome {
    let device = Device::new()?;
    // A power that is none of the whole ones has no pieces: `narrow_powers_are_those_of_quadrature`.
    let (pieces, others): (Vec<Curve>, Vec<Curve>) = curves()?.into_iter().partition(|curve| curve.0 != "power");
    assert_eq!(others.len(), 1);
    for (name, curve, [low, high]) in pieces {
        let span = high - low;
        let (least, most) = curve.range(low, high);
        let points = points(low, span);
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
                worst[at] = larger(worst[at], apart[at] / allowed[at]);
            }
        }
        println!("{name}: {:.2} and {:.2} of what is allowed, {smooth} without a bend", worst[0], worst[1]);
        assert!(worst.iter().all(|&part| part <= 1.0), "{name}: {worst:?}\n{text}");
        // Most places are away from bends, and some are at them where there are any.
        let bent = results.len() - smooth;
        assert!(smooth > results.len() / 2, "{name}: {smooth} of {} without a bend", results.len());
        assert!(if bends.is_empty() { bent == 0 } else { bent > 100 }, "{name}: {bent} at bends {bends:?}");
    }
    Ok(())
}

/// Powers other than the whole ones, from their tables.
#[test]
fn narrow_powers_are_those_of_quadrature() -> Outcome {
    let device = Device::new()?;
    let (low, high) = (-1.0, 1.3);
    for exponent in [1.05, 1.7, 2.5, 6.0] {
        let curve = HeightTransfer::power(exponent)?;
        let (least, most) = curve.range(low, high);
        let points = points(low, high - low);
        let (text, tables) = transfer::stage("judged", &curve);
        let [table] = &tables[..] else { return Err(format!("{} tables", tables.len()).into()) };
        let texture = device.upload(table, Address::Clamp)?;
        let text = text + &transfer::narrow("judged", &curve);
        let results = Function::in_text(&text, "judged_narrow")?.results(&device, &[&texture], &points)?;
        assert!(!results.is_empty() && results.len() == points.len());
        let mut worst = [0.0f64; 2];
        for (point, found) in points.iter().zip(&results) {
            let heights = |value| [curve.height(value), curve.slope(value)];
            let [height, variance, ..] = moments(&curve.bends(), heights, point[0], point[1]);
            let apart = [found[0] - height, found[1] - variance.max(0.0).sqrt()].map(|error| error.abs());
            worst = [0, 1].map(|at| larger(worst[at], apart[at] / (most - least)));
        }
        println!("power {exponent}: {:.1e} and {:.1e} of the heights", worst[0], worst[1]);
        assert!(worst.iter().all(|&part| part <= TABLE), "power {exponent}: {worst:?}\n{text}");
    }
    Ok(())
}
