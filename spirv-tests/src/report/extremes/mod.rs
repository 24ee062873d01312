//! Hard cases: formulas that break, and what stands in their place.

mod broken;
pub mod formulas;
pub mod pairs;

use super::document::Section;
use super::{Bench, Error, Extent};

/// Steps of this part.
pub fn steps(_: Extent) -> u64 {
    broken::STEPS
}

/// Measures it.
///
/// # Errors
/// Those of scenes, of the device, and a message where a formula cannot be judged.
pub fn section(bench: &Bench<'_>) -> Result<Section, Error> {
    let items = broken::items(bench)?;
    Ok(Section { stem: "extremes".into(), title: "Hard cases".into(), items })
}
