//! Which combinations there are, and that their colors are sums and products of their layers'.

use prefilter::gpu::Device;
use prefilter::{Accuracy, ColorMap, Combination, Error, Irradiance, Microsurface, Scene, SlopeMap};
use spirv_tests::any;
use spirv_tests::random::Random;

use crate::{run, Outcome};

fn rock() -> Result<Scene, Error> {
    let map = ColorMap::gradient([(0.3, [0.2, 0.3, 0.1]), (0.9, [0.4, 0.35, 0.3])])?;
    Ok(Scene::new("rock").steepness(map))
}

fn high() -> Result<Scene, Error> {
    Ok(Scene::new("high").height(ColorMap::gradient([(0.6, [0.0; 3]), (0.8, [1.0; 3])])?))
}

fn sand() -> Result<Scene, Error> {
    Ok(Scene::new("sand").slope(ColorMap::gradient([(-0.3, [0.7, 0.6, 0.4]), (0.3, [0.9, 0.8, 0.6])])?))
}

fn grain() -> Result<Scene, Error> {
    Ok(Scene::new("grain").texture(ColorMap::gradient([(0.1, [0.5; 3]), (0.9, [1.0, 0.95, 0.9])])?))
}

fn flat() -> Result<SlopeMap, Error> {
    SlopeMap::from_texels(2, 1.0, &[[0.2; 3], [0.4; 3], [0.6; 3], [0.8; 3]])
}

fn sky() -> Result<Irradiance, Error> {
    Irradiance::from_equirectangular(64, 32, &[[0.4, 0.6, 1.0]; 64 * 32])
}

/// Ordinary numbers of a parameter.
fn ordinary(random: &mut Random, name: &str) -> Vec<f64> {
    let unit = [0.36, 0.48, 0.8];
    match name {
        "slope_covariance" => vec![0.2 + 0.2 * random.unit(), 0.1 * random.unit(), 0.3],
        "view" => unit.to_vec(),
        "light" | "x" => vec![0.6, 0.0, 0.8],
        "y" => vec![0.0, 1.0, 0.0],
        "z" => vec![-0.8, 0.0, 0.6],
        "mean_slope" => vec![0.4 * random.unit() - 0.2, 0.3],
        "direction" => vec![0.6, -0.8],
        name if name.ends_with("deviation") => vec![0.02 + 0.3 * random.unit()],
        _ => vec![random.unit()],
    }
}

/// The numbers that every export takes from the same point.
fn points(count: usize) -> impl FnMut(usize, &str) -> Vec<f64> {
    let mut known = std::collections::BTreeMap::new();
    let mut random = Random::new(0x5ca1e);
    move |point, name| {
        assert!(point < count);
        // A layer's own scene calls its statistics `mean` and `deviation`.
        known.entry((point, name.to_owned())).or_insert_with(|| ordinary(&mut random, name)).clone()
    }
}

#[test]
fn colors_are_sums_and_products_of_layers() -> Outcome {
    let device = Device::new()?;
    let [rock, high, sand, grain] = [rock()?, high()?, sand()?, grain()?];
    let snow = Combination::color([0.9, 0.9, 0.95])?;
    let expression =
        &grain * (&rock + 0.3 * &sand) * (1.0 - &high) + snow * &high * Combination::weight("snowfall")? - 0.02;
    let module = Scene::new("hills").combination(expression).module()?;
    let count = 1000;
    let mut number = points(count);
    let combined = run(&device, &module, "hills_combined", count, &mut number)?;
    let mut layer = |scene: &Scene, own: Option<&str>, kind: &str| {
        let (module, export) = (scene.module()?, format!("{}_{kind}", scene.map().map_or("", |_| own.unwrap_or(kind))));
        let name = module.exports()[0].name.clone();
        assert!(!export.is_empty());
        run(&device, &module, &name, count, |point, name| match (own, name) {
            (Some(own), "mean" | "deviation") => number(point, &format!("{own}_{name}")),
            _ => number(point, name),
        })
    };
    let rock = layer(&rock, None, "steepness")?;
    let high = layer(&high, None, "height")?;
    let sand = layer(&sand, None, "slope")?;
    let grain = layer(&grain, Some("grain"), "texture")?;
    for point in 0..count {
        let snowfall = number(point, "snowfall")[0] as f32;
        for channel in 0..3 {
            let [rock, high, sand, grain] = [&rock, &high, &sand, &grain].map(|colors| colors[point][channel]);
            let snow = [0.9, 0.9, 0.95][channel];
            let expected = grain * (rock + 0.3 * sand) * (1.0 - high) + snow * high * snowfall - 0.02;
            let apart = (combined[point][channel] - expected).abs();
            assert!(apart < 1e-6, "point {point}: {apart:e}");
        }
    }
    Ok(())
}

