//! Scenes of steepness: whether they keep their bounds and the hull of their colors, and refuse what they would ignore.

use prefilter::gpu::Device;
use prefilter::reference::footprint::deviations;
use prefilter::reference::slopes::Visible;
use prefilter::reference::steepness::mean;
use prefilter::{Accuracy, ColorMap, Error, Ranges, Scene, SlopeTaps, SlopeTier, Tier};
use spirv_tests::any;
use spirv_tests::exports::ExportKernel;
use spirv_tests::maps::named;
use spirv_tests::random::Random;
use spirv_tests::scenes;

use crate::steepness::seen;
use crate::{Fault, Outcome};

/// Whatever the numbers, colors are finite and in the hull.
#[test]
fn colors_of_steepness_stay_in_the_hull() -> Outcome {
    let device = Device::new()?;
    let mut random = Random::new(171);
    for (name, scene) in scenes::steepnesses()? {
        let (module, (low, high)) = (scene.module()?, scene.map().ok_or("no map")?.hull());
        let calls: Vec<f32> = (0..50_000)
            .flat_map(|_| {
                let mean = [0, 1].map(|_| any::number(&mut random).clamp(-f32::MAX, f32::MAX));
                let covariance = [0, 1, 2].map(|_| any::number(&mut random));
                let view = any::direction(&mut random).map(|part| part as f32);
                [&mean[..], &covariance, &view].concat()
            })
            .collect();
        let colors = ExportKernel::new(&device, &module, &module.exports()[0])?.run(&calls)?;
        assert_eq!(colors.len(), 50_000);
        for (color, call) in colors.iter().zip(calls.chunks(8)) {
            for channel in 0..3 {
                let hull = low[channel] - 5e-4..=high[channel] + 5e-4;
                assert!(hull.contains(&color[channel]), "{name}: {call:?} gives {color:?}");
            }
        }
    }
    Ok(())
}

#[test]
fn every_scene_of_steepness_keeps_its_bound() -> Outcome {
    let device = Device::new()?;
    for (name, scene) in scenes::steepnesses()? {
        let (module, map, ranges) = (scene.module()?, scene.map().ok_or("no map")?, scene.chosen_ranges());
        let mut random = Random::new(161);
        let calls: Vec<Visible> = (0..150)
            .map(|_| {
                let deviation = random.between(2e-3, ranges.deviation.into());
                let aspect = random.between(1.0, 2.0);
                seen(&mut random, deviation, aspect, ranges.mean.1.into())
            })
            .collect();
        let numbers = |visible: &Visible| [&visible.mean[..], &visible.covariance, &visible.view].concat();
        let numbers: Vec<f32> = calls.iter().flat_map(numbers).map(|value| value as f32).collect();
        let colors = ExportKernel::new(&device, &module, &module.exports()[0])?.run(&numbers)?;
        assert!(!colors.is_empty() && colors.len() == calls.len());
        let (reference, bound) = (map.reference(), f64::from(module.bound().value()));
        let [mut worst, mut naive] = [0.0f64; 2];
        for (color, visible) in colors.iter().zip(&calls) {
            assert!(deviations(visible.covariance)[0] <= 1.01 * f64::from(ranges.deviation));
            let truth = mean(&reference, visible);
            let plain = reference.value(visible.mean[0].hypot(visible.mean[1]));
            for channel in 0..map.channels() {
                worst = worst.max((f64::from(color[channel]) - truth[channel]).abs());
                naive = naive.max((plain[channel] - truth[channel]).abs());
            }
        }
        let table = module.tables()[0].error;
        println!("{name}: {worst:.2e}, bound {bound:.2e}, table {table:.1e}; at the mean slope {naive:.2e}");
        let filtered = name != "steepness_naive";
        assert!(worst <= bound && (naive > 2.0 * worst) == filtered, "{name}: {worst} {naive}");
    }
    Ok(())
}

