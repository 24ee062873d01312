//! Visibility: is the reference right, does the device compute it, and does nothing leave its range?

mod extremes;
mod figures;
mod reference;

use prefilter::gpu::Device;
use spirv_tests::kernel::Function;

/// PCG's output function over a linear congruential generator: the same cases on every machine.
struct Random(u32);

impl Random {
    fn word(&mut self) -> u32 {
        self.0 = self.0.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
        let word = ((self.0 >> ((self.0 >> 28) + 4)) ^ self.0).wrapping_mul(277_803_737);
        (word >> 22) ^ word
    }

    fn unit(&mut self) -> f64 {
        f64::from(self.word()) / 4_294_967_296.0
    }

    fn pick<T: Copy, const N: usize>(&mut self, of: [T; N]) -> T {
        of[self.word() as usize % N]
    }

    /// Evenly between the logarithms.
    fn between(&mut self, low: f64, high: f64) -> f64 {
        low * (high / low).powf(self.unit())
    }

    fn sign(&mut self) -> f64 {
        self.pick([-1.0, 1.0])
    }
}

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