/// Of a color that is the same for all slopes nothing is to be averaged together, and all of it is lit alike.
#[test]
fn constant_colors_are_lit_by_the_mean_irradiance() -> Outcome {
    let device = Device::new()?;
    let gray = ColorMap::gradient([(0.0, [0.5, 0.25, 1.0])])?;
    let irradiance =
        Scene::new("hills").irradiance(sky()?).irradiance_tier(prefilter::IrradianceTier::FourGaussians).module()?;
    let combined = Scene::new("hills").combination(Scene::new("gray").slope(gray)).irradiance(sky()?).module()?;
    let mut number = points(100);
    let lit = run(&device, &combined, "hills_lit", 100, &mut number)?;
    let light = run(&device, &irradiance, "hills_irradiance", 100, &mut number)?;
    for (lit, light) in lit.iter().zip(light) {
        for (channel, color) in [0.5, 0.25, 1.0].into_iter().enumerate() {
            assert!((lit[channel] - color * light[channel]).abs() < 1e-6, "{lit:?} {light:?}");
        }
    }
    Ok(())
}

#[test]
fn layers_are_named_and_shared_terms_evaluated_once() -> Outcome {
    let (rock, high) = (rock()?, high()?);
    let low = Scene::new("low").height(ColorMap::gradient([(0.1, [1.0; 3]), (0.3, [0.0; 3])])?);
    let module = Scene::new("hills").combination(&rock * &high + &rock * &low).module()?;
    let text = module.wgsl();
    let body = text.split("fn hills_combined").nth(1).and_then(|rest| rest.split("\n}").next()).ok_or("no body")?;
    assert_eq!(body.matches("smith_lambda_fast(").count(), 2, "{body}");
    assert_eq!(body.matches("hills_rock_steepness(").count(), 1, "{body}");
    assert_eq!(body.matches("steepness_moments(").count(), 1, "{body}");
    assert!(!body.contains("slopes_") && !body.contains("direction"), "{body}");
    let unshadowed = Microsurface { shadowing: false, ..Microsurface::default() };
    let module = Scene::new("hills").combination(&high + &low).microsurface(unshadowed).module()?;
    let signature = "fn hills_combined(mean: f32, deviation: f32, slope_covariance: vec3f, view: vec3f) -> vec3f";
    assert_eq!(module.exports()[0].signature, signature);
    assert_eq!(module.exports().len(), 1);
    Ok(())
}

