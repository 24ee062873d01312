//! Moments of curves and of their slopes over normal values: what modules hold, against quadrature.

use prefilter::driver::transfer;
use prefilter::gpu::{Address, Device};
use prefilter::reference::piece::moments;
use prefilter::table::Table;
use prefilter::{Error, HeightTransfer, Ranges};
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

/// Powers between the whole ones are as exact, by a table with a single row.
#[test]
fn powers_are_the_moments_of_curves() -> Outcome {
    let device = Device::new()?;
    for exponent in [1.05, 1.7, 2.5, 6.0] {
        let curve = HeightTransfer::power(exponent)?.scaled(-0.7, 0.2)?;
        let (errors, table) = tabulated(&device, &curve, [-1.0, 1.0], &points([-1.0, 1.0], 4000))?;
        println!("{exponent}: {}, table {:.1e}", errors.map(|error| format!("{error:.1e}")).join(", "), table.error);
        assert!(errors.iter().all(|&error| error <= FIGURE), "{exponent}: {errors:?}");
    }
    Ok(())
}

/// Preconvolved curves are within what their tables say, and close where footprints are wide against the columns.
#[test]
fn tables_keep_their_errors() -> Outcome {
    let device = Device::new()?;
    let knots = (0..40u16).map(|knot| (f32::from(knot) / 39.0, f32::from(knot * 7 % 5) / 5.0));
    let curves = [
        ("terraces", HeightTransfer::terraces(20, 0.3)?),
        ("knots", HeightTransfer::knots(knots)?.scaled(3.0, -200.0)?),
    ];
    for (name, curve) in curves {
        let mut random = Random::new(6);
        // The ranges that a curve over [0, 1] is read in.
        let mut point = |least: f64| -> Vec<f64> {
            [2.0 * random.unit() - 0.5, random.between(least, 0.5)].map(|value| rounded(value, Scalar::Float)).to_vec()
        };
        let narrow: Vec<_> = (0..2000).map(|_| point(1e-4)).collect();
        let wide: Vec<_> = (0..2000).map(|_| point(0.05)).collect();
        let (errors, table) = tabulated(&device, &curve, [0.0, 1.0], &narrow)?;
        println!("{name}: {}, table {:.1e}", errors.map(|error| format!("{error:.1e}")).join(", "), table.error);
        // Means in parts of whole ranges; at row 0 bends are steps of the slope.
        assert!(errors[0].max(errors[2]) <= f64::from(table.error), "{name}: {errors:?}, {}", table.error);
        let (errors, _) = tabulated(&device, &curve, [0.0, 1.0], &wide)?;
        println!("{name}, wide: {}", errors.map(|error| format!("{error:.1e}")).join(", "));
        // A step of eight bits, where deviations are a tenth of the largest or more.
        assert!(errors.iter().all(|&error| error <= 1.0 / 255.0), "{name}: {errors:?}");
    }
    Ok(())
}

/// The errors of a curve that is read from a table, its own or preconvolved, and the table.
fn tabulated(
    device: &Device,
    curve: &HeightTransfer,
    span: [f64; 2],
    points: &[Vec<f64>],
) -> Result<([f64; 4], Table), Box<dyn std::error::Error + Send + Sync>> {
    let (text, tables) = transfer::stage("judged", curve);
    let (text, table) = match tables.into_iter().next() {
        Some(table) => (text, table),
        None => transfer::preconvolved("judged", curve, &Ranges { mean: (-0.5, 1.5), deviation: 0.5 })?,
    };
    let texture = device.upload(&table, Address::Clamp)?;
    let results = Function::in_text(&text, "judged_transferred")?.results(device, &[&texture], points)?;
    Ok((errors(curve, span, points, &results), table))
}

/// Heights whose squares no float holds are refused, not written as what no shader reads.
#[test]
fn heights_beyond_floats_are_refused() -> Result<(), Error> {
    let whole = Ranges { mean: (-65504.0, 65504.0), deviation: 65504.0 };
    for (exponent, fits) in [(8.0, false), (3.5, false), (2.5, true), (1.5, true)] {
        let curve = HeightTransfer::power(exponent)?;
        match transfer::preconvolved("far", &curve, &whole) {
            Ok((text, _)) => {
                assert!(fits, "{text}");
                prefilter::link(&[], &text)?;
            }
            Err(error) => assert!(!fits && error.to_string().contains("1e18"), "{error}"),
        }
    }
    let narrow = Ranges { mean: (0.0, 1.0), deviation: 0.0 };
    assert!(matches!(transfer::preconvolved("flat", &HeightTransfer::absolute(), &narrow), Err(Error::Value { .. })));
    Ok(())
}
