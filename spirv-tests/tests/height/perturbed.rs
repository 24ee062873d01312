//! Heights with noise on them.

use prefilter::gpu::Device;
use prefilter::reference::height::mean_by_parts;
use prefilter::reference::heights::perturbed_cumulative;
use prefilter::reference::perturbed::{mean as perturbed_mean, over_heights, over_noise};
use prefilter::{ColorMap, Colors, Error, HeightTier, Microsurface, Ranges, Scene};
use spirv_tests::exports::ExportKernel;
use spirv_tests::maps::{named, random};
use spirv_tests::random::Random;

use crate::{calls, error, Call, Outcome, EXACT};

fn noisy() -> Microsurface {
    Microsurface { perturbed: true, ..Microsurface::default() }
}

/// The calls with a random share of their variance, from none to all of it, made noise.
pub fn perturbed(numbers: &mut Random, ranges: Ranges, calls: impl Iterator<Item = Call>) -> Vec<Call> {
    let (low, high) = ranges.mean;
    let mut one = |call: Call| {
        let (mean, share) = (f64::from(low) + numbers.unit() * f64::from(high - low), numbers.unit());
        let share = numbers.pick([share, share, 1.0 - 1e-4 * share, 1e-4 * share]);
        call.perturbed(mean as f32, share)
    };
    calls.map(&mut one).collect()
}

/// Question 1: both orders of integration agree, and so does the integral by parts of what noise leaves of a step.
#[test]
fn references_agree() -> Outcome {
    let mut numbers = Random::new(5);
    for map in [named("terrain")?, named("steps6")?, random(5, true, 3)?] {
        let map = map.reference();
        for lambda in [0.0, 0.4, 30.0, 1e4] {
            let (at, deviation) = (2.0 * numbers.unit() - 0.7, 0.02 + 0.3 * numbers.unit());
            for ratio in [0.5, 0.8, 1.0, 1.4] {
                let noise = [0.3 * numbers.unit(), ratio * deviation];
                let one = over_noise(&map, at, deviation, lambda, noise);
                let other = over_heights(&map, at, deviation, lambda, noise);
                assert!((0..4).all(|channel| (one[channel] - other[channel]).abs() < 1e-9), "{one:?} {other:?}");
            }
            // Without noise, and with nothing but noise.
            let none = perturbed_mean(&map, at, deviation, lambda, [0.1, 0.0]);
            let plain = mean_by_parts(&map, at + 0.1, deviation, lambda);
            assert!((0..4).all(|channel| (none[channel] - plain[channel]).abs() < 1e-9), "{none:?} {plain:?}");
        }
    }
    let step = ColorMap::bands([0.0; 3], [(0.5, [1.0; 3])])?.reference();
    for (lambda, noise) in [(0.7, 0.05), (60.0, 0.3), (3000.0, 0.01)] {
        let [above, ..] = perturbed_mean(&step, 0.2, 0.1, lambda, [0.04, noise]);
        let below = perturbed_cumulative((0.5 - 0.24) / 0.1, lambda, noise / 0.1);
        assert!((above + below - 1.0).abs() < 1e-10, "{above} {below}");
    }
    Ok(())
}

/// The largest error of a step at a Λ with noise of so many deviations of the heights.
fn step_error(device: &Device, tier: HeightTier, lambda: f64, noise: f64) -> Result<f64, crate::Fault> {
    let step = ColorMap::bands([0.0; 3], [(0.0, [1.0; 3])])?;
    let ranges = Ranges { mean: (-7.0, 3.0), deviation: 2.0 };
    let scene = Scene::new("edge").height(step).height_tier(tier).ranges(ranges).microsurface(noisy());
    let scene = if tier == HeightTier::ClosedForm { scene } else { scene.tier(EXACT) };
    let module = scene.module()?;
    // A light overhead hides nothing, and near the horizon Λ is 1/(2 √π a) − 1/2.
    let z = 0.5 * std::f64::consts::FRAC_1_SQRT_2 / std::f64::consts::PI.sqrt() / (lambda + 0.5);
    let view = [(1.0 - z * z).sqrt(), 0.0, z].map(|value| value as f32);
    let calls = (-60..=120).map(|at| {
        let call = Call::new(-0.05 * at as f32, 1.0, [0.25, 0.0, 0.25], view, [0.0, 0.0, 1.0]);
        Call { noise: [0.0, noise as f32], ..call }
    });
    let calls: Vec<Call> = calls.collect();
    let numbers: Vec<f32> = calls.iter().flat_map(|call| call.arguments(&module.exports()[0].signature)).collect();
    let colors = ExportKernel::new(device, &module, &module.exports()[0])?.run(&numbers)?;
    let errors = colors.iter().zip(&calls).map(|(color, call)| {
        let below = perturbed_cumulative(f64::from(-call.numbers[0]), call.lambda, f64::from(call.noise[1]));
        (1.0 - below - f64::from(color[0])).abs()
    });
    assert_eq!(colors.len(), calls.len());
    Ok(errors.fold(0.0, f64::max))
}

