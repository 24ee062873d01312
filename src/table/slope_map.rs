//! Tables of a map's means over round normal distributions of slopes: baked exactly, because the mean of a product is
//! the product of the means along both components, and judged by quadrature of the map.

use super::grid::Axis;
use super::lattice::{half_rounded, rows, Lattice};
use super::Table;
use crate::reference::normal::{cumulative, density};
use crate::reference::slope_map::Bilinear;

/// Beyond this many deviations lies less than 6e-7 of a distribution.
const FAR: f64 = 5.0;

/// Of so many deviations next to each other the map itself has the last word where reads are farthest from its means.
const JUDGED: usize = 5;

/// A map, the axes of its table, and what the table is judged over.
#[derive(Clone, Copy)]
pub(crate) struct Plan<'a> {
    /// The map.
    pub map: &'a Bilinear,
    /// The columns and the rows: components of the mean slope.
    pub slopes: Axis,
    /// The slices: deviations of a component.
    pub deviations: Axis,
    /// The largest component of a mean slope that occurs; those beyond the axis read the border.
    pub farthest: f64,
    /// The deviation above which the colors change little from cell to cell.
    pub smooth: f64,
}

/// A table, and how far it is from the map's means at each deviation where that was measured.
pub(crate) struct Baked {
    /// The table, with its error over all deviations.
    pub table: Table,
    errors: Vec<(f64, f32)>,
}

impl Baked {
    /// The largest error from a deviation on.
    pub(crate) fn error(&self, from: f64) -> f32 {
        // Those just below stand for what lies between.
        let next = self.errors.iter().map(|error| error.0).filter(|&at| at <= from).fold(0.0, f64::max);
        self.errors.iter().filter(|error| error.0 >= next).map(|error| error.1).fold(0.0, f32::max)
    }
}

impl Plan<'_> {
    /// The table, and how far it is from the map's means between its nodes.
    pub(crate) fn table(self, name: &str) -> Baked {
        let lattice = Lattice([self.slopes, self.slopes, self.deviations]);
        let nodes: Vec<f64> = (0..self.slopes.count).map(|node| self.slopes.value(node as f64)).collect();
        let slice = |slice: usize| {
            let colors = means(self.map, &nodes, &nodes, self.deviations.value(slice as f64));
            colors.into_iter().flat_map(|color| color.map(half_rounded)).collect()
        };
        let texels = rows(self.deviations.count, slice);
        let halves = (0..2 * self.deviations.count - 1).map(|half| self.deviations.value(0.5 * half as f64));
        let deviations: Vec<f64> = halves.collect();
        let groups: Vec<&[f64]> = deviations.chunks(JUDGED).collect();
        let errors = rows(groups.len(), |group| self.errors(lattice, &texels, groups[group]));
        let table = lattice.table(name, texels, errors.iter().copied().fold(0.0, f32::max));
        Baked { table, errors: deviations.into_iter().zip(errors).collect() }
    }

    /// The largest difference between a filtered read and the map's mean at each deviation; the map itself has the last
    /// word on the largest of all.
    fn errors(self, lattice: Lattice, texels: &[f32], deviations: &[f64]) -> Vec<f32> {
        let mut found: Vec<(f64, [f64; 2])> =
            deviations.iter().map(|&deviation| self.worst(lattice, texels, deviation)).collect();
        let numbers = deviations.iter().zip(&mut found);
        if let Some((deviation, (error, [x, y]))) = numbers.max_by(|one, other| one.1 .0.total_cmp(&other.1 .0)) {
            let variance = deviation * deviation;
            let read = lattice.filtered(texels, [*x, *y, *deviation]);
            *error = apart(read, self.map.mean([*x, *y], [variance, 0.0, variance]));
        }
        found.into_iter().map(|(error, _)| error as f32).collect()
    }

    /// The largest difference at a deviation and where it is: at the centers of cells, beside them on the lines of
    /// nodes, and beyond the axis.
    fn worst(self, lattice: Lattice, texels: &[f32], deviation: f64) -> (f64, [f64; 2]) {
        let asked = |slope: &f64| slope.abs() <= self.farthest;
        let half = |half: usize| self.slopes.value(0.5 * half as f64);
        let beyond = [-self.farthest, self.farthest];
        // What is blurred over cells changes little from one to the next.
        let [every, other] = if deviation < self.smooth { [1, 1] } else { [3, 2] };
        let columns = (0..2 * self.slopes.count - 1).step_by(every).map(half);
        let centers = (1..self.slopes.count).step_by(other).map(|cell| half(2 * cell - 1));
        let columns: Vec<f64> = columns.chain(beyond).filter(asked).collect();
        let centers: Vec<f64> = centers.chain(beyond).filter(asked).collect();
        let near = means(self.map, &columns, &centers, deviation);
        let slice = lattice.slice(texels, deviation);
        let place = |at: &f64| {
            let number = self.slopes.number(*at);
            (number as usize, number.fract())
        };
        let [columns_at, centers_at] = [&columns, &centers].map(|places| places.iter().map(place).collect::<Vec<_>>());
        let (size, last) = (self.slopes.count, self.slopes.count - 1);
        let mut worst = (0.0, [0.0; 2]);
        for ((y, &(row, up)), near) in centers.iter().zip(&centers_at).zip(near.chunks_exact(columns.len())) {
            let [low, high] = [row, (row + 1).min(last)].map(|row| &slice[row * size..(row + 1) * size]);
            for ((x, &(column, along)), near) in columns.iter().zip(&columns_at).zip(near) {
                let next = (column + 1).min(last);
                let error = apart(
                    between(between(low[column], low[next], along), between(high[column], high[next], along), up),
                    *near,
                );
                if error > worst.0 {
                    worst = (error, [*x, *y]);
                }
            }
        }
        worst
    }
}

