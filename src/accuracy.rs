//! How close a filter must be, over which values, and what is known of how close it is.

use crate::transfer::color_map::ColorMap;
use crate::transfer::height_transfer::HeightTransfer;
use crate::Error;

/// The largest mean and deviation, as of positions.
const LARGEST: f32 = crate::transfer::color_map::MAX_COLOR;

/// The values over which a scene's bounds hold, in the unit of the color map's positions.
///
/// Means and deviations are at most 65504 either way, the range of means at least 0.001 wide and the largest deviation
/// at least 0.001; [`Scene::module`](crate::Scene::module) refuses others. Bounds hold from a deviation of 1e-6, as
/// which smaller ones count.
///
/// # Beyond the ranges
/// Colors stay in the hull of the map's whatever the inputs are. What an input counts as is where a bound goes on:
/// * Deviations of values and heights that are larger count as the largest.
/// * A component of the slope that deviates more counts as drawn together about the middle of the map until it
///   deviates by the largest: the shares to either side of that middle stay. The share beyond an edge at t is off by up
///   to 0.61 |t − middle| over the largest deviation, for views above the horizon.
/// * Λ of view and light together count as 1e4 where more hides a height and skewed heights stand for those in sight,
///   in closed form or in a table; as 255.75 where a table has heights by a curve; and as 1e6 by one normal
///   distribution, by the paper's, and where bands or percentiles are colored.
/// * Below the least deviation that [`Module::explain`](crate::Module::explain) states of heights and of components of
///   slopes, colors are those of means within 7e-6 of the largest mean.
///
/// No bound goes on for means beyond these, for slopes of correlations beyond 0.9, for Λ beyond what is covered where a
/// curve makes heights, nor for maps of the whole slope, steepness and irradiance beyond their deviations. Moments that
/// rounding leaves a little below 0, or correlated a little beyond 1, count as the nearest that there are. WGSL says
/// nothing of inputs that are infinite or no numbers; where it was tried, they left colors in the hull, too.
/// `spirv-tests/tests/hard_cases.rs` asks for all that.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Ranges {
    /// The means that occur, of heights with noise those of the sum. Default: −0.25 to 1.25, those of a map over
    /// [0, 1].
    pub mean: (f32, f32),
    /// The largest deviation that occurs, likewise; larger ones count as this. Default: 0.5, the largest of any value
    /// in [0, 1].
    pub deviation: f32,
}

impl Default for Ranges {
    fn default() -> Self {
        Self { mean: (-0.25, 1.25), deviation: 0.5 }
    }
}

impl Ranges {
    /// The ranges of a map: the unit range and the map's positions, with a quarter of padding on either side, and the
    /// largest deviation of any value between.
    pub fn of(map: &ColorMap) -> Self {
        let positions = || map.knots().iter().map(|knot| knot.position);
        let (low, high) = (positions().fold(0.0, f32::min), positions().fold(1.0, f32::max));
        let padding = 0.25 * (high - low);
        let mean = ((low - padding).max(-LARGEST), (high + padding).min(LARGEST));
        Self { mean, deviation: (0.5 * (high - low)).min(LARGEST) }
    }

    /// The ranges of the values that a height transfer is applied to: those of [`HeightTransfer::over`] or its default.
    pub fn of_transfer(curve: &HeightTransfer) -> Self {
        if let Some((mean, deviation)) = curve.values() {
            return Self { mean, deviation };
        }
        let bends = curve.bends();
        let ends = (bends.first().copied().unwrap_or(0.0), bends.last().copied().unwrap_or(0.0));
        // A curve without two places of its own has no scale.
        let (low, high) = if ends.0 < ends.1 { ends } else { (-1.0, 1.0) };
        let part = (0.5 * (high - low)).max(1e-3);
        let limited = |value: f64| (value as f32).clamp(-LARGEST, LARGEST);
        Self { mean: (limited(low - part), limited(high + part)), deviation: limited(part).max(1e-3) }
    }

    /// The largest magnitude of a mean.
    pub(crate) fn largest_mean(&self) -> f32 {
        self.mean.0.abs().max(self.mean.1.abs())
    }

