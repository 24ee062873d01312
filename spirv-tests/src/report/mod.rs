//! The report: speed against error of every filter, side by side, on whatever device is there.

pub mod accuracy;
pub mod cache;
pub mod costs;
pub mod csv;
pub mod document;
pub mod extremes;
pub mod filters;
pub mod generation;
pub mod markdown;
pub mod needs;
pub mod page;
pub mod plot;
pub mod publish;
pub mod scenes;
pub mod timing;

use cache::Cache;
use document::Section;
use prefilter::gpu::Device;

pub use crate::imaging::Error;

/// How much is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extent {
    /// Small pictures, few cases: all parts together within two minutes on two cores.
    Quick,
    /// What is published: within half an hour.
    Full,
}

impl Extent {
    /// One of two values.
    pub fn pick<T>(self, quick: T, full: T) -> T {
        match self {
            Self::Quick => quick,
            Self::Full => full,
        }
    }
}

/// What parts of the report measure with.
pub struct Bench<'a> {
    /// The device, with all its threads.
    pub device: &'a Device,
    /// The same, with one thread where it is a processor: what is timed is timed here.
    pub timed: &'a Device,
    /// How much is measured.
    pub extent: Extent,
    /// Where ground truths are kept.
    pub cache: &'a Cache,
    /// Is told about every so many steps that have been done.
    pub done: &'a (dyn Fn(u64) + Sync),
}

/// A part of the report.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// Every filter by itself.
    Filters,
    /// The examples' scenes, all methods side by side.
    Scenes,
    /// Whether budgets are kept, and by what.
    Accuracy,
    /// Hard cases.
    Extremes,
    /// What modules consist of.
    Needs,
    /// How long scenes take to become modules and tables.
    Generation,
    /// Closed forms, tables and mixtures, and the weights by which tiers are chosen.
    Costs,
}

impl Part {
    /// All of them, in the report's order.
    pub const ALL: [Self; 7] =
        [Self::Filters, Self::Scenes, Self::Accuracy, Self::Extremes, Self::Needs, Self::Generation, Self::Costs];

    /// Its name, as on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Filters => "filters",
            Self::Scenes => "scenes",
            Self::Accuracy => "accuracy",
            Self::Extremes => "extremes",
            Self::Needs => "needs",
            Self::Generation => "generation",
            Self::Costs => "costs",
        }
    }

    /// Steps that it does, some tenths of a second each, for a progress bar.
    pub fn steps(self, extent: Extent) -> u64 {
        match self {
            Self::Filters => filters::steps(extent),
            Self::Scenes => scenes::steps(extent),
            Self::Accuracy => accuracy::steps(extent),
            Self::Extremes => extremes::steps(extent),
            Self::Needs => needs::steps(extent),
            Self::Generation => generation::steps(extent),
            Self::Costs => costs::steps(extent),
        }
    }

    /// Measures it.
    ///
    /// # Errors
    /// Those of scenes, of the device and of files.
    pub fn section(self, bench: &Bench<'_>) -> Result<Section, Error> {
        match self {
            Self::Filters => filters::section(bench),
            Self::Scenes => scenes::section(bench),
            Self::Accuracy => accuracy::section(bench),
            Self::Extremes => extremes::section(bench),
            Self::Needs => needs::section(bench),
            Self::Generation => generation::section(bench),
            Self::Costs => costs::section(bench),
        }
    }
}
