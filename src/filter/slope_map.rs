//! Cs of a map of the whole slope, such as a wheel of aspects: reads from a table of the map's means over round normal
//! distributions of slopes.
//!
//! The visible slopes are represented by one or two normal distributions, as in [`slope`], and each of
//! those by a few round ones along its major axis.

use super::shared::{statements, Shared};
use super::slope::{self, SlopeTier, VIEWED};
use super::texture::{color_type, number, Filter};
use crate::accuracy::{Bound, Ranges};
use crate::table::grid::{Axis, Spacing, BEND};
use crate::table::slope_map::{Baked, Plan};
use crate::table::Table;
use crate::transfer::slope_map::{SlopeDomain, SlopeMap};

/// How many reads of the table stand for one normal distribution of slopes.
///
/// Of a normal distribution itself, a step, a disc or a sector errs by up to this much. Over a flat mesh with a map of
/// normals that is all, by [`SlopeTier::Unweighted`]:
///
/// | deviations of the axes | one read | three | five | seven | nine |
/// |---|---|---|---|---|---|
/// | 1:1 | 0 | 0 | 0 | 0 | 0 |
/// | 2:1 | 0.102 | 0.017 | 0.0016 | 0.0002 | 0.0001 |
/// | 4:1 | 0.20 | 0.077 | 0.026 | 0.0061 | 0.0019 |
///
/// Seen from the horizon of the mean surface, the normal distribution of visible slopes is up to 1.5 times longer
/// across the view than that of all slopes, and the longer one of two up to 2.6 times.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum SlopeTaps {
    /// A round distribution of the same area, for slopes that vary alike in all directions.
    One,
    /// Three round ones along the major axis; they widen distributions that are longer than 3.4 times their width.
    Three,
    /// Five, up to 6.2 times.
    Five,
    /// Seven, up to 8.3 times; of two normal distributions for the longer one, and six for the other. Both read the one
    /// that they become, where it is longer than four times its width. As close as nine each where slopes vary up to
    /// twice as much along an axis as across.
    Seven,
    /// Nine, up to 11 times: as long as what is seen from the horizon of slopes that vary four times as much across
    /// the view as along it.
    Nine,
}

impl std::fmt::Display for SlopeTaps {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.write_str(match self {
            Self::One => "one read",
            Self::Three => "three reads",
            Self::Five => "five reads",
            Self::Seven => "up to seven reads",
            Self::Nine => "nine reads",
        })
    }
}

/// Nodes along each component of the mean slope.
pub(crate) const NODES: usize = 128;

/// Those from which an accuracy chooses.
pub(crate) const SIZES: [usize; 3] = [32, 64, NODES];

/// Nodes along the deviation: they stand in `wgsl/filter/slope_map.wgsl` too.
const SLICES: usize = 20;

/// Where no ranges are given: mean slopes to 1 either way, deviations to 0.5.
pub(crate) const RANGES: Ranges = Ranges { mean: (-1.0, 1.0), deviation: 0.5 };

/// How far reads may lie beyond the mean of all slopes, in deviations: 1.664 for the pair at the horizon, and about as
/// much for the outermost reads of any weight, of those on its axis.
const REACH: f64 = 3.4;

/// How far a map that is constant beyond its domain blurs out of it, in deviations.
const BLUR: f64 = 3.0;

/// The smallest deviation that the table's error counts from, as a part of the largest.
const FLOOR: f64 = 0.24;

/// The smallest deviation that a bound holds from.
pub(crate) fn floor(ranges: Ranges) -> f64 {
    FLOOR * f64::from(ranges.deviation)
}

/// How many times narrower than all slopes those are that a tier reads the table for, at most: seen from the horizon,
/// one normal distribution has 0.655 of the deviation along the view, and the narrower one of two 0.39.
fn narrow(tier: SlopeTier) -> f64 {
    match tier {
        SlopeTier::Naive => 0.0,
        SlopeTier::Unweighted => 1.0,
        SlopeTier::Gaussian => 0.65,
        SlopeTier::Pair => 0.38,
    }
}

/// A map's table with the numbers by which it is read.
pub(crate) struct Atlas {
    baked: Baked,
    numbers: [String; 4],
    ranges: Ranges,
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
        let baked = Plan { map: &map.reference(), slopes, deviations, farthest, smooth: floor(ranges) }.table("table");
        let per_octave = (1.0 - 1.0 / SLICES as f64) / (1.0 + BEND).log2();
        let numbers = [per_slope, 1.0 / unit, BEND / deviation, per_octave].map(|value| number(value as f32));
        Self { baked, numbers, ranges }
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

    fn error(&self, tier: SlopeTier) -> f32 {
        self.baked.error(narrow(tier) * floor(self.ranges))
    }
}

/// The largest error of a step, of a disc about the slope 0 and of a quarter of all directions, for views above the
/// horizon of the mean surface whose slopes' covariance has axes of ratios up to 2; of one, three, five, seven and nine
/// reads.
/// `shapes_keep_the_figures_of_their_tiers` in `spirv-tests/tests/slope_map/figures.rs` measures them on the device.
const UNWEIGHTED: [f64; 5] = [0.643, 0.587, 0.579, 0.577, 0.577];
const GAUSSIAN: [f64; 5] = [0.163, 4.75e-2, 4.7e-2, 4.7e-2, 4.7e-2];
const PAIR: [f64; 5] = [0.177, 6.15e-2, 2.35e-2, 1.3e-2, 1.3e-2];

/// The largest error of a map with one edge from 0 to 1.
pub(crate) fn edge_error(tier: SlopeTier, taps: SlopeTaps) -> f64 {
    let errors = match tier {
        SlopeTier::Naive => [1.0; 5],
        SlopeTier::Unweighted => UNWEIGHTED,
        SlopeTier::Gaussian => GAUSSIAN,
        SlopeTier::Pair => PAIR,
    };
    errors[taps as usize]
}

