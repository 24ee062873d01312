//! Heights of displaced geometry: the mean of a curve over normal values, as the device finds it.

use super::Error;
use crate::exports::ExportKernel;
use prefilter::gpu::Device;
use prefilter::Module;

/// Means of f that are looked at: of a variance of 1 none is beyond.
const MEANS: f64 = 5.0;

/// Steps from one to the other end of means, and from 0 to 1 of deviations: between them heights are off by less than
/// 1e-4 of their range.
const STEPS: [usize; 2] = [1600, 64];

/// Mean heights over mean and deviation of f.
#[derive(Clone, Debug)]
pub struct Displacement {
    heights: Vec<f64>,
}

impl Displacement {
    /// What `NAME_transferred` of a module gives.
    ///
    /// # Errors
    /// Those of the device; a module without that export.
    pub fn new(device: &Device, module: &Module) -> Result<Self, Error> {
        let points: Vec<f32> = (0..=STEPS[1]).flat_map(row).collect();
        let name = format!("{}_transferred", module.name());
        let export = module.exports().iter().find(|export| export.name == name);
        let Some(export) = export else { return Err(Error::Map(format!("no export {name}"))) };
        let found = ExportKernel::new(device, module, export)?.run(&points)?;
        Ok(Self { heights: found.iter().map(|moments| f64::from(moments[0])).collect() })
    }

    /// The mean height.
    pub fn height(&self, mean: f64, deviation: f64) -> f64 {
        let at = |value: f64, steps: usize| {
            let place = (value * steps as f64).clamp(0.0, steps as f64);
            let first = (place as usize).min(steps - 1);
            (first, place - first as f64)
        };
        let ((column, right), (row, down)) = (at(0.5 + 0.5 * mean / MEANS, STEPS[0]), at(deviation, STEPS[1]));
        let node = |row: usize, column: usize| self.heights[row * (STEPS[0] + 1) + column];
        let along = |row: usize| node(row, column) + right * (node(row, column + 1) - node(row, column));
        along(row) + down * (along(row + 1) - along(row))
    }

    /// How much it changes with the mean.
    pub fn slope(&self, mean: f64, deviation: f64) -> f64 {
        let step = MEANS / STEPS[0] as f64;
        (self.height(mean + step, deviation) - self.height(mean - step, deviation)) / (2.0 * step)
    }
}

/// Means and deviations of a row of the table.
fn row(row: usize) -> impl Iterator<Item = f32> {
    let deviation = row as f64 / STEPS[1] as f64;
    let mean = |column: usize| MEANS * (2.0 * column as f64 / STEPS[0] as f64 - 1.0);
    (0..=STEPS[0]).flat_map(move |column| [mean(column) as f32, deviation as f32])
}

#[cfg(test)]
mod tests {
    use super::super::method::module;
    use super::super::scene::{materials, HEIGHT};
    use super::*;
    use prefilter::reference::normal::density;
    use prefilter::TransferTier;

    /// Against the midpoint rule over the curve itself, between the nodes of the table, too.
    #[test]
    fn geometry_stands_at_the_mean_height() -> Result<(), Error> {
        let device = Device::new()?;
        for material in materials()? {
            let displacement = Displacement::new(&device, &module(&material, TransferTier::Paper)?)?;
            for (mean, deviation) in [(-1.03, 0.7), (0.31, 0.0), (0.617, 0.211), (1.1, 0.004), (0.0, 1.0), (3.7, 0.9)] {
                let (mut sum, mut weights) = (0.0, 0.0);
                for number in 0..2000 {
                    let away = 0.008 * (f64::from(number) + 0.5) - 8.0;
                    sum += density(away) * material.curve.height(mean + deviation * away);
                    weights += density(away);
                }
                let (found, expected) = (displacement.height(mean, deviation), sum / weights);
                let off = (found - expected).abs() / f64::from(HEIGHT);
                assert!(off < 3e-4, "{}, {mean} {deviation}: {found} {expected}", material.name);
            }
        }
        Ok(())
    }
}
