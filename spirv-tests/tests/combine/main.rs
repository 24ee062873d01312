//! Combinations of layers on the device: sums and products of what each layer is, with light and without.

mod bounds;
mod driven;
mod joint;
mod light;
mod limits;
mod scenes;
mod settings;

use std::error::Error;

use prefilter::gpu::Device;
use prefilter::Module;
use spirv_tests::exports::ExportKernel;

type Fault = Box<dyn Error + Send + Sync>;
type Outcome = Result<(), Fault>;

/// The colors of an export: `number` gives the numbers of a parameter by its name, point by point.
fn run(
    device: &Device,
    module: &Module,
    export: &str,
    points: usize,
    mut number: impl FnMut(usize, &str) -> Vec<f64>,
) -> Result<Vec<[f32; 4]>, Fault> {
    let export = module.exports().iter().find(|found| found.name == export).ok_or("no such export")?;
    let parameters: Vec<_> = export.parameters().into_iter().filter(|(_, kind)| !kind.contains("texture")).collect();
    let names = || parameters.iter().map(|(name, _)| *name).filter(|name| !name.ends_with("_sampler"));
    let numbers: Vec<f32> = (0..points)
        .flat_map(|point| names().flat_map(|name| number(point, name)).collect::<Vec<_>>())
        .map(|v| v as f32)
        .collect();
    Ok(ExportKernel::new(device, module, export)?.run(&numbers)?)
}
