//! Scenes of slopes: what they export, choose, leave out and refuse; any numbers for inputs.

use prefilter::gpu::Device;
use prefilter::{Accuracy, ColorMap, Driver, Error, HeightTier, Kernel, Microsurface, Moments, Scene, SlopeTier, Tier};
use spirv_tests::any;
use spirv_tests::exports::ExportKernel;
use spirv_tests::maps::named;
use spirv_tests::random::Random;
use spirv_tests::scenes;

use crate::Outcome;

#[test]
fn what_is_off_leaves_no_trace() -> Outcome {
    let scene = Scene::new("moss").slope(named("terrain")?).tier(Tier::Naive);
    let signature = |tier| {
        let module = scene.clone().slope_tier(tier).module()?;
        let exports = module.exports();
        assert_eq!(exports.len(), 1, "{tier}");
        Ok::<_, Error>((exports[0].signature.clone(), module.wgsl().to_owned()))
    };
    let (flat, text) = signature(SlopeTier::Unweighted)?;
    assert_eq!(flat, "fn moss_slope(mean_slope: vec2f, slope_covariance: vec3f, direction: vec2f) -> vec3f");
    assert!(!text.contains("slopes_") && !text.contains("view"), "{text}");
    let viewed = "fn moss_slope(mean_slope: vec2f, slope_covariance: vec3f, view: vec3f, direction: vec2f) -> vec3f";
    let (naive, text) = signature(SlopeTier::Naive)?;
    assert!(naive == viewed && !text.contains("slopes_") && text.contains("_texture(dot(direction, mean_slope), 0.0)"));
    let (one, text) = signature(SlopeTier::Gaussian)?;
    assert!(one == viewed && !text.contains("slopes_pair") && !text.contains("slopes_area"), "{text}");
    let (two, text) = signature(SlopeTier::Pair)?;
    assert!(two == viewed && text.contains("if parameter < slopes_single") && !text.contains("slopes_skewness"));
    // The whole chain of a tier without tables.
    assert!(text.lines().filter(|line| !line.trim_start().starts_with("//")).count() <= 120, "{text}");
    Ok(())
}

#[test]
fn the_accuracy_chooses_among_tiers_of_slopes() -> Outcome {
    let ramp = ColorMap::gradient([(-0.5, [0.1, 0.3, 0.4]), (0.5, [0.9, 0.6, 0.2])])?;
    let rock = |error: f32| Scene::new("rock").slope(ramp.clone()).accuracy(Accuracy::max_filter_error(error));
    for (error, tier) in [(0.05, "one normal distribution over"), (0.02, "two normal distributions over")] {
        let module = rock(error).module()?;
        assert!(module.bound().value() <= error);
        assert!(module.explain().starts_with(&format!("rock: slope (Cs) by {tier}")), "{}", module.explain());
    }
    assert!(matches!(rock(1e-3).module(), Err(Error::Accuracy { .. })));
    // Whoever asks for none takes what there is.
    let default = Scene::new("rock").slope(ramp.clone()).module()?;
    assert!(default.explain().contains("rock: slope (Cs) by two") && default.explain().contains("near the closest"));
    // A tier of slopes that is named leaves the color map's to the accuracy.
    let one = rock(1e-3).slope_tier(SlopeTier::Gaussian).module()?;
    assert!(one.explain().contains("the tier of slopes; that of the color map is the lightest"), "{}", one.explain());
    Ok(())
}

#[test]
fn scenes_that_cannot_be_are_refused() -> Outcome {
    let scene = || Ok::<_, crate::Fault>(Scene::new("rock").slope(named("terrain")?));
    let conflict = |scene: Scene| match scene.module() {
        Err(Error::Conflict(message)) => message,
        other => format!("no conflict: {:?}", other.map(|module| module.explain().to_owned())),
    };
    let both = conflict(scene()?.texture(named("terrain")?));
    assert!(both.contains("more than one filter"), "{both}");
    let driven = conflict(scene()?.driver(Driver::Moments(Moments::default())));
    assert!(driven.contains("goes without a driver that gives mean and deviation"), "{driven}");
    assert!(conflict(scene()?.height_tier(HeightTier::Gaussian)).contains("without a tier of heights"));
    let hidden = Microsurface { shadowing: false, ..Microsurface::default() };
    assert!(conflict(scene()?.microsurface(hidden)).contains("without a `microsurface`"));
    Ok(())
}

