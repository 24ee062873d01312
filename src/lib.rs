//! Filtered color maps as WGSL.
#![deny(missing_docs)]

mod error;
#[cfg(feature = "gpu")]
pub mod gpu;
pub mod reference;
pub mod table;

pub use error::Error;
