//! Maps over percentiles of heights.

use prefilter::gpu::Device;
use prefilter::reference::normal::cumulative;
use prefilter::reference::percentile::{mean, mean_by_ranks};
use prefilter::{Accuracy, ColorMap, Colors, Driver, Error, HeightTier, Kernel, Microsurface, Moments, Scene, Tier};
use spirv_tests::exports::ExportKernel;
use spirv_tests::maps::{named, random};
use spirv_tests::random::Random;

use crate::{covariance, direction, Call, Outcome};

/// Question 1: both quadratures agree with each other and with the largest of some even numbers.
#[test]
fn references_agree() -> Outcome {
    let mut numbers = Random::new(11);
    for map in [named("terrain")?, named("steps6")?, random(12, true, 3)?, sharp(&mut numbers)?] {
        let map = map.reference();
        for lambda in [0.0, 0.013, 0.7, 9.0, 160.0, 1e4, 1e6] {
            let (one, other) = (mean(&map, lambda), mean_by_ranks(&map, lambda));
            assert!((0..4).all(|channel| (one[channel] - other[channel]).abs() < 2e-11), "{lambda}: {one:?} {other:?}");
        }
    }
    // Equation 3 without its visibility; the mean of the largest of n even numbers is n/(n + 1).
    let line = ColorMap::gradient([(0.0, [0.0; 3]), (1.0, [1.0; 3])])?.reference();
    for hidden in [0.0, 1.0, 4.0, 99.0] {
        assert!((mean(&line, hidden)[0] - (1.0 + hidden) / (2.0 + hidden)).abs() < 1e-13, "{hidden}");
    }
    Ok(())
}

/// A map of narrow ramps, of knots next to both ends and of hard edges there.
fn sharp(numbers: &mut Random) -> Result<ColorMap, Error> {
    let mut positions = vec![0.0, 1e-7, 1e-3, 0.999, 1.0 - 1.2e-7, 1.0];
    for _ in 0..4 {
        let at = numbers.unit() as f32;
        positions.extend([at, (at + numbers.between(1e-6, 0.1) as f32).min(1.0)]);
    }
    positions.sort_by(f32::total_cmp);
    positions.dedup();
    let mut color = || [0.0; 3].map(|_: f32| numbers.unit() as f32);
    let stops = positions.into_iter().enumerate().flat_map(|(index, at)| {
        let hard = (index % 3 == 0).then(&mut color);
        [Some((at, color())), hard.map(|color| (at, color))].into_iter().flatten().collect::<Vec<_>>()
    });
    ColorMap::gradient(stops.collect::<Vec<_>>())
}

/// Calls from directions down to where the shelf's Λ ends, 5.2e5.
fn calls(numbers: &mut Random, count: usize) -> Vec<Call> {
    let calls = (0..count).map(|_| {
        let [view, light] = [direction(numbers), direction(numbers)];
        Call::new(0.0, 1.0, covariance(numbers), view, light)
    });
    calls.filter(|call| call.parts.iter().all(|lambda| *lambda < 5.2e5)).collect()
}

/// The largest error of a scene's colors, which stay in the map's hull.
fn error(device: &Device, scene: &Scene, calls: &[Call]) -> Result<f64, crate::Fault> {
    let (module, map) = (scene.module()?, scene.map().ok_or("no map")?);
    let export = &module.exports()[0];
    let numbers: Vec<f32> = calls.iter().flat_map(|call| call.arguments(&export.signature)).collect();
    let colors = ExportKernel::new(device, &module, export)?.run(&numbers)?;
    let (reference, (low, high)) = (map.reference(), map.hull());
    assert!(!colors.is_empty() && colors.len() == calls.len());
    let mut worst = 0.0f64;
    for (color, call) in colors.iter().zip(calls) {
        let truth = mean(&reference, call.lambda);
        for channel in 0..map.channels() {
            assert!((low[channel]..=high[channel]).contains(&color[channel]), "{color:?} leaves the hull");
            worst = worst.max((f64::from(color[channel]) - truth[channel]).abs());
        }
    }
    Ok(worst)
}

