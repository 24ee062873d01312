//! The demo of noise: a plane to the horizon and blocks with sharp edges, colored by noise, filtered on the device and
//! judged against brute force. `cargo run --release -p spirv-tests --bin noise` makes it.
//!
//! The truth evaluates the noise itself, by its definition, at many places of a pixel, and looks each up in the map.
//! Methods evaluate once at the pixel's middle, or at a few taps, and know the pixel's sides: those that people use
//! where there is no filter, the recipe of Heitz et al. 2014, and the generated modules. Of blocks only colors are
//! judged: light and silhouettes are the same in all pictures.
//!
//! `docs/noise.csv` is a full run.

pub mod input;
pub mod judge;
pub mod lens;
pub mod method;
pub mod sheet;
pub mod table;
pub mod truth;

pub use crate::imaging::Error;
