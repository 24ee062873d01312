//! Color by the steepness |s|: how far the distribution of Rice is from the visible slopes, on the device against the
//! f64 integral, and whether scenes keep their bounds and refuse what they would ignore.

use std::f64::consts::{FRAC_PI_2, TAU};

use prefilter::gpu::Device;
use prefilter::reference::footprint::deviations;
use prefilter::reference::slopes::Visible;
use prefilter::reference::steepness::{below, mean};
use prefilter::{Accuracy, ColorMap, Error, Scene, SlopeTier, Tier};
use spirv_tests::any;
use spirv_tests::exports::ExportKernel;
use spirv_tests::kernel::Function;
use spirv_tests::maps::named;
use spirv_tests::random::Random;
use spirv_tests::scenes;

use crate::{single, Fault, Outcome};

/// ν and σ as the shelf has them.
const CHAIN: &str = "fn asked(view: vec3f, mean_slope: vec2f, covariance: vec3f) -> vec2f {
    let square = steepness_moments(view, mean_slope, covariance);
    return steepness_rice(square.x, square.y);
}";

/// A surface seen from above its horizon, whose slopes have one deviation along an axis and `aspect` times less across.
fn seen(random: &mut Random, deviation: f64, aspect: f64, most: f64) -> Visible {
    loop {
        let (even, grazing, azimuth) = (random.unit(), random.between(1e-3, 1.0), TAU * random.unit());
        let z = random.pick([even, grazing]);
        let radius = ((1.0 - z) * (1.0 + z)).max(0.0).sqrt();
        let (any, part) = (TAU * random.unit(), random.unit());
        let turn = azimuth + random.pick([0.0, 0.25 * TAU, any]);
        let covariance = turned(deviation, aspect, turn);
        let (length, heading) = (most * random.pick([0.0, part]), TAU * random.unit());
        let mean = single([length * heading.cos(), length * heading.sin()]);
        let view = single([radius * azimuth.cos(), radius * azimuth.sin(), z]);
        let visible = Visible { view, covariance, mean };
        if visible.parameter() >= 0.0 {
            return visible;
        }
    }
}

/// Whatever the numbers, colors are finite and in the hull.
#[test]
fn colors_of_steepness_stay_in_the_hull() -> Outcome {
    let device = Device::new()?;
    let mut random = Random::new(171);
    let scene = scenes::steepnesses()?.remove(0).1;
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
            assert!(hull.contains(&color[channel]), "{call:?} gives {color:?}");
        }
    }
    Ok(())
}

/// Views along x at parameters from 0, of slopes with the deviation 0.4 along an axis at some angle with it, about
/// means towards and away from it and aside, in deviations.
fn grid(aspect: f64) -> Vec<Visible> {
    let mut views = Vec::new();
    for turn in [0.0, 0.125, 0.25, 0.5, 0.75].map(|part| part * FRAC_PI_2).into_iter().chain([FRAC_PI_2]) {
        let covariance = turned(0.4, aspect, turn);
        for place in (-8..=4).flat_map(|x| (0..=3).map(move |y| [x, y])) {
            let mean = single(place.map(|part| 0.08 * f64::from(part)));
            for parameter in [1e-3, 0.7] {
                let z = mean[0] + parameter * covariance[0].sqrt();
                let view = single([1.0 / f64::hypot(1.0, z), 0.0, z / f64::hypot(1.0, z)]);
                views.push(Visible { view, covariance, mean });
            }
        }
    }
    views
}

/// A covariance with a deviation along an axis, and `aspect` times less across.
fn turned(deviation: f64, aspect: f64, turn: f64) -> [f64; 3] {
    let (sin, cos) = turn.sin_cos();
    let [long, short] = [deviation * deviation, (deviation / aspect).powi(2)];
    single([long * cos * cos + short * sin * sin, (long - short) * sin * cos, long * sin * sin + short * cos * cos])
}

/// The largest and the root mean square error of steps at many steepnesses.
fn step_errors(device: &Device, aspect: f64, count: usize) -> Result<[f64; 2], Fault> {
    let mut random = Random::new(151);
    let views: Vec<Visible> = (0..count)
        .map(|_| {
            let deviation = random.between(0.05, 1.0);
            let most = random.pick([0.3, 3.0 * deviation]);
            seen(&mut random, deviation, aspect, most)
        })
        .chain(grid(aspect))
        .collect();
    let points: Vec<Vec<f64>> =
        views.iter().map(|visible| [&visible.view[..], &visible.mean, &visible.covariance].concat()).collect();
    let got = Function::in_text(CHAIN, "asked")?.results(device, &[], &points)?;
    assert!(!got.is_empty() && got.len() == views.len());
    let (mut worst, mut sum) = (0.0f64, 0.0);
    for (visible, rice) in views.iter().zip(&got) {
        // Within the axes of a scene's table.
        let (length, [wide, _]) = (visible.mean[0].hypot(visible.mean[1]), deviations(visible.covariance));
        assert!(rice[0] <= length + 1.35 * wide && rice[1] <= 1.25 * wide, "{visible:?}: {rice:?}");
        let variance = rice[1] * rice[1];
        let round = Visible { view: [0.0, 0.0, 1.0], covariance: [variance, 0.0, variance], mean: [rice[0], 0.0] };
        for step in 0..24 {
            let at = (rice[0] + rice[1] * 0.25 * (f64::from(step) - 11.5)).abs();
            let error = below(visible, at) - below(&round, at);
            assert!(error.is_finite(), "{visible:?}");
            worst = worst.max(error.abs());
            sum += error * error;
        }
    }
    Ok([worst, (sum / (24 * views.len()) as f64).sqrt()])
}

#[test]
fn steps_of_steepness_keep_their_figures() -> Outcome {
    let device = Device::new()?;
    for (aspect, figure) in [(1.0, 3.9e-2), (2.0, 0.105), (4.0, 0.155)] {
        let [worst, square] = step_errors(&device, aspect, 500)?;
        println!("axes of {aspect}:1: a step errs by {worst:.3e}, root mean square {square:.3e}");
        assert!(worst <= figure && 1.05 * worst >= figure, "{aspect}: {worst}");
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
        assert!(worst <= bound && naive > 2.0 * worst, "{name}: {worst} {naive}");
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
    assert!(conflict(scene()?.slope_tier(SlopeTier::Pair)).contains("goes without a tier of slopes"));
    let closed = conflict(scene()?.accuracy(Accuracy::max_filter_error(1.0).without_tables()));
    assert!(closed.contains("needs a table"), "{closed}");
    let asked = scene()?.accuracy(Accuracy::max_filter_error(1e-3)).module();
    assert!(matches!(asked, Err(Error::Accuracy { .. })));
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
