//! Filtered color maps as WGSL.
#![deny(missing_docs)]

mod accuracy;
mod cost;
pub mod driver;
mod error;
pub mod filter;
#[cfg(feature = "gpu")]
pub mod gpu;
mod module;
mod name;
mod probe;
pub mod reference;
mod reserved;
mod scene;
mod shader;
pub mod table;
pub mod transfer;

pub use accuracy::{Accuracy, Bound, Ranges};
pub use cost::Cost;
pub use driver::moment_mipmap::{Edge, MomentMipmap};
pub use driver::moments::{Moments, Pixel, Taps};
pub use driver::Driver;
pub use error::Error;
pub use filter::{Kernel, Tier};
pub use module::{Export, Module, Stage};
#[cfg(feature = "macros")]
#[doc(inline)]
pub use prefilter_macros::include_wgsl;
pub use scene::Scene;
pub use shader::{link, Shader};
pub use table::Table;
pub use transfer::color_map::{ColorMap, Colors};
