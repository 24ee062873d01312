//! Whatever numbers a description holds, it becomes a module or an error, never a panic.

use std::error::Error as StdError;

use prefilter::{
    Accuracy, ColorMap, Colors, Driver, Error, HeightTier, HeightTransfer, Kernel, Microsurface, Module, Moments,
    Pixel, Ranges, Scene, Shader, Table, Taps, Tier, TransferTier,
};
use proptest::prelude::*;
use proptest::test_runner::TestRunner;

/// Any f32: subnormal, infinite and NaN, and often one at a limit.
fn number() -> impl Strategy<Value = f32> {
    let limits = [0.0, -0.0, 1.0, 1e-6, 1e-3, 65504.0, -65504.0, f32::MAX, f32::MIN_POSITIVE, 1e-45, 0.1, 0.5];
    prop_oneof![2 => proptest::num::f32::ANY, 3 => proptest::sample::select(limits.to_vec()), 3 => -2.0f32..2.0]
}

fn stops() -> impl Strategy<Value = Vec<(f32, [f32; 4])>> {
    prop::collection::vec((number(), prop::array::uniform4(number())), 0..6)
}

/// Stops that make a map: sorted, no position more than twice, in the limits.
fn sorted(stops: &[(f32, [f32; 4])]) -> Vec<(f32, [f32; 4])> {
    let fine = |number: f32| if number.abs() <= 65504.0 { number } else { 0.25 };
    let mut stops: Vec<_> = stops.iter().map(|(at, color)| (fine(*at) + 0.0, color.map(fine))).collect();
    stops.sort_by(|a, b| a.0.total_cmp(&b.0));
    stops.dedup_by_key(|stop| stop.0);
    stops
}

fn tier() -> impl Strategy<Value = (Option<Tier>, Colors)> {
    let exact = Tier::ClosedForm(Kernel::Exact);
    let fast = Tier::ClosedForm(Kernel::Fast);
    proptest::sample::select(vec![
        (Some(Tier::Naive), Colors::Constant),
        (Some(fast), Colors::Constant),
        (Some(exact), Colors::Constant),
        (Some(exact), Colors::Dynamic),
        (Some(Tier::Naive), Colors::Dynamic),
        (Some(Tier::Table), Colors::Constant),
        (Some(Tier::Table), Colors::Dynamic),
        (None, Colors::Dynamic),
        (None, Colors::Constant),
    ])
}

fn height_tier() -> impl Strategy<Value = HeightTier> {
    use HeightTier::{ClosedForm, ClosedFormFast, Exact, Gaussian, Paper, Skewed};
    proptest::sample::select(vec![Paper, Gaussian, ClosedFormFast, ClosedForm, Exact, Skewed])
}

/// Curves of any numbers, those that are refused left out.
fn curve() -> impl Strategy<Value = Option<HeightTransfer>> {
    let any = (prop::collection::vec((number(), number()), 1..4), number(), number(), (number(), number()), 0..5);
    any.prop_map(|(mut knots, a, b, values, shape)| {
        knots.sort_by(|one, other| one.0.total_cmp(&other.0));
        let curve = match shape {
            0 => HeightTransfer::knots(knots),
            1 => HeightTransfer::smoothstep(a.min(b), a.max(b)),
            2 => HeightTransfer::terraces(3, a),
            3 => HeightTransfer::power(1.0 + a.abs().fract()),
            _ => HeightTransfer::absolute().scaled(a, b),
        };
        let over = |curve: HeightTransfer| if a < b { curve.over(values, b) } else { curve };
        curve.ok().map(over)
    })
}

fn pixel() -> impl Strategy<Value = Pixel> {
    prop_oneof![number().prop_map(Pixel::Round), prop::array::uniform3(number()).prop_map(Pixel::Covariance)]
}

fn surface() -> impl Strategy<Value = Microsurface> {
    prop::array::uniform5(prop::bool::ANY).prop_map(|[shadowing, hotspot, masking, mean_slope, perturbed]| {
        Microsurface { shadowing, hotspot, masking, mean_slope, perturbed }
    })
}

/// The map with its positions in [0, 1], however close to each other that brings them.
fn shares(map: &ColorMap) -> Result<ColorMap, TestCaseError> {
    let mut stops: Vec<_> = map.knots().iter().map(|knot| (knot.position.abs().fract(), knot.right)).collect();
    stops.sort_by(|a, b| a.0.total_cmp(&b.0));
    stops.dedup_by_key(|stop| stop.0);
    ColorMap::gradient(stops).map_err(|error| TestCaseError::fail(error.to_string()))
}

/// Whether a module's text, numbers and probe hold together: 1, or 0 for a scene that is refused for what it says. One
/// whose text no validator takes is not refused but wrong.
fn sound(scene: &Scene) -> Result<usize, TestCaseError> {
    let module = match scene.module() {
        Ok(module) => module,
        Err(error @ (Error::Shader { .. } | Error::Collision { .. } | Error::Backend { .. })) => {
            return Err(TestCaseError::fail(format!("{error}: {scene:?}")))
        }
        Err(_) => return Ok(0),
    };
    prop_assert!(module.bound().value() >= 0.0 && module.bound().value().is_finite(), "{}", module.explain());
    let linked = module.link(&module.probe(prefilter::Stage::Fragment));
    prop_assert!(linked.is_ok_and(|shader| shader.spirv().is_ok()), "{}", module.wgsl());
    Ok(1)
}

