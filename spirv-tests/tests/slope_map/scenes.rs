//! Scenes of maps of the whole slope: do they keep their bounds, stay in the hull, choose and refuse as they say?

use prefilter::gpu::Device;
use prefilter::reference::footprint::deviations;
use prefilter::reference::slopes::Visible;
use prefilter::{
    Accuracy, Bound, Error, Irradiance, Kernel, Ranges, Scene, SlopeDomain, SlopeMap, SlopeTaps, SlopeTier,
};
use prefilter::{Driver, Moments, Tier};
use spirv_tests::any;
use spirv_tests::exports::ExportKernel;
use spirv_tests::random::Random;
use spirv_tests::scenes;

use crate::{edges, seen, Fault, Outcome};

/// The largest errors of a scene's colors against the means over the visible and over all slopes, and of the color of
/// the mean slope.
fn errors(device: &Device, scene: &Scene, map: &SlopeMap, calls: &[Visible]) -> Result<[f64; 3], Fault> {
    let module = scene.module()?;
    let export = &module.exports()[0];
    let viewed = export.signature.contains("view:");
    let numbers = |visible: &Visible| {
        let view = if viewed { &visible.view[..] } else { &[] };
        [&visible.mean[..], &visible.covariance, view].concat()
    };
    let numbers: Vec<f32> = calls.iter().flat_map(numbers).map(|value| value as f32).collect();
    let colors = ExportKernel::new(device, &module, export)?.run(&numbers)?;
    assert!(!colors.is_empty() && colors.len() == calls.len());
    let (reference, mut worst) = (map.reference(), [0.0f64; 3]);
    for (color, visible) in colors.iter().zip(calls) {
        let seen = reference.mean_visible(visible);
        let all = reference.mean(visible.mean, visible.covariance);
        let naive = reference.value(visible.mean);
        for channel in 0..map.channels() {
            let got = f64::from(color[channel]);
            for (worst, apart) in
                worst.iter_mut().zip([got - seen[channel], got - all[channel], naive[channel] - seen[channel]])
            {
                assert!(apart.is_finite(), "{visible:?}: {color:?}");
                *worst = worst.max(apart.abs());
            }
        }
    }
    Ok(worst)
}

/// Views of slopes within the usual ranges, from the floor of their deviations on and with axes of ratios up to 2.
fn calls(seed: u32, count: usize) -> Vec<Visible> {
    let mut random = Random::new(seed);
    let call = |_| {
        let aspect = random.between(1.0, 2.0);
        let deviation = random.between(0.12 * aspect, 0.5);
        seen(&mut random, deviation, aspect, 1.0)
    };
    (0..count).map(call).collect()
}

#[test]
fn every_scene_of_slope_maps_keeps_its_bound() -> Outcome {
    let device = Device::new()?;
    for (seed, (name, scene)) in (41..).zip(scenes::slope_maps()?) {
        let map = scene.map_of_slopes().ok_or("no map")?;
        let calls = calls(seed, 60);
        assert!(calls.iter().all(|visible| deviations(visible.covariance)[0] <= 0.501));
        let bound = scene.module()?.bound();
        let [seen, all, naive] = errors(&device, &scene, map, &calls)?;
        println!("{name}: {seen:.2e}, bound {bound}; over all slopes {all:.2e}, the mean slope errs by {naive:.2e}");
        assert!(matches!(bound, Bound::Estimated(_)) && seen <= f64::from(bound.value()), "{name}: {seen}");
        assert!(naive > 4.0 * seen || name == "slope_map_unweighted", "{name}: {naive}");
        // What counts all slopes alike is the table over them.
        assert!(if name == "slope_map_unweighted" { all < 0.05 } else { all > 4.0 * seen }, "{name}: {all}");
    }
    Ok(())
}

