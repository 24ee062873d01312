//! Means, variances and slopes of sums on the device against all pairs of waves.

use std::fmt::Write;

use prefilter::driver::cosines::Wave;
use prefilter::gpu::Device;
use prefilter::reference::cosines::{surface, Surface, Wave as Exact};
use spirv_tests::kernel::Function;
use spirv_tests::random::Random;

use crate::{waves, Outcome};

/// The sum as a driver writes it.
fn text(waves: &[Wave]) -> Result<String, std::fmt::Error> {
    let mut text = String::from(
        "fn asked(position: vec2f, across: vec2f, along: vec2f) -> statistics_surface {
    var sum = cosines_sum();
",
    );
    for Wave { frequency: [x, y], amplitude, phase } in waves {
        let wave = format!("vec4f({x:?}, {y:?}, {amplitude:?}, {phase:?})");
        writeln!(text, "    sum = cosines_with(sum, cosines_wave(position, across, along, {wave}));")?;
    }
    Ok(text + "    return cosines_surface(sum, across, along);\n}\n")
}

fn exact(waves: &[Wave]) -> Vec<Exact> {
    let wave = |wave: &Wave| Exact {
        frequency: wave.frequency.map(f64::from),
        amplitude: wave.amplitude.into(),
        phase: wave.phase.into(),
    };
    waves.iter().map(wave).collect()
}

/// Places with footprints of a deviation and an aspect, turned at random.
fn places(count: usize, deviation: f64, aspect: f64, seed: u32) -> Vec<Vec<f64>> {
    let mut next = Random::new(seed);
    let place = |_| {
        let (sin, cos) = (std::f64::consts::TAU * next.unit()).sin_cos();
        let (long, short) = (deviation * aspect.sqrt(), deviation / aspect.sqrt());
        let point = [8.0 * next.unit(), 8.0 * next.unit(), long * cos, long * sin, -short * sin, short * cos];
        point.map(|number| f64::from(number as f32)).to_vec()
    };
    (0..count).map(place).collect()
}

fn pair(of: &[f64]) -> [f64; 2] {
    [of[0], of[1]]
}

/// One wave is exact, anywhere.
#[test]
fn single_waves_are_exact() -> Outcome {
    let device = Device::new()?;
    for seed in 0..6 {
        let one = waves(1, 0.4, 4.0, 0.3, seed);
        let function = Function::in_text(&text(&one)?, "asked")?;
        for (deviation, aspect) in [(0.02, 1.0), (0.1, 3.0), (0.3, 1.0), (0.6, 8.0)] {
            let places = places(300, deviation, aspect, seed);
            for (place, got) in places.iter().zip(function.results(&device, &[], &places)?) {
                let truth = surface(&exact(&one), pair(place), pair(&place[2..]), pair(&place[4..]));
                let steep = truth.slope_covariance[0] + truth.slope_covariance[2];
                let errors = [
                    (got[0] - truth.mean).abs(),
                    (got[1] - truth.variance).abs() / (1e-3 + truth.variance.sqrt()),
                    (got[4] - truth.slope[0]).abs().max((got[5] - truth.slope[1]).abs()),
                    (got[6] + got[8] - steep).abs() / (1e-3 + steep.sqrt()),
                ];
                assert!(errors.iter().all(|error| *error < 2e-5), "{place:?}: {got:?} {truth:?}");
            }
        }
    }
    Ok(())
}

/// Root mean square errors of deviations relative to the mean deviation: ours, and the same deviation everywhere; of
/// heights and of slopes, by their covariance's trace.
fn figures(device: &Device, deviation: f64, aspect: f64) -> Result<[f64; 4], Box<dyn std::error::Error + Send + Sync>> {
    let (mut errors, mut totals) = ([0.0; 4], [0.0; 2]);
    for seed in 0..12 {
        // Footprints are in wavelengths of the middle one.
        let eight = waves(8, 0.5, 4.0, 0.2, seed);
        let function = Function::in_text(&text(&eight)?, "asked")?;
        let places = places(400, deviation, aspect, 100 + seed);
        let truths: Vec<Surface> = places
            .iter()
            .map(|place| surface(&exact(&eight), pair(place), pair(&place[2..]), pair(&place[4..])))
            .collect();
        let trace = |truth: &Surface| truth.slope_covariance[0] + truth.slope_covariance[2];
        let count = truths.len() as f64;
        // The same everywhere, the mean over places, is what is known without the phases.
        let same = truths.iter().map(|truth| truth.variance).sum::<f64>() / count;
        let steep = truths.iter().map(trace).sum::<f64>() / count;
        for (truth, got) in truths.iter().zip(function.results(device, &[], &places)?) {
            assert!((got[0] - truth.mean).abs() < 2e-6, "{got:?} {truth:?}");
            assert!((got[4] - truth.slope[0]).abs() + (got[5] - truth.slope[1]).abs() < 4e-5, "{got:?} {truth:?}");
            assert!(got[6] >= 0.0 && got[7] * got[7] <= got[6] * got[8] * (1.0 + 1e-5), "{got:?}");
            let own = [truth.variance.max(0.0).sqrt(), trace(truth).max(0.0).sqrt()];
            let found = [got[1].sqrt(), same.sqrt(), (got[6] + got[8]).sqrt(), steep.sqrt()];
            for (at, found) in found.into_iter().enumerate() {
                errors[at] += (found - own[at / 2]).powi(2) / count;
            }
            totals = [totals[0] + own[0].powi(2) / count, totals[1] + own[1].powi(2) / count];
        }
    }
    let relative = |at: usize| f64::sqrt(errors[at] / totals[at / 2]);
    Ok([0, 1, 2, 3].map(relative))
}

/// What the documentation of the driver says.
#[test]
fn deviations_keep_their_figures() -> Outcome {
    let device = Device::new()?;
    for (deviation, documented) in [
        (0.05, [0.035, 0.43, 0.04, 0.36]),
        (0.15, [0.115, 0.32, 0.13, 0.25]),
        (0.3, [0.15, 0.23, 0.13, 0.16]),
        (1.0, [0.09, 0.09, 0.05, 0.05]),
    ] {
        let found = figures(&device, deviation, 1.0)?;
        println!("{deviation}: ours, same, slopes, same {found:.3?}; 1:4 {:.3?}", figures(&device, deviation, 4.0)?);
        for (found, documented) in found.into_iter().zip(documented) {
            assert!((found - documented).abs() < 0.0051, "{found} is not {documented}");
        }
    }
    Ok(())
}