    pub(crate) fn check(&self) -> Result<(), Error> {
        let (low, high) = self.mean;
        let fine = |value: f32| value.abs() <= LARGEST;
        for (what, value) in [("the low end of the means", low), ("the high end of the means", high)] {
            if !fine(value) {
                return Err(Error::value(what, value, "a number from -65504 to 65504"));
            }
        }
        if high - low < 1e-3 {
            return Err(Error::value(
                "the high end of the means",
                high,
                format!("at least 0.001 above the low end {low}"),
            ));
        }
        if !(self.deviation >= 1e-3 && fine(self.deviation)) {
            return Err(Error::value("the largest deviation", self.deviation, "0.001 to 65504"));
        }
        Ok(())
    }
}

/// The largest filter error that a scene accepts, and the means allowed to keep it.
///
/// Of the tiers of what is filtered, of the tiers of the color map that these stand on, of the numbers of reads and of
/// the sizes of tables the scene takes the lightest by [`Cost::weight`](crate::Cost::weight), and of those the one with
/// the fewest bytes of tables, whose [`Bound`] over the scene's [`Ranges`] is at most this; where none is,
/// [`Scene::module`](crate::Scene::module) says with [`Error::Accuracy`] which is the closest. What the scene names is
/// not chosen, and a bound without it is what counts. A combination shares its accuracy among its layers; of
/// transferred heights nodes and filter do.
///
/// The error is the filter's alone, given what is known of a footprint. How far the driver is from that, its
/// [`Taps`](crate::Taps) included, depends on the image or function and has no bound: the driver's gap, which
/// [`Module::explain`](crate::Module::explain) states in words and figures. No accuracy chooses taps.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Accuracy {
    /// The largest error of a channel, in color units. Default: 1/255.
    pub max_filter_error: f32,
    /// Whether tables may be used, which cost a binding. Default: yes.
    pub tables: bool,
}

impl Default for Accuracy {
    fn default() -> Self {
        Self::max_filter_error(1.0 / 255.0)
    }
}

impl Accuracy {
    /// At most this error of a channel, by whatever means.
    pub fn max_filter_error(error: f32) -> Self {
        Self { max_filter_error: error, tables: true }
    }

    /// The same, without tables.
    #[must_use]
    pub fn without_tables(self) -> Self {
        Self { tables: false, ..self }
    }

    pub(crate) fn check(&self) -> Result<(), Error> {
        if self.max_filter_error > 0.0 && self.max_filter_error.is_finite() {
            return Ok(());
        }
        Err(Error::value("the largest filter error", self.max_filter_error, "a finite number above 0"))
    }
}

/// What is known of the largest error of a channel over a scene's [`Ranges`], in color units.
///
/// The error is against the integral that the filter approximates: the mean of the map over a normal variable, with a
/// deviation from 1e-6 to the largest of the ranges; of a scene of heights or slopes that over the visible ones, from
/// the deviation and up to the Λ that [`Module::explain`](crate::Module::explain) states.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Bound {
    /// Summed from the promises of the shelf functions and the step errors of [`HeightTier`](crate::HeightTier)s and
    /// [`SlopeTier`](crate::SlopeTier)s, each times the variation of the map that deviations reach at once, which the
    /// crate's tests enforce.
    Guaranteed(f32),
    /// Twice the largest error that was measured between the texels of a table. A sampler that keeps 8 bits of the
    /// fraction between texels, as many do, errs by up to 1/512 of the difference between neighbors besides. Of a map
    /// of slopes also twice the largest error that was measured of maps with one edge, times the span of the colors.
    Estimated(f32),
}

impl Bound {
    /// The bound's size, whichever its kind.
    pub fn value(self) -> f32 {
        match self {
            Self::Guaranteed(value) | Self::Estimated(value) => value,
        }
    }
}

impl std::fmt::Display for Bound {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Guaranteed(value) => write!(formatter, "{value:.1e}, guaranteed"),
            Self::Estimated(value) => write!(formatter, "{value:.1e}, twice the measured"),
        }
    }
}

/// The absolute error that a shelf function promises in its contract; infinite for one that promises none.
pub(crate) fn promise(function: &str) -> f64 {
    let shelf = prefilter_wgsl::mentioned(function);
    let declaration = shelf.iter().find(|(_, declaration)| declaration.name == function);
    declaration.and_then(|(_, declaration)| stated(&declaration.documentation())).unwrap_or(f64::INFINITY)
}

fn stated(documentation: &str) -> Option<f64> {
    let line = documentation.lines().find_map(|line| line.strip_prefix("Error:"))?;
    let (number, _) = line.split_once("absolute")?;
    number.trim().parse().ok()
}
