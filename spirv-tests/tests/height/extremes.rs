//! Horizons, flat surfaces and any bits for inputs.

use prefilter::gpu::Device;
use prefilter::{HeightTier, Microsurface, Scene};
use spirv_tests::any;
use spirv_tests::exports::ExportKernel;
use spirv_tests::random::Random;
use spirv_tests::scenes;

use crate::Outcome;

/// What the exports take whose surface has nothing special.
const USUAL: &str = "mean: f32, deviation: f32, slope_covariance: vec3f, view: vec3f, light: vec3f";

/// Below a horizon nothing is lit, and colors stay finite and in the hull; so they do for flat surfaces and heights.
#[test]
fn horizons_and_flat_surfaces_are_harmless() -> Outcome {
    let device = Device::new()?;
    let up = [0.0, 0.0, 1.0];
    let [low, flat] = [[0.6, 0.0, -0.8], [0.6, 0.8, 0.0]];
    let mut usual = 0;
    for (name, scene) in scenes::heights()? {
        let (module, map) = (scene.module()?, scene.map().ok_or("no map")?);
        if !module.exports()[0].signature.contains(USUAL) {
            continue;
        }
        usual += 1;
        let mut points = Vec::new();
        for covariance in [[0.0; 3], [0.2, 0.1, 0.3], [0.25, 0.25, 0.25]] {
            for (view, light) in [(up, up), (low, up), (up, low), (low, low), (flat, flat), (flat, up)] {
                for deviation in [0.0, 1e-7, 0.1, 1e9] {
                    points.extend([&[0.43, deviation][..], &covariance, &view, &light].concat());
                }
            }
        }
        let ((least, most), reference) = (map.hull(), map.reference());
        let colors = ExportKernel::new(&device, &module, &module.exports()[0])?.run(&points)?;
        assert_eq!(colors.len(), 72);
        for (color, point) in colors.iter().zip(points.chunks_exact(11)) {
            let truth = reference.value(0.43);
            for channel in 0..3 {
                let slack = if module.tables().is_empty() { 0.0 } else { 1e-3 };
                assert!(
                    (least[channel] - slack..=most[channel] + slack).contains(&color[channel]),
                    "{name}: {point:?}"
                );
                // Without a deviation, and overhead as good as that, the color is the map's.
                let near = module.tables().is_empty() && point[1] <= 1e-7;
                assert!(!near || (f64::from(color[channel]) - truth[channel]).abs() < 1e-4, "{name}: {point:?}");
            }
        }
        let lit: Vec<f32> = points.chunks_exact(11).flat_map(|point| point[2..].to_vec()).collect();
        let shares = ExportKernel::new(&device, &module, &module.exports()[1])?.run(&lit)?;
        for (share, point) in shares.iter().zip(lit.chunks_exact(9)) {
            let below = point[5] <= 0.0 || point[8] <= 0.0;
            assert!(if below { share[0] == 0.0 } else { share[0] > 0.99 }, "{name}: {point:?} gives {share:?}");
        }
    }
    assert!(usual >= 8, "{usual}");
    Ok(())
}

/// A mean surface that rises by 1 along x stands in the way of what comes flatter from there: nothing is lit, and the
/// color is that of the highest heights. From behind nothing is hidden.
#[test]
fn the_horizon_is_that_of_the_mean_surface() -> Outcome {
    let device = Device::new()?;
    let surface = Microsurface { mean_slope: true, masking: true, ..Microsurface::default() };
    let scene = Scene::new("slope").height(spirv_tests::maps::named("steps6")?).microsurface(surface);
    let (low, behind, up) = ([0.8, 0.0, 0.6], [-0.8, 0.0, 0.6], [0.0, 0.0, 1.0]);
    for tier in [HeightTier::Exact, HeightTier::Gaussian] {
        let module = scene.clone().height_tier(tier).module()?;
        let surface = [1.0, 0.0, 0.2, 0.05, 0.1];
        let pairs = [(low, up), (up, low), (low, low), (behind, behind)];
        let run = |export: usize, points: Vec<f32>| {
            ExportKernel::new(&device, &module, &module.exports()[export])?.run(&points)
        };
        let points = |(view, light): ([f32; 3], [f32; 3])| [&surface[..], &view, &light].concat();
        let shares = run(1, pairs.into_iter().flat_map(points).collect())?;
        assert!(shares[..3].iter().all(|share| share[0] == 0.0) && shares[3][0] > 0.99, "{shares:?}");
        let masking = run(2, [low, behind].into_iter().flat_map(|view| [&surface[..], &view].concat()).collect())?;
        assert!(masking[0][0] == 0.0 && masking[1][0] > 0.99, "{masking:?}");
        let heights = |pair| [&[0.41, 1e-3][..], &points(pair)].concat();
        let colors = run(0, pairs.into_iter().flat_map(heights).collect())?;
        assert!(colors[0] == colors[1] && colors[1] == colors[2], "{colors:?}");
    }
    Ok(())
}

/// Points at a time.
const BATCH: usize = 100_000;

/// The numbers of a parameter: any bits, or of its own kind, as far as that goes.
fn any_numbers(random: &mut Random, (name, kind): (&str, &str), wild: bool) -> Vec<f32> {
    let single = |values: &[f64]| values.iter().map(|value| *value as f32).collect();
    match (name, kind) {
        ("view" | "light", _) if !wild => single(&any::direction(random)),
        ("slope_covariance", _) if !wild => single(&any::covariance(random)),
        ("mean_slope", _) if !wild => single(&any::slope(random)),
        (_, "f32") => vec![any::number(random)],
        (_, "vec2f") => vec![any::number(random), any::number(random)],
        (_, "vec3f") => vec![any::number(random), any::number(random), any::number(random)],
        _ => Vec::new(),
    }
}

/// Whatever the numbers: huge, denormal, infinite, of both signs, directions about the horizons and covariances of any
/// size and rank.
#[test]
fn any_input_gives_a_color() -> Outcome {
    let device = Device::new()?;
    let mut random = Random::new(77);
    for (name, scene) in scenes::heights()? {
        let (module, map) = (scene.module()?, scene.map().ok_or("no map")?);
        let (low, high) = map.hull();
        for export in module.exports() {
            let kernel = ExportKernel::new(&device, &module, export)?;
            let colored = export.name.ends_with("_height");
            let mut count = 0;
            while count < any::inputs(BATCH) {
                let mut point = |index: usize| {
                    let parameters = export.parameters().into_iter();
                    parameters
                        .flat_map(|each| any_numbers(&mut random, each, index.is_multiple_of(2)))
                        .collect::<Vec<f32>>()
                };
                let points: Vec<Vec<f32>> = (0..BATCH).map(&mut point).collect();
                let results = kernel.run(&points.concat())?;
                assert_eq!(results.len(), BATCH);
                for (result, point) in results.iter().zip(&points) {
                    for channel in 0..if colored { map.channels() } else { 1 } {
                        let slack = if module.tables().is_empty() { 0.0 } else { 1e-3 };
                        let hull = if colored { low[channel] - slack..=high[channel] + slack } else { 0.0..=1.0 };
                        assert!(hull.contains(&result[channel]), "{name}: {} of {point:?}: {result:?}", export.name);
                    }
                }
                count += BATCH;
            }
            println!("{name}: {count} results of {}", export.name);
        }
    }
    Ok(())
}
