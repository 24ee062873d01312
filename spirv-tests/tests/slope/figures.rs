//! Do tiers keep their figures and bounds, on the device against the f64 integral?

use std::f64::consts::TAU;

use prefilter::gpu::Device;
use prefilter::reference::footprint::variance_along;
use prefilter::reference::slope::mean;
use prefilter::reference::slopes::Visible;
use prefilter::reference::texture;
use prefilter::{ColorMap, Colors, Kernel, Ranges, Scene, SlopeTier, Tier};
use spirv_tests::exports::ExportKernel;
use spirv_tests::maps::random;
use spirv_tests::scenes;

use crate::{single, view, Fault, Outcome, Random};

pub(crate) const EXACT: Tier = Tier::ClosedForm(Kernel::Exact);

pub(crate) type Call = (Visible, [f64; 2]);

/// Mean and deviation of the component over all slopes.
pub(crate) fn component((visible, direction): &Call) -> [f64; 2] {
    let mean = direction[0] * visible.mean[0] + direction[1] * visible.mean[1];
    [mean, variance_along(visible.covariance, *direction).sqrt()]
}

/// Calls within ranges, with deviations down to the scenes' floor, and mean slopes about the map's knots and anywhere.
pub(crate) fn calls(random: &mut Random, map: &ColorMap, ranges: Ranges, count: usize) -> Vec<Call> {
    let [low, high] = [ranges.mean.0, ranges.mean.1].map(f64::from);
    let floor = 1.01e-3 * low.abs().max(high.abs());
    let mut calls = Vec::new();
    while calls.len() < count {
        let (mut visible, direction) = view(random);
        let scale = random.between(floor, ranges.deviation.into()) / component(&(visible, direction))[1];
        let knot = f64::from(map.knots()[random.word() as usize % map.knots().len()].position);
        let near = knot + 3.0 * (2.0 * random.unit() - 1.0) * scale;
        let anywhere = low + (high - low) * random.unit();
        let at = random.pick([near, near, anywhere]);
        // A mean slope with that component, and any part across.
        let aside = 0.3 * (2.0 * random.unit() - 1.0);
        visible.mean = single([at * direction[0] - aside * direction[1], at * direction[1] + aside * direction[0]]);
        visible.covariance = single(visible.covariance.map(|value| scale * scale * value));
        let call = (visible, direction);
        let [mean, deviation] = component(&call);
        let inside = (low..=high).contains(&mean) && (floor..=ranges.deviation.into()).contains(&deviation);
        if inside && visible.parameter() >= 0.0 {
            calls.push(call);
        }
    }
    calls
}

/// The largest errors of a scene's colors, which stay in the map's hull, against the means over the visible slopes and
/// over all slopes.
fn errors(device: &Device, scene: &Scene, calls: &[Call]) -> Result<[f64; 2], Fault> {
    let (module, map) = (scene.module()?, scene.map().ok_or("no map")?);
    let export = &module.exports()[0];
    let viewed = export.signature.contains("view:");
    let numbers = |(visible, direction): &Call| {
        let view = if viewed { &visible.view[..] } else { &[] };
        [&visible.mean[..], &visible.covariance, view, direction].concat()
    };
    let numbers: Vec<f32> = calls.iter().flat_map(numbers).map(|value| value as f32).collect();
    let colors = ExportKernel::new(device, &module, export)?.run(&numbers)?;
    let (reference, (low, high)) = (map.reference(), map.hull());
    assert!(!colors.is_empty() && colors.len() == calls.len());
    let halves = if module.tables().is_empty() { 0.0 } else { 5e-4 };
    let mut worst = [0.0f64; 2];
    for (color, call) in colors.iter().zip(calls) {
        let [at, deviation] = component(call);
        let truths = [mean(&reference, &call.0, call.1), texture::mean(&reference, at, deviation)];
        for channel in 0..map.channels() {
            let slack = halves * high[channel].abs().max(low[channel].abs());
            let hull = low[channel] - slack..=high[channel] + slack;
            assert!(hull.contains(&color[channel]), "{color:?} leaves the hull at {call:?}");
            for (worst, truth) in worst.iter_mut().zip(truths) {
                *worst = worst.max((f64::from(color[channel]) - truth[channel]).abs());
            }
        }
    }
    Ok(worst)
}

