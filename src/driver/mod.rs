//! What a footprint knows of the function that drives a material: its mean and deviation there.

pub mod moment_mipmap;
pub mod moments;

use moments::Moments;

use crate::Error;

/// Where a scene's mean and deviation come from; a scene without one takes them as arguments.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Driver {
    /// A tabulated function: an image.
    Moments(Moments),
}

impl Driver {
    /// Whether the description can be used.
    ///
    /// # Errors
    /// [`Error::Value`] for a number outside its range.
    pub(crate) fn check(&self) -> Result<(), Error> {
        match self {
            Self::Moments(moments) => moments.check(),
        }
    }

    /// Turns of the loop in `NAME_color`.
    pub(crate) fn trips(&self) -> usize {
        match self {
            Self::Moments(moments) => moments.taps.count() as usize,
        }
    }

    /// What no bound of a filter covers with this driver, and how much that was measured to be.
    pub(crate) fn gap(&self) -> String {
        match self {
            Self::Moments(moments) => moments::gap(moments.taps),
        }
    }

    /// The WGSL of `NAME_color`, which calls `NAME_texture`.
    ///
    /// `extra_parameters` and `extra_arguments` are empty or begin with a comma: what `NAME_texture` takes after the
    /// deviation.
    pub(crate) fn glue(&self, name: &str, color_type: &str, extra_parameters: &str, extra_arguments: &str) -> String {
        match self {
            Self::Moments(moments) => moments::glue(name, color_type, extra_parameters, extra_arguments, moments),
        }
    }
}
