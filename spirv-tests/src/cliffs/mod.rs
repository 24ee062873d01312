//! The demo of mountains: rock where it is steep, snow where it is high and flat, in the light of skies with a sun,
//! near and far, judged against rays to all of them. `cargo run --release -p spirv-tests --bin cliffs` makes it.
//!
//! The truth shoots rays from the eye to a relief of all elevations and looks color and irradiance up there; nothing
//! hides the sky from a point, as in the filters. What those know is the ground as the pixel's footprint leaves it, and
//! the statistics of the heights and slopes that the footprint loses, read from pyramids along the ray. Figures are
//! told apart by how much is lost. Near, the displaced geometry errs, which is the same for every method. Far, the
//! filters do, and their model: heights and slopes of mountains are neither normal nor independent.
//!
//! Against the model itself, in f64, methods are judged besides: what the product of the mean color and the mean
//! irradiance costs is small against what mountains differ from the model by, and shows only there.
//!
//! `docs/cliffs.csv` and `docs/cliffs_model.csv` are a full run.

pub mod ground;
pub mod judge;
pub mod known;
pub mod method;
pub mod model;
pub mod scene;
pub mod sheet;
pub mod table;
pub mod truth;

pub use crate::imaging::Error;