/// Noise enlarges no step error of a normal distribution, as a mean of differences is no larger than the largest of
/// them; it shrinks it.
///
/// Source of what one normal distribution errs by: numerics/height.md, section 3.3.
#[test]
fn noise_enlarges_no_step_error() -> Outcome {
    let device = Device::new()?;
    for tier in [HeightTier::Paper, HeightTier::Gaussian] {
        for lambda in [0.3, 1.0, 10.0, 100.0, 9000.0] {
            let errors = [0.0, 0.1, 0.25, 0.5, 1.0].map(|noise| step_error(&device, tier, lambda, noise));
            let errors = errors.into_iter().collect::<Result<Vec<f64>, _>>()?;
            println!("{tier}, lambda {lambda}: {errors:.5?} with noise of 0, 0.1, 0.25, 0.5, 1 deviations");
            // What rounding may add, of 2e-7 a step and 6e-8 a mean.
            assert!(errors.windows(2).all(|pair| pair[1] <= pair[0] + 1e-6), "{tier}, {lambda}: {errors:?}");
            assert!(errors[4] < 0.7 * errors[0], "{tier}, {lambda}: {errors:?}");
        }
    }
    for (lambda, noise, known) in [(1.0, 0.5, 5.8e-3), (10.0, 0.25, 2.2e-2), (100.0, 0.5, 1.2e-2)] {
        let found = step_error(&device, HeightTier::Gaussian, lambda, noise)?;
        // The notes have the moments closer than the tier: by 9e-4 of a mean and of a deviation.
        assert!((found - known).abs() < 1e-3, "{lambda}, {noise}: {found}");
    }
    Ok(())
}

/// It enlarges that of skewed heights, whose family the sum leaves; the tails follow.
#[test]
fn skewed_heights_keep_their_figures_with_noise() -> Outcome {
    let device = Device::new()?;
    for (lambda, figure) in [(0.3, 2e-4), (10.0, 6e-4), (100.0, 7e-4), (9999.0, 8.8e-4)] {
        let errors =
            [0.107, 0.2, 0.28, 0.36, 0.5, 1.0].map(|noise| step_error(&device, HeightTier::ClosedForm, lambda, noise));
        let worst = errors.into_iter().collect::<Result<Vec<f64>, _>>()?.into_iter().fold(0.0, f64::max);
        println!("skewed heights, lambda {lambda}: {worst:.2e} with noise of 0.107 to 1 deviations");
        assert!(worst <= figure && worst > 0.5 * figure, "{lambda}: {worst:e}");
    }
    Ok(())
}

#[test]
fn random_maps_keep_their_bounds() -> Outcome {
    let device = Device::new()?;
    for seed in 0..3 {
        let mut numbers = Random::new(seed);
        let map = random(2 + 2 * seed as usize, seed % 2 == 0, seed)?;
        let ranges = Ranges { mean: (-0.5, 1.5), deviation: 0.5 };
        let flat = calls(&mut numbers, &map, ranges, 1.6e-3, 150);
        let calls = perturbed(&mut numbers, ranges, flat.into_iter());
        for colors in [Colors::Constant, Colors::Dynamic] {
            let scene = Scene::new("judged").height(map.clone()).ranges(ranges).colors(colors).microsurface(noisy());
            let fast = (colors == Colors::Constant).then_some(HeightTier::ClosedFormFast);
            for tier in [HeightTier::Skewed, HeightTier::ClosedForm].into_iter().chain(fast) {
                let scene = scene.clone().height_tier(tier);
                let (bound, found) = (scene.module()?.bound(), error(&device, &scene, &calls)?);
                println!("seed {seed}, {tier}, {colors:?}: {found:.2e}, bound {bound}");
                let judged = f64::from(bound.value());
                assert!(found <= judged, "seed {seed}, {tier}, {colors:?}: {found:e} exceeds {bound}");
            }
        }
        for tier in [HeightTier::Paper, HeightTier::Gaussian] {
            for (below, colors) in [(EXACT, Colors::Constant), (EXACT, Colors::Dynamic)] {
                let scene = Scene::new("judged").height(map.clone()).ranges(ranges).colors(colors);
                let scene = scene.height_tier(tier).tier(below).microsurface(noisy());
                let (bound, found) = (scene.module()?.bound(), error(&device, &scene, &calls)?);
                println!("seed {seed}, {tier} over {below}: {found:.2e}, bound {bound}");
                assert!(found <= f64::from(bound.value()), "seed {seed}, {tier}, {below}: {found:e} exceeds {bound}");
            }
        }
    }
    Ok(())
}

/// A noise of no deviation is none.
#[test]
fn no_noise_changes_nothing() -> Outcome {
    let device = Device::new()?;
    let scene = Scene::new("rock").height(named("terrain")?).height_tier(HeightTier::ClosedForm);
    let plain = calls(&mut Random::new(8), scene.map().ok_or("no map")?, Ranges::default(), 1e-2, 2000);
    let run = |scene: &Scene| {
        let module = scene.module()?;
        let export = &module.exports()[0];
        let numbers: Vec<f32> = plain.iter().flat_map(|call| call.arguments(&export.signature)).collect();
        ExportKernel::new(&device, &module, export)?.run(&numbers)
    };
    let (with, without) = (run(&scene.clone().microsurface(noisy()))?, run(&scene)?);
    for (one, other) in with.iter().zip(without) {
        assert!((0..3).all(|channel| (one[channel] - other[channel]).abs() <= 1e-5), "{one:?} {other:?}");
    }
    Ok(())
}

#[test]
fn bands_in_closed_form_refuse_noise() -> Outcome {
    let scene = Scene::new("strata").height(named("steps6")?).microsurface(noisy());
    let Err(Error::Conflict(message)) = scene.clone().height_tier(HeightTier::Exact).module() else {
        return Err("bands have no sum with noise".into());
    };
    assert!(message.contains("know no noise on the heights"), "{message}");
    // Left to choose, a scene takes what can.
    let module = scene.module()?;
    assert!(module.explain().contains("skewed heights in closed form"), "{}", module.explain());
    assert!(module.explain().contains("deviations with noise from"), "{}", module.explain());
    let height = "mean: f32, deviation: f32, noise_mean: f32, noise_deviation: f32, slope_covariance: vec3f";
    assert!(module.exports()[0].signature.contains(height), "{}", module.exports()[0].signature);
    assert!(!module.exports()[1].signature.contains("noise"));
    Ok(())
}
