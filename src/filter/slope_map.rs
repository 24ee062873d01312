//! Cs of a map of the whole slope, such as a wheel of aspects: reads from a table of the map's means over round normal
//! distributions of slopes.
//!
//! The visible slopes are represented by one normal distribution, as in [`slope`], or by two of which a narrow third is
//! taken away, and each of those by a few round ones along its major axis.

pub(crate) mod atlas;

use super::shared::{statements, Shared};
use super::slope::{self, SlopeTier, VIEWED};
use super::texture::{color_type, number, Filter};
use crate::accuracy::Bound;
use crate::table::Table;
use crate::transfer::slope_map::SlopeMap;
use atlas::{floor, Atlas, SLICES};

/// How many reads of the table stand for one normal distribution of slopes.
///
/// Of a normal distribution itself, a step, a disc or a sector errs by up to this much. Over a flat mesh with a map of
/// normals that is all, by [`SlopeTier::Unweighted`]:
///
/// | deviations of the axes | one read | three | five | seven | eleven |
/// |---|---|---|---|---|---|
/// | 1:1 | 0 | 0 | 0 | 0 | 0 |
/// | 2:1 | 0.102 | 0.017 | 0.0015 | 0.0002 | 0.0001 |
/// | 4:1 | 0.20 | 0.077 | 0.026 | 0.0061 | 0.0007 |
///
/// Seen from the horizon of the mean surface, the normal distribution of visible slopes is up to 1.5 times longer
/// across the view than that of all slopes, and the longer one of two up to 1.8 times.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum SlopeTaps {
    /// A round distribution of the same area, for slopes that vary alike in all directions.
    One,
    /// Three round ones along the major axis; they widen distributions that are longer than 3.4 times their width.
    Three,
    /// Five, up to 6.2 times.
    Five,
    /// Seven, up to 8.3 times; the third that is taken away from two has five, and three with fewer.
    Seven,
    /// Eleven, up to 14 times: longer than what is seen from the horizon of slopes that vary four times as much across
    /// the view as along it. Of two distributions the lower one has ten, which stand between those of the higher one,
    /// and so has a single one that is longer than four times its width. Those shorter than 2.2 times have seven, and
    /// six for ten.
    Eleven,
}

impl std::fmt::Display for SlopeTaps {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.write_str(match self {
            Self::One => "one read",
            Self::Three => "three reads",
            Self::Five => "five reads",
            Self::Seven => "seven reads",
            Self::Eleven => "eleven reads",
        })
    }
}

/// The largest error of a step, of a disc about the slope 0 and of a quarter of all directions, for views above the
/// horizon of the mean surface whose slopes' covariance has axes of ratios up to 2; of one, three, five, seven and
/// eleven reads.
/// `shapes_keep_the_figures_of_their_tiers` in `spirv-tests/tests/slope_map/figures.rs` measures them on the device.
const UNWEIGHTED: [f64; 5] = [0.643, 0.587, 0.579, 0.577, 0.577];
const GAUSSIAN: [f64; 5] = [0.163, 4.75e-2, 4.7e-2, 4.7e-2, 4.7e-2];
const PAIR: [f64; 5] = [0.156, 4.25e-2, 1.5e-2, 4.9e-3, 4.46e-3];

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

/// The shelf's function of so many reads, and the part of its length that the width of a distribution is at least.
fn function(taps: SlopeTaps) -> (&'static str, Option<&'static str>) {
    match taps {
        SlopeTaps::One => ("slope_map_one", None),
        SlopeTaps::Three => ("slope_map_three", Some("rounds_three_least")),
        SlopeTaps::Five => ("slope_map_five", Some("rounds_five_least")),
        SlopeTaps::Seven => ("slope_map_seven", Some("rounds_seven_least")),
        SlopeTaps::Eleven => ("slope_map_eleven", Some("rounds_eleven_least")),
    }
}

/// The reads of the third distribution, which counts for a tenth at most.
fn fewer(taps: SlopeTaps) -> SlopeTaps {
    match taps {
        SlopeTaps::One => SlopeTaps::One,
        SlopeTaps::Three | SlopeTaps::Five => SlopeTaps::Three,
        SlopeTaps::Seven | SlopeTaps::Eleven => SlopeTaps::Five,
    }
}

/// The shelf's function of the lower one of two, and when it is read.
fn lower(taps: SlopeTaps) -> (&'static str, &'static str) {
    match taps {
        SlopeTaps::Eleven => ("slope_map_ten", "parameter < split_single || high.part < rounds_eleven_long"),
        _ => (function(taps).0, "parameter < split_single"),
    }
}

/// What of the slopes a tier needs: that of Cs, but for what stands for them.
pub(crate) fn shared(tier: SlopeTier) -> Vec<Shared> {
    let mut shared = slope::shared(tier);
    if tier == SlopeTier::Pair {
        shared.pop();
        shared.push(Shared::new("split", "vec4f", "split_pair(parameter)"));
        shared.push(Shared::new("less", "vec3f", "split_less(parameter)"));
    }
    shared
}

/// The body of a tier.
pub(crate) fn body(atlas: &Atlas, map: &SlopeMap, tier: SlopeTier, taps: SlopeTaps) -> String {
    let layout = atlas.numbers.join(", ");
    let [per_slope, bend, ..] = &atlas.numbers;
    let shape = |taps: SlopeTaps, covariance: &str| match function(taps).1 {
        Some(least) => format!("footprint_stretched({covariance}, {least})"),
        None => covariance.to_owned(),
    };
    let seen = |taps: SlopeTaps, variance: &str| shape(taps, &format!("slopes_covariance(factor, {variance})"));
    let read = |function: &str, mean: &str, shape: &str| {
        format!("{function}({mean}, {shape}, {layout}, table, table_sampler)")
    };
    let at = |part: &str| format!("middle + {part} * factor.xy");
    let color = |read: &str, outside: bool| atlas.color(map, read, outside);
    // Infinite slopes are far ones.
    let middle = "    let middle = clamp(mean_slope, vec2f(-1e18), vec2f(1e18));\n";
    let rest = match tier {
        SlopeTier::Naive => {
            let slice = number(0.5 / SLICES as f32);
            let read = format!("slope_map_read(middle, {slice}, {per_slope}, {bend}, table, table_sampler)");
            format!("    return {};\n", color(&read, false))
        }
        SlopeTier::Unweighted => format!(
            "    let spread = clamp(slope_covariance, vec3f(-1e18), vec3f(1e18));\n    return {};\n",
            color(&read(function(taps).0, "middle", &shape(taps, "spread")), false)
        ),
        SlopeTier::Gaussian => {
            format!(
                "    return {};\n",
                color(&read(function(taps).0, &at("moments.x"), &seen(taps, "moments.y")), false)
            )
        }
        // All shapes before the first read, so that a device finds them beside each other.
        SlopeTier::Pair => {
            let (lower, two) = lower(taps);
            format!(
                "    let low = {};
    let high = {};
    let narrow = {};
    var c = {};
    if {two} {{
        c = 0.5 * (c + {});
    }}
    if parameter < split_single {{
        c += less.z * (c - {});
    }}
    return {};
",
                seen(taps, "split.y"),
                seen(taps, "split.w"),
                seen(fewer(taps), "less.y"),
                read(function(taps).0, &at("split.z"), "high"),
                read(lower, &at("split.x"), "low"),
                read(function(fewer(taps)).0, &at("less.x"), "narrow"),
                color("c", true)
            )
        }
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
