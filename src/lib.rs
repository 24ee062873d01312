//! Filtered color maps as WGSL.
#![deny(missing_docs)]

mod error;
#[cfg(feature = "gpu")]
pub mod gpu;
pub mod reference;
pub mod table;

pub use error::Error;
#[cfg(feature = "macros")]
#[doc(inline)]
pub use prefilter_macros::include_wgsl;
