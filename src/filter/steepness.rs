//! Cs of a map of the steepness |s|, such as rock on cliffs, by distributions of Rice: reads from a table over them.
//!
//! One has the mean and the variance of |s|² over the slopes that a view sees. Closer are three, of parts of the
//! visible slopes beside each other on their major axis, and ten: two normal distributions stand for the visible
//! slopes, as in [`slope`](super::slope), and five round ones along the major axis for each of those, whose lengths
//! have distributions of Rice.

use super::height::variation;
use super::shared::{statements, Shared};
use super::slope::{self, SlopeTier};
use super::slope_map::SlopeTaps;
use super::texture::{bends, color_type, number, swizzle, Filter};
use crate::accuracy::{Bound, Ranges};
use crate::table::grid::{Axis, Spacing};
use crate::table::rice::Plan;
use crate::transfer::color_map::{ColorMap, Colors};

/// Nodes along ν and along σ.
pub(crate) const NODES: [usize; 2] = [256, 32];

/// Sizes from which an accuracy chooses.
pub(crate) const SIZES: [[usize; 2]; 3] = [[64, 16], [128, 16], NODES];

/// The largest error of a step for views above the horizon of the mean surface, whose slopes' covariance has axes of
/// ratios up to 2; `steps_of_steepness_keep_their_figures` in `spirv-tests/tests/slope/steepness.rs` measures them on
/// the device.
const NAIVE: f64 = 1.0;
const ONE: f64 = 0.105;
const THREE: f64 = 3.7e-2;
const TEN: f64 = 0.026;

/// What stands for the lengths of the visible slopes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Lengths {
    /// That of the mean slope.
    Naive,
    /// A distribution of Rice.
    One,
    /// Three.
    Three,
    /// Ten.
    Ten,
}

impl Lengths {
    /// Those that a tier of slopes and reads name, none where they name what there is not.
    pub(crate) fn named(tier: Option<SlopeTier>, taps: Option<SlopeTaps>) -> Option<Self> {
        match (tier, taps) {
            (Some(SlopeTier::Naive), None) => Some(Self::Naive),
            (None | Some(SlopeTier::Gaussian), Some(SlopeTaps::One)) | (Some(SlopeTier::Gaussian), None) => {
                Some(Self::One)
            }
            (None | Some(SlopeTier::Gaussian), Some(SlopeTaps::Three)) => Some(Self::Three),
            (Some(SlopeTier::Pair), None | Some(SlopeTaps::Five)) | (None, Some(SlopeTaps::Five)) => Some(Self::Ten),
            _ => None,
        }
    }

    /// The largest error of a step.
    pub(crate) fn step(self) -> f64 {
        match self {
            Self::Naive => NAIVE,
            Self::One => ONE,
            Self::Three => THREE,
            Self::Ten => TEN,
        }
    }

    /// The tier in words.
    pub(crate) fn label(self) -> &'static str {
        match self {
            Self::Naive => "the mean slope",
            Self::One => "one distribution of Rice",
            Self::Three => "three distributions of Rice",
            Self::Ten => "ten distributions of Rice",
        }
    }

    /// How far ν may lie beyond the mean slope's length, and the σ from which on the table is judged, in deviations of
    /// the widest axis.
    fn reach(self) -> (f32, f64) {
        match self {
            // Naive reads without a deviation; of that its bound counts all of a step.
            Self::Naive | Self::One => (REACH, NARROWEST),
            Self::Three => (REACH_OF_THREE, NARROWEST_OF_THREE),
            Self::Ten => (REACH_OF_TEN, NARROWEST_OF_TEN),
        }
    }
}

/// The smallest σ that bounds hold from, as a part of the largest ν of one distribution.
const FLOOR: f64 = 1e-3;

/// How far ν may lie beyond the mean slope's length, and how large σ may be, in deviations of the widest axis, as the
/// same test finds: 1.335 and 1.218 for one distribution, 2.2 and less than 1 for three, 2.8 and less than 1 for ten.
const REACH: f32 = 1.35;
const REACH_OF_THREE: f32 = 2.25;
const REACH_OF_TEN: f32 = 3.1;
const WIDTH: f32 = 1.25;

/// The smallest σ for axes of ratios up to 2, in deviations of the widest axis, as the same test finds: 0.43 of one
/// distribution, 0.345 of three, 0.195 of ten: half of the root of 0.152, the variance of the lower one of the pair at
/// the horizon.
const NARROWEST: f64 = 0.42;
const NARROWEST_OF_THREE: f64 = 0.33;
const NARROWEST_OF_TEN: f64 = 0.19;

/// The smallest deviation that a bound holds from.
pub(crate) fn floor(ranges: Ranges) -> f32 {
    (FLOOR as f32 * highest(ranges, REACH)).max(1e-5)
}

fn highest(ranges: Ranges, reach: f32) -> f32 {
    ranges.mean.1.max(0.0) + reach * ranges.deviation
}

