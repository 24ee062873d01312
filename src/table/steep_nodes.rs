//! Tables of what hides transferred heights: scales and weights of the nodes that are steep, which alone have a Λ.

use super::grid::{Axis, Spacing};
use super::lattice::{half_rounded, Lattice};
use super::normal;
use super::rule::rule;
use super::slope_nodes::{ends, Nodes, LEVEL};
use super::threads::rows;
use super::{Level, Table};

/// The most nodes that one texel holds with their weights.
pub(crate) const TOGETHER: usize = 2;

/// Columns and rows between which a table is judged: one in so many.
const JUDGED: [usize; 2] = [3, 4];

/// Visibility parameters over slopes of the scale 1, in the steepest scale: from grazing views on.
const PARAMETERS: [f64; 5] = [0.05, 0.15, 0.4, 0.8, 1.5];

impl Nodes<'_> {
    /// The nodes that are steep.
    pub(crate) fn steep(&self) -> usize {
        self.count - usize::from(self.has_level())
    }

    /// Their scales |g′| and their weights over a normal f: the rule of those slopes that are not level.
    fn hiding(&self, mean: f64, deviation: f64) -> [[f64; 4]; 2] {
        let (count, mut found) = (self.steep(), [[0.0; 4]; 2]);
        let values = if self.is_level(mean, deviation) { Vec::new() } else { self.values(mean, deviation) };
        let whole: f64 = values.iter().map(|value| value.1).sum();
        if whole <= 0.0 {
            found[0][..count].fill(self.nearest_scale(mean).abs());
            return found;
        }
        for (node, [scale, weight]) in rule(&values, count).into_iter().enumerate() {
            (found[0][node], found[1][node]) = (scale, weight * whole);
        }
        found
    }

    /// The slopes |g′| that are not level, with their shares.
    fn values(&self, mean: f64, deviation: f64) -> Vec<(f64, f64)> {
        let surface = self.between(ends(), mean, deviation);
        let all = surface.parts.iter().map(|part| (part.scale.abs(), part.share));
        let steepest = all.clone().map(|value| value.0).fold(0.0, f64::max);
        let level = if self.has_level() { LEVEL * steepest } else { -1.0 };
        all.filter(|value| value.0 > level).collect()
    }
}

/// The table: columns are means of f, rows its deviations. A texel holds the scales of two nodes and then their
/// weights; of more nodes there are two slices, of scales and of weights.
///
/// Its error is the largest difference of Smith's Λ, over 1 + Λ, between texels, from that of all parts of the surface,
/// for deviations of f from the distance of two columns on.
pub(crate) fn table(nodes: Nodes<'_>, means: Axis, deviations: Axis, name: &str) -> Table {
    let count = nodes.steep();
    let slices = if count > TOGETHER { 2 } else { 1 };
    let line = |row: usize| {
        // A deviation of 0 is the limit, as of all nodes' table.
        let deviation = deviations.value(row as f64).max(0.25 * deviations.value(1.0));
        let found: Vec<[[f64; 4]; 2]> =
            (0..means.count).map(|column| nodes.hiding(means.value(column as f64), deviation)).collect();
        let texel = |[scales, weights]: &[[f64; 4]; 2], slice: usize| match (slices, slice) {
            (1, _) => [scales[0], scales[1], weights[0], weights[1]],
            (_, 0) => *scales,
            _ => *weights,
        };
        let texels = (0..slices).flat_map(|slice| found.iter().flat_map(move |found| texel(found, slice)));
        texels.map(half_rounded).collect()
    };
    let third = Axis { low: 0.0, high: 1.0, count: slices, spacing: Spacing::Linear };
    let lattice = Lattice([means, deviations, third]);
    let texels = lattice.sliced(&rows(deviations.count, line));
    let error = error(nodes, lattice, &texels);
    lattice.table(name, texels, error)
}

/// The error of the Λ of a level surface by a table of all that is known of nodes, whose first two slices are scales
/// and weights: as that of [`table`].
pub(crate) fn hiding_error(nodes: Nodes<'_>, means: Axis, deviations: Axis, table: &Table) -> f32 {
    let Level { depth, texels, .. } = &table.levels[0];
    let third = Axis { low: 0.0, high: f64::from(depth - 1), count: *depth as usize, spacing: Spacing::Linear };
    error(nodes, Lattice([means, deviations, third]), texels)
}

