//! Filters of the heights h = g(f) that a curve g makes of a function f, from the statistics of f.
//!
//! Where f is normal, and its slopes are, too, and independent of it, the slopes of h at a value of f are normal with
//! g′(f) times their mean and g′(f)² times their covariance. Over a footprint they are a mixture of such, narrow where
//! the curve is flat and wide where it is steep, and what is steep is not anywhere: on the flanks of the heights.
//!
//! Source: Heitz, Nowrouzezahrai, Poulin and Neyret 2014, "Filtering Non-Linear Transfer Functions on Surfaces",
//! section 7, for a single normal distribution.

use super::texture::number;
use crate::accuracy::Ranges;
use crate::table::grid::{Axis, Spacing};
use crate::table::steep_nodes::{self, TOGETHER};
use crate::table::{slope_nodes, Table};
use crate::transfer::height_transfer::HeightTransfer;

/// How heights and slopes of a transferred surface are represented: a ladder from the cheapest to the closest.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum TransferTier {
    /// The paper's: one normal distribution of heights and one of slopes, with the mean and variance of h and of its
    /// slopes. Any filter takes these; a step of slopes errs by up to 0.2 to 0.4 where the curve is a smooth step.
    Paper,
    /// Slopes: two normal distributions, with nodes and weights from a table over mean and deviation of f. Heights, of
    /// this and the following tiers: a table over mean and deviation of f and what hides them, for any curve.
    TwoNodes,
    /// Slopes: three normal distributions.
    ThreeNodes,
    /// Slopes: four normal distributions.
    FourNodes,
}

impl std::fmt::Display for TransferTier {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.write_str(match self {
            Self::Paper => "one normal distribution of heights and one of slopes",
            Self::TwoNodes => "two nodes of the slopes' mixture",
            Self::ThreeNodes => "three nodes of the slopes' mixture",
            Self::FourNodes => "four nodes of the slopes' mixture",
        })
    }
}

impl TransferTier {
    /// The normal distributions of slopes.
    pub(crate) fn nodes(self) -> usize {
        match self {
            Self::Paper => 1,
            Self::TwoNodes => 2,
            Self::ThreeNodes => 3,
            Self::FourNodes => 4,
        }
    }
}

/// The table of nodes, and its axes as a shader knows them.
pub(crate) struct Nodes {
    /// A volume with a slice each for scales, weights, rates and spreads.
    pub table: Table,
    /// The means of f on the first and the last column, and the columns.
    pub means: [f32; 3],
    /// The deviation of f on the last row, and the rows.
    pub deviations: [f32; 2],
    /// The steep nodes of a table of what hides heights: their scales and weights alone, as their slopes have no mean.
    pub hiding: Option<usize>,
    /// By which part of 1 + Λ the Λ of a level surface errs between texels.
    pub lambda_error: f32,
}

/// The slices of the table of nodes.
const SLICES: [&str; 4] = ["scales", "weights", "rates", "spreads"];

impl Nodes {
    /// The statements that read the first slices, by `mean` and `deviation` of f.
    pub fn read(&self, slices: usize) -> String {
        let Self { table: Table { name, .. }, means: [low, high, columns], deviations: [most, rows], .. } = self;
        let [low, high, columns, most, rows] = [low, high, columns, most, rows].map(|value| number(*value));
        let (x, y) = (
            format!("grid_linear(mean, {low}, {high}, {columns})"),
            format!("grid_cube_root(deviation, {most}, {rows})"),
        );
        let (what, count) = match self.hiding {
            Some(_) => (self.known(), self.known().len()),
            None => (&SLICES[..slices], SLICES.len()),
        };
        let mut text = format!("    let place = vec2f({x}, {y});\n");
        for (slice, what) in what.iter().enumerate() {
            let depth = (slice as f32 + 0.5) / count as f32;
            let place = if count > 1 { format!("vec3f(place, {depth:?})") } else { "place".to_owned() };
            text += &format!("    let {what} = textureSampleLevel({name}, {name}_sampler, {place}, 0.0);\n");
        }
        text
    }

