//! Colors by the heights h = g(f) that a curve makes, from a table over mean and deviation of f and what hides them.
//!
//! At a height h the share exp(−Λ X) of the surface is visible, with X = ∫ |g′|/E|g′| d(ln P) over all that is higher,
//! P being the share of the surface below a height: Smith's model for slopes that depend on the height, to first order.
//! For a line X = −ln Φ, as of heights that are normal.

use super::glue::{slopes, Shares};
use super::surface::{lambda, shared_by, step_error, Microsurface};
use super::tails::tails;
use super::tier::{self, HeightTier};
use super::variation;
use crate::accuracy::{Bound, Ranges};
use crate::filter::height_transfer::{self, Nodes};
use crate::filter::shared::statements;
use crate::filter::texture::{color_type, number, swizzle, Filter};
use crate::table::grid::{Axis, Spacing};
use crate::table::transferred::{moved, Plan, DENSER, HIDING};
use crate::transfer::color_map::{ColorMap, Colors, MAX_COLOR};
use crate::transfer::height_transfer::HeightTransfer;
use crate::Error;

/// Nodes along the mean and along the deviation of f.
const MEANS: usize = 128;
const DEVIATIONS: usize = 24;

/// How many columns of the table a deviation of f covers from which on it is read; below, h is taken for normal.
const NARROW: f64 = 1.0;

/// Colors by transferred heights.
pub(crate) struct Transferred {
    /// By the table.
    pub filter: Filter,
    /// The function that it calls for narrow footprints, over which a curve is nearly a line: `NAME_level`, the color
    /// by normal heights.
    pub level: String,
    /// The deviation of f from which on nothing but the table is read.
    pub narrow: f32,
    /// The largest difference of two colors that errors of Λ between the texels of nodes make.
    pub moved: f32,
}

/// The filter of a map; `narrow_heights` is the expression of mean and deviation of h over narrow footprints.
///
/// # Errors
/// As of [`tails`].
pub(crate) fn transferred(
    name: &str,
    map: &ColorMap,
    colors: Colors,
    curve: &HeightTransfer,
    surface: Microsurface,
    nodes: &Nodes,
    narrow_heights: &str,
) -> Result<Transferred, Error> {
    let ranges = Ranges::of_transfer(curve);
    let reference = map.reference();
    let (low, high) = (f64::from(ranges.mean.0), f64::from(ranges.mean.1));
    let means = match colors {
        Colors::Constant => Axis::fitted(low, high, MEANS, &Plan::changes(&reference, curve, (low, high))),
        // The same for all maps.
        Colors::Dynamic => Axis::round(low, high, MEANS),
    };
    let means = means.in_f32();
    let most = f64::from(ranges.deviation);
    let narrow = (NARROW * (means.high - means.low) / (MEANS - 1) as f64).min(0.25 * most);
    let deviations = Axis { low: narrow, high: most, count: DEVIATIONS, spacing: Spacing::Ratio };
    let table = Plan { map: &reference, curve, means, deviations }.table("table", 2.0 * narrow);
    let (lowest, highest) = curve.range(low - 2.0 * most, high + 2.0 * most);
    let near = tails(map, colors, surface, around(Ranges::of(map), lowest as f32, highest as f32))?;
    // A level stretch that lies on a hard edge counts as above it, as in the table.
    let above = number((1e-5 * (highest - lowest).min(1e5)) as f32);
    let given = if surface.shadowing { ["seen, lit", "seen: f32, lit: f32"] } else { ["seen", "seen: f32"] };
    let low = number(narrow as f32);
    let (color, channels) = (color_type(map.channels()), swizzle(map));
    let arguments: String = near.tables.iter().map(|table| format!(", {}", table.name)).collect();
    let body = format!(
        "    let wide = {}{channels};
    let part = clamp((deviation - {low}) / {low}, 0.0, 1.0);
    if part >= 1.0 {{
        return wide;
    }}
    // The curve is nearly a line over the footprint, whose heights are nearly normal.
    let h = {narrow_heights};
    return mix({name}_level(h.x + {above}, h.y, {}{arguments}), wide, part);
",
        read([means, deviations], lambda(surface)),
        given[0]
    );
    let parameters: String =
        near.tables.iter().map(|table| format!(", {}: {}", table.name, table.wgsl_type())).collect();
    let level = format!(
        "
/// Mean color over normal heights of which the shares that Λ of view and light leave are visible.
fn {name}_level(mean: f32, deviation: f32, {}{parameters}) -> {color} {{
{}}}
",
        given[1], near.body
    );
    let step = step_error(HeightTier::Skewed, surface, tier::rounded(HeightTier::Skewed, ranges));
    let moved = moved(&table, nodes.lambda_error.into(), if surface.shadowing { 2.0 } else { 1.0 });
    let bound = 2.0 * (f64::from(table.error) + moved) + step * variation(map);
    let tables = near.tables.into_iter().chain([table]).collect();
    let filter = Filter { body, bound: Bound::Estimated(bound as f32), tables, trips: near.trips };
    Ok(Transferred { filter, level, narrow: 2.0 * narrow as f32, moved: moved as f32 })
}

