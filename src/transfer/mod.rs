//! What is applied to the values that a pixel covers: color maps, and light by the normal.

pub mod color_map;
#[cfg(feature = "image")]
mod image_row;
#[cfg(feature = "image")]
mod image_sphere;
pub mod irradiance;
pub(crate) mod pieces;
#[cfg(feature = "colorgrad")]
mod sampled_gradient;
#[cfg(feature = "serde")]
mod serial;
pub mod slope_map;
pub mod srgb;
