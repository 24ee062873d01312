//! The demo of a rough surface: heights colored by a map, seen and lit from many directions, near and far, judged
//! against rays through all of them. `cargo run --release -p spirv-tests --bin rough` makes it.
//!
//! The truth shoots rays from the eye to a relief of all heights, and from there toward the suns. What filters know is
//! the surface as the pixel's footprint leaves it, and the statistics of the heights and slopes that the footprint
//! loses. Three kinds of error are in the figures, told apart by how much is lost. Near, the displaced geometry errs,
//! which is the same for every method. Far, where all is lost, the distribution of visible heights errs, and Smith's
//! model under it. Between, waves that are left and waves that are lost hide each other over distances that both
//! have: the model knows the lost ones over a plane only, sees too many valleys, and a fit that is too high for the
//! model is nearer to the truth by accident.
//!
//! `docs/rough.csv` is a full run. The truth's standard error is below a third of every figure over all pixels. Of far
//! pixels it is up to 0.4 of the closed form's, lit from ahead or seen from overhead; its variance is taken off.

pub mod judge;
pub mod known;
pub mod method;
pub mod relief;
pub mod scene;
pub mod sheet;
pub mod surface;
pub mod table;
pub mod tally;
pub mod truth;

pub use crate::imaging::Error;
