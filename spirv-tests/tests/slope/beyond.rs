//! Components that deviate more than a scene's ranges say.

use prefilter::gpu::Device;
use prefilter::reference::slope::mean;
use prefilter::reference::slopes::Visible;
use prefilter::reference::texture::{self, PiecewiseLinear};
use prefilter::{Ranges, Scene, SlopeTier};
use spirv_tests::exports::ExportKernel;
use spirv_tests::maps::random;

use crate::figures::{calls, component, Call, EXACT};
use crate::{single, Outcome, Random};

const RANGES: Ranges = Ranges { mean: (-1.0, 1.4), deviation: 0.5 };

/// The middle of a map.
fn middle(map: &PiecewiseLinear) -> f64 {
    let ends = [map.knots.first(), map.knots.last()].into_iter().flatten();
    0.5 * ends.map(|knot| knot.0).sum::<f64>()
}

/// The largest density of a component of visible slopes, times its deviation over all slopes: that of Rayleigh at the
/// horizon of the mean surface, e^-½.
const DENSEST: f64 = 0.607;

/// The call with slopes that deviate a tenth more than the ranges say along its direction, to a million times as much.
fn widened(random: &mut Random, (visible, direction): Call) -> Call {
    let [_, deviation] = component(&(visible, direction));
    let scale = 0.55 / deviation * 10f64.powf(6.0 * random.unit());
    let covariance = single(visible.covariance.map(|value| scale * scale * value));
    (Visible { covariance, ..visible }, direction)
}

/// The map drawn apart about the middle by as much as slopes are drawn together.
fn apart(map: &PiecewiseLinear, deviation: f64) -> PiecewiseLinear {
    let times = (deviation / f64::from(RANGES.deviation)).max(1.0);
    let middle = middle(map);
    let knots = map.knots.iter().map(|knot| (middle + (knot.0 - middle) * times, knot.1, knot.2));
    PiecewiseLinear { knots: knots.collect() }
}

/// What drawing slopes together may move a channel by: of each change what lies between it and where it is drawn.
fn moved(map: &PiecewiseLinear, channel: usize) -> f64 {
    let share = |at: f64| (DENSEST * (at - middle(map)).abs() / f64::from(RANGES.deviation)).min(1.0);
    let jumps = map.knots.iter().map(|knot| (knot.2[channel] - knot.1[channel]).abs() * share(knot.0));
    let ramps = map
        .knots
        .windows(2)
        .map(|pair| (pair[1].1[channel] - pair[0].2[channel]).abs() * share(pair[0].0).max(share(pair[1].0)));
    jumps.sum::<f64>() + ramps.sum::<f64>()
}

/// Against the integral of slopes drawn together, which is as near that of all as [`Ranges`] says; what cuts deviations
/// alone, while means move on, is far off.
#[test]
fn components_beyond_the_ranges_are_drawn_together() -> Outcome {
    let device = Device::new()?;
    let map = random(8, true, 5)?;
    let reference = map.reference();
    let scene = Scene::new("dune").slope(map.clone()).ranges(RANGES).tier(EXACT);
    let mut random = Random::new(67);
    let inside = calls(&mut random, &map, RANGES, 600);
    let calls: Vec<Call> = inside.into_iter().map(|call| widened(&mut random, call)).collect();
    for tier in [SlopeTier::Gaussian, SlopeTier::Pair] {
        let module = scene.clone().slope_tier(tier).module()?;
        let of =
            |(visible, direction): &Call| [&visible.mean[..], &visible.covariance, &visible.view, direction].concat();
        let numbers: Vec<f32> = calls.iter().flat_map(of).map(|value| value as f32).collect();
        let colors = ExportKernel::new(&device, &module, &module.exports()[0])?.run(&numbers)?;
        let [mut worst, mut cut] = [0.0f64; 2];
        for (color, call) in colors.iter().zip(&calls) {
            let (visible, direction) = call;
            let counted = mean(&apart(&reference, component(call)[1]), visible, *direction);
            let truth = mean(&reference, visible, *direction);
            let [at, wide, _] = visible.moments_along(*direction);
            let limited = texture::mean(&reference, at, wide.min(RANGES.deviation.into()));
            for channel in 0..3 {
                assert!((counted[channel] - truth[channel]).abs() <= moved(&reference, channel), "{call:?}");
                worst = worst.max((f64::from(color[channel]) - counted[channel]).abs());
                cut = cut.max((limited[channel] - truth[channel]).abs());
            }
        }
        let bound = f64::from(module.bound().value());
        println!("{tier}: {worst:.2e} of {bound:.2e}; with deviations cut alone {cut:.2}");
        assert!(worst > 0.0 && worst <= bound && cut > bound && cut > 10.0 * worst, "{tier}: {worst}, {bound}, {cut}");
    }
    Ok(())
}