    /// The names of what is read of a table of what hides.
    fn known(&self) -> &'static [&'static str] {
        match self.hiding {
            Some(0..=TOGETHER) => &["steep"],
            _ => &SLICES[..2],
        }
    }

    /// The expression of a direction's Λ, by the function of a scene, where slopes have no mean.
    pub fn lambda_of(&self, name: &str, direction: &str) -> String {
        format!("{name}_lambda({direction}, slope_covariance, {})", self.known().join(", "))
    }

    /// The deviation of f from which on bends are not misread: the distance of two columns.
    pub fn narrow(&self) -> f32 {
        let [low, high, columns] = self.means;
        (high - low) / (columns - 1.0)
    }

    /// The body of the area of the surface in the picture.
    pub fn area(&self) -> String {
        format!(
            "{}    let averted = slope_nodes_averted(view, mean_slope, slopes_factor(view, slope_covariance), scales);
    return max(dot(weights, slope_nodes_rises(view, mean_slope, scales) + averted), 1e-20);
",
            self.read(2)
        )
    }

    /// The function `NAME_lambda`, Λ of a direction over all nodes of slopes that have no mean. Level ground hides
    /// nothing.
    pub fn lambda(&self, name: &str) -> String {
        let components = ["x", "y", "z", "w"];
        let count = self.hiding.unwrap_or_default().min(components.len());
        let node = |node: usize| match self.known() {
            [steep] => [node, TOGETHER + node].map(|at| format!("{steep}.{}", components[at])),
            _ => [SLICES[0], SLICES[1]].map(|slice| format!("{slice}.{}", components[node])),
        };
        let hiding = |[scale, weight]: [String; 2]| format!("{weight} * slope_nodes_hiding(ratio, {scale})");
        let all: Vec<String> = (0..count).map(node).map(hiding).collect();
        let parameters: String = self.known().iter().map(|known| format!(", {known}: vec4f")).collect();
        format!(
            "
/// Smith's Λ of a direction over all slopes of `{name}`.
fn {name}_lambda(direction: vec3f, slope_covariance: vec3f{parameters}) -> f32 {{
    let ratio = slope_nodes_ratio(direction, slope_covariance);
    let lambda = {};
    return select(lambda, 2.0 * smith_horizon, ratio <= 0.0);
}}
",
            all.join("\n        + ")
        )
    }
}

/// The expression of a direction's Λ over all nodes, whose `scales` and `weights` are named.
pub(crate) fn lambda(direction: &str, mean_slope: &str) -> String {
    let averted =
        format!("slope_nodes_averted({direction}, {mean_slope}, slopes_factor({direction}, slope_covariance), scales)");
    format!("slope_nodes_lambda({direction}, {mean_slope}, scales, weights, {averted})")
}

/// The body of an export that averages over the nodes: `call` is that of the heights' export, of `node_slope` and
/// `node_covariance`, and `result` its type. Where no view is given all slopes count alike.
pub(crate) fn averaged(nodes: &Nodes, count: usize, viewed: bool, call: &str, result: &str) -> String {
    let shares = if viewed { VIEWED_SHARES } else { "    let shares = weights;\n" };
    format!(
        "{}{shares}    var sum = {result}();
    var low = {result}(3e38);
    var high = {result}(-3e38);
    for (var node = 0; node < {count}; node++) {{
        let scale = scales[node];
        let node_slope = scale * mean_slope;
        let node_covariance = scale * scale * slope_covariance;
        let color = {call};
        sum += shares[node] * color;
        low = min(low, color);
        high = max(high, color);
    }}
    return clamp(sum, low, high); // rounded shares may add up to more than one
",
        nodes.read(if viewed { SLICES.len() } else { 2 })
    )
}

/// The statements that name the shares of the nodes in what a view sees.
const VIEWED_SHARES: &str =
    "    let averted = slope_nodes_averted(view, mean_slope, slopes_factor(view, slope_covariance), scales);
    let lambda = slope_nodes_lambda(view, mean_slope, scales, weights, averted);
    let bits = slope_nodes_bits(lambda, rates, spreads);
    let shares = slope_nodes_shares(view, mean_slope, scales, weights, averted, bits);
";

/// Columns and rows of the table of nodes.
const NODES: [usize; 2] = [64, 24];

impl Nodes {
    /// The table of a curve's nodes: where slopes of f have no mean and heights are colored, of what hides them alone.
    pub fn new(curve: &HeightTransfer, ranges: Ranges, tier: TransferTier, tilted: bool) -> Self {
        let Ranges { mean: (low, high), deviation } = ranges;
        let [columns, rows] = NODES;
        let means = Axis { low: low.into(), high: high.into(), count: columns, spacing: Spacing::Linear };
        let deviations = Axis { low: 0.0, high: deviation.into(), count: rows, spacing: Spacing::CubeRoot };
        let signed = tilted && !curve.is_monotone();
        let count = tier.nodes();
        let nodes = slope_nodes::Nodes { curve, count, signed };
        let bake = if tilted { slope_nodes::table } else { steep_nodes::table };
        let table = bake(nodes, means, deviations, "nodes");
        let hiding = (!tilted).then(|| nodes.steep());
        let all = || steep_nodes::hiding_error(nodes, means, deviations, &table);
        let lambda_error = if tilted { all() } else { table.error };
        let (means, deviations) = ([low, high, columns as f32], [deviation, rows as f32]);
        Self { table, means, deviations, hiding, lambda_error }
    }
}