/// A tier of a map of |s|.
pub(crate) struct Steepness {
    /// What averages over the visible slopes.
    pub filter: Filter,
    /// The body of the mean over all slopes of a normal distribution, seen alike.
    pub alike: String,
}

/// The view to which all slopes count alike.
const ALIKE: &str = "    let view = vec3f(0.0, 0.0, 1.0);\n";

/// The filter of a map of |s|.
pub(crate) fn filter(
    map: &ColorMap,
    colors: Colors,
    tier: Lengths,
    [columns, rows]: [usize; 2],
    ranges: Ranges,
) -> Steepness {
    let (reach, narrowest) = tier.reach();
    let highest = f64::from(highest(ranges, reach));
    let centers = match colors {
        Colors::Constant => Axis::fitted(0.0, highest, columns, &bends(map)).in_f32(),
        Colors::Dynamic => Axis::round(0.0, highest, columns).in_f32(),
    };
    let widest = WIDTH * ranges.deviation;
    let deviations = Axis { low: 0.0, high: widest.into(), count: rows, spacing: Spacing::CubeRoot };
    let (reference, floor) = (map.reference(), narrowest * f64::from(floor(ranges)));
    let table = Plan { map: &reference, centers, deviations, highest, floor }.table("table");
    let axes = [centers.low as f32, centers.high as f32, widest].map(number).join(", ");
    let returned = |function: &str, arguments: &str| {
        format!("    return {function}({arguments}, {axes}, table, table_sampler){};\n", swizzle(map))
    };
    let (body, alike) = match tier {
        Lengths::Naive => {
            let body = returned("texture_table", "length(mean_slope), 0.0");
            (body.clone(), body)
        }
        Lengths::One => {
            let body = returned("texture_table", "rice.x, rice.y");
            let alike = ALIKE.to_owned() + &statements(&shared(tier)) + &body;
            (body, alike)
        }
        Lengths::Three => {
            let body = returned("rice_three", "view, mean_slope, slope_covariance");
            let alike = ALIKE.to_owned() + &body;
            (body, alike)
        }
        Lengths::Ten => {
            let of = |mean: &str, variance: &str| {
                let slopes = format!("mean_slope + {mean} * factor.xy, slopes_covariance(factor, {variance})");
                format!("rice_five({slopes}, {axes}, table, table_sampler)")
            };
            let body = format!(
                "    var c = {};
    if parameter < slopes_single {{
        c = 0.5 * (c + {});
    }}
    return c{};
",
                of("pair.x", "pair.y"),
                of("pair.z", "pair.w"),
                swizzle(map)
            );
            (body, returned("rice_five", "mean_slope, slope_covariance"))
        }
    };
    let bound = Bound::Estimated((2.0 * f64::from(table.error) + tier.step() * variation(map)) as f32);
    Steepness { filter: Filter { body, bound, tables: vec![table], trips: 1 }, alike }
}

/// The distribution of Rice of the lengths that are seen, or what the two normal distributions of the slopes need.
pub(crate) fn shared(tier: Lengths) -> Vec<Shared> {
    match tier {
        Lengths::Naive | Lengths::Three => Vec::new(),
        Lengths::One => {
            let square = "steepness_moments(view, mean_slope, slope_covariance)";
            let rice = "steepness_rice(square.x, square.y)";
            vec![Shared::new("square", "vec2f", square), Shared::new("rice", "vec2f", rice)]
        }
        Lengths::Ten => slope::shared(SlopeTier::Pair),
    }
}

/// What no bound covers, and how much that was measured to be.
///
/// Source: `docs/steepness_gap.csv`, by lines of sight over height fields of four spectra; a test of `spirv-tests`
/// compares.
pub(crate) const GAP: &str = "\
how far slopes are from a normal distribution of that mean and covariance. That facets hide
    each other whatever their slopes was measured against lines of sight over rough surfaces: steps of the
    length err by up to 0.02 with a Gaussian autocorrelation, 0.05 with others";

/// What `NAME_steepness` takes between the slopes' statistics and the tables, behind a comma.
pub(crate) const GIVEN: &str = ", view: vec3f";

/// `NAME_steepness` with a body.
pub(crate) fn glue(name: &str, map: &ColorMap, tier: Lengths, parameters: &str, body: &str) -> String {
    format!(
        "/// Mean color of `{name}` over the slopes that are seen,
/// by {}.
///
/// Positions of the map are steepnesses, lengths of slopes: the tangent of a facet's angle with the plane across z.
/// Slopes have a mean and a covariance, xx, xy, yy.
///
/// `view` is a unit vector away from the surface, z along its normal; (0, 0, 1) counts all slopes alike, as over a flat
/// mesh with a map of normals. Below the horizon of the mean surface the color is that of the slopes that rise above
/// it.
fn {name}_steepness(mean_slope: vec2f, slope_covariance: vec3f{GIVEN}{parameters}) -> {} {{
{}{body}}}
",
        tier.label(),
        color_type(map.channels()),
        statements(&shared(tier))
    )
}