/// Maps with many edges: colors at random.
#[test]
fn random_maps_keep_their_bounds() -> Outcome {
    let device = Device::new()?;
    for (seed, domain) in [(51, SlopeDomain::Within(1.2)), (52, SlopeDomain::All), (53, SlopeDomain::Within(0.5))] {
        let mut random = Random::new(seed);
        let texels: Vec<[f32; 4]> = (0..81).map(|_| [0, 1, 2, 3].map(|_| random.unit() as f32)).collect();
        let at = |part: f32| (4.5 + 9.0 * part.clamp(-0.499, 0.499)) as usize;
        let color = |[x, y]: [f32; 2]| texels[at(0.7 * x) + 9 * at(0.7 * y)];
        let map = SlopeMap::from_function(64, domain, color)?;
        let calls = calls(seed, 40);
        for (tier, taps) in [
            (SlopeTier::Gaussian, SlopeTaps::One),
            (SlopeTier::Gaussian, SlopeTaps::Three),
            (SlopeTier::Pair, SlopeTaps::Three),
            (SlopeTier::Pair, SlopeTaps::Five),
            (SlopeTier::Pair, SlopeTaps::Seven),
            (SlopeTier::Pair, SlopeTaps::Eleven),
        ] {
            let scene = Scene::new("judged").slope_map(map.clone()).slope_tier(tier).slope_taps(taps);
            let (bound, [found, _, _]) = (scene.module()?.bound(), errors(&device, &scene, &map, &calls)?);
            println!("seed {seed}, {tier} by {taps}: {found:.2e}, bound {bound}");
            assert!(found <= f64::from(bound.value()), "seed {seed}, {tier} by {taps}: {found:e} exceeds {bound}");
        }
    }
    Ok(())
}

/// Whatever the numbers, colors are finite and in the hull.
#[test]
fn colors_of_slope_maps_stay_in_the_hull() -> Outcome {
    const BATCH: usize = 100_000;
    let device = Device::new()?;
    let mut random = Random::new(61);
    for (name, scene) in scenes::slope_maps()? {
        let (module, map) = (scene.module()?, scene.map_of_slopes().ok_or("no map")?);
        let export = &module.exports()[0];
        let viewed = export.signature.contains("view:");
        let kernel = ExportKernel::new(&device, &module, export)?;
        let (low, high) = map.hull();
        for _ in 0..any::inputs(BATCH) / BATCH {
            let calls: Vec<Vec<f32>> = (0..BATCH)
                .map(|_| {
                    let raw = [0, 1].map(|_| any::number(&mut random).clamp(-f32::MAX, f32::MAX));
                    let mean = if random.unit() < 0.5 { raw } else { any::slope(&mut random).map(|part| part as f32) };
                    let bits = [0, 1, 2].map(|_| any::number(&mut random));
                    let usual = any::covariance(&mut random).map(|part| part as f32);
                    let covariance = random.pick([bits, usual]);
                    let view = any::direction(&mut random).map(|part| part as f32);
                    [&mean[..], &covariance, if viewed { &view } else { &[] }].concat()
                })
                .collect();
            let colors = kernel.run(&calls.concat())?;
            assert_eq!(colors.len(), BATCH);
            for (color, call) in colors.iter().zip(&calls) {
                for channel in 0..map.channels() {
                    let hull = low[channel] - 5e-4..=high[channel] + 5e-4;
                    assert!(hull.contains(&color[channel]), "{name}: {call:?} gives {color:?}");
                }
            }
        }
    }
    Ok(())
}

