//! Visibility: is the reference right, does the device compute it, and does nothing leave its range?

mod extremes;
mod figures;
mod reference;

use prefilter::gpu::Device;
use spirv_tests::kernel::Function;
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

/// The results of the function `judged` of a text that mentions the shelf.
fn results(text: &str, points: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let function = Function::in_text(text, "judged").expect("naga takes the text");
    function.results(&Device::new().expect("the tests need a device"), &[], points).expect("the device runs it")
}
