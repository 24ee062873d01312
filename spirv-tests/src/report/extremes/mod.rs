//! Hard cases: every filter and driver where it is hard, and formulas that break there.

mod broken;
pub mod cases;
pub mod covers;
pub mod drivers;
pub mod filters;
pub mod footprints;
pub mod formulas;
pub mod judge;
pub mod outcome;
pub mod pairs;
pub mod points;
pub mod promise;
mod pyramids;
pub mod subject;
mod tables;
mod truth;

use super::document::Section;
use super::{Bench, Error, Extent};

/// Points of a case: as many as there are depths below the horizon and powers of ten, and ten times as many.
pub const POINTS: [usize; 2] = [18, 180];

/// Steps of this part.
pub fn steps(_: Extent) -> u64 {
    tables::STEPS + broken::STEPS
}

/// Measures it.
///
/// # Errors
/// Those of scenes, of the device, and a message where a filter or a formula cannot be judged.
pub fn section(bench: &Bench<'_>) -> Result<Section, Error> {
    let [quick, full] = POINTS;
    let mut items = tables::items(bench, bench.extent.pick(quick, full))?;
    items.extend(broken::items(bench)?);
    Ok(Section { stem: "extremes".into(), title: "Hard cases".into(), items })
}
