//! Color by one component of the slope: the reference by two methods, and the shelf's chain on the device against it.

mod beyond;
mod chain;
mod driven;
mod figures;
mod references;
mod scenes;
mod steepness;
mod steepness_scenes;

use std::error::Error;
use std::f64::consts::TAU;

use prefilter::reference::slopes::Visible;
use prefilter::ColorMap;
use spirv_tests::maps::{named, random};
use spirv_tests::random::Random;

type Fault = Box<dyn Error + Send + Sync>;
type Outcome = Result<(), Fault>;

/// Maps over slopes from −1 to 1, with their total variation: gradients, bands, and both.
fn maps() -> Result<Vec<(ColorMap, f64)>, Fault> {
    let maps = [named("terrain")?, named("steps6")?, random(12, true, 3)?];
    maps.into_iter().map(|map| over_slopes(&map)).collect()
}

/// A map over [0, 1] stretched to slopes, and the most that a channel rises and falls.
fn over_slopes(map: &ColorMap) -> Result<(ColorMap, f64), Fault> {
    let three = |[r, g, b, _]: [f32; 4]| [r, g, b];
    let stops = map.knots().iter().flat_map(|knot| {
        let at = 2.0 * knot.position - 1.0;
        let hard = (knot.left != knot.right).then_some((at, three(knot.right)));
        [Some((at, three(knot.left))), hard].into_iter().flatten()
    });
    let stops: Vec<_> = stops.collect();
    let change = |channel: usize, pair: &[(f32, [f32; 3])]| f64::from((pair[1].1[channel] - pair[0].1[channel]).abs());
    let variation = (0..3).map(|channel| stops.windows(2).map(|pair| change(channel, pair)).sum::<f64>());
    let variation = variation.fold(0.0, f64::max);
    Ok((ColorMap::gradient(stops)?, variation))
}

/// The numbers as the device takes them.
fn single<const N: usize>(values: [f64; N]) -> [f64; N] {
    values.map(|value| f64::from(value as f32))
}

/// A surface seen from above its horizon, and a direction: along the view, against it, across or anywhere.
fn view(random: &mut Random) -> (Visible, [f64; 2]) {
    loop {
        let (even, grazing, azimuth) = (random.unit(), random.between(1e-3, 1.0), TAU * random.unit());
        let z = random.pick([even, grazing]);
        let radius = ((1.0 - z) * (1.0 + z)).max(0.0).sqrt();
        let [x, y] = [random.between(0.03, 1.2), random.between(0.03, 1.2)];
        let covariance = single([x * x, 0.9 * (2.0 * random.unit() - 1.0) * x * y, y * y]);
        let mean = single([0.6 * random.unit() - 0.3, 0.6 * random.unit() - 0.3]);
        let view = single([radius * azimuth.cos(), radius * azimuth.sin(), z]);
        let turn = TAU * random.unit();
        let angle = azimuth + random.pick([0.0, 0.5 * TAU, 0.25 * TAU, turn]);
        let visible = Visible { view, covariance, mean };
        if visible.parameter() >= 0.0 {
            return (visible, single([angle.cos(), angle.sin()]));
        }
    }
}
