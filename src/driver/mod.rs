//! What a driver knows of a function over a footprint: its mean and deviation there, or those of its slopes.

mod bend;
pub mod cosines;
pub mod custom;
pub mod fold;
pub mod four_moments;
pub mod function;
pub mod gabor;
pub mod gabor_spectrum;
pub mod indicator_mipmap;
pub mod indicators;
pub mod moment_mipmap;
pub mod moments;
pub mod noise;
mod octave_slopes;
mod octaves;
pub mod pattern;
mod pyramid;
mod slope_grid;
pub mod slope_mipmap;
pub mod slope_moments;
mod solid;
pub mod taps;
pub mod transfer;
pub mod warp;

use cosines::Cosines;
use custom::Custom;
use function::Function;
use gabor::Gabor;
use indicators::Indicators;
use moments::Moments;
use noise::Noise;
use pattern::Pattern;
use slope_moments::SlopeMoments;
use taps::Taps;
use warp::Warp;

use crate::Error;

/// Where a scene's statistics come from; a scene without one takes them as arguments.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Driver {
    /// Mean and deviation of a tabulated function, an image: for values and heights.
    Moments(Moments),
    /// Shares of an image that each band of a map of bands covers: for values.
    Indicators(Indicators),
    /// Mean and covariance of the slopes of a map of normals or heights: for slopes, steepness and irradiance.
    SlopeMoments(SlopeMoments),
    /// Octaves of noise, in the plane or in space: for values and heights, and for slopes in the plane.
    Noise(Noise),
    /// One of two values, by stripes, a checker or a grid: for values and heights.
    Pattern(Pattern),
    /// Solid noise of waves at random places, in three coordinates: for values and heights.
    Gabor(Gabor),
    /// A sum of cosines, such as waves on water: for values, heights and slopes.
    Cosines(Cosines),
    /// A function of the plane whose positions noise displaces: for values and heights.
    Warp(Warp),
    /// A function of your own: for values and heights, and for slopes where it knows them.
    Custom(Custom),
}

impl Driver {
    /// Whether the description can be used.
    ///
    /// # Errors
    /// [`Error::Value`] for a number outside its range, [`Error::Conflict`] for a function that is not as needed.
    pub(crate) fn check(&self) -> Result<(), Error> {
        match self {
            Self::Moments(moments) => moments.pixel.check(),
            Self::Indicators(indicators) => indicators.pixel.check(),
            Self::SlopeMoments(moments) => moments.pixel.check(),
            Self::Noise(noise) => noise.check(),
            Self::Pattern(pattern) => pattern.check(),
            Self::Gabor(gabor) => gabor.check(),
            Self::Cosines(cosines) => cosines.check(),
            Self::Warp(warp) => warp.check(),
            Self::Custom(custom) => custom.check(),
        }
    }