#[test]
fn scenes_of_steepness_refuse_what_they_would_ignore() -> Outcome {
    let scene = || Ok::<_, Fault>(Scene::new("cliff").steepness(named("terrain")?));
    let conflict = |scene: Scene| match scene.module() {
        Err(Error::Conflict(message)) => message,
        other => format!("no conflict: {:?}", other.map(|module| module.explain().to_owned())),
    };
    let two = conflict(scene()?.slope(named("terrain")?));
    assert!(two.contains("more than one filter, a `slope` and a `steepness`"), "{two}");
    assert!(conflict(scene()?.tier(Tier::Table)).contains("a `steepness` goes without a color map's tier"));
    assert!(conflict(scene()?.slope_tier(SlopeTier::Unweighted)).contains("goes without a tier of slopes"));
    let closed = conflict(scene()?.accuracy(Accuracy::max_filter_error(1.0).without_tables()));
    assert!(closed.contains("needs a table"), "{closed}");
    let none = conflict(scene()?.slope_tier(SlopeTier::Pair).slope_taps(SlopeTaps::Eleven));
    assert!(none.contains("a `steepness` goes without two normal distributions by eleven reads"), "{none}");
    // The accuracy chooses, and asks for what there is none of.
    for (error, label) in
        [(0.35, "one distribution of Rice"), (0.15, "three distributions of Rice"), (0.08, "ten distributions of Rice")]
    {
        let module = scene()?.accuracy(Accuracy::max_filter_error(error)).module()?;
        assert!(module.explain().contains(label) && module.bound().value() <= error, "{}", module.explain());
    }
    // Ranges are those of the mean slope's length and of the widest deviation.
    let ranged = scene()?.ranges(Ranges { mean: (0.0, 0.5), deviation: 0.2 }).module()?;
    assert!(ranged.explain().contains("means 0 to 0.5, deviations to 0.2"), "{}", ranged.explain());
    let asked = scene()?.accuracy(Accuracy::max_filter_error(1e-3)).module();
    assert!(matches!(asked, Err(Error::Accuracy { .. })));
    // Ranges are its own.
    let narrow = scene()?.ranges(Ranges { mean: (0.0, 0.5), deviation: 0.1 }).module()?;
    assert!(narrow.explain().contains("means 0 to 0.5, deviations to 0.1"), "{}", narrow.explain());
    // Scenes stored before there was steepness still load.
    let older = Scene::new("rock").texture(named("terrain")?);
    let mut file = serde_json::to_value(&older)?;
    assert!(file.as_object_mut().ok_or("an object")?.remove("steepness").is_some());
    assert_eq!(serde_json::from_value::<Scene>(file)?, older);
    Ok(())
}

#[test]
fn flat_maps_of_steepness_are_exact() -> Outcome {
    let device = Device::new()?;
    let map = ColorMap::gradient([(0.4, [0.2, 0.5, 0.75]), (0.8, [0.2, 0.5, 0.75])])?;
    let module = Scene::new("plain").steepness(map).module()?;
    let call = [0.1, 0.2, 0.04, 0.01, 0.09, 0.6, 0.0, 0.8];
    let colors = ExportKernel::new(&device, &module, &module.exports()[0])?.run(&call)?;
    for (got, flat) in colors[0].iter().zip([0.2f32, 0.5, 0.75]) {
        assert!((got - flat).abs() < 2e-4, "{colors:?}");
    }
    Ok(())
}

/// What the README says of the default tier.
#[test]
fn the_readme_quotes_the_cost() -> Outcome {
    let cost = Scene::new("quoting").steepness(named("terrain")?).module()?.cost();
    let said = format!("takes one fetch of {} KiB and {} operations", cost.table_bytes / 1024, cost.operations);
    assert!(cost.fetches == 1 && include_str!("../../../README.md").contains(&said), "the README lacks: {said}");
    Ok(())
}
