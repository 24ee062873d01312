//! What the values that a footprint covers are taken for, given what is known of them.

use super::texture::{self, Filter};
use super::Tier;
use crate::accuracy::Ranges;
use crate::table::learned::Learned;
use crate::transfer::color_map::{ColorMap, Colors};
use crate::Error;

/// What distribution the values over a footprint are taken for.
///
/// Root mean square errors of the color, in thousandths, over round footprints of 2, 8 and 32 texels on images whose
/// moments there are known exactly: as a normal distribution, a Beta distribution, two normal ones, and as learned from
/// the other half of the image (`spirv-tests/tests/shapes.rs` measures them again).
///
/// | image, map | 2 texels | 8 texels | 32 texels |
/// |---|---|---|---|
/// | gravel, terrain | 43, 36, 11, 32 | 41, 31, 8, 21 | 31, 22, 4, 10 |
/// | gravel, steps6 | 64, 61, 34, 58 | 46, 44, 33, 32 | 36, 33, 25, 16 |
/// | brick, terrain | 80, 67, 15, 33 | 177, 152, 25, 36 | 197, 167, 26, 26 |
/// | brick, steps6 | 99, 89, 52, 48 | 215, 194, 108, 59 | 218, 198, 117, 36 |
/// | elevations, terrain | 8, 8, 2, 8 | 28, 23, 9, 27 | 60, 40, 28, 60 |
/// | elevations, steps6 | 21, 20, 13, 23 | 39, 36, 22, 43 | 47, 43, 45, 57 |
///
/// Learning pays where an image is alike everywhere, and not for elevations, whose one half has not the hills of the
/// other.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Distribution {
    /// The normal one of their mean and deviation.
    #[default]
    Normal,
    /// Two normal ones of one deviation, of their mean, deviation, skewness and excess kurtosis.
    ///
    /// Exports `NAME_pair(mean, deviation, skewness, kurtosis)`, which evaluates `NAME_texture` twice and is that where
    /// skewness and kurtosis are 0, as where they are not known. Values that are one of two, or about them, have such
    /// distributions. The [`Ranges`] are those of either.
    Pair,
    /// The Beta distribution of their mean and deviation between two ends, for values that have such, as sines have.
    ///
    /// Over footprints of a sine with deviations of 0.5, 1 and 4 radians the color errs, root mean square over four
    /// maps, by 0.006, 0.009 and 0.0001, where a normal distribution errs by 0.038, 0.071 and 0.065.
    ///
    /// It fills a table, [`Tier::Table`], of parts of the largest deviation that a mean has, for 13 operations more
    /// than that of normal distributions: read by the deviation itself it would err several times as much between
    /// texels, as its colors bend where all values are at the ends. Means beyond an end count as that end, deviations
    /// as at most what values between the ends have, all of which are then at the ends. Bounds are against the mean
    /// over Beta distributions. The ends are the scene's [`Ranges`], too.
    Beta {
        /// The low end.
        low: f32,
        /// The high end, from 0.002 above the low one.
        high: f32,
    },
    /// Whatever footprints of an image have that are of their mean and deviation, for values of that image or of one
    /// like it.
    ///
    /// It fills the table of [`Tier::Table`], at no cost at run time. Bounds are against what was learned.
    Learned(Learned),
}

impl Distribution {
    /// Whether the description can be used.
    ///
    /// # Errors
    /// [`Error::Value`] for ends beyond the limits of [`Ranges`] or too near.
    pub(crate) fn check(&self) -> Result<(), Error> {
        match self {
            Self::Normal | Self::Pair => Ok(()),
            Self::Learned(image) => image.check(),
            Self::Beta { low, high } => {
                let ends = [("low", low), ("high", high)];
                if let Some((end, value)) = ends.into_iter().find(|(_, value)| !(value.abs() <= 65504.0)) {
                    let what = format!("the {end} end of the Beta distributions");
                    return Err(Error::value(what, *value, "a number from -65504 to 65504"));
                }
                // Half of it is the largest deviation, whose limit is the same.
                if high - low >= 2e-3 {
                    return Ok(());
                }
                let what = "the high end of the Beta distributions";
                Err(Error::value(what, *high, format!("at least 0.002 above the low end {low}")))
            }
        }
    }

    /// The means and deviations that it has, where it has not all.
    pub(crate) fn ranges(&self) -> Option<Ranges> {
        match *self {
            Self::Beta { low, high } => Some(Ranges { mean: (low, high), deviation: 0.5 * (high - low) }),
            Self::Normal | Self::Pair | Self::Learned(_) => None,
        }
    }

    /// Whether it stands in a table, and nowhere else.
    pub(crate) fn tabulated(&self) -> bool {
        matches!(self, Self::Beta { .. } | Self::Learned(_))
    }

    /// What `NAME_texture` is over: of two distributions one.
    pub(crate) fn single(&self) -> &Self {
        match self {
            Self::Pair => &Self::Normal,
            _ => self,
        }
    }

    /// The filter of one tier, its table having so many nodes; that of normal distributions is not baked where its
    /// bound is sure to be above `most`.
    ///
    /// # Errors
    /// A tier that does not go with the colors.
    pub(crate) fn filter(
        &self,
        map: &ColorMap,
        colors: Colors,
        tier: Tier,
        nodes: [usize; 2],
        ranges: Ranges,
        most: f32,
    ) -> Result<Filter, Error> {
        match self {
            Self::Normal | Self::Pair => texture::filter(map, colors, tier, nodes, ranges, most),
            Self::Beta { low, high } => Ok(texture::bounded(map, (*low, *high), nodes)),
            Self::Learned(image) => Ok(texture::learned(map, colors, nodes, ranges, image)),
        }
    }
}

impl std::fmt::Display for Distribution {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Normal => formatter.write_str("a normal distribution"),
            Self::Pair => formatter.write_str("two normal distributions"),
            Self::Beta { low, high } => write!(formatter, "a Beta distribution between {low} and {high}"),
            Self::Learned(image) => {
                let [width, height] = image.size();
                write!(formatter, "a distribution learned from an image of {width} × {height} texels")
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn refuses_ends_that_are_none() {
        for (low, high) in [(1.0, 0.0), (0.0, 0.0), (0.0, 1e-3), (f32::NAN, 1.0), (0.0, f32::INFINITY), (-1e5, 0.0)] {
            let refused = Distribution::Beta { low, high }.check();
            assert!(matches!(refused, Err(Error::Value { .. })), "{low}, {high}: {refused:?}");
        }
        for (low, high) in [(0.0, 1.0), (-65504.0, 65504.0), (0.25, 0.252)] {
            let distribution = Distribution::Beta { low, high };
            assert_eq!(distribution.check(), Ok(()));
            assert_eq!(distribution.ranges().map(|ranges| ranges.check()), Some(Ok(())), "{low}, {high}");
        }
    }
}
