//! How far means over visible normals are from the quadrature, in the measures that bounds of irradiance have.

use std::f64::consts::TAU;

use prefilter::gpu::Device;
use prefilter::reference::normals::means;
use prefilter::reference::slopes::Visible;
use spirv_tests::gap::figure::over_seeds;
use spirv_tests::kernel::Function;
use spirv_tests::random::Random;
use spirv_tests::rows::{self, Row};

/// Points of a seed, and seeds.
const POINTS: usize = 500;
const SEEDS: usize = 12;

/// Views from 5 degrees above the plane, mean slopes to 0.3 on each axis, deviations from 0.05 up to the largest along
/// either axis, correlations up to 0.9, a third of each at its ends: those of them that the contract is about.
fn points(row: &Row, seed: u64, most: f64) -> Vec<Vec<f64>> {
    let mut random = Random::new(seed as u32);
    let mut ended = |low: f64, high: f64| {
        let between = low + (high - low) * random.unit();
        [between, between, between, between, low, high][random.word() as usize % 6]
    };
    let mut point = || {
        let (z, azimuth) = (ended(0.0873, 1.0), ended(0.0, TAU));
        let radius = (1.0 - z * z).sqrt();
        let [x, y] = [ended(0.05, most), ended(0.05, most)];
        let covariance = [x * x, ended(-0.9, 0.9) * x * y, y * y];
        let mean = [ended(-0.3, 0.3), ended(-0.3, 0.3)];
        let point = [&[radius * azimuth.cos(), radius * azimuth.sin(), z][..], &mean, &covariance].concat();
        point.into_iter().map(|value| f64::from(value as f32)).collect()
    };
    let mut all = Vec::new();
    while all.len() < POINTS {
        let point: Vec<f64> = point();
        if row.judges(&point) {
            all.push(point);
        }
    }
    all
}

/// The largest errors of the mean of n, as a length, and of the mean of n nᵀ, as the root of the sum of the squares of
/// its nine components.
fn errors(device: &Device, name: &str, most: f64) -> Result<[f64; 2], String> {
    let function = Function::shelf()?.into_iter().find(|function| function.name == name).ok_or("no function")?;
    let row = rows::all().into_iter().find(|row| row.name == name).ok_or("no row")?;
    let points: Vec<Vec<Vec<f64>>> = (0..SEEDS as u64).map(|seed| points(&row, seed, most)).collect();
    let found = function.results(device, &[], &points.concat())?;
    let truths = over_seeds(SEEDS, |seed| {
        let truth = |point: &Vec<f64>| {
            let visible = Visible {
                view: [point[0], point[1], point[2]],
                mean: [point[3], point[4]],
                covariance: [point[5], point[6], point[7]],
            };
            means(&visible)
        };
        points[seed as usize].iter().map(truth).collect::<Vec<_>>()
    });
    assert_eq!(found.len(), POINTS * SEEDS);
    let mut worst = [0.0f64; 2];
    for (found, truth) in found.iter().zip(truths.into_iter().flatten()) {
        let [x, y, z, xx, xy, yy, xz, yz, _]: [f64; 9] = std::array::from_fn(|at| found[at] - truth[at]);
        let sum = xx * xx + yy * yy + (xx + yy).powi(2) + 2.0 * (xy * xy + xz * xz + yz * yz);
        let errors = [(x * x + y * y + z * z).sqrt(), sum.sqrt()];
        for (worst, error) in worst.iter_mut().zip(errors) {
            // NaN is the worst.
            *worst = if error.is_nan() { f64::INFINITY } else { worst.max(error) };
        }
    }
    Ok(worst)
}

#[test]
fn means_keep_the_figures_of_irradiance() -> Result<(), String> {
    let device = Device::new().map_err(|error| error.to_string())?;
    for (name, most, figures) in [
        ("normals_visible_points", 0.3, [2.6e-3, 8.5e-3]),
        ("normals_visible_fast", 1.0, [4e-3, 6.5e-3]),
        ("normals_visible", 1.0, [6.6e-4, 7e-4]),
    ] {
        let found = errors(&device, name, most)?;
        println!("{name}: the mean of n errs by {:.3e}, of n nᵀ by {:.3e}", found[0], found[1]);
        for (found, figure) in found.into_iter().zip(figures) {
            assert!(found <= figure && 1.25 * found >= figure, "{name}: {found:e} of {figure:e}");
        }
    }
    Ok(())
}