    /// The statistics that it gives a filter, with its name.
    pub(crate) fn gives(&self) -> &'static str {
        match self {
            Self::Moments(Moments { slopes: true, .. }) => {
                "mean and deviation of a height and its slopes, `Driver::Moments` with `slopes`"
            }
            Self::Moments(_) => "mean and deviation of a value, `Driver::Moments`",
            Self::Indicators(_) => "shares of a map of two to nine bands, `Driver::Indicators`",
            Self::SlopeMoments(_) => "mean and covariance of slopes, `Driver::SlopeMoments`",
            Self::Noise(noise) if noise.knows_slopes() => "values, heights and slopes, `Driver::Noise`",
            Self::Noise(_) => {
                "values and heights without slopes, `Driver::Noise` in space, folded or with the method `Stationary`"
            }
            Self::Pattern(_) => "values and heights without slopes, `Driver::Pattern`",
            Self::Gabor(_) => "values and heights without slopes, `Driver::Gabor`",
            Self::Cosines(_) => "values, heights and slopes, `Driver::Cosines`",
            Self::Warp(_) => "values and heights without slopes, `Driver::Warp`",
            Self::Custom(custom) if custom.knows_slopes() => "values, heights and slopes, `Driver::Custom`",
            Self::Custom(_) => "values and heights without slopes, `Driver::Custom`",
        }
    }

    /// Whether it is a function that knows mean and covariance of its slopes.
    pub(crate) fn knows_slopes(&self) -> bool {
        match self {
            Self::Moments(_) | Self::Indicators(_) | Self::SlopeMoments(_) => false,
            Self::Pattern(_) | Self::Gabor(_) => false,
            Self::Noise(noise) => noise.knows_slopes(),
            Self::Warp(_) => false,
            Self::Cosines(_) => true,
            Self::Custom(custom) => custom.knows_slopes(),
        }
    }

    /// Whether it knows skewness and excess kurtosis of values.
    pub(crate) fn knows_shape(&self) -> bool {
        match self {
            Self::Moments(_) | Self::Pattern(_) | Self::Custom(_) => true,
            Self::Warp(warp) => warp.driver.knows_shape(),
            Self::SlopeMoments(_) | Self::Indicators(_) | Self::Noise(_) | Self::Gabor(_) | Self::Cosines(_) => false,
        }
    }

    /// The pattern of two values that it has, displaced or not.
    pub(crate) fn pattern(&self) -> Option<&Pattern> {
        match self {
            Self::Pattern(pattern) => Some(pattern),
            Self::Warp(warp) => warp.driver.pattern(),
            _ => None,
        }
    }

    /// What it says of a footprint where it is a function of the position, with its slopes or without.
    pub(crate) fn function(&self, slopes: bool) -> Option<Function> {
        match self {
            Self::Moments(_) | Self::Indicators(_) | Self::SlopeMoments(_) => None,
            Self::Noise(noise) => Some(noise.function(slopes)),
            Self::Pattern(pattern) => Some(pattern.function()),
            Self::Gabor(gabor) => Some(gabor.function()),
            Self::Cosines(cosines) => Some(cosines.function(slopes)),
            Self::Warp(warp) => warp.function(),
            Self::Custom(custom) => Some(custom.function(slopes)),
        }
    }

    /// Turns of the loops in the functions that it writes, by what follows the scene's name in theirs.
    pub(crate) fn trips(&self) -> Vec<(&'static str, usize)> {
        let taps = |taps: Taps| ("color", taps.count() as usize);
        let of = |function: Function| vec![taps(function.taps), (function.suffix(), function.trips)];
        match self {
            Self::Moments(moments) => vec![taps(moments.taps)],
            Self::Indicators(indicators) => vec![taps(indicators.taps)],
            Self::SlopeMoments(moments) => vec![taps(moments.taps)],
            _ => [false, true].into_iter().filter_map(|slopes| self.function(slopes)).flat_map(of).collect(),
        }
    }

    /// Turns of the loops in the functions of the shelf that it calls, by their names.
    pub(crate) fn shelf_trips(&self) -> Vec<(&'static str, usize)> {
        match self {
            Self::Gabor(gabor) => gabor.trips(),
            Self::Warp(warp) => warp.driver.shelf_trips(),
            _ => Vec::new(),
        }
    }

    /// What no bound of a filter of values or, where it knows them, of slopes covers with this driver, and how much
    /// that was measured to be.
    pub(crate) fn gap(&self, slopes: bool) -> String {
        match self {
            Self::Moments(moments) => moments::gap(moments.taps),
            Self::Indicators(_) => indicators::GAP.to_owned(),
            Self::SlopeMoments(moments) => slope_moments::gap(moments.taps),
            _ => self.function(slopes && self.knows_slopes()).map_or(String::new(), |function| function.gap),
        }
    }

    /// WGSL that it needs and that is neither of the shelf nor the module's own: a text of yours.
    pub(crate) fn foreign(&self) -> &str {
        match self {
            Self::Custom(custom) => &custom.text,
            Self::Warp(warp) => warp.driver.foreign(),
            _ => "",
        }
    }

    /// The WGSL of `NAME_color`, which calls a filter.
    pub(crate) fn glue(&self, called: &Called<'_>) -> String {
        match self {
            Self::Moments(moments) => moments::glue(called, moments),
            Self::Indicators(indicators) => indicators::glue(called, indicators),
            Self::SlopeMoments(moments) => slope_moments::glue(called, moments),
            Self::Pattern(pattern) => pattern.glue(called, &pattern.function()),
            Self::Warp(warp) => warp.glue(called),
            _ => {
                let slopes = self.knows_slopes() && !matches!(called.function, "texture" | "pair");
                self.function(slopes).map_or(String::new(), |function| function.glue(called))
            }
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
    /// The edges of the map that the filter is of, where it has nothing but bands.
    pub edges: &'a [f32],
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