/// The shelf's functions of so many reads, for the longer of two distributions and for the shorter one, and the part of
/// its length that the width of a distribution is at least.
fn functions(taps: SlopeTaps) -> ([&'static str; 2], Option<&'static str>) {
    match taps {
        SlopeTaps::One => (["slope_map_one"; 2], None),
        SlopeTaps::Three => (["slope_map_three"; 2], Some("rounds_three_least")),
        SlopeTaps::Five => (["slope_map_five"; 2], Some("rounds_five_least")),
        SlopeTaps::Seven => (["slope_map_seven", "slope_map_six"], Some("rounds_seven_least")),
        SlopeTaps::Nine => (["slope_map_nine"; 2], Some("rounds_nine_least")),
    }
}

/// What of the slopes a tier needs: that of Cs, but for the two normal distributions.
pub(crate) fn shared(tier: SlopeTier) -> Vec<Shared> {
    let mut shared = slope::shared(tier);
    if let (SlopeTier::Pair, Some(pair)) = (tier, shared.last_mut()) {
        *pair = Shared::new("split", "vec4f", "split_pair(parameter)");
    }
    shared
}

/// The body of a tier.
pub(crate) fn body(atlas: &Atlas, map: &SlopeMap, tier: SlopeTier, taps: SlopeTaps) -> String {
    let ([function, fewer], least) = functions(taps);
    let layout = atlas.numbers.join(", ");
    let [per_slope, bend, ..] = &atlas.numbers;
    let shape = |covariance: &str| match least {
        Some(least) => format!("footprint_stretched({covariance}, {least})"),
        None => covariance.to_owned(),
    };
    let seen = |variance: &str| shape(&format!("slopes_covariance(factor, {variance})"));
    let read = |function: &str, mean: &str, shape: &str| {
        format!("{function}({mean}, {shape}, {layout}, table, table_sampler)")
    };
    let at = |part: &str| format!("middle + {part} * factor.xy");
    let channels = if map.channels() == 3 { ".rgb" } else { "" };
    let ordered = fewer != function;
    let both = if ordered { "longer" } else { "split" };
    // Where there is one, and long, the other's sum is another one of it.
    let long = if ordered { " || one.part < rounds_seven_enough" } else { "" };
    // Infinite slopes are far ones.
    let middle = "    let middle = clamp(mean_slope, vec2f(-1e18), vec2f(1e18));\n";
    let rest = match tier {
        SlopeTier::Naive => {
            let slice = number(0.5 / SLICES as f32);
            format!(
                "    return slope_map_read(middle, {slice}, {per_slope}, {bend}, table, table_sampler){channels};\n"
            )
        }
        SlopeTier::Unweighted => format!(
            "    let spread = clamp(slope_covariance, vec3f(-1e18), vec3f(1e18));\n    return {}{channels};\n",
            read(function, "middle", &shape("spread"))
        ),
        SlopeTier::Gaussian => {
            format!("    return {}{channels};\n", read(function, &at("moments.x"), &seen("moments.y")))
        }
        // Both shapes before the first read, so that a device finds them beside each other.
        SlopeTier::Pair => format!(
            "{}    let one = {};
    let other = {};
    var c = {};
    if parameter < split_single{long} {{
        c = 0.5 * (c + {});
    }}
    return c{channels};
",
            if ordered { "    let longer = split_longer_first(factor, split);\n" } else { "" },
            seen(&format!("{both}.y")),
            seen(&format!("{both}.w")),
            read(function, &at(&format!("{both}.x")), "one"),
            read(fewer, &at(&format!("{both}.z")), "other")
        ),
    };
    middle.to_owned() + &rest
}

/// The filter of a tier with a body.
pub(crate) fn over(body: String, table: Table, map: &SlopeMap, tier: SlopeTier, taps: SlopeTaps) -> Filter {
    let bound = 2.0 * (f64::from(table.error) + edge_error(tier, taps) * map.widest_span());
    Filter { body, bound: Bound::Estimated(bound as f32), tables: vec![table], trips: 1 }
}

/// What `NAME_slope_map` takes between the slopes' statistics and the tables, behind a comma.
pub(crate) fn given(tier: SlopeTier) -> &'static str {
    match tier {
        SlopeTier::Unweighted => "",
        SlopeTier::Naive | SlopeTier::Gaussian | SlopeTier::Pair => ", view: vec3f",
    }
}

/// `NAME_slope_map` with a body.
pub(crate) fn glue(
    name: &str,
    map: &SlopeMap,
    atlas: &Atlas,
    tier: SlopeTier,
    label: &str,
    parameters: &str,
    body: &str,
) -> String {
    let weighted = tier != SlopeTier::Unweighted;
    let color = color_type(map.channels());
    format!(
        "/// Mean color of `{name}` over {},
/// by {label}.
///
/// A facet of the slope s has a normal along (-s.x, -s.y, 1). Slopes have a mean and a covariance, xx, xy, yy.
/// Deviations count up to {}. The table errs by up to {:.1e}, from a deviation of {:.3} on by {:.1e}.{}
fn {name}_slope_map(mean_slope: vec2f, slope_covariance: vec3f{}{parameters}) -> {color} {{
{}{body}}}
",
        if weighted { "the slopes that are seen" } else { "all slopes" },
        atlas.ranges.deviation,
        atlas.baked.error(0.0),
        floor(atlas.ranges),
        atlas.baked.error(floor(atlas.ranges)),
        if weighted { VIEWED } else { "" },
        given(tier),
        statements(&shared(tier))
    )
}