/// From directions to colors, with constant and with dynamic colors.
#[test]
fn percentiles_keep_their_figure_and_bounds() -> Outcome {
    let device = Device::new()?;
    let mut numbers = Random::new(4);
    let calls = calls(&mut numbers, 6000);
    let mut maps = vec![
        ("linear", ColorMap::gradient([(0.0, [0.0, 1.0, 0.2]), (1.0, [1.0, 0.1, 0.9])])?),
        ("terrain", named("terrain")?),
        ("gist_earth", named("gist_earth")?),
        ("steps6", named("steps6")?),
        ("random", random(9, true, 2)?),
    ];
    for _ in 0..3 {
        maps.push(("sharp", sharp(&mut numbers)?));
    }
    for (name, map) in maps {
        for colors in [Colors::Constant, Colors::Dynamic] {
            let scene = Scene::new("rock").height_percentile(map.clone()).colors(colors);
            let (bound, found) = (scene.module()?.bound(), error(&device, &scene, &calls)?);
            println!("{name}, {colors:?}: {found:.2e}, bound {bound}");
            assert!(found <= 2e-6 && found <= f64::from(bound.value()), "{name}, {colors:?}: {found:e}");
        }
    }
    Ok(())
}

/// Bounds hold for colors far from 0 and of any size, for many knots and for few, crowded about any place.
#[test]
fn any_map_keeps_its_bound() -> Outcome {
    let device = Device::new()?;
    for seed in 0..24 {
        let mut numbers = Random::new(seed);
        let calls = calls(&mut numbers, 400);
        let (offset, size) = (numbers.pick([0.0, 1.0, 100.0, -30_000.0]), numbers.pick([1.0, 1e-2, 1e-4, 30_000.0]));
        let (center, spread) = (numbers.pick([0.0, 0.5, 1.0]), numbers.pick([1.0, 0.1, 1e-3, 1e-6]));
        let count = numbers.pick([1, 2, 3, 20, 200]);
        let mut positions: Vec<f32> =
            (0..count).map(|_| (center + spread * (numbers.unit() - 0.5)).clamp(0.0, 1.0) as f32).collect();
        positions.sort_by(f32::total_cmp);
        positions.dedup();
        let mut color = || [0.0; 4].map(|_: f32| offset + size * numbers.unit() as f32);
        let stops: Vec<_> = positions.into_iter().map(|at| (at, color())).collect();
        let map = ColorMap::gradient(stops)?;
        let largest = offset.abs() + size;
        for colors in [Colors::Constant, Colors::Dynamic] {
            let scene = Scene::new("rock").height_percentile(map.clone()).colors(colors);
            let (bound, found) = (f64::from(scene.module()?.bound().value()), error(&device, &scene, &calls)?);
            // The reference errs by 2e-11 of a color.
            assert!(found <= bound + 2e-11 * f64::from(largest), "seed {seed}, {colors:?}: {found:e} of {bound:e}");
        }
    }
    Ok(())
}

/// What hides the surface is as for heights.
#[test]
fn switches_are_those_of_heights() -> Outcome {
    let device = Device::new()?;
    let mut numbers = Random::new(14);
    let calls = calls(&mut numbers, 2000);
    let scene = Scene::new("rock").height_percentile(named("terrain")?);
    let dark = scene.clone().microsurface(Microsurface { shadowing: false, ..Microsurface::default() });
    let hot = scene.microsurface(Microsurface { hotspot: true, ..Microsurface::default() });
    let unlit: Vec<Call> = calls.iter().cloned().map(Call::unlit).collect();
    assert!(error(&device, &dark, &unlit)? <= 2e-6);
    let correlated: Vec<Call> = calls.into_iter().map(Call::hot).collect();
    let found = error(&device, &hot, &correlated)?;
    // The shelf's independence of azimuths errs by 6e-6.
    assert!(found <= 4e-6, "{found}");
    Ok(())
}

/// Below a horizon the color is that of the highest heights, and where nothing is hidden the mean over all of them.
#[test]
fn horizons_and_flat_surfaces() -> Outcome {
    let device = Device::new()?;
    let map = ColorMap::gradient([(0.0, [0.2, 0.9, 0.1]), (0.3, [0.5, 0.1, 0.7]), (1.0, [0.9, 0.3, 0.4])])?;
    let up = [0.0, 0.0, 1.0];
    let (low, level, rough) = ([0.6, 0.0, -0.8], [0.6, 0.8, 0.0], [0.2, 0.1, 0.3]);
    let points: Vec<f32> = [
        (rough, low, up),
        (rough, up, low),
        (rough, level, up),
        ([0.0; 3], low, low),
        ([0.0; 3], [0.6, 0.0, 0.8], [0.0, 0.8, 0.6]),
        (rough, up, up),
    ]
    .into_iter()
    .flat_map(|(covariance, view, light)| [covariance, view, light].concat())
    .collect();
    for colors in [Colors::Constant, Colors::Dynamic] {
        let module = Scene::new("rock").height_percentile(map.clone()).colors(colors).module()?;
        let found = ExportKernel::new(&device, &module, &module.exports()[0])?.run(&points)?;
        let middle = |from: f32, to: f32| 0.5 * (from + to);
        for channel in 0..3 {
            let [first, second, last] = [0, 1, 2].map(|knot: usize| map.knots()[knot].right[channel]);
            let whole = 0.3 * middle(first, second) + 0.7 * middle(second, last);
            assert!(found[..4].iter().all(|color| (color[channel] - last).abs() < 3e-6), "{found:?}");
            assert!(found[4..].iter().all(|color| (color[channel] - whole).abs() < 1e-6), "{found:?}");
        }
    }
    Ok(())
}

