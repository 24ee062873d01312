//! What is applied to the values that a pixel covers: color maps.

pub mod color_map;
#[cfg(feature = "image")]
mod image_row;
pub(crate) mod pieces;
#[cfg(feature = "colorgrad")]
mod sampled_gradient;
#[cfg(feature = "serde")]
mod serial;
pub mod srgb;
