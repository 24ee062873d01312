//! The table of a map of the whole slope, and the numbers and colors by which a module reads it.

use crate::accuracy::Ranges;
use crate::filter::slope::SlopeTier;
use crate::filter::texture::number;
use crate::table::grid::{Axis, Spacing, BEND};
use crate::table::slope_map::{Baked, Plan, Stored};
use crate::table::Table;
use crate::transfer::slope_map::{SlopeDomain, SlopeMap};

/// Nodes along each component of the mean slope: reads of a table of 128 lie so far apart that the caches of a GPU hold
/// too few of them.
pub(crate) const NODES: usize = 96;

/// Those from which an accuracy chooses.
pub(crate) const SIZES: [usize; 4] = [32, 64, NODES, 128];

/// Nodes along the deviation: they stand in `wgsl/filter/slope_map.wgsl` too.
pub(super) const SLICES: usize = 20;

/// Where no ranges are given: mean slopes to 1 either way, deviations to 0.5.
pub(crate) const RANGES: Ranges = Ranges { mean: (-1.0, 1.0), deviation: 0.5 };

/// How far reads may lie beyond the mean of all slopes, in deviations: 1.46 for the farther of two at the horizon, and
/// somewhat more for the outermost reads of any weight, of those on its axis.
const REACH: f64 = 3.4;

/// How far a map that is constant beyond its domain blurs out of it, in deviations.
const BLUR: f64 = 3.0;

/// The smallest deviation that the table's error counts from, as a part of the largest.
const FLOOR: f64 = 0.24;

/// The smallest deviation that a bound holds from.
pub(crate) fn floor(ranges: Ranges) -> f64 {
    FLOOR * f64::from(ranges.deviation)
}

/// The least part of the deviation of all slopes that one normal distribution of those has that are seen, along the
/// view: at the horizon.
const ONE: f64 = 0.65;

/// That of the narrower of two, of both less a third.
const NARROWER: f64 = 0.55;

/// That of the third, and its weight.
const THIRD: f64 = 0.28;
const LESS: f64 = 0.09;

/// A map's table with the numbers by which it is read.
pub(crate) struct Atlas {
    pub(super) baked: Baked,
    stored: Stored,
    pub(super) numbers: [String; 4],
    pub(super) ranges: Ranges,
}

impl Atlas {
    /// The table of a map, with so many nodes along each component.
    pub(crate) fn new(map: &SlopeMap, nodes: usize, ranges: Ranges) -> Self {
        let [mean, deviation] = [ranges.largest_mean(), ranges.deviation].map(f64::from);
        let farthest = mean + REACH * deviation;
        let inside = 1.0 - 1.0 / nodes as f64;
        // Over all slopes nodes are those of a map of as many cells. Where the map ends, what is blurred out of it
        // needs fewer nodes than the map.
        let (high, unit) = match map.domain() {
            SlopeDomain::Within(reach) => {
                let high = f64::from((f64::from(reach) + BLUR * deviation).min(farthest) as f32);
                (high, high)
            }
            SlopeDomain::All => (nodes as f64 - 1.0, 1.0),
        };
        let slopes = Axis { low: -high, high, count: nodes, spacing: Spacing::Companded { unit } };
        let per_slope = 0.5 * inside * (unit + high) / (unit * high);
        let deviations = Axis { low: 0.0, high: deviation, count: SLICES, spacing: Spacing::Logarithm };
        let (stored, smooth) = (stored(map), floor(ranges));
        let baked = Plan { map: &map.reference(), slopes, deviations, farthest, smooth, stored }.table("table");
        let per_octave = (1.0 - 1.0 / SLICES as f64) / (1.0 + BEND).log2();
        let numbers = [per_slope, 1.0 / unit, BEND / deviation, per_octave].map(|value| number(value as f32));
        Self { baked, stored, numbers, ranges }
    }

    /// The table with the error that a tier's reads have of it.
    pub(crate) fn table(&self, tier: SlopeTier) -> Table {
        Table { error: self.error(tier), ..self.baked.table.clone() }
    }

    /// The same, without a copy.
    pub(crate) fn take(&mut self, tier: SlopeTier) -> Table {
        let levels = std::mem::take(&mut self.baked.table.levels);
        Table { error: self.error(tier), levels, ..self.baked.table.clone() }
    }

    /// The color of what is read, or of a sum of it that may lie outside of what the map's colors are.
    pub(super) fn color(&self, map: &SlopeMap, read: &str, outside: bool) -> String {
        let (low, high) = map.hull();
        let [low, high] = [low, high].map(|end| {
            let channels: Vec<String> = end[..map.channels()].iter().map(|&channel| number(channel)).collect();
            format!("vec{0}f({1})", map.channels(), channels.join(", "))
        });
        let read = if map.channels() == 3 { format!("{read}.rgb") } else { read.to_owned() };
        match (self.stored, outside) {
            (Stored::Halves, false) => read,
            (Stored::Halves, true) => format!("clamp({read}, {low}, {high})"),
            (Stored::Parts { .. }, false) => format!("mix({low}, {high}, {read})"),
            (Stored::Parts { .. }, true) => format!("mix({low}, {high}, saturate({read}))"),
        }
    }

    /// By how much the table errs where a tier reads it.
    fn error(&self, tier: SlopeTier) -> f32 {
        let from = |part: f64| self.baked.error(part * floor(self.ranges));
        match tier {
            SlopeTier::Naive => from(0.0),
            SlopeTier::Unweighted => from(1.0),
            SlopeTier::Gaussian => from(ONE),
            SlopeTier::Pair => from(NARROWER) + LESS as f32 * (from(NARROWER) + from(THIRD)),
        }
    }
}

/// How a map's colors are stored: in ten bits a channel those that a screen shows, three from 0 to 1.
fn stored(map: &SlopeMap) -> Stored {
    let (low, high) = map.hull();
    let shown = map.channels() == 3 && low.iter().chain(&high).all(|channel| (0.0..=1.0).contains(channel));
    if shown {
        Stored::Parts { low, high }
    } else {
        Stored::Halves
    }
}