/// A map of one color gives that color, of any slopes, and hardly varying slopes the map itself.
#[test]
fn limits_are_the_map_itself() -> Outcome {
    let device = Device::new()?;
    let color = [0.25, 0.5, 0.75];
    let flat = SlopeMap::from_texels(3, 1.0, &[color; 9])?;
    let ramp = SlopeMap::from_function(128, SlopeDomain::All, |[x, y]| [x.clamp(-1.0, 1.0), y.clamp(-1.0, 1.0), 0.5])?;
    for taps in [SlopeTaps::One, SlopeTaps::Three, SlopeTaps::Five, SlopeTaps::Seven, SlopeTaps::Eleven] {
        let scene =
            |map: &SlopeMap| Scene::new("plain").slope_map(map.clone()).slope_tier(SlopeTier::Pair).slope_taps(taps);
        let module = scene(&flat).module()?;
        let kernel = ExportKernel::new(&device, &module, &module.exports()[0])?;
        let calls = [[0.3, -2.0, 0.2, 0.1, 0.3, 0.6, 0.0, 0.8], [1e30, 0.0, 1e9, 0.0, 0.0, 0.0, 0.0, 1.0]];
        for found in kernel.run(calls.as_flattened())? {
            assert!((0..3).all(|channel| (found[channel] - color[channel]).abs() < 1e-6), "{found:?}");
        }
        let module = scene(&ramp).module()?;
        let kernel = ExportKernel::new(&device, &module, &module.exports()[0])?;
        let found = kernel.run(&[0.41, -0.23, 1e-10, 0.0, 1e-10, 0.0, 0.6, 0.8])?[0];
        assert!((found[0] - 0.41).abs() < 1e-3 && (found[1] + 0.23).abs() < 1e-3, "{found:?}");
    }
    Ok(())
}

#[test]
fn the_accuracy_chooses_among_tiers_and_reads() -> Outcome {
    let map = edges(32, SlopeDomain::Within(1.0), 0.3)?;
    let scene = |error: f32| Scene::new("rock").slope_map(map.clone()).accuracy(Accuracy::max_filter_error(error));
    for (error, choice) in [
        (0.4, "one normal distribution by one read"),
        (0.12, "one normal distribution by three reads"),
        (0.05, "two normal distributions by five reads"),
        (0.03, "two normal distributions by seven reads"),
    ] {
        let module = scene(error).module()?;
        assert!(module.bound().value() <= error);
        assert!(module.explain().starts_with(&format!("rock: slope map (Cs) by {choice}")), "{}", module.explain());
    }
    assert!(matches!(scene(1e-3).module(), Err(Error::Accuracy { .. })));
    // Whoever asks for none takes the closest.
    let closest = Scene::new("rock").slope_map(map.clone()).module()?;
    assert!(closest.explain().starts_with("rock: slope map (Cs) by two normal distributions by eleven reads"));
    assert!(closest.explain().contains("at most twice as large along an axis as across"), "{}", closest.explain());
    let named = Scene::new("rock").slope_map(map.clone()).slope_tier(SlopeTier::Pair).slope_taps(SlopeTaps::One);
    assert!(named.module()?.explain().contains("chosen  the scene names this tier"));
    Ok(())
}

#[test]
fn scenes_of_slope_maps_refuse_what_they_would_ignore() -> Outcome {
    let map = edges(8, SlopeDomain::All, 0.3)?;
    let scene = || Scene::new("rock").slope_map(map.clone());
    let conflict = |scene: Scene| match scene.module() {
        Err(Error::Conflict(message)) => message,
        other => format!("no conflict: {:?}", other.map(|module| module.explain().to_owned())),
    };
    let sky = Irradiance::from_harmonics([[1.0; 3]; 9])?;
    assert!(conflict(scene().irradiance(sky)).contains("more than one filter, a `slope_map` and `irradiance`"));
    assert!(conflict(scene().tier(Tier::ClosedForm(Kernel::Exact))).contains("goes without a color map's tier"));
    assert!(conflict(scene().driver(Driver::Moments(Moments::default()))).contains("goes without a driver"));
    assert!(conflict(scene().accuracy(Accuracy::default().without_tables())).contains("needs a table"));
    let light = Scene::new("rock").irradiance(sky).slope_taps(SlopeTaps::Three);
    let naive = scene().slope_tier(SlopeTier::Naive);
    assert_eq!(naive.module()?.cost().fetches, 1);
    assert!(conflict(naive.slope_taps(SlopeTaps::Five)).contains("the mean slope goes without five reads"));
    assert!(conflict(light).contains("goes without three reads from a table of slopes"));
    // Ranges are its own.
    let narrow = scene().ranges(Ranges { mean: (-0.1, 0.1), deviation: 0.1 }).slope_tier(SlopeTier::Pair);
    assert!(narrow.slope_taps(SlopeTaps::Three).module()?.explain().contains("means -0.1 to 0.1, deviations to 0.1"));
    Ok(())
}

