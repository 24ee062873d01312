//! Color by the whole slope: the reference by two methods, the round distributions that stand for visible slopes and
//! the tables of their means on the device against it.

mod figures;
mod references;
mod scenes;
mod tables;

use std::error::Error;
use std::f64::consts::TAU;

use prefilter::reference::slopes::Visible;
use prefilter::{SlopeDomain, SlopeMap};
use spirv_tests::random::Random;

type Fault = Box<dyn Error + Send + Sync>;
type Outcome = Result<(), Fault>;

/// The numbers as a device takes them.
fn single<const N: usize>(values: [f64; N]) -> [f64; N] {
    values.map(|value| f64::from(value as f32))
}

/// A covariance with a deviation along an axis, and `aspect` times less across.
fn turned(deviation: f64, aspect: f64, turn: f64) -> [f64; 3] {
    let (sin, cos) = turn.sin_cos();
    let [long, short] = [deviation * deviation, (deviation / aspect).powi(2)];
    single([long * cos * cos + short * sin * sin, (long - short) * sin * cos, long * sin * sin + short * cos * cos])
}

/// A surface seen from above its horizon, whose slopes have one deviation along an axis and `aspect` times less across.
fn seen(random: &mut Random, deviation: f64, aspect: f64, most: f64) -> Visible {
    loop {
        let (even, grazing, azimuth) = (random.unit(), random.between(1e-3, 1.0), TAU * random.unit());
        let z = random.pick([even, grazing]);
        let radius = ((1.0 - z) * (1.0 + z)).max(0.0).sqrt();
        let covariance = turned(deviation, aspect, TAU * random.unit());
        let mean = single([0, 1].map(|_| most * (2.0 * random.unit() - 1.0)));
        let view = single([radius * azimuth.cos(), radius * azimuth.sin(), z]);
        let visible = Visible { view, covariance, mean };
        if visible.parameter() >= 0.0 {
            return visible;
        }
    }
}

/// A half plane, red; a disc, green; a quarter of all directions, blue: white on black, with edges a cell wide.
fn edges(size: usize, domain: SlopeDomain, turn: f32) -> Result<SlopeMap, prefilter::Error> {
    let (sin, cos) = turn.sin_cos();
    let inside = |yes: bool| f32::from(u8::from(yes));
    SlopeMap::from_function(size, domain, |[x, y]| {
        let [along, across] = [cos * x + sin * y, cos * y - sin * x];
        [inside(along > 0.17), inside(x.hypot(y) < 0.6), inside(along > 0.0 && across > 0.0)]
    })
}
