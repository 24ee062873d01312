//! The table over mean, deviation and skewness: its figures, its cost and its length.

use prefilter::gpu::Device;
use prefilter::reference::height::mean;
use prefilter::reference::heights::{cumulative, lambda_of_skewness, moments, perturbed_cumulative};
use prefilter::{link, ColorMap, HeightTier, Module, Ranges, Scene};
use spirv_tests::exports::ExportKernel;
use spirv_tests::kernel::Function;
use spirv_tests::maps::named;
use spirv_tests::random::Random;

use crate::{covariance, direction, Call, Fault, Outcome};

/// The largest step error by the device's moments and slices as exact as can be: what no table makes smaller.
#[test]
fn four_slices_hold_steps() -> Outcome {
    let device = Device::new()?;
    let functions = Function::shelf()?;
    let of_lambda = functions.iter().find(|function| function.name == "heights_moments").ok_or("no moments")?;
    let lambdas: Vec<f64> = (0..=240).map(|part| 1e-3 * 1e7f64.powf(f64::from(part) / 240.0)).collect();
    let points: Vec<Vec<f64>> = lambdas.iter().map(|&lambda| vec![f64::from(lambda as f32)]).collect();
    let found = of_lambda.results(&device, &[], &points)?;
    let [_, _, skewest, _] = moments(1e4);
    let slices = [0.0, 1.0, 2.0, 3.0].map(|slice| {
        let lambda = lambda_of_skewness(skewest * slice / 3.0);
        (lambda, moments(lambda))
    });
    let mut worst = [0.0f64; 2];
    for (&lambda, visible) in lambdas.iter().zip(&found) {
        let place = (3.0 * visible[2] / skewest).clamp(0.0, 3.0);
        let (slice, fraction) = ((place as usize).min(2), place - (place as usize).min(2) as f64);
        for at in -100..=160 {
            let height = 0.05 * f64::from(at);
            let below = |(lambda, [mean, deviation, ..]): (f64, [f64; 4])| {
                cumulative(mean + deviation * (height - visible[0]) / visible[1], lambda)
            };
            let read = below(slices[slice]) * (1.0 - fraction) + below(slices[slice + 1]) * fraction;
            let error = (read - cumulative(height, lambda)).abs();
            worst[0] = if lambda <= 100.0 { worst[0].max(error) } else { worst[0] };
            worst[1] = worst[1].max(error);
        }
    }
    println!("before the table's own error: {:.2e} for lambda up to 100, {:.2e} up to 1e4", worst[0], worst[1]);
    assert!(worst[0] <= 4.6e-4 && worst[1] <= 5.8e-4, "{worst:?}");
    Ok(())
}

/// Visible heights with noise are not those of another Λ: this much off by those with the same three moments.
#[test]
fn noise_leaves_the_family_by_little() {
    let mut worst = 0.0f64;
    for part in 0..=14 {
        let lambda = 0.1 * 1e5f64.powf(f64::from(part) / 14.0);
        let [mean, deviation, skewness, _] = moments(lambda);
        for noise in [0.02, 0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.6, 1.0] {
            let total = deviation.hypot(noise);
            let like = lambda_of_skewness(skewness * (deviation / total).powi(3));
            let [like_mean, like_deviation, ..] = moments(like);
            for at in -60..=100 {
                let z = 0.06 * f64::from(at);
                let sum = perturbed_cumulative(mean + total * z, lambda, noise);
                worst = worst.max((sum - cumulative(like_mean + like_deviation * z, like)).abs());
            }
        }
    }
    println!("noise: a step errs by {worst:.2e} more");
    assert!((4.1e-3..=4.3e-3).contains(&worst));
}

fn module(map: ColorMap, ranges: Ranges) -> Result<Module, prefilter::Error> {
    Scene::new("judged").height(map).height_tier(HeightTier::Skewed).ranges(ranges).module()
}

/// The errors of the first channel over calls, sorted.
fn errors(device: &Device, map: &ColorMap, ranges: Ranges, calls: &[Call]) -> Result<Vec<f64>, Fault> {
    let module = module(map.clone(), ranges)?;
    let numbers: Vec<f32> = calls.iter().flat_map(|call| call.numbers).collect();
    let colors = ExportKernel::new(device, &module, &module.exports()[0])?.run(&numbers)?;
    let reference = map.reference();
    let error = |(color, call): (&[f32; 4], &Call)| {
        let truth = mean(&reference, call.numbers[0].into(), call.numbers[1].into(), call.lambda);
        (0..3).map(|channel| (f64::from(color[channel]) - truth[channel]).abs()).fold(0.0, f64::max)
    };
    let mut errors: Vec<f64> = colors.iter().zip(calls).map(error).collect();
    errors.sort_by(f64::total_cmp);
    assert!(errors.len() == calls.len() && errors.len() >= 1000);
    Ok(errors)
}

