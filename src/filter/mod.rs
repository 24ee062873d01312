//! Filters: what the mean of a transfer function over a footprint is, tier by tier.

pub mod combine;
pub mod distribution;
pub(crate) mod envelope;
pub mod height;
pub mod height_transfer;
pub mod irradiance;
mod knots;
pub mod percentile;
pub(crate) mod shared;
pub mod slope;
pub mod slope_map;
pub(crate) mod steepness;
mod terms;
pub mod texture;

/// How a filter is evaluated: a ladder from the cheapest to the closest.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Tier {
    /// The map at the mean: no filtering at all, to compare with.
    Naive,
    /// The table of Heitz et al. 2014: 256 × 256, deviation linear, means in [0, 1]. One fetch.
    Paper,
    /// 512 means by 16 deviations spaced by cube root, means padded by the scene's ranges. One fetch, 64 KiB.
    Table,
    /// The integral itself, a term a stop: no table, no limit to how sharp an edge or how small a deviation is.
    ClosedForm(Kernel),
}

/// The approximation of the normal distribution behind a closed form.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Kernel {
    /// Shorter polynomials: 1e-6 deviations a kink, 2e-5 a step.
    Fast,
    /// Exact to f32 rounding.
    Exact,
}

impl std::fmt::Display for Tier {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.write_str(match self {
            Self::Naive => "the naive map at the mean",
            Self::Paper => "the paper's table",
            Self::Table => "the cube-root table",
            Self::ClosedForm(Kernel::Fast) => "the closed form with the fast kernel",
            Self::ClosedForm(Kernel::Exact) => "the closed form with the exact kernel",
        })
    }
}
