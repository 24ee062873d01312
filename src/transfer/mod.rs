//! What is applied to the values that a pixel covers: color maps, light by the normal, and curves from values to
//! heights.

pub mod color_map;
pub mod height_transfer;
#[cfg(feature = "image")]
mod image_row;
#[cfg(feature = "image")]
mod image_sphere;
pub mod irradiance;
pub(crate) mod pieces;
pub(crate) mod polynomial;
#[cfg(feature = "colorgrad")]
mod sampled_gradient;
#[cfg(feature = "serde")]
mod serial;
mod shape;
pub mod slope_map;
pub mod srgb;
