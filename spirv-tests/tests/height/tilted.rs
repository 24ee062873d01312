//! Tilted mean surfaces: steps near their horizons.

use prefilter::gpu::Device;
use prefilter::reference::visibility::{masking, shadowing};
use prefilter::{ColorMap, HeightTier, Microsurface, Ranges, Scene};
use spirv_tests::exports::ExportKernel;
use spirv_tests::random::Random;

use crate::{covariance, error, Call, Outcome, EXACT};

/// A mean slope up to 1.
fn mean_slope(random: &mut Random) -> [f32; 2] {
    let (size, turn) = (random.unit().sqrt(), std::f64::consts::TAU * random.unit());
    [size * turn.cos(), size * turn.sin()].map(|value| value as f32)
}

/// The same calls over tilted mean surfaces, those that are below no horizon.
pub fn tilted(random: &mut Random, calls: impl Iterator<Item = Call>) -> Vec<Call> {
    calls.filter_map(|call| call.tilted(mean_slope(random))).filter(|call| call.lambda <= 1e4).collect()
}

/// A direction that wins little over a mean surface: about as much as bounds ask for.
fn near_the_horizon(random: &mut Random, mean_slope: [f32; 2]) -> [f32; 3] {
    let (turn, rise) = (std::f64::consts::TAU * random.unit(), random.between(0.0102, 0.05));
    let along = f64::from(mean_slope[0]) * turn.cos() + f64::from(mean_slope[1]) * turn.sin();
    // sin α − s cos α = rise, α being the angle over the plane.
    let angle = along.atan() + (rise / (1.0 + along * along).sqrt()).asin();
    [angle.cos() * turn.cos(), angle.cos() * turn.sin(), angle.sin()].map(|value| value as f32)
}

/// Calls with both directions near the horizon of a tilted surface.
fn calls(random: &mut Random, count: usize) -> Vec<Call> {
    let mut calls = Vec::new();
    while calls.len() < count {
        let slope = mean_slope(random);
        let [view, light] = [near_the_horizon(random, slope), near_the_horizon(random, slope)];
        let at = (1.0 - 6.0 * random.unit()) as f32;
        calls.extend(Call::new(at, 1.0, covariance(random), view, light).tilted(slope));
    }
    calls
}

/// What modules say of the shares that are lit and seen over a tilted mean surface.
#[test]
fn shares_over_tilted_surfaces() -> Outcome {
    let device = Device::new()?;
    let calls = calls(&mut Random::new(19), 20_000);
    for (tier, hotspot, figure) in [
        (HeightTier::Exact, false, "2e-5"),
        (HeightTier::Exact, true, "4.6e-5"),
        (HeightTier::Gaussian, false, "1.1e-4"),
        (HeightTier::Gaussian, true, "2.3e-4"),
    ] {
        let surface = Microsurface { mean_slope: true, masking: true, hotspot, ..Microsurface::default() };
        let scene = Scene::new("rock").height(ColorMap::bands([0.0; 3], [(0.5, [1.0; 3])])?).microsurface(surface);
        let module = scene.height_tier(tier).module()?;
        let hot: Vec<Call> = if hotspot { calls.iter().cloned().map(Call::hot).collect() } else { calls.clone() };
        for (export, figure, truth) in [
            (
                1,
                figure,
                &(|call: &Call| shadowing(call.parts[0], call.lambda - call.parts[0])) as &dyn Fn(&Call) -> f64,
            ),
            (2, if tier == HeightTier::Exact { "2e-5" } else { "1.1e-4" }, &|call: &Call| masking(call.parts[0])),
        ] {
            let export = &module.exports()[export];
            assert!(export.documentation.contains(&format!("Within {figure} of")), "{}", export.documentation);
            let numbers: Vec<f32> = hot.iter().flat_map(|call| call.arguments(&export.signature)).collect();
            let shares = ExportKernel::new(&device, &module, export)?.run(&numbers)?;
            assert_eq!(shares.len(), calls.len());
            let error = |(share, call): (&[f32; 4], &Call)| (f64::from(share[0]) - truth(call)).abs();
            let worst = shares.iter().zip(&hot).map(error).fold(0.0, f64::max);
            println!("{tier}, hotspot {hotspot}: {} errs by {worst:.2e}", export.name);
            assert!(worst <= figure.parse()?, "{worst}");
        }
    }
    Ok(())
}

/// Over tilted mean surfaces steps err as over level ones, but for what the rise over the surface loses in f32.
#[test]
fn tilted_surfaces_keep_the_figures() -> Outcome {
    let device = Device::new()?;
    let step = ColorMap::bands([0.0; 3], [(0.0, [1.0; 3])])?;
    let ranges = Ranges { mean: (-6.0, 3.0), deviation: 1.0 };
    let calls = calls(&mut Random::new(17), 30_000);
    let surface = Microsurface { mean_slope: true, ..Microsurface::default() };
    let scene = Scene::new("edge").height(step).microsurface(surface).ranges(ranges);
    for (tier, figure) in [
        (HeightTier::Exact, 2e-6),
        (HeightTier::ClosedForm, 3.3e-4),
        (HeightTier::ClosedFormFast, 1.65e-3),
        (HeightTier::Gaussian, 4.5e-2),
    ] {
        let scene = scene.clone().height_tier(tier);
        let over = tier == HeightTier::Gaussian;
        let scene = if over { scene.tier(EXACT) } else { scene };
        let found = error(&device, &scene, &calls)?;
        println!("{tier} over tilted surfaces: a step errs by {found:.3e}");
        assert!(found <= figure && found > figure / 4.0, "{tier}: {found}");
    }
    Ok(())
}