/// Scenes stored before there were slopes still load.
#[test]
fn older_files_load() -> Outcome {
    let scene = Scene::new("rock").texture(named("terrain")?);
    let mut file = serde_json::to_value(&scene)?;
    let fields = file.as_object_mut().ok_or("an object")?;
    for new in ["slope", "slope_tier"] {
        assert!(fields.remove(new).is_some(), "{new}");
    }
    assert_eq!(serde_json::from_value::<Scene>(file)?, scene);
    Ok(())
}

/// Any finite number, or any that is not NaN.
fn any_number(random: &mut Random, infinite: bool) -> f32 {
    let value = any::number(random);
    if value.is_infinite() && !infinite {
        0.5
    } else {
        value
    }
}

/// Inputs of one call: means and vectors are finite, variances may be anything.
fn any_call(random: &mut Random, viewed: bool) -> Vec<f32> {
    let mut call: Vec<f32> = (0..5).map(|number| any_number(random, number >= 2)).collect();
    if viewed {
        call.extend(any::direction(random).map(|part| part as f32));
    }
    call.extend((0..2).map(|_| any_number(random, false).clamp(-1.0, 1.0)));
    call
}

/// Whatever the numbers, colors are finite and in the hull.
#[test]
fn colors_stay_in_the_hull() -> Outcome {
    const BATCH: usize = 100_000;
    let device = Device::new()?;
    let mut random = Random::new(91);
    for (name, scene) in scenes::slopes()? {
        let (module, map) = (scene.module()?, scene.map().ok_or("no map")?);
        let export = &module.exports()[0];
        let viewed = export.signature.contains("view:");
        let kernel = ExportKernel::new(&device, &module, export)?;
        let (low, high) = map.hull();
        let slack = if module.tables().is_empty() { 0.0 } else { 5e-4 };
        for _ in 0..any::inputs(BATCH) / BATCH {
            let calls: Vec<Vec<f32>> = (0..BATCH).map(|_| any_call(&mut random, viewed)).collect();
            let colors = kernel.run(&calls.concat())?;
            assert_eq!(colors.len(), BATCH);
            for (color, call) in colors.iter().zip(&calls) {
                for channel in 0..3 {
                    let hull = low[channel] - slack..=high[channel] + slack;
                    assert!(hull.contains(&color[channel]), "{name}: {call:?} gives {color:?}");
                }
            }
        }
    }
    Ok(())
}

/// Half a direction asks for half the component.
#[test]
fn directions_may_be_shorter_than_one() -> Outcome {
    let device = Device::new()?;
    let step = |at: f32| ColorMap::bands([0.0; 3], [(at, [1.0; 3])]);
    let surface = [0.3, -0.1, 0.1, 0.04, 0.08, 0.8, 0.0, 0.6];
    for tier in [SlopeTier::Unweighted, SlopeTier::Gaussian, SlopeTier::Pair] {
        let color = |at: f32, direction: [f32; 2]| {
            let scene = Scene::new("dune").slope(step(at)?).slope_tier(tier).tier(Tier::ClosedForm(Kernel::Exact));
            let (module, viewed) = (scene.module()?, if tier == SlopeTier::Unweighted { 5 } else { 8 });
            let numbers = [&surface[..viewed], &direction].concat();
            let colors = ExportKernel::new(&device, &module, &module.exports()[0])?.run(&numbers)?;
            Ok::<_, crate::Fault>(colors[0][0])
        };
        let (whole, half) = (color(0.2, [0.6, 0.8])?, color(0.1, [0.3, 0.4])?);
        assert!(whole > 0.1 && whole < 0.9 && (whole - half).abs() < 1e-5, "{tier}: {whole} {half}");
    }
    Ok(())
}
