//! Do lit colors stay within the light times the colors that there are, and are they those of a single slope?

use std::f64::consts::PI;

use prefilter::gpu::Device;
use prefilter::{ColorMap, Irradiance, IrradianceTier, Reflectance, Scene, SlopeDomain, SlopeMap, SlopeTier};
use spirv_tests::any;
use spirv_tests::random::Random;

use crate::{run, Fault, Outcome};

fn single<const N: usize>(values: [f64; N]) -> [f64; N] {
    values.map(|value| f64::from(value as f32))
}

fn sky() -> Result<Irradiance, Fault> {
    let mut harmonics =
        [[0.9, 1.1, 1.4], [0.1, 0.12, 0.1], [0.5, 0.6, 0.9], [0.4, 0.35, 0.2], [0.0; 3], [0.05; 3]].to_vec();
    harmonics.extend([[0.1, 0.08, 0.11], [0.2, 0.15, 0.1], [-0.04, 0.02, 0.01]]);
    Ok(Irradiance::from_harmonics(harmonics.try_into().map_err(|_| "nine")?)?)
}

fn sloped() -> Result<Scene, Fault> {
    let ramp = ColorMap::gradient([(-0.4, [-0.5, 0.2, 0.9, 0.1]), (0.5, [0.8, 0.7, 0.1, 0.9])])?;
    let module = Scene::new("hills").combination(0.5 * Scene::new("sand").slope(ramp) + 0.25);
    Ok(module.irradiance(sky()?).reflectance(Reflectance::Lambert))
}

/// A single slope has one color and one light.
#[test]
fn light_on_a_single_slope_is_its_own() -> Outcome {
    let device = Device::new()?;
    let module = sloped()?.module()?;
    let sky = sky()?;
    let mut random = Random::new(0x51);
    let slopes: Vec<[f64; 2]> = (0..200).map(|_| single([random.unit() - 0.5, random.unit() - 0.5])).collect();
    let views = [[0.0, 0.0, 1.0], [0.6, 0.0, 0.8], [-0.36, 0.48, 0.8]];
    let light = [-0.48, 0.36, 0.8];
    // None, singular, tiny.
    let covariances = [[0.0; 3], [1e-10, -1e-10, 1e-10], [0.0, 0.0, 1e-9], [1e-40, 0.0, 1e-40]];
    let number = |at: usize, name: &str| match name {
        "mean_slope" => slopes[at].to_vec(),
        "slope_covariance" => covariances[at % 4].to_vec(),
        "view" => views[at % 3].to_vec(),
        "light" => light.to_vec(),
        "direction" => vec![0.6, -0.8],
        "x" => vec![1.0, 0.0, 0.0],
        "y" => vec![0.0, 1.0, 0.0],
        "z" => vec![0.0, 0.0, 1.0],
        "radiance" => vec![PI; 3],
        _ => vec![f64::NAN],
    };
    let colors = run(&device, &module, "hills_combined", slopes.len(), number)?;
    let lit = run(&device, &module, "hills_lit", slopes.len(), number)?;
    let radiance = run(&device, &module, "hills_radiance", slopes.len(), number)?;
    for (at, [x, y]) in slopes.into_iter().enumerate() {
        let length = (1.0 + x * x + y * y).sqrt();
        let normal = [-x / length, -y / length, 1.0 / length];
        let environment = sky.value(normal.map(|part| part as f32));
        let cosine: f64 = normal.iter().zip(light).map(|(n, l)| n * l).sum();
        let share = ((0.6 * x - 0.8 * y + 0.4) / 0.9).clamp(0.0, 1.0);
        for channel in 0..3 {
            let [low, high] = [[-0.5, 0.8], [0.2, 0.7], [0.9, 0.1]][channel];
            let color = 0.5 * (low + share * (high - low)) + 0.25;
            let close = |found: f32, expected: f64, most: f64| {
                assert!((f64::from(found) - expected).abs() < most, "{at} {channel}: {found} is not {expected}");
            };
            close(colors[at][channel], color, 3e-5);
            // The tier's own error is 2e-3 of the mean irradiance.
            close(lit[at][channel], color * f64::from(environment[channel]), 6e-3);
            close(radiance[at][channel], color * cosine, 3e-4);
        }
        assert_eq!([lit[at][3], radiance[at][3]], [colors[at][3]; 2]);
    }
    Ok(())
}

