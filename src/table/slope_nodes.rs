//! Tables of the nodes that stand for the slopes of a transferred height, over the mean and the deviation of f.
//!
//! Where the curve has level pieces the first node is they: the scale 0, with the share of the surface that is level.
//! The others are Gauss's rule of |g′| over the rest. A rule of all |g′| puts a node near 0, not on it, and misses the
//! step at the slope 0 by half of the level share.

use std::sync::OnceLock;

use super::grid::{Axis, Spacing};
use super::lattice::{half_rounded, Lattice};
use super::rule::rule;
use super::slope_hiding::hidden;
use super::slope_steps::error;
use super::threads::rows;
use super::Table;
use crate::reference::slope_nodes::{Ends, Part, Transferred};
use crate::transfer::height_transfer::HeightTransfer;
use crate::transfer::polynomial::Piece;

/// How far hiding follows |g′|: a compromise, chosen by ray-cast fields. With 0, which is P^Λ, smoothstep(0, 1.2) is
/// 0.016 of a step off at 75 degrees, with this 0.019, and with 1 more; beyond 85 degrees, and for convex curves, more
/// is closer. `spirv-tests/tests/slope_nodes/gap.rs` measures this one alone.
pub const FOLLOWS: f64 = 0.25;

/// Slopes below this part of the steepest are level.
pub(super) const LEVEL: f64 = 1e-9;

/// Deviations of f on either side of its mean in which nodes are found: 2e-9 of its values are beyond.
const REACH: usize = 6;

/// Parts of a deviation, for nodes.
const PARTS: usize = 16;

/// The ends of such parts.
pub(super) fn ends() -> &'static Ends {
    static ENDS: OnceLock<Ends> = OnceLock::new();
    ENDS.get_or_init(|| Ends::within(REACH, PARTS))
}

/// Values of f this many deviations from the mean do not occur.
const FAR: f64 = 8.0;

/// The node of ground that is level everywhere.
fn level() -> Node {
    static LEVEL: OnceLock<Node> = OnceLock::new();
    *LEVEL.get_or_init(|| {
        let surface = Transferred::between(ends(), [0.0, 1.0], &[], |_| (0.0, 0.0));
        let rates = surface.rates(FOLLOWS);
        let parts: Vec<(f64, f64)> = surface.parts.iter().map(|part| part.share).zip(rates).collect();
        hidden(0.0, &parts)
    })
}

/// What is stored of the nodes, a slice each.
pub(super) const SLICES: usize = 4;

/// One node.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Node {
    /// What the slopes of f are multiplied by.
    pub scale: f64,
    /// The share of the surface.
    pub weight: f64,
    /// How fast it is hidden while Λ is small.
    pub rate: f64,
    /// How much slower later: (1 + Λ spread)^(−rate/spread) is not hidden.
    pub spread: f64,
}

/// A curve and the nodes that stand for its slopes.
#[derive(Clone, Copy, Debug)]
pub struct Nodes<'a> {
    /// The curve.
    pub curve: &'a HeightTransfer,
    /// Nodes, from 1 to 4, that of level pieces among them.
    pub count: usize,
    /// Nodes keep the sign of g′, which matters where f has a mean slope. Those of tables do where a curve only falls.
    pub signed: bool,
}

