//! Footprints of nothing, of everything and of a line, positions far away, and descriptions at their limits.

use std::f64::consts::{PI, TAU};

use prefilter::gpu::Device;
use prefilter::reference::gabor::noise as exact;
use prefilter::reference::gabor_spectrum::Spectrum as Ranges;
use prefilter::{Driver, Error, Gabor, GaborMethod, Scene, Spectrum};
use spirv_tests::random::Random;

use crate::{module, noise, place, plane, spectra, statistics, Outcome, CELL};

/// The isotropic spectrum of [`spectra`], in cells.
const RANGES: Ranges = Ranges { frequency: [1.3 * CELL, 0.0], azimuth: [0.0, TAU], height: [-1.0, 2.0] };

/// Positions that f32 holds in cells, too.
fn positions(count: usize, reach: f64) -> Vec<[f64; 3]> {
    let mut random = Random::new(12);
    (0..count).map(|_| place(&mut random, reach).map(|part| f64::from(part as f32))).collect()
}

/// The exact mean over a footprint at the position as f32 has it in cells.
fn truth(at: [f64; 3], footprint: [[f64; 3]; 2]) -> f64 {
    let at = at.map(|part| f64::from(part as f32 * 1.25));
    exact(at, 2, 0, &RANGES, footprint.map(|vector| vector.map(|part| part / CELL))).0
}

#[test]
fn points_are_themselves_and_the_widest_footprints_are_the_whole() -> Outcome {
    let device = Device::new()?;
    for (name, spectrum) in spectra() {
        for method in [GaborMethod::Exact, GaborMethod::Paper] {
            let module = module(Gabor { method, mean: 0.3, deviation: 0.2, ..noise(spectrum) })?;
            let mut random = Random::new(1);
            for length in [0.0, 1e-30, 1e-12, 1e2, 1e6, 1e30, f64::from(f32::MAX)] {
                let [across, along] = plane(&mut random, [length, length]);
                let footprints: Vec<_> = positions(50, 100.0).into_iter().map(|at| [at, across, along]).collect();
                let points: Vec<_> = footprints.iter().map(|[at, ..]| [*at, [0.0; 3], [0.0; 3]]).collect();
                let (found, points) =
                    (statistics(&device, &module, &footprints)?, statistics(&device, &module, &points)?);
                for ([mean, variance], [point, none]) in found.into_iter().zip(points) {
                    assert_eq!(none, 0.0, "{name} {method:?}: a point varies");
                    let [expected, spread] = if length < 1.0 { [point, 0.0] } else { [0.3, 0.04] };
                    // 100/a leave 1/(2π 1e4) of the variance in the plane, and more of waves that lie along it.
                    let off = if length < 1.0 { 1e-6 } else { 3e-3 };
                    assert!((mean - expected).abs() < off, "{name} {method:?} {length}: {mean}, not {expected}");
                    assert!((variance - spread).abs() < off * 0.2, "{name} {method:?} {length}: {variance}");
                }
            }
        }
    }
    Ok(())
}

/// Lines, turned vectors of the same covariance, and positions up to a million cells away.
#[test]
fn any_footprint_anywhere_has_its_mean() -> Outcome {
    let device = Device::new()?;
    let module = module(noise(spectra()[1].1))?;
    let mut random = Random::new(6);
    for (reach, off) in [(1.0, 2e-5), (1e4, 2e-5), (8e5, 2e-5)] {
        for lengths in [[0.3, 0.0], [0.3, 0.1], [1e-3, 1e-3]] {
            let [a, b] = plane(&mut random, lengths).map(|vector| vector.map(|part| f64::from(part as f32)));
            let turned = |turn: f64| {
                let (sin, cos) = turn.sin_cos();
                [[cos, sin], [-sin, cos]].map(|[x, y]| [0, 1, 2].map(|axis| x * a[axis] + y * b[axis]))
            };
            for turn in [0.0, 0.25 * PI, 0.9 * PI] {
                let [across, along] = turned(turn);
                let positions = positions(200, reach);
                let footprints: Vec<_> = positions.iter().map(|&at| [at, across, along]).collect();
                let found = statistics(&device, &module, &footprints)?;
                let mut errors: Vec<f64> =
                    positions.iter().zip(&found).map(|(&at, found)| (found[0] - truth(at, [a, b])).abs()).collect();
                errors.sort_by(f64::total_cmp);
                // A kernel that ends between f32 and f64 is 1 % of a deviation, at one place of a thousand.
                assert!(errors[197] < off, "{reach} {lengths:?} {turn}: {:?}", &errors[195..]);
                assert!(errors[199] < 0.02, "{reach} {lengths:?} {turn}: {:?}", &errors[195..]);
            }
        }
    }
    Ok(())
}

/// Whatever numbers a description holds, it becomes a module or an error.
#[test]
fn any_description_is_a_module_or_an_error() -> Outcome {
    let mut random = Random::new(77);
    let map = prefilter::ColorMap::gradient([(0.0, [0.0; 3]), (1.0, [1.0; 3])])?;
    let mut modules = 0;
    for _ in 0..3000 {
        let mut number = || match random.word() % 4 {
            0 => f32::from_bits(random.word()),
            1 => random.pick([0.0, -0.0, 1.0, -1.0, 1e-45, 1e-6, 1e6, 16.0, 1e15, f32::NAN, f32::INFINITY, f32::MAX]),
            _ => (2.0 * random.unit()) as f32,
        };
        let pair = [number(), number(), number(), number(), number(), number()];
        let spectrum = match number().to_bits() % 3 {
            0 => Spectrum::Anisotropic { frequency: [pair[0], pair[1], pair[2]] },
            1 => Spectrum::Isotropic { frequency: pair[0] },
            _ => Spectrum::Hybrid {
                frequency: (pair[0], pair[1]),
                azimuth: (pair[2], pair[3]),
                height: (pair[4], pair[5]),
            },
        };
        let [bandwidth, mean, deviation] = [number(), number(), number()];
        let kernels = random.word() % 18;
        let gabor = Gabor { spectrum, bandwidth, kernels, seed: random.word(), mean, deviation, ..Gabor::default() };
        let scene = Scene::new("wood").texture(map.clone()).tier(prefilter::Tier::Naive);
        match scene.driver(Driver::Gabor(gabor)).module() {
            Ok(_) => modules += 1,
            Err(Error::Value { .. } | Error::Size { .. }) => {}
            Err(error) => return Err(format!("{gabor:?}: {error}").into()),
        }
    }
    println!("{modules} modules");
    assert!(modules > 30, "{modules}");
    Ok(())
}
