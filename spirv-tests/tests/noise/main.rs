//! Procedural noise on the device: its statistics, its periods, its seeds and its gradient.

mod noises;
mod periods;

use prefilter::gpu::Device;
use spirv_tests::kernel::Function;

type Outcome = Result<(), Box<dyn std::error::Error + Send + Sync>>;

/// The results of a function of the shelf at lists of numbers.
fn at(
    device: &Device,
    name: &str,
    points: &[Vec<f64>],
) -> Result<Vec<Vec<f64>>, Box<dyn std::error::Error + Send + Sync>> {
    let shelf = Function::shelf()?;
    let function = shelf.iter().find(|function| function.name == name).ok_or("no such function")?;
    Ok(function.results(device, &[], points)?)
}