/// Whatever comes in, a lit color is the light times a color that there is.
#[test]
fn lit_colors_stay_in_their_hull() -> Outcome {
    const BATCH: usize = 50_000;
    let device = Device::new()?;
    let module = sloped()?.module()?;
    let bare = Scene::new("bare").irradiance(sky()?).irradiance_tier(IrradianceTier::FourGaussians).module()?;
    let mut random = Random::new(0x4011);
    let points: Vec<_> = (0..BATCH)
        .map(|_| {
            let [view, light] = [(); 2].map(|()| any::direction(&mut random).to_vec());
            [any::slope(&mut random).to_vec(), any::covariance(&mut random).to_vec(), view, light]
        })
        .collect();
    let number = |at: usize, name: &str| match name {
        "mean_slope" => points[at][0].clone(),
        "slope_covariance" => points[at][1].clone(),
        "view" => points[at][2].clone(),
        "light" => points[at][3].clone(),
        "direction" => vec![0.6, -0.8],
        "x" => vec![0.6, 0.0, 0.8],
        "y" => vec![0.0, 1.0, 0.0],
        "z" => vec![-0.8, 0.0, 0.6],
        "radiance" => vec![PI; 3],
        _ => vec![f64::NAN],
    };
    let hull = [[0.0, 0.65], [0.35, 0.6], [0.3, 0.7], [0.3, 0.7]];
    for (export, of) in [("hills_lit", "bare_irradiance"), ("hills_radiance", "bare_lambert")] {
        let lit = run(&device, &module, export, BATCH, number)?;
        let lights = run(&device, &bare, of, BATCH, number)?;
        for (at, (lit, light)) in lit.iter().zip(lights).enumerate() {
            for channel in 0..4 {
                let cosine = of == "bare_lambert";
                let light = if channel == 3 { 1.0 } else { light[if cosine { 0 } else { channel }] };
                let [low, high] = hull[channel];
                // Shadows take from the light of a single direction.
                let low = if cosine && channel < 3 { 0.0 } else { low * light };
                let most = 1e-5 * (1.0 + light);
                assert!(
                    lit[channel] >= low - most && lit[channel] <= high * light + most,
                    "{export} {at}: {lit:?} {light} {:?}",
                    points[at]
                );
            }
        }
    }
    Ok(())
}

/// Of every tier that there is, alone and with the others.
#[test]
fn every_tier_is_lit_by_its_own_slope() -> Outcome {
    const POINTS: usize = 60;
    let device = Device::new()?;
    let map = ColorMap::gradient([(-0.4, [0.1, 0.2, 0.9]), (0.5, [0.8, 0.7, 0.1])])?;
    let length = ColorMap::gradient([(0.1, [0.1, 0.2, 0.9]), (0.5, [0.8, 0.7, 0.1])])?;
    let wheel = |[x, y]: [f32; 2]| [0.5 + 0.4 * x, 0.5 + 0.4 * y, 0.5];
    let wheel = SlopeMap::from_function(16, SlopeDomain::Within(1.0), wheel)?;
    let mut layers = Vec::new();
    for tier in [SlopeTier::Naive, SlopeTier::Unweighted, SlopeTier::Gaussian, SlopeTier::Pair] {
        layers.push(Scene::new("sand").slope(map.clone()).slope_tier(tier));
        if tier != SlopeTier::Unweighted {
            layers.push(Scene::new("rock").steepness(length.clone()).slope_tier(tier));
        }
        layers.push(Scene::new("wheel").slope_map(wheel.clone()).slope_tier(tier));
    }
    let bare = Scene::new("bare").irradiance(sky()?).irradiance_tier(IrradianceTier::FourGaussians).module()?;
    let mut random = Random::new(0x717);
    let slopes: Vec<_> = (0..POINTS).map(|_| single([random.unit() - 0.5, random.unit() - 0.5]).to_vec()).collect();
    let number = |at: usize, name: &str| match name {
        "mean_slope" => slopes[at].clone(),
        "slope_covariance" => vec![0.0; 3],
        "view" => vec![0.6, 0.0, 0.8],
        "light" => vec![-0.48, 0.36, 0.8],
        "direction" => vec![0.6, -0.8],
        "x" => vec![1.0, 0.0, 0.0],
        "y" => vec![0.0, 1.0, 0.0],
        "z" => vec![0.0, 0.0, 1.0],
        "radiance" => vec![PI; 3],
        _ => vec![f64::NAN],
    };
    let lights =
        [run(&device, &bare, "bare_irradiance", POINTS, number)?, run(&device, &bare, "bare_lambert", POINTS, number)?];
    let other = Scene::new("other").steepness(length.clone()).slope_tier(SlopeTier::Gaussian);
    for (place, layer) in layers.iter().enumerate() {
        let scene = Scene::new("hills").combination(layer + 0.5 * &other);
        let module = scene.irradiance(sky()?).reflectance(Reflectance::Lambert).module()?;
        let colors = run(&device, &module, "hills_combined", POINTS, number)?;
        for (kind, export) in ["hills_lit", "hills_radiance"].into_iter().enumerate() {
            let lit = run(&device, &module, export, POINTS, number)?;
            for (at, lit) in lit.iter().enumerate() {
                for channel in 0..3 {
                    let light = lights[kind][at][if kind == 0 { channel } else { 0 }];
                    let apart = lit[channel] - colors[at][channel] * light;
                    assert!(apart.abs() < 1e-4, "layer {place}, {export} {at}: {apart:e}\n{}", module.explain());
                }
            }
        }
    }
    Ok(())
}
