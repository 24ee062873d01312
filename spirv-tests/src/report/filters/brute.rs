//! Brute force: the same means by stratified samples on the device.

use super::pixel::Pixel;
use crate::exports::ExportKernel;
use prefilter::gpu::Device;
use prefilter::{Error, Module};

/// Strata along each side of the unit square.
pub const SIDES: [usize; 7] = [1, 2, 4, 8, 16, 32, 64];

/// What a sample is, and what it counts.
#[derive(Clone, Debug)]
pub struct Brute {
    /// Modules whose exports the samples call: maps without any filter.
    pub modules: Vec<Module>,
    /// What is known of a pixel: names and types of parameters.
    pub parameters: &'static str,
    /// Statements once a pixel.
    pub before: String,
    /// Statements that name the sample's `color` and `weight`; they know its `index`, that there are `count`, and the
    /// random `point` of its stratum.
    pub sample: String,
}

const FUNCTIONS: &str = include_str!("brute.wgsl");

impl Brute {
    /// The function on a device.
    ///
    /// # Errors
    /// What naga or the device refuses.
    pub fn kernel(&self, device: &Device) -> Result<ExportKernel, Error> {
        let Self { modules, parameters, before, sample } = self;
        let text = format!(
            "fn brute({parameters}, side: f32, seed: f32) -> vec3f {{
    let across = u32(side);
    let count = across * across;
    let chance = u32(seed);
    {before}
    var sum = vec3f();
    var whole = 0.0;
    for (var index = 0u; index < count; index++) {{
        let point = brute_point(index, across, chance);
        {sample}
        sum += weight * color;
        whole += weight;
    }}
    return sum / whole;
}}

{FUNCTIONS}"
        );
        ExportKernel::before(device, &modules.iter().collect::<Vec<_>>(), &text, "brute")
    }

    /// The numbers that the function takes of pixels; each has chances of its own.
    pub fn points(kernel: &ExportKernel, pixels: &[Pixel], side: usize, first: usize) -> Vec<f32> {
        let parameters = kernel.parameters();
        let number = |(at, pixel): (usize, &Pixel)| {
            pixel.numbers(&parameters, &[("side", side as f64), ("seed", (first + at) as f64)])
        };
        pixels.iter().enumerate().flat_map(number).collect()
    }
}