#[test]
fn refuses_what_is_no_combination() -> Outcome {
    let (rock, high, sand, grain) = (rock()?, high()?, sand()?, grain()?);
    let four = Scene::new("four").slope(ColorMap::gradient([(0.0, [0.1, 0.2, 0.3, 1.0])])?);
    let other = Scene::new("rock").steepness(ColorMap::gradient([(0.5, [0.4; 3]), (0.6, [0.1; 3])])?);
    let refused = |combination: Combination, what: &str| {
        let error = Scene::new("hills").combination(combination).module().map(|_| ()).expect_err(what);
        assert!(error.to_string().contains(what), "{error}");
    };
    refused(&rock * &sand, "depend on the slopes");
    refused(&high * (1.0 - &high), "depend on the heights");
    refused(&grain * &grain, "depend on the value `grain`");
    refused(&rock + &four, "channels");
    refused(&rock + &other, "two different layers");
    refused(Combination::from(0.5) + Combination::weight("wetness")?, "no layer");
    refused(Combination::channel(&high, 0)? * 0.5, "no color");
    refused(Scene::new("sky").irradiance(sky()?).into(), "is no layer");
    refused(Scene::new("gl").steepness(rock.map().ok_or("no map")?.clone()) + 1.0, "gl");
    let scene = || Scene::new("hills").combination(&rock);
    for (scene, what) in [
        (scene().slope_tier(prefilter::SlopeTier::Pair), "a tier of slopes"),
        (scene().slope_taps(prefilter::SlopeTaps::Five), "reads of a map"),
        (scene().slope_map(flat()?), "a map of slopes"),
        (scene().texture(ColorMap::gradient([(0.0, [0.1; 3])])?), "a color map of its own"),
        (scene().irradiance_tier(prefilter::IrradianceTier::Points), "has not"),
        (rock.clone().reflectance(prefilter::Reflectance::Given), "a `reflectance`"),
    ] {
        let error = scene.module().map(|_| ()).expect_err(what);
        assert!(error.to_string().contains(what), "{error}");
    }
    assert!(Combination::weight("1st").is_err() && Combination::color([f32::NAN; 3]).is_err());
    Ok(())
}

/// Maps of the whole slope are layers, too, and lit together.
#[test]
fn maps_of_slopes_are_layers() -> Outcome {
    let device = Device::new()?;
    let (aspect, high) = (Scene::new("aspect").slope_map(flat()?), high()?);
    let module = Scene::new("hills").combination(&aspect * &high).irradiance(sky()?).module()?;
    let alone = aspect.module()?;
    let mut number = points(100);
    let combined = run(&device, &module, "hills_combined", 100, &mut number)?;
    let map = run(&device, &alone, "aspect_slope_map", 100, &mut number)?;
    let mask = run(&device, &high.module()?, "high_height", 100, &mut number)?;
    for ((combined, map), mask) in combined.iter().zip(map).zip(mask) {
        for channel in 0..3 {
            assert!((combined[channel] - map[channel] * mask[channel]).abs() < 1e-6, "{combined:?} {map:?} {mask:?}");
        }
    }
    assert!(run(&device, &module, "hills_lit", 100, &mut number)?.iter().flatten().all(|part| part.is_finite()));
    Ok(())
}

#[test]
fn an_accuracy_is_shared_among_layers() -> Outcome {
    let (high, sand) = (high()?, sand()?);
    for error in [0.1, 0.02] {
        let scene = Scene::new("hills").combination(&sand + 0.5 * &high).accuracy(Accuracy::max_filter_error(error));
        assert!(scene.module()?.bound().value() <= error, "{}", scene.module()?.explain());
    }
    let scene = Scene::new("hills").combination(&sand + &high).accuracy(Accuracy::max_filter_error(1e-6));
    assert!(scene.module().is_err());
    Ok(())
}

/// Whatever comes in, what comes out is a number.
#[test]
fn never_is_a_color_no_number() -> Outcome {
    const BATCH: usize = 100_000;
    let device = Device::new()?;
    let expression = (&grain()? + &high()?) * (&rock()? + 0.5 * &sand()?);
    let scene =
        Scene::new("hills").combination(expression).irradiance(sky()?).reflectance(prefilter::Reflectance::Lambert);
    let module = scene.module()?;
    let mut random = Random::new(0xbad);
    for export in ["hills_combined", "hills_lit", "hills_radiance"] {
        for _ in 0..any::inputs(BATCH) / BATCH {
            let colors = run(&device, &module, export, BATCH, |_, name| match name {
                "view" | "light" => any::direction(&mut random).to_vec(),
                "slope_covariance" => any::covariance(&mut random).to_vec(),
                "mean_slope" => any::slope(&mut random).to_vec(),
                "direction" | "x" | "y" | "z" => ordinary(&mut random, name),
                "radiance" => vec![1.0, 2.0, 3.0],
                _ => vec![f64::from(any::number(&mut random))],
            })?;
            assert_eq!(colors.len(), BATCH);
            assert!(colors.iter().flatten().all(|channel| channel.is_finite()), "{export}");
        }
    }
    Ok(())
}
