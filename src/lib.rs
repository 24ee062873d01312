//! Filtered color maps as WGSL.
#![deny(missing_docs)]

mod error;
pub mod reference;
pub mod table;

pub use error::Error;