/// Scenes of slopes and of their lengths.
fn slopes(map: &ColorMap, colors: Colors, ranges: Ranges, accuracy: Accuracy) -> [Scene; 4] {
    let slope = Scene::new("extreme").slope(map.clone()).colors(colors);
    let steep = Scene::new("extreme").steepness(map.clone()).colors(colors);
    [slope.clone().ranges(ranges), slope.accuracy(accuracy), steep.clone().ranges(ranges), steep]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn constructors_return(stops in stops(), low in number(), high in number()) {
        let colors: Vec<[f32; 4]> = stops.iter().map(|stop| stop.1).collect();
        let _ = ColorMap::gradient(stops.clone());
        let _ = ColorMap::gradient_srgb(stops.clone());
        let _ = ColorMap::bands([low; 4], stops.clone());
        let _ = ColorMap::bands_srgb([low; 4], stops.clone());
        let _ = ColorMap::sampled(low, high, &colors);
        let _ = ColorMap::sampled_srgb(low, high, &colors);
    }
}

/// One scene in ten and more is not refused, so that the test says something.
#[test]
fn scenes_return() -> Result<(), Box<dyn StdError + Send + Sync>> {
    let accepted = std::cell::Cell::new(0);
    let config = ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() };
    let mean = (number(), number());
    let inputs = (stops(), tier(), pixel(), number(), mean, number(), height_tier(), surface());
    TestRunner::new(config).run(
        &inputs,
        |(stops, (tier, colors), pixel, error, mean, deviation, height, surface)| {
            let accuracy = Accuracy::max_filter_error(error).without_tables();
            let driver = Driver::Moments(Moments { taps: Taps::Two, pixel, slopes: false });
            let ranges = Ranges { mean, deviation };
            let Ok(map) = ColorMap::gradient(sorted(&stops)) else { return Ok(()) };
            let high =
                Scene::new("extreme").height(map.clone()).colors(colors).height_tier(height).microsurface(surface);
            let shares = Scene::new("extreme").height_percentile(shares(&map)?).colors(colors).microsurface(surface);
            let over = tier.filter(|_| matches!(height, HeightTier::Paper | HeightTier::Gaussian));
            let high = over.map_or(high.clone().accuracy(accuracy), |tier| high.tier(tier));
            let scene = Scene::new("extreme").texture(map.clone()).colors(colors);
            let scene = tier.map_or(scene.clone().accuracy(accuracy), |tier| scene.tier(tier));
            let driven = [scene.clone().driver(driver.clone()), scene.clone().ranges(ranges).driver(driver.clone())];
            let plain = [scene.clone(), scene.ranges(ranges), shares];
            let heights = [high.clone().driver(driver), high.clone(), high.ranges(ranges)];
            let slopes = slopes(&map, colors, ranges, accuracy);
            for scene in driven.iter().chain(&plain).chain(&heights).chain(&slopes) {
                accepted.set(accepted.get() + sound(scene)?);
            }
            Ok(())
        },
    )?;
    println!("{} scenes accepted", accepted.get());
    assert!(accepted.get() >= 240);
    Ok(())
}

/// The same of heights by a curve, whose tables take longer.
#[test]
fn scenes_of_curves_return() -> Result<(), Box<dyn StdError + Send + Sync>> {
    let accepted = std::cell::Cell::new(0);
    let config = ProptestConfig { cases: 60, failure_persistence: None, ..ProptestConfig::default() };
    TestRunner::new(config).run(
        &(stops(), curve(), surface(), prop::bool::ANY),
        |(stops, curve, surface, paper)| {
            let (Ok(map), Some(curve)) = (ColorMap::gradient(sorted(&stops)), curve) else { return Ok(()) };
            let tier = if paper { TransferTier::Paper } else { TransferTier::TwoNodes };
            let high = Scene::new("extreme").height(map.clone()).microsurface(surface);
            for scene in [high, Scene::new("extreme").slope(map.clone()), Scene::new("extreme").steepness(map)] {
                accepted.set(accepted.get() + sound(&scene.transfer(curve.clone()).transfer_tier(tier))?);
            }
            Ok(())
        },
    )?;
    println!("{} scenes accepted", accepted.get());
    assert!(accepted.get() >= 10);
    Ok(())
}

#[test]
fn as_many_knots_as_a_map_may_have() -> Result<(), Box<dyn StdError + Send + Sync>> {
    let many = |count: i32| {
        ColorMap::gradient((0..count).map(|at| (at as f32, [(at % 7) as f32 / 6.0, 0.5, (at % 2) as f32])))
    };
    let ranges = Ranges { mean: (-10.0, 2100.0), deviation: 600.0 };
    for (count, tier, colors) in [
        (600, Tier::ClosedForm(Kernel::Exact), Colors::Constant), // naga's time grows with the square
        (2048, Tier::ClosedForm(Kernel::Exact), Colors::Dynamic),
        (2048, Tier::Table, Colors::Constant),
    ] {
        let module = Scene::new("many").texture(many(count)?).ranges(ranges).tier(tier).colors(colors).module()?;
        module.link(&module.probe(prefilter::Stage::Compute))?.spirv()?;
    }
    Ok(())
}

#[test]
fn descriptions_and_results_go_between_threads() {
    fn shared<T: Send + Sync + Clone + std::fmt::Debug>() {}
    shared::<Scene>();
    shared::<ColorMap>();
    shared::<Module>();
    shared::<Shader>();
    shared::<Table>();
    shared::<Error>();
    shared::<prefilter::MomentMipmap>();
    shared::<prefilter::gpu::Device>();
    shared::<prefilter::gpu::Kernel>();
    shared::<prefilter::gpu::Dispatch>();
    shared::<prefilter::gpu::Texture>();
}