/// What lies a part of the way from one color to another.
fn between(from: [f64; 4], to: [f64; 4], part: f64) -> [f64; 4] {
    std::array::from_fn(|channel| from[channel] + part * (to[channel] - from[channel]))
}

/// The largest difference of two colors in a channel.
fn apart(one: [f64; 4], other: [f64; 4]) -> f64 {
    one.iter().zip(other).map(|(one, other)| (one - other).abs()).fold(0.0, f64::max)
}

/// The weights of the nodes in the mean over a normal variable of a function that is linear between them and constant
/// beyond: the first node that has one, and the weights.
///
/// The mean of the ramp from 0 at a node to 1 at the next is the difference of the means of max(v − x, 0) at both, over
/// their distance; a node's hat is the difference of the ramps on its sides.
fn hats(nodes: &[f64], mean: f64, deviation: f64) -> (usize, Vec<f64>) {
    let excess = |node: f64| {
        let from = (mean - node) / deviation;
        if deviation > 0.0 && from.abs() < FAR {
            deviation * (density(from) + from * cumulative(from))
        } else {
            (mean - node).max(0.0)
        }
    };
    let reach = FAR * deviation;
    let first = nodes.partition_point(|&node| node <= mean - reach).saturating_sub(1);
    let last = nodes.partition_point(|&node| node < mean + reach).min(nodes.len() - 1);
    let ramp = |cell: usize| (excess(nodes[cell]) - excess(nodes[cell + 1])) / (nodes[cell + 1] - nodes[cell]);
    let mut left = 1.0;
    let weight = |node: usize| {
        let right = if node + 1 < nodes.len() && node < last { ramp(node) } else { 0.0 };
        let weight = left - right;
        left = right;
        weight
    };
    (first, (first..=last).map(weight).collect())
}

/// The means of a map over round normal distributions at all pairs of components, row by row.
fn means(map: &Bilinear, columns: &[f64], lines: &[f64], deviation: f64) -> Vec<[f64; 4]> {
    let [across, down] = [columns, lines]
        .map(|places| places.iter().map(|&at| hats(&map.nodes, at, deviation)).collect::<Vec<(usize, Vec<f64>)>>());
    let size = map.nodes.len();
    // Sums of whole rows run over neighbors: first along the lines, then, the axes exchanged, along the columns.
    let blurred = exchanged(&weighted(&down, &map.colors, size), size);
    let means = weighted(&across, &blurred, lines.len());
    exchanged(&means, lines.len())
}

/// Weighted sums of rows of so many colors.
fn weighted(sums: &[(usize, Vec<f64>)], rows: &[[f64; 4]], length: usize) -> Vec<[f64; 4]> {
    let mut all = vec![[0.0; 4]; sums.len() * length];
    for ((first, weights), sum) in sums.iter().zip(all.chunks_exact_mut(length)) {
        for (weight, row) in weights.iter().zip(rows[first * length..].chunks_exact(length)) {
            for (total, color) in sum.iter_mut().zip(row) {
                *total = std::array::from_fn(|channel| total[channel] + weight * color[channel]);
            }
        }
    }
    all
}

/// Rows of so many colors as columns.
fn exchanged(rows: &[[f64; 4]], length: usize) -> Vec<[f64; 4]> {
    (0..length).flat_map(|column| rows.iter().skip(column).step_by(length).copied()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn means_are_those_of_the_reference() {
        // Uneven nodes, and colors without symmetry.
        let nodes = vec![-2.0, -0.5, 0.1, 0.3, 4.0];
        let colors = (0..25).map(|at| [0, 1, 2, 3].map(|channel| f64::from((7 * at + 5 * channel) % 11) / 11.0));
        let map = Bilinear { nodes, colors: colors.collect() };
        for (place, deviation) in
            [([0.2, -0.3], 0.4), ([-1.9, 3.7], 0.05), ([8.0, -6.0], 1.5), ([0.1, 0.2], 0.0), ([0.11, 0.2], 1e-4)]
        {
            let truth = map.mean(place, [deviation * deviation, 0.0, deviation * deviation]);
            let found = means(&map, &place[..1], &place[1..], deviation)[0];
            assert!(apart(truth, found) < 1e-7, "{place:?}, {deviation}: {found:?} {truth:?}");
        }
    }
}
