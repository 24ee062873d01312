//! What a footprint knows of the function that drives a material: its mean and deviation there, or those of its slopes.

pub mod moment_mipmap;
pub mod moments;
mod pyramid;
mod slope_grid;
pub mod slope_mipmap;
pub mod slope_moments;
pub mod taps;

use moments::Moments;
use slope_moments::SlopeMoments;

use crate::Error;

/// Where a scene's statistics come from; a scene without one takes them as arguments.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Driver {
    /// Mean and deviation of a tabulated function, an image: for values and heights.
    Moments(Moments),
    /// Mean and covariance of the slopes of a map of normals or heights: for slopes, steepness and irradiance.
    SlopeMoments(SlopeMoments),
}

impl Driver {
    /// Whether the description can be used.
    ///
    /// # Errors
    /// [`Error::Value`] for a number outside its range.
    pub(crate) fn check(&self) -> Result<(), Error> {
        match self {
            Self::Moments(moments) => moments.pixel.check(),
            Self::SlopeMoments(moments) => moments.pixel.check(),
        }
    }

    /// The statistics that it gives a filter, with its name.
    pub(crate) fn gives(&self) -> &'static str {
        match self {
            Self::Moments(Moments { slopes: true, .. }) => {
                "mean and deviation of a height and its slopes, `Driver::Moments` with `slopes`"
            }
            Self::Moments(_) => "mean and deviation of a value, `Driver::Moments`",
            Self::SlopeMoments(_) => "mean and covariance of slopes, `Driver::SlopeMoments`",
        }
    }

    /// Turns of the loop in `NAME_color`.
    pub(crate) fn trips(&self) -> usize {
        match self {
            Self::Moments(moments) => moments.taps.count() as usize,
            Self::SlopeMoments(moments) => moments.taps.count() as usize,
        }
    }

    /// What no bound of a filter covers with this driver, and how much that was measured to be.
    pub(crate) fn gap(&self) -> String {
        match self {
            Self::Moments(moments) => moments::gap(moments.taps),
            Self::SlopeMoments(moments) => slope_moments::gap(moments.taps),
        }
    }

    /// The WGSL of `NAME_color`, which calls a filter.
    pub(crate) fn glue(&self, called: &Called<'_>) -> String {
        match self {
            Self::Moments(moments) => moments::glue(called, moments),
            Self::SlopeMoments(moments) => slope_moments::glue(called, moments),
        }
    }
}

/// The filter that a driver's export calls for each tap.
pub(crate) struct Called<'a> {
    /// The scene's name.
    pub name: &'a str,
    /// What follows it in the filter's name: `texture`.
    pub function: &'a str,
    /// The type of the filter's result.
    pub color_type: &'a str,
    /// What the filter takes after the driver's statistics, the same for every tap, each parameter behind a comma.
    pub given: &'a str,
    /// The tables that it takes behind that, each parameter behind a comma.
    pub parameters: &'a str,
    /// Their arguments, each behind a comma.
    pub arguments: &'a str,
}

impl Called<'_> {
    /// The call with these statistics for its first arguments.
    pub(crate) fn call(&self, statistics: &str) -> String {
        let Self { name, function, arguments, .. } = self;
        let given = self.given.split(", ").filter_map(|parameter| parameter.split_once(": "));
        let given: String = given.map(|(name, _)| format!(", {name}")).collect();
        format!("{name}_{function}({statistics}{given}{arguments})")
    }
}