/// A step at 0 by a tier, seen along and against the component from the horizon of the mean surface up.
fn steps(tier: SlopeTier) -> Result<(Scene, Vec<Call>), Fault> {
    let step = ColorMap::bands([0.0; 3], [(0.0, [1.0; 3])])?;
    let ranges = Ranges { mean: (-4.0, 4.0), deviation: 1.0 };
    let scene = Scene::new("edge").slope(step.clone()).slope_tier(tier).ranges(ranges).tier(EXACT);
    let mut calls = calls(&mut Random::new(61), &step, ranges, 2000);
    for place in -130..=130 {
        for parameter in [1e-4, 0.1, 0.5, 1.0, 2.0, 2.8, 3.01, 4.0] {
            // Along x, where slopes have the mean s and the deviation 0.5, the parameter is 2 (z/x − s).
            let slope = 0.02 * f64::from(place);
            let view = [1.0, 0.0, slope + 0.5 * parameter];
            let view = single(view.map(|part| part / f64::hypot(view[0], view[2])));
            let visible = Visible { view, covariance: [0.25, 0.0, 0.25], mean: single([slope, 0.0]) };
            calls.extend([1.0, -1.0].map(|turn| (visible, [turn, 0.0])));
        }
    }
    Ok((scene, calls))
}

/// The largest error of a step at 0.
fn step_error(device: &Device, tier: SlopeTier) -> Result<f64, Fault> {
    let (scene, calls) = steps(tier)?;
    Ok(errors(device, &scene, &calls)?[0])
}

const ONE: &[(f64, f64)] = &[
    (0.5, 4e-2),
    (0.75, 3.52e-2),
    (1.75, 3.46e-2),
    (2.0, 2.4e-2),
    (2.25, 1.3e-2),
    (2.5, 9.3e-3),
    (3.0, 4.4e-3),
    (4.0, 6e-4),
    (5.0, 3.6e-5),
];
const TWO: &[(f64, f64)] = &[(2.0, 8.4e-3), (2.25, 5.2e-3), (2.5, 4.6e-3), (3.0, 3.1e-3), (3.5, 1.5e-3), (4.0, 5.5e-4)];

/// By the distance of the step from the mean of the visible slopes' component, in its deviations.
#[test]
fn steps_far_from_the_mean_keep_their_figures() -> Outcome {
    let device = Device::new()?;
    let mut wide = Vec::new();
    for (tier, figures) in [(SlopeTier::Gaussian, ONE), (SlopeTier::Pair, TWO)] {
        let (scene, calls) = steps(tier)?;
        let apart = |(visible, direction): &Call| {
            let [mean, deviation, _] = visible.moments_along(*direction);
            mean.abs() / deviation
        };
        let calls: Vec<(f64, Call)> = calls.into_iter().map(|call| (apart(&call), call)).collect();
        // From the farthest on: those between two distances are judged once.
        let (mut found, mut until) = (0.0f64, f64::INFINITY);
        for (from, figure) in figures.iter().rev() {
            let between = calls.iter().filter(|call| (*from..until).contains(&call.0));
            let between: Vec<Call> = between.map(|call| call.1).collect();
            found = found.max(errors(&device, &scene, &between)?[0]);
            println!("{tier}, from {from} deviations on a step errs by {found:.3e}, {figure:.2e}");
            if !(found <= *figure && 1.2 * found >= *figure) {
                wide.push((tier, *from, found));
            }
            until = *from;
        }
    }
    assert!(wide.is_empty(), "{wide:?}");
    Ok(())
}

#[test]
fn worst_steps_keep_the_figures_of_their_tiers() -> Outcome {
    let device = Device::new()?;
    for (tier, figure) in [
        (SlopeTier::Naive, 1.0),
        (SlopeTier::Unweighted, 0.579),
        (SlopeTier::Gaussian, 4.66e-2),
        (SlopeTier::Pair, 1.19e-2),
    ] {
        let found = step_error(&device, tier)?;
        println!("{tier}: a step errs by {found:.3e}");
        assert!(found <= figure && 1.05 * found >= figure, "{tier}: {found}");
    }
    Ok(())
}

#[test]
fn every_scene_of_slopes_keeps_its_bound() -> Outcome {
    let device = Device::new()?;
    for (seed, (name, scene)) in (71..).zip(scenes::slopes()?) {
        let (map, ranges) = (scene.map().ok_or("no map")?, scene.chosen_ranges());
        let bound = f64::from(scene.module()?.bound().value());
        let [visible, all] = errors(&device, &scene, &calls(&mut Random::new(seed), map, ranges, 1500))?;
        println!("{name}: {visible:.2e}, bound {bound:.2e}; over all slopes {all:.2e}");
        assert!(visible <= bound, "{name}: {visible}");
        // What counts all slopes alike is C0 over them.
        assert!(if name == "slope_unweighted" { all < 3.9e-3 } else { all > 0.1 }, "{name}: {all}");
    }
    Ok(())
}