impl Nodes<'_> {
    /// The surface over a normal f.
    pub fn surface(&self, parts: usize, mean: f64, deviation: f64) -> Transferred {
        self.between(&Ends::even(parts), mean, deviation)
    }

    /// The same between ends that are known.
    pub(super) fn between(&self, ends: &Ends, mean: f64, deviation: f64) -> Transferred {
        Transferred::between(ends, [mean, deviation], &self.breaks(), |f| self.curve.at(f))
    }

    /// The values between which the curve is smooth.
    fn breaks(&self) -> Vec<f64> {
        let pieces = self.curve.pieces().unwrap_or_default().iter();
        pieces.map(|piece| piece.to).filter(|to| to.is_finite()).chain([0.0]).collect()
    }

    /// Whether the curve has level pieces, for which the first node is kept.
    pub(crate) fn has_level(&self) -> bool {
        self.curve.pieces().unwrap_or_default().iter().any(Piece::is_level)
    }

    /// Whether the curve is level over all values of a normal f that occur.
    pub(super) fn is_level(&self, mean: f64, deviation: f64) -> bool {
        let [low, high] = [mean - FAR * deviation, mean + FAR * deviation];
        let mut within =
            self.curve.pieces().unwrap_or_default().iter().filter(|piece| piece.from < high && piece.to > low);
        deviation > 0.0 && self.has_level() && within.all(Piece::is_level)
    }

    /// The nodes over a normal f; those that are not needed have the weight 0.
    pub fn over(&self, mean: f64, deviation: f64) -> [Node; 4] {
        if self.is_level(mean, deviation) {
            let beside = Node { scale: self.nearest_scale(mean), spread: 1.0, rate: 1.0, weight: 0.0 };
            let mut nodes = [beside; 4];
            nodes[0] = level();
            nodes[self.count..].iter_mut().for_each(|node| node.scale = 0.0);
            return nodes;
        }
        let surface = self.between(ends(), mean, deviation);
        let rates = surface.rates(FOLLOWS);
        let steepest = surface.parts.iter().map(|part| part.scale.abs()).fold(0.0, f64::max);
        let has_level = self.has_level();
        let level = |part: &Part| has_level && part.scale.abs() <= LEVEL * steepest;
        let of = |part: &Part| if self.signed { part.scale } else { part.scale.abs() };
        let mut nodes = [Node { spread: 1.0, rate: 1.0, ..Node::default() }; 4];
        let mut next = 0;
        if has_level {
            let share = |(part, rate): (&Part, &f64)| level(part).then_some((part.share, *rate));
            let shares: Vec<(f64, f64)> = surface.parts.iter().zip(&rates).filter_map(share).collect();
            nodes[0] = hidden(0.0, &shares);
            next = 1;
        }
        let mut rest: Vec<(f64, f64, f64)> = surface
            .parts
            .iter()
            .zip(&rates)
            .filter(|(part, _)| !level(part))
            .map(|(p, r)| (of(p), p.share, *r))
            .collect();
        rest.sort_by(|one, other| one.0.total_cmp(&other.0));
        let whole: f64 = rest.iter().map(|value| value.1).sum();
        if whole <= 0.0 {
            let scale = self.nearest_scale(mean);
            nodes[next..self.count].iter_mut().for_each(|node| node.scale = scale);
            return nodes;
        }
        let values: Vec<(f64, f64)> = rest.iter().map(|value| (value.0, value.1)).collect();
        let mut from = 0.0;
        for [scale, weight] in rule(&values, self.count - next) {
            // The values that a node stands for are next to each other in order: it lies between the least and the
            // most.
            let to = from + weight * whole;
            let mut below = 0.0;
            let within = rest.iter().map(|&(_, share, rate)| {
                let part = (below + share).clamp(from, to) - below.clamp(from, to);
                below += share;
                (part, rate)
            });
            let within: Vec<(f64, f64)> = within.filter(|part| part.0 > 0.0).collect();
            nodes[next] = hidden(scale, &within);
            nodes[next].weight = weight * whole;
            (next, from) = (next + 1, to);
        }
        nodes
    }

    /// The scale on the side that is not level of the bend nearest to a value.
    pub(super) fn nearest_scale(&self, mean: f64) -> f64 {
        let mut breaks = self.breaks();
        breaks.sort_by(|one, other| (one - mean).abs().total_cmp(&(other - mean).abs()));
        let beside = breaks.iter().flat_map(|at| {
            let step = 1e-6 * (1.0 + at.abs());
            [at - step, at + step].map(|at| self.curve.slope(at))
        });
        let scale = beside.into_iter().find(|scale| *scale != 0.0).unwrap_or(0.0);
        if self.signed {
            scale
        } else {
            scale.abs()
        }
    }
}