/// The largest difference between the texels.
fn error(nodes: Nodes<'_>, lattice: Lattice, texels: &[f32]) -> f32 {
    let Lattice([means, deviations, third]) = lattice;
    let column = means.value(1.0) - means.value(0.0);
    let halves = (1..2 * deviations.count - 1).rev().map(|half| deviations.value(0.5 * half as f64));
    let lines: Vec<f64> = halves.filter(|&line| line >= column).step_by(JUDGED[1]).chain([column]).collect();
    let worst = |line: usize| {
        let cells = (line % JUDGED[0]..means.count - 1).step_by(JUDGED[0]);
        let apart = |cell: usize| {
            let mean = means.value(cell as f64 + 0.5);
            let read = |slice: f64| lattice.filtered(texels, [mean, lines[line], slice]);
            let [first, second] = [read(0.0), read(1.0)];
            let read: Vec<(f64, f64)> = match third.count {
                1 => vec![(first[0], first[2]), (first[1], first[3])],
                _ => first.into_iter().map(f64::abs).zip(second).collect(),
            };
            let surface = nodes.between(ends(), mean, lines[line]);
            let parts: Vec<(f64, f64)> = surface.parts.iter().map(|part| (part.scale.abs(), part.share)).collect();
            // Where all parts are level, what neighbors know of steep ones is what errs.
            let steepest = parts.iter().chain(&read).map(|part| part.0).fold(0.0, f64::max);
            if steepest <= 0.0 {
                return 0.0;
            }
            let errors = PARAMETERS.map(|parameter| {
                let [truth, read] = [&parts, &read].map(|nodes| lambda(nodes, parameter * steepest));
                (truth - read).abs() / (1.0 + truth)
            });
            errors.into_iter().fold(0.0, f64::max)
        };
        vec![cells.map(apart).fold(0.0, f64::max) as f32]
    };
    rows(lines.len(), worst).into_iter().fold(0.0, f32::max)
}

/// Smith's Λ of scales with their shares, by the visibility parameter over slopes of the scale 1: E[max(−t, 0)] over
/// E[t].
fn lambda(nodes: &[(f64, f64)], parameter: f64) -> f64 {
    let horizon = std::f64::consts::SQRT_2 * parameter;
    let each = nodes.iter().filter(|node| node.0 > 1e-9).map(|&(scale, share)| {
        let at = horizon / scale;
        share * normal::excess(at) / at
    });
    each.sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::transfer::height_transfer::HeightTransfer;

    /// They are those of the table of slopes.
    #[test]
    fn nodes_that_hide_are_those_of_slopes() -> Result<(), crate::Error> {
        let knots = HeightTransfer::knots([(0.0, 0.0), (0.5, 1.0), (0.6, 0.2)])?;
        for curve in [HeightTransfer::smoothstep(0.0, 1.2)?, HeightTransfer::absolute(), knots] {
            for (count, [mean, deviation]) in [(2, [0.3, 0.2]), (3, [0.7, 0.05]), (4, [-0.2, 0.5]), (3, [-9.0, 0.1])] {
                let nodes = Nodes { curve: &curve, count, signed: false };
                let [scales, weights] = nodes.hiding(mean, deviation);
                let all = nodes.over(mean, deviation);
                for (node, slope) in all[count - nodes.steep()..count].iter().enumerate() {
                    let apart = (scales[node] - slope.scale).abs().max((weights[node] - slope.weight).abs());
                    assert!(apart < 1e-9, "{mean}, {deviation}: {scales:?} {weights:?} {all:?}");
                }
            }
        }
        Ok(())
    }

    /// A texel holds two nodes, two slices hold more; both as Λ of all parts.
    #[test]
    fn tables_hold_all_that_hides() -> Result<(), crate::Error> {
        let axis = |low, high, count| Axis { low, high, count, spacing: Spacing::Linear };
        for (curve, count, slices, within) in [
            (HeightTransfer::smoothstep(0.0, 1.2)?, 3, 1, 2e-2),
            (HeightTransfer::smoothstep(0.0, 1.2)?, 4, 2, 2e-2),
            (HeightTransfer::power(1.0)?, 2, 1, 2e-3),
        ] {
            let nodes = Nodes { curve: &curve, count, signed: false };
            let table = table(nodes, axis(-0.6, 1.8, 64), axis(0.0, 0.6, 24), "nodes");
            assert_eq!(table.levels[0].depth, slices);
            assert!(f64::from(table.error) < within, "{count}: {}", table.error);
        }
        Ok(())
    }
}