#[test]
fn random_maps_keep_their_bounds() -> Outcome {
    let device = Device::new()?;
    for seed in 0..8 {
        let (unit, center) = ([1.0, 0.2][seed as usize % 2], [0.0, 0.3, -0.5][seed as usize % 3]);
        let map = random(2 + seed as usize, seed % 2 == 0, seed)?;
        let stops = map.knots().iter().flat_map(|knot| {
            let at = center + unit * (knot.position - 0.5);
            let hard = (knot.left != knot.right).then_some((at, knot.right));
            [Some((at, knot.left)), hard].into_iter().flatten()
        });
        let map = ColorMap::gradient(stops)?;
        let ranges = Ranges { mean: (center - unit, center + unit), deviation: 0.6 * unit };
        let calls = calls(&mut Random::new(80 + seed), &map, ranges, 400);
        for tier in [SlopeTier::Gaussian, SlopeTier::Pair] {
            for (below, colors) in [(EXACT, Colors::Constant), (EXACT, Colors::Dynamic)] {
                let scene = Scene::new("judged").slope(map.clone()).ranges(ranges).colors(colors);
                let scene = scene.slope_tier(tier).tier(below);
                let (bound, [found, _]) = (scene.module()?.bound(), errors(&device, &scene, &calls)?);
                println!("seed {seed}, {tier}: {found:.2e}, bound {bound}");
                assert!(found <= f64::from(bound.value()), "seed {seed}, {tier}: {found:e} exceeds {bound}");
            }
        }
    }
    Ok(())
}

/// Where the component hardly deviates, and the mean surface is steep across it, the rise over that surface rounds: the
/// difference of a view's height and of what the surface gains, for a reach that is as small.
#[test]
fn narrow_slopes_on_steep_surfaces_keep_their_bounds() -> Outcome {
    let device = Device::new()?;
    let step = ColorMap::bands([0.0; 3], [(0.0, [1.0; 3])])?;
    let ranges = Ranges { mean: (-0.01, 0.01), deviation: 0.01 };
    let mut random = Random::new(95);
    let scene = Scene::new("edge").slope(step).ranges(ranges).tier(EXACT);
    for tier in [SlopeTier::Gaussian, SlopeTier::Pair] {
        let scene = scene.clone().slope_tier(tier);
        let explained = scene.module()?.explain().to_owned();
        let least = explained.split_once("component from ").and_then(|(_, rest)| rest.split_once(','));
        let least: f64 = least.ok_or("no smallest deviation")?.0.parse()?;
        let mut calls = Vec::new();
        while calls.len() < 20_000 {
            let (size, turn) = (least * random.between(1.01, 2.0), 0.125 * TAU + 0.4 * (random.unit() - 0.5));
            let ([cos, sin], across) = ([turn.cos(), turn.sin()], 0.99 * (2.0 * random.unit() - 1.0));
            let covariance = single([size * size, 0.9 * size * size, size * size]);
            let at = 4.0 * size * (2.0 * random.unit() - 1.0);
            let mean = single([at * cos - across * sin, at * sin + across * cos]);
            let aside = turn + random.pick([0.0, 0.5 * TAU]) + random.unit() - 0.5;
            let parameter = random.between(1e-3, 0.5);
            let gained = mean[0] * aside.cos() + mean[1] * aside.sin();
            let reach = variance_along(covariance, [aside.cos(), aside.sin()]).sqrt();
            let view = [aside.cos(), aside.sin(), gained + parameter * reach];
            let length = (1.0 + view[2] * view[2]).sqrt();
            let visible = Visible { view: single(view.map(|part| part / length)), covariance, mean };
            let call = (visible, single([cos, sin]));
            let [_, deviation] = component(&call);
            if visible.parameter() >= 0.0 && deviation >= least {
                calls.push(call);
            }
        }
        let (bound, [found, _]) = (f64::from(scene.module()?.bound().value()), errors(&device, &scene, &calls)?);
        println!("{tier}: {found:.3e} from deviations of {least:.1e}, bound {bound:.3e}");
        assert!(found <= bound, "{tier}: {found:e} of {bound:e}");
    }
    Ok(())
}