/// The table of the nodes: columns are means of f, rows its deviations, slices scales, weights, rates and spreads.
///
/// Its error is the largest that a step over the slopes in sight was measured to be off, at any view above 85 degrees
/// from the normal: of the nodes themselves and of reading between texels together, for deviations of f from the
/// distance of two columns on. Below it a bend of the curve is as wide as that distance.
pub fn table(nodes: Nodes<'_>, means: Axis, deviations: Axis, name: &str) -> Table {
    let nodes = Nodes { signed: nodes.signed || nodes.curve.is_monotone(), ..nodes };
    let line = |row: usize| {
        // A deviation of 0 is the limit: level or not, and the rule of a narrow distribution.
        let least = 0.25 * deviations.value(1.0);
        let deviation = deviations.value(row as f64).max(least);
        let texel = |column: usize| nodes.over(means.value(column as f64), deviation);
        let texels: Vec<[Node; 4]> = (0..means.count).map(texel).collect();
        let parts: [fn(&Node) -> f64; SLICES] = [|n| n.scale, |n| n.weight, |n| n.rate, |n| n.spread];
        parts.iter().flat_map(|part| texels.iter().flatten().map(|node| half_rounded(part(node)))).collect()
    };
    let lattice = Lattice([means, deviations, Axis { low: 0.0, high: 3.0, count: SLICES, spacing: Spacing::Linear }]);
    let texels = lattice.sliced(&rows(deviations.count, line));
    let error = error(nodes, lattice, &texels);
    lattice.table(name, texels, error)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::table::slope_hiding::FASTEST;
    use crate::table::slope_steps::step_error;

    /// Where all is level a single node stands for it, as the parts' own would.
    #[test]
    fn level_ground_is_one_node() -> Result<(), crate::Error> {
        let curve = HeightTransfer::smoothstep(0.0, 1.0)?;
        let nodes = Nodes { curve: &curve, count: 3, signed: false };
        let (level, surface) = (nodes.over(-0.81, 0.1), nodes.between(ends(), -0.81, 0.1));
        let parts: Vec<(f64, f64)> = surface.parts.iter().map(|part| part.share).zip(surface.rates(FOLLOWS)).collect();
        let truth = hidden(0.0, &parts);
        assert!(
            (level[0].rate - truth.rate).abs() < 1e-9 && (level[0].spread - truth.spread).abs() < 1e-9,
            "{level:?}"
        );
        assert!((level[0].weight - 1.0).abs() < 1e-12 && level[0].scale == 0.0, "{level:?}");
        assert!(level[1..].iter().all(|node| node.weight == 0.0), "{level:?}");
        Ok(())
    }

    /// What the notes behind the crate have as Gauss's rule of |g′|, for a surface of which a third is level: the step
    /// at the slope 0 is off by up to half of it, however many nodes there are.
    #[test]
    fn a_rule_of_all_slopes_misses_level_ground() -> Result<(), crate::Error> {
        let curve = HeightTransfer::smoothstep(-1.0, 1.0)?;
        let surface = Nodes { curve: &curve, count: 4, signed: false }.surface(64, 0.0, 1.0);
        let values: Vec<(f64, f64)> = surface.parts.iter().map(|part| (part.scale.abs(), part.share)).collect();
        let mut sorted = values.clone();
        sorted.sort_by(|one, other| one.0.total_cmp(&other.0));
        let steepest = surface.average(|part| part.scale * part.scale).sqrt();
        for count in 2..=4 {
            let mut nodes = [Node { spread: 1.0, ..Node::default() }; 4];
            for (node, [scale, weight]) in nodes.iter_mut().zip(rule(&sorted, count)) {
                (node.scale, node.weight) = (scale, weight);
            }
            assert!(step_error(&surface, &nodes, steepest) > 0.08, "{count}: {nodes:?}");
            let ours = Nodes { curve: &curve, count, signed: false }.over(0.0, 1.0);
            assert!(step_error(&surface, &ours, steepest) < [0.1, 0.03, 0.02][count - 2], "{count}: {ours:?}");
        }
        Ok(())
    }

    /// With a mean slope, a fall is no rise.
    #[test]
    fn a_falling_curve_has_negative_scales() -> Result<(), crate::Error> {
        let curve = HeightTransfer::smoothstep(-1.0, 1.0)?.scaled(-1.0, 0.0)?;
        let nodes = Nodes { curve: &curve, count: 3, signed: false };
        let axis = |low, high| Axis { low, high, count: 2, spacing: Spacing::Linear };
        let table = table(nodes, axis(0.1, 0.2), axis(0.0, 0.3), "nodes");
        let scales = &table.levels[0].texels[8..11];
        assert!(scales[0] == 0.0 && scales[1] < scales[2] && scales[2] < 0.0, "{scales:?}");
        Ok(())
    }

    #[test]
    fn weights_sum_to_one_and_nodes_stay_finite() -> Result<(), crate::Error> {
        let curves = [
            HeightTransfer::smoothstep(0.0, 1.0)?,
            HeightTransfer::absolute(),
            HeightTransfer::terraces(3, 0.4)?,
            HeightTransfer::power(1.5)?,
            HeightTransfer::knots([(0.0, 0.3)])?,
            HeightTransfer::knots([(0.0, 0.0), (0.5, 1.0), (0.6, 0.2)])?,
        ];
        for curve in &curves {
            for signed in [false, true] {
                for (mean, deviation) in [(0.0, 0.0), (0.5, 1e-5), (0.51, 0.02), (-3.0, 0.1), (2.15, 0.3), (40.0, 1.0)]
                {
                    let nodes = Nodes { curve, count: 3, signed }.over(mean, deviation);
                    let sum: f64 = nodes.iter().map(|node| node.weight).sum();
                    assert!((sum - 1.0).abs() < 1e-9, "{mean}, {deviation}: {nodes:?}");
                    let fine = |n: &Node| n.scale.is_finite() && n.weight >= 0.0 && (0.0..=FASTEST).contains(&n.rate);
                    assert!(nodes.iter().all(fine), "{nodes:?}");
                }
            }
        }
        Ok(())
    }
}
