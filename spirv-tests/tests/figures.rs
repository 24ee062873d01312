//! The figures that the crate promises for C0, measured on the device against the f64 integral.

use std::error::Error;

use prefilter::gpu::Device;
use prefilter::{ColorMap, Colors, Kernel, Ranges, Scene, Tier};
use spirv_tests::exports::ExportKernel;
use spirv_tests::judged::{measured, points};
use spirv_tests::maps::{named, random};
use spirv_tests::scenes;

type Outcome = Result<(), Box<dyn Error + Send + Sync>>;

const EXACT: Tier = Tier::ClosedForm(Kernel::Exact);
const FAST: Tier = Tier::ClosedForm(Kernel::Fast);

fn error_of(
    device: &Device,
    map: &ColorMap,
    tier: Tier,
    means: (f32, f32),
) -> Result<f32, Box<dyn Error + Send + Sync>> {
    let module = Scene::new("judged").texture(map.clone()).tier(tier).module()?;
    let error = measured(device, &module, map, &points(map, Ranges { mean: means, deviation: 0.5 }, 20_000))?;
    println!("{tier}, {} knots: {error:.2e}", map.knots().len());
    Ok(error)
}

const WIDE: (f32, f32) = (-0.5, 1.5);

#[test]
fn closed_forms_keep_their_figures() -> Outcome {
    let device = Device::new()?;
    let terrain = named("terrain")?;
    assert!(error_of(&device, &terrain, EXACT, WIDE)? <= 5e-6);
    assert!(error_of(&device, &terrain, FAST, WIDE)? <= 3e-4);
    for map in [named("steps6")?, named("stripe1_hard")?, named("stripe1_lin")?, named("gist_earth")?] {
        assert!(error_of(&device, &map, EXACT, WIDE)? <= 3e-5);
    }
    for seed in [1, 2, 3, 4] {
        assert!(error_of(&device, &random(32, false, seed)?, EXACT, WIDE)? <= 3e-5);
        assert!(error_of(&device, &random(32, true, seed)?, EXACT, WIDE)? <= 3e-5);
    }
    Ok(())
}

#[test]
fn ramps_keep_their_figure_down_to_the_narrowest() -> Outcome {
    let device = Device::new()?;
    for width in [1e-1, 1e-2, 6e-3, 4e-3, 1e-3, 1e-4, 1e-5] {
        for start in [0.0, 0.31, 0.93] {
            let ramp = ColorMap::gradient([(start, [0.1, 1.0, 0.0]), (start + width, [0.9, 0.0, 0.5])])?;
            assert!(error_of(&device, &ramp, EXACT, WIDE)? <= 3e-4);
            assert!(error_of(&device, &ramp, FAST, WIDE)? <= 3e-4);
        }
    }
    Ok(())
}

#[test]
fn tables_keep_their_figures() -> Outcome {
    let device = Device::new()?;
    for (name, figure) in [("terrain", 4e-3), ("viridis", 2e-3), ("gist_earth", 1.7e-2)] {
        let map = named(name)?;
        let table = error_of(&device, &map, Tier::Table, (-0.25, 1.25))?;
        let paper = error_of(&device, &map, Tier::Paper, (0.0, 1.0))?;
        let outside = error_of(&device, &map, Tier::Paper, (-0.25, 1.25))?;
        println!("{name}: cube-root table {table:.2e}, paper's table {paper:.2e} in [0, 1], {outside:.2e} beyond");
        assert!(table <= figure);
    }
    Ok(())
}

#[test]
fn every_scene_of_values_keeps_its_bound() -> Outcome {
    let device = Device::new()?;
    for (name, scene) in scenes::textures()? {
        let module = scene.module()?;
        let (map, ranges) = (scene.map().ok_or("no map")?, scene.chosen_ranges());
        let error = measured(&device, &module, map, &points(map, ranges, 20_000))?;
        println!("{name}: {error:.2e}, bound {}", module.bound());
        // The reference itself errs by 1e-13.
        assert!(error <= module.bound().value() + 1e-12, "{name}: {error} exceeds {}", module.bound());
    }
    Ok(())
}

#[test]
fn limits_are_the_map_itself() -> Outcome {
    let device = Device::new()?;
    let map = named("terrain")?;
    let flat = ColorMap::gradient([(0.2, [0.25, 0.5, 0.75]), (0.8, [0.25, 0.5, 0.75])])?;
    for (tier, colors) in [
        (EXACT, Colors::Constant),
        (FAST, Colors::Constant),
        (Tier::Table, Colors::Constant),
        (Tier::Paper, Colors::Constant),
        (Tier::Naive, Colors::Constant),
        (EXACT, Colors::Dynamic),
    ] {
        let module = Scene::new("plain").texture(flat.clone()).colors(colors).tier(tier).module()?;
        let kernel = ExportKernel::new(&device, &module, &module.exports()[0])?;
        for color in kernel.run(&[0.5, 0.1, -3.0, 1e30, 7.0, 0.0, f32::MAX, f32::INFINITY, 0.5, 1e-40])? {
            assert_eq!(color[..3], [0.25, 0.5, 0.75], "{tier}");
        }
        let module = Scene::new("terrain").texture(map.clone()).colors(colors).tier(tier).module()?;
        let kernel = ExportKernel::new(&device, &module, &module.exports()[0])?;
        // A table ends at its border: with a deviation that is no longer the end color.
        let spread = if matches!(tier, Tier::Table | Tier::Paper) { 0.0 } else { 0.2 };
        let far = kernel.run(&[-1e30, 0.0, 1e30, 0.0, f32::NEG_INFINITY, spread, f32::INFINITY, spread])?;
        for (color, end) in far.iter().zip([[0.2, 0.2, 0.6], [1.0; 3], [0.2, 0.2, 0.6], [1.0; 3]]) {
            let error = (0..3).map(|channel| (color[channel] - end[channel]).abs()).fold(0.0, f32::max);
            // Tables hold halves; the paper's first texel lies half a texel inside, 1/512, where the slope is up to 6.
            let slack = if tier == Tier::Paper { 6.0 / 512.0 } else { 5e-4 };
            assert!(error <= slack, "{tier}: {color:?} is not {end:?}");
        }
    }
    Ok(())
}

/// With Ranges in meters the same map gives the same colors: units cancel.
#[test]
fn units_cancel() -> Outcome {
    let device = Device::new()?;
    let stops = |unit: f32| [(0.0, [0.0, 0.2, 0.4]), (0.5 * unit, [0.9, 0.1, 0.3]), (unit, [1.0, 0.8, 0.6])];
    let one = ColorMap::gradient(stops(1.0))?;
    let many = ColorMap::gradient(stops(1024.0))?;
    let wide = Ranges { mean: (-256.0, 1280.0), deviation: 512.0 };
    let module = Scene::new("unit").texture(one.clone()).tier(EXACT).module()?;
    let meters = Scene::new("meters").texture(many).tier(EXACT).ranges(wide).module()?;
    let points = points(&one, Ranges::default(), 20_000);
    let scaled: Vec<f32> = points.iter().map(|value| value * 1024.0).collect();
    let ours = ExportKernel::new(&device, &module, &module.exports()[0])?.run(&points)?;
    let theirs = ExportKernel::new(&device, &meters, &meters.exports()[0])?.run(&scaled)?;
    assert!(!ours.is_empty());
    for (ours, theirs) in ours.iter().zip(theirs) {
        assert!((0..3).all(|channel| (ours[channel] - theirs[channel]).abs() <= 4e-6), "{ours:?} {theirs:?}");
    }
    Ok(())
}
