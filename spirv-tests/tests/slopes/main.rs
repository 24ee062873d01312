//! Visible slopes: the reference against definitions and a second quadrature, the device against the reference, and the
//! figures that the crate promises, and the model against height fields.

mod device;
mod extremes;
mod gap;
mod normals;
mod references;
mod ridges;
mod standard;
mod steepness;
mod steps;

use std::f64::consts::TAU;

use prefilter::reference::slopes::Visible;
use spirv_tests::random::Random;

/// The numbers as the device takes them.
fn single<const N: usize>(values: [f64; N]) -> [f64; N] {
    values.map(|value| f64::from(value as f32))
}

/// The unit vector with the height z at an azimuth, in f32.
fn direction(z: f64, azimuth: f64) -> [f64; 3] {
    let radius = ((1.0 - z) * (1.0 + z)).max(0.0).sqrt();
    single([radius * azimuth.cos(), radius * azimuth.sin(), z])
}

/// A surface seen from above or below its horizon: deviations in [0.05, 1.5], correlations up to 0.98, mean slopes up
/// to 0.5, numbers in f32.
fn any(random: &mut Random) -> Visible {
    let view = direction(random.unit() * 1.2 - 0.2, TAU * random.unit());
    let [x, y] = [random.between(0.05, 1.5), random.between(0.05, 1.5)];
    let correlation = 0.98 * (2.0 * random.unit() - 1.0);
    let tilt = random.pick([0.0, 1.0, 1.0]);
    let mean = single([tilt * (random.unit() - 0.5), tilt * (random.unit() - 0.5)]);
    Visible { view, covariance: single([x * x, correlation * x * y, y * y]), mean }
}