/// The ranges of a map, and of heights between two.
fn around(map: Ranges, lowest: f32, highest: f32) -> Ranges {
    let limited = |value: f32| value.clamp(-MAX_COLOR, MAX_COLOR);
    let mean = (map.mean.0.min(limited(lowest)), map.mean.1.max(limited(highest)));
    Ranges { mean, deviation: map.deviation.max(limited(0.5 * (highest - lowest))) }
}

/// The expression that reads the table, of `mean`, `deviation` and an expression of Λ.
fn read([means, deviations]: [Axis; 2], lambda: &str) -> String {
    let numbers = |values: &[f64]| values.iter().map(|&value| number(value as f32)).collect::<Vec<_>>().join(", ");
    let column = numbers(&[means.low, means.high, means.count as f64]);
    let row = numbers(&[deviations.low.log2(), deviations.high.log2(), deviations.count as f64]);
    let slice = numbers(&[HIDING.low, HIDING.high, HIDING.count as f64]);
    let hiding = format!("log2(1.0 + {} * clamp({lambda}, 0.0, 1e6))", number(DENSER as f32));
    let width = "log2(max(deviation, 1e-30))";
    let place =
        format!("vec3f(grid_linear(mean, {column}), grid_linear({width}, {row}), grid_linear({hiding}, {slice}))");
    format!("textureSampleLevel(table, table_sampler, {place}, 0.0)")
}

/// `NAME_height` and the shares that are seen and lit; `tables` are their parameters: of all, and of the nodes alone.
pub(crate) fn glue(
    name: &str,
    map: &ColorMap,
    surface: Microsurface,
    nodes: &Nodes,
    body: &str,
    tables: [&str; 2],
) -> String {
    let shared = shared_by(surface, &|direction| {
        if surface.mean_slope {
            return height_transfer::lambda(direction, "mean_slope");
        }
        nodes.lambda_of(name, direction)
    });
    let (light, who) = if surface.shadowing { (", light: vec3f", "seen and lit") } else { ("", "seen") };
    let (before, [all, own]) = (nodes.read(2), tables);
    let height = format!(
        "/// Mean color of `{name}` over the heights h = g(f) that are {who}, from a table.
///
/// `mean` and `deviation` are those of f, and so are the slopes'; positions of the map are heights. Directions are unit
/// vectors away from the surface, z along its normal. Below a horizon the color is that of the highest heights.
fn {name}_height(mean: f32, deviation: f32, {}, view: vec3f{light}{all}) -> {} {{
{before}{}{body}}}
",
        slopes(surface),
        color_type(map.channels()),
        statements(&shared),
    );
    let within = [(); 2].map(|()| WITHIN.to_owned());
    let statistics = "mean: f32, deviation: f32, ";
    height + &Shares { name, surface, before: &before, shared, statistics, tables: own, within }.text()
}

/// What is said of the error of shares.
const WITHIN: &str = "By Smith's model\n/// for the slopes of all nodes.";