#[test]
fn maps_of_slopes_go_through_files() -> Outcome {
    let map = edges(6, SlopeDomain::Within(0.7), 0.3)?;
    let scene = Scene::new("rock").slope_map(map.clone()).slope_taps(SlopeTaps::Five);
    let text = serde_json::to_string(&scene)?;
    assert_eq!(serde_json::from_str::<Scene>(&text)?, scene);
    let mut file = serde_json::to_value(&map)?;
    file["colors"][7][1] = 1e9.into();
    let refused = serde_json::from_value::<SlopeMap>(file).map_or_else(|error| error.to_string(), |_| String::new());
    assert!(refused.contains("column 1 of row 1"), "{refused}");
    // Scenes stored before there were maps of slopes still load.
    let older = Scene::new("rock").irradiance(Irradiance::from_harmonics([[1.0; 3]; 9])?);
    let mut file = serde_json::to_value(&older)?;
    for new in ["slope_map", "slope_taps"] {
        assert!(file.as_object_mut().is_some_and(|fields| fields.remove(new).is_some()), "{new}");
    }
    assert_eq!(serde_json::from_value::<Scene>(file)?, older);
    Ok(())
}

/// A combination evaluates the layer as its scene does, with the view's share that all layers have.
#[test]
fn maps_of_slopes_are_layers() -> Outcome {
    let device = Device::new()?;
    let map = edges(32, SlopeDomain::Within(1.0), 0.3)?;
    let rock = Scene::new("rock").slope_map(map).slope_tier(SlopeTier::Pair).slope_taps(SlopeTaps::Three);
    let whole = Scene::new("hill").combination(0.5 * &rock).module()?;
    let call = [0.2, -0.1, 0.09, 0.02, 0.06, 0.6, 0.48, 0.64];
    let [alone, half] = [rock.module()?, whole].map(|module| {
        let kernel = ExportKernel::new(&device, &module, &module.exports()[0])?;
        Ok::<_, Fault>(kernel.run(&call)?[0])
    });
    let (alone, half) = (alone?, half?);
    assert!(alone[..3].iter().all(|channel| *channel > 0.01), "{alone:?}");
    assert!((0..3).all(|channel| (0.5 * alone[channel] - half[channel]).abs() < 1e-6), "{alone:?} {half:?}");
    Ok(())
}

/// A gray of 127 in sRGB is 0.2122 of the light; what is clear has none.
#[test]
fn images_of_spheres_are_maps() -> Outcome {
    let gray = image::DynamicImage::ImageRgb8(image::RgbImage::from_pixel(8, 8, image::Rgb([127, 127, 127])));
    let map = SlopeMap::image_normals(16, &gray)?;
    assert_eq!((map.size(), map.channels(), map.domain()), (16, 3, SlopeDomain::All));
    assert!(map.hull().0[..3].iter().chain(&map.hull().1[..3]).all(|value| (value - 0.2122).abs() < 1e-3));
    let clear = image::DynamicImage::ImageRgba8(image::RgbaImage::from_pixel(8, 8, image::Rgba([127, 127, 127, 0])));
    let map = SlopeMap::image_normals(16, &clear)?;
    assert_eq!((map.channels(), map.hull()), (4, ([0.0; 4], [0.0; 4])));
    Ok(())
}