/// The heights' mean and deviation cancel: edges at heights are edges at the shares below them.
#[test]
fn edges_at_heights_are_edges_at_shares() -> Outcome {
    let device = Device::new()?;
    let colors = [(0.1, [0.9, 0.2, 0.1]), (0.35, [0.3, 0.6, 0.2]), (0.8, [0.1, 0.1, 0.7])];
    let shares = colors.map(|(at, color)| (cumulative((at - 0.4) / 0.2) as f32, color));
    let heights = ColorMap::bands([0.5; 3], colors.map(|(at, color)| (at as f32, color)))?;
    let heights = Scene::new("rock").height(heights).height_tier(HeightTier::Exact).module()?;
    let shares = Scene::new("rock").height_percentile(ColorMap::bands([0.5; 3], shares)?).module()?;
    let calls: Vec<Call> = calls(&mut Random::new(8), 2000);
    let run = |module: &prefilter::Module, with: &[f32]| {
        let numbers: Vec<f32> = calls.iter().flat_map(|call| [with, &call.numbers[2..]].concat()).collect();
        ExportKernel::new(&device, module, &module.exports()[0])?.run(&numbers)
    };
    let (one, other) = (run(&heights, &[0.4, 0.2])?, run(&shares, &[])?);
    for (one, other) in one.iter().zip(other) {
        assert!((0..3).all(|channel| (one[channel] - other[channel]).abs() < 4e-6), "{one:?} {other:?}");
    }
    Ok(())
}

#[test]
fn materials_of_percentiles_share_a_text() -> Outcome {
    let module = |name: &str| {
        Scene::new("rock").height_percentile(named(name)?).colors(Colors::Dynamic).module().map_err(crate::Fault::from)
    };
    let (one, other) = (module("terrain")?, module("steps6")?);
    assert_eq!(one.wgsl(), other.wgsl());
    assert_ne!(one.tables(), other.tables());
    let height = "fn rock_height(slope_covariance: vec3f, view: vec3f, light: vec3f, knots: texture_2d<f32>) -> vec3f";
    assert_eq!(one.exports()[0].signature, height);
    assert!(!one.wgsl().contains("deviation: f32"), "{}", one.wgsl());
    Ok(())
}

#[test]
fn percentiles_that_cannot_be_are_refused() -> Outcome {
    let scene = Scene::new("rock").height_percentile(named("terrain")?);
    let refused = |scene: Scene| scene.module().map(|module| module.explain().to_owned()).unwrap_err().to_string();
    let meters = ColorMap::gradient([(0.0, [0.0; 3]), (1.5, [1.0; 3])])?;
    let message = refused(Scene::new("rock").height_percentile(meters));
    assert_eq!(message, "knot 1's position, a share of the surface, is 1.5; allowed is 0 to 1");
    let noise = Microsurface { perturbed: true, ..Microsurface::default() };
    for (refusal, scene) in [
        ("without noise on the heights", scene.clone().microsurface(noise)),
        ("without a tier of heights, one normal distribution", scene.clone().height_tier(HeightTier::Gaussian)),
        ("without a color map's tier", scene.clone().tier(Tier::ClosedForm(Kernel::Fast))),
        ("without a driver", scene.clone().driver(Driver::Moments(Moments::default()))),
        ("more than one filter", scene.clone().height(named("terrain")?)),
        ("promises", scene.clone().accuracy(Accuracy::max_filter_error(1e-9))),
    ] {
        let message = refused(scene);
        assert!(message.contains(refusal), "{message}");
    }
    scene.clone().height_tier(HeightTier::Exact).module()?;
    let said = scene.module()?.explain().to_owned();
    assert!(
        said.contains("Λ of a direction to 5.2e5, any heights: a step errs by 8.5e-6") && !said.contains("ranges"),
        "{said}"
    );
    Ok(())
}
