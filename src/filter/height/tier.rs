//! The ladder of representations of visible heights, with the step error of each.

use crate::accuracy::Ranges;

/// How the distribution of visible heights is represented: a ladder from the cheapest to the closest.
///
/// The step error is the largest difference of its cumulative function from that of D_h; times a map's total variation
/// it bounds the error of any map.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum HeightTier {
    /// A normal distribution of the paper's mean and deviation, to compare with. A step errs by up to 9.1e-2 for Λ up
    /// to 100, and 0.48 up to 1e4.
    Paper,
    /// A normal distribution of the mean and deviation of D_h. 4.5e-2 for Λ up to 100, 5.8e-2 up to 1e4.
    Gaussian,
    /// A table over the mean, deviation and skewness of D_h, 256 KiB: 6e-4 for Λ up to 1e4, and what lies between its
    /// texels, which grows where the heights' deviation is less than some hundredths of the range of means. One fetch,
    /// for any map.
    Skewed,
    /// Two shorter tails with the mean, the deviation and the skewness of D_h, a term a knot of the color map: 1.55e-3
    /// for Λ up to 100, 1.65e-3 up to 1e4; with noise on the heights 5.2e-3. Needs no table and constant colors. From
    /// some three knots on it costs less than the normal distribution over a closed form.
    ClosedFormFast,
    /// Two tails with the mean, the deviation and the skewness of D_h, a term a knot of the color map: 2.6e-4 for Λ up
    /// to 100, 3.3e-4 up to 1e4; with noise on the heights 6.8e-4 and 8.7e-4. Needs no table.
    ClosedForm,
    /// D_h itself, for bands of constant colors: f32 rounding at any Λ.
    Exact,
}

impl HeightTier {
    /// Whether the tier stands on no C0, whose tiers are another choice.
    pub(crate) fn stands_alone(self) -> bool {
        match self {
            Self::Paper | Self::Gaussian => false,
            Self::Skewed | Self::ClosedFormFast | Self::ClosedForm | Self::Exact => true,
        }
    }
}

impl std::fmt::Display for HeightTier {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.write_str(match self {
            Self::Paper => "the paper's fits",
            Self::Gaussian => "one normal distribution",
            Self::Skewed => "a table over skewness",
            Self::ClosedFormFast => "skewed heights in closed form with the fast kernel",
            Self::ClosedForm => "skewed heights in closed form",
            Self::Exact => "bands in closed form",
        })
    }
}

/// Step errors for Λ up to 1e4, as `worst_steps_keep_the_figures_of_their_tiers` in
/// `spirv-tests/tests/height/figures.rs` measures them on the device; it fails where they are exceeded, and where they
/// are more than 4% too wide.
const PAPER: f64 = 0.484;
pub(crate) const GAUSSIAN: f64 = 5.75e-2;
const CLOSED_FORM_FAST: f64 = 1.65e-3;
const CLOSED_FORM: f64 = 3.3e-4;

/// The same of a normal distribution by the distance of the step from the mean visible height, in deviations of the
/// visible heights: `steps_far_from_the_mean_keep_their_figures`, in the same file.
pub(crate) const ENVELOPE: [[f64; 2]; 9] = [
    [0.0, GAUSSIAN],
    [0.5, 4.2e-2],
    [1.0, 3.58e-2],
    [1.75, 3.05e-2],
    [2.0, 2.15e-2],
    [2.5, 1.45e-2],
    [3.0, 8.8e-3],
    [4.0, 2.3e-3],
    [5.0, 4.2e-4],
];

/// What the fits of the moments add to the table's own error, by the shelf's promises at the narrowest distribution, of
/// deviation 0.304: 7e-5 of the mean at a density of at most 1.4, 7e-5 of the deviation at 0.26/0.304, and 1.6e-3 of
/// the skewness at 0.07.
const SKEWED: f64 = 2.8e-4;

/// The step error of bands at any Λ by the shelf's promises: 1e-6 of the probability, what both directions' Λ add, and
/// the rounding of a height in deviations. The same test has up to 8e-7.
const EXACT: f64 = 2.2e-6 + HIDING;

/// What both directions' Λ add to a step error, of which nothing else is off, for slope correlations up to 0.98: at
/// most 1/e of the error of their sum relative to 1 + Λ, up to twice that of either, which the shelf promises to be
/// 1e-6 and 1.5e-7/(1 − 0.98) for the parameter.
pub(crate) const HIDING: f64 = 6.3e-6;

/// What the directions' Λ add to a step error: at most 1/e of the error of their sum relative to 1 + Λ, up to twice
/// that of either, which the shelf promises to be 9e-5 for the fast form.
const LAMBDA: f64 = 7e-5;

/// What rounding of the mean visible height adds for deviations from [`FLOOR`] on: φ(0) 2^-24 / (0.304 · 1e-3).
const ROUNDED: f64 = 1e-4;

/// The smallest deviation that bounds of the tiers over C0 hold from, as a part of the largest mean; and as one of the
/// largest deviation, where that is less.
const FLOOR: f32 = 1e-3;
const NARROW: f32 = 0.1;

/// How far the mean of visible heights may lie above that of all and how wide they may be, in deviations of all: 4.2
/// and 1 by the paper's fits, 3.9 and 1.001 by the others, at Λ up to 1e4.
pub(crate) const REACH: f32 = 4.25;
pub(crate) const WIDTH: f32 = 1.01;

/// The means and deviations of visible heights.
pub(crate) fn texture_ranges(ranges: Ranges) -> Ranges {
    let (low, high) = ranges.mean;
    Ranges { mean: (low, high + REACH * ranges.deviation), deviation: WIDTH * ranges.deviation }
}

/// The smallest deviation that a bound holds from.
pub(crate) fn floor(tier: HeightTier, ranges: Ranges) -> f32 {
    match tier {
        HeightTier::Exact => 1e-6,
        _ => (FLOOR * ranges.largest_mean()).min(NARROW * ranges.deviation).max(1e-5),
    }
}

/// What rounding of a mean adds to a step error for deviations from [`floor`] on.
pub(crate) fn rounded(tier: HeightTier, ranges: Ranges) -> f64 {
    match tier {
        HeightTier::Exact => 0.0,
        _ => ROUNDED * f64::from(FLOOR * ranges.largest_mean() / floor(tier, ranges)).max(1.0),
    }
}

/// The step error of a tier, beyond that of its table and [`rounded`], the errors of the directions' Λ included.
pub(crate) fn step_error(tier: HeightTier) -> f64 {
    match tier {
        HeightTier::Paper => PAPER + LAMBDA,
        HeightTier::Gaussian => GAUSSIAN + LAMBDA,
        HeightTier::ClosedFormFast => CLOSED_FORM_FAST + LAMBDA,
        HeightTier::ClosedForm => CLOSED_FORM + LAMBDA,
        HeightTier::Skewed => SKEWED + LAMBDA,
        HeightTier::Exact => EXACT,
    }
}