/// Maps over three deviations of the heights on either side, means up to two of them away from the middle.
#[test]
fn whole_maps_err_by_less_than_a_thousandth() -> Outcome {
    let device = Device::new()?;
    let sixth = (1.0f32 / 6.0).next_down();
    let ranges = Ranges { mean: (1.0 / 6.0, 5.0 / 6.0), deviation: sixth };
    for name in ["terrain", "gist_earth"] {
        let map = named(name)?;
        let mut random = Random::new(4);
        let mut calls = Vec::new();
        while calls.len() < 20_000 {
            let at = random.between(1.0 / 6.0, 5.0 / 6.0) as f32;
            let call = Call::new(at, sixth, covariance(&mut random), direction(&mut random), direction(&mut random));
            calls.extend((call.lambda <= 1e4).then_some(call));
        }
        let errors = errors(&device, &map, ranges, &calls)?;
        println!("{name}: at most {:.2e}", errors[errors.len() - 1]);
        assert!(errors[errors.len() - 1] <= 1e-3);
    }
    Ok(())
}

/// Steps within ±3, deviations of heights even from 0.15 to 1, means even within ±2, and Λ from 0.01 to 316.
#[test]
fn edges_err_little_and_seldom() -> Outcome {
    let device = Device::new()?;
    let ranges = Ranges { mean: (-2.0, 2.0), deviation: 1.0 };
    let mut all = Vec::new();
    for (seed, edge) in [(6, 0.3), (7, -1.13), (8, 1.87), (9, 2.6)] {
        let mut random = Random::new(seed);
        let mut calls = Vec::new();
        while calls.len() < 10_000 {
            let [at, deviation] = [4.0 * random.unit() - 2.0, 0.15 + 0.85 * random.unit()].map(|value| value as f32);
            let directions = [direction(&mut random), direction(&mut random)];
            let call = Call::new(at, deviation, covariance(&mut random), directions[0], directions[1]);
            calls.extend((0.01..=316.0).contains(&call.lambda).then_some(call));
        }
        let step = ColorMap::bands([0.0; 3], [(edge, [1.0; 3])])?;
        all.extend(errors(&device, &step, ranges, &calls)?);
    }
    all.sort_by(f64::total_cmp);
    let mean = all.iter().sum::<f64>() / all.len() as f64;
    let [high, highest] = [all[all.len() * 99 / 100], all[all.len() - 1]];
    println!("steps: mean {mean:.2e}, 99th percentile {high:.2e}, at most {highest:.2e}");
    assert!(mean <= 2e-4 && high <= 1.5e-3, "{mean:e}, {high:e}");
    Ok(())
}

/// The paper's recipe: its two fits and a table over mean and deviation, with Λ as it is printed and the complementary
/// error function of Abramowitz and Stegun 1964, "Handbook of Mathematical Functions", formula 7.1.26.
const RECIPE: &str = "
fn recipe_erfc(x: f32) -> f32 {
    let t = 1.0 / (1.0 + 0.3275911 * x);
    return t * (0.254829592 + t * (-0.284496736 + t * (1.421413741 + t * (-1.453152027 + t * 1.061405429))))
        * exp(-x * x);
}

fn recipe_lambda(a: f32) -> f32 {
    return exp(-a * a) / (3.54490770 * a) - 0.5 * recipe_erfc(a);
}

fn recipe_height(
    mean: f32, deviation: f32, slope_covariance: vec3f, view: vec3f, light: vec3f, table: texture_2d<f32>,
    table_sampler: sampler,
) -> vec3f {
    let seen = recipe_lambda(smith_parameter_level(view, slope_covariance));
    let lit = recipe_lambda(smith_parameter_level(light, slope_covariance));
    let visible = heights_moments_paper(seen + lit);
    let at = vec2f(mean + deviation * visible.x, deviation * visible.y * 2.0);
    return textureSampleLevel(table, table_sampler, at, 0.0).xyz;
}
";

#[test]
fn the_chain_is_as_short_and_light_as_the_papers() -> Outcome {
    let module = module(named("terrain")?, Ranges::default())?;
    let ours = link(&[&module], "")?.cost("judged_height").ok_or("no export")?;
    let recipe = link(&[], RECIPE)?.cost("recipe_height").ok_or("no recipe")?;
    println!("ours: {ours}; the paper's: {recipe}");
    assert!(ours.fetches == 1 && recipe.fetches == 1);
    assert!(ours.operations <= recipe.operations);
    let lines = module.wgsl().lines().filter(|line| !line.trim().is_empty() && !line.trim().starts_with("//")).count();
    println!("{lines} lines of WGSL without comments, visibility included");
    assert!(lines <= 60);
    Ok(())
}
