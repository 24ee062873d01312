//! Tables of a map's means over the visible heights h = g(f) of a curve g, by mean and deviation of f.

use std::f64::consts::LN_2;

use super::balanced::{balance, Nodes};
use super::grid::{Axis, Spacing};
use super::hiding::Hiding;
use super::lattice::{half_rounded, Lattice};
use super::layers::{Layers, REACH};
use super::threads::rows;
use super::Table;
use crate::reference::slope_nodes::Transferred;
use crate::reference::texture::PiecewiseLinear;
use crate::transfer::height_transfer::HeightTransfer;

/// The most bends that are judged, and one column in how many.
const JUDGED: [usize; 2] = [48, 2];

/// A map over the heights that a curve makes, and what its table covers.
pub(crate) struct Plan<'a> {
    /// Colors by height.
    pub map: &'a PiecewiseLinear,
    /// Heights by value.
    pub curve: &'a HeightTransfer,
    /// The columns, means of f.
    pub means: Axis,
    /// The rows, its deviations: what is visible moves and widens with each by as many of its own deviations.
    pub deviations: Axis,
}

/// The slices: log₂(1 + 4Λ) of the sum of Smith's Λ of view and light. Few views hide more than half of a surface, as
/// they do at Λ = 1: half of the slices are below 8.
pub(crate) const HIDING: Axis = Axis { low: 0.0, high: 10.0, count: 16, spacing: Spacing::Linear };

/// What Λ is multiplied by there.
pub(crate) const DENSER: f64 = 4.0;

/// What errors of Λ move a color by, where the Λ of so many directions each err by a part of 1 + Λ: the largest change
/// of a table's texels from slice to slice, times the slices that their sum is off by.
///
/// Between slices a color that is read is even. Where the sum moves by δ, log₂(1 + 4Λ) moves by 4 δ/(1 + 4Λ) over ln 2,
/// which is most on the first of two slices.
pub(crate) fn moved(table: &Table, error: f64, directions: f64) -> f64 {
    let texels = &table.levels[0].texels;
    let slice = texels.len() / HIDING.count;
    let steps = (0..SLICES - 1).map(|number| {
        let [near, far] = [number, number + 1].map(|number| &texels[number * slice..(number + 1) * slice]);
        let change = near.iter().zip(far).map(|(near, far)| f64::from((near - far).abs())).fold(0.0, f64::max);
        let lambda = lambda(number as f64);
        let slices = (HIDING.number(1.0) - HIDING.number(0.0)) * DENSER / (1.0 + DENSER * lambda) / LN_2;
        change * slices * error * (directions + lambda)
    });
    steps.fold(0.0, f64::max)
}

/// The largest such sum for which the error is measured, and the slices up to there. Beyond, rows err: what is visible
/// is narrower than it moves between two of them.
pub(crate) const COVERED: f64 = 100.0;
const SLICES: usize = 14;

impl Plan<'_> {
    /// The table, with its error as measured between texels for deviations from `floor` on and Λ up to [`COVERED`].
    pub(crate) fn table(&self, name: &str, floor: f64) -> Table {
        let lattice = Lattice([self.means, self.deviations, HIDING]);
        let bends = self.bends();
        let layers = Layers::new(self.map, self.curve, &bends, self.values());
        let hiding = Hiding::new([1.0, 2.0, 3.0].map(lambda), 3.0 / DENSER, HIDING.count);
        let [width, height, depth] = lattice.0.map(|axis| axis.count);
        let line = |row: usize| {
            let deviation = self.deviations.value(row as f64);
            let colors = |column: usize| layers.colors(self.means.value(column as f64), deviation, &hiding);
            let columns: Vec<Vec<[f64; 4]>> = (0..width).map(colors).collect();
            let slices = (0..depth).flat_map(|slice| columns.iter().map(move |column| column[slice]));
            slices.flat_map(|color| color.map(|channel| channel as f32)).collect()
        };
        let mut texels = lattice.sliced(&rows(height, line));
        self.balance(&mut texels, lattice);
        texels.iter_mut().for_each(|texel| *texel = half_rounded(f64::from(*texel)));
        let error = self.error(lattice, &layers, &bends, &texels, floor);
        lattice.table(name, texels, error)
    }

    /// The largest difference between a filtered read and the color: on the first slice and by turns between slices and
    /// on them, on the first and the last row, between rows and on the least, over the centers of every other cell of
    /// columns, those between them on the next line, and where the color bends. Of each line the reference has the last
    /// word where the difference is largest.
    fn error(&self, lattice: Lattice, layers: &Layers<'_>, bends: &[f64], texels: &[f32], floor: f64) -> f32 {
        let Lattice([columns, deviations, _]) = lattice;
        let judged = [0.5, 0.0]
            .map(|before| Hiding::new([1.0, 2.0, 3.0].map(|slice| lambda(slice - before)), 3.0 / DENSER, SLICES));
        // Of many bends some stand for all: each costs as much as a column.
        let within = bends.iter().copied().filter(|at| (columns.low..=columns.high).contains(at));
        let some: Vec<f64> = within.step_by(bends.len().div_ceil(JUDGED[0]).max(1)).collect();
        let middles = (0..deviations.count - 1).map(|row| deviations.value(row as f64 + 0.5));
        let ends = [floor, deviations.value(0.0), deviations.high];
        let lines: Vec<f64> = middles.chain(ends).filter(|&line| line >= floor).collect();
        let worst = |line: usize| {
            let deviation = lines[line];
            // Judged on other columns by the next line but one.
            let hiding = &judged[line / 2 % 2];
            let apart = |mean: f64, slice: usize, color: [f64; 4]| {
                let third = (1.0 + DENSER * hiding.lambdas()[slice]).log2();
                let read = lattice.filtered(texels, [mean, deviation, third]);
                read.iter().zip(color).map(|(read, truth)| (read - truth).abs()).fold(0.0, f64::max)
            };
            let centers = (line % JUDGED[1]..columns.count - 1).step_by(JUDGED[1]);
            let places = centers.map(|cell| columns.value(cell as f64 + 0.5)).chain(some.iter().copied());
            let errors = places.flat_map(|mean| {
                let colors = layers.colors(mean, deviation, hiding).into_iter().enumerate();
                colors.map(move |(slice, color)| (mean, slice, color)).collect::<Vec<_>>()
            });
            let errors = errors.map(|(mean, slice, color)| (apart(mean, slice, color), mean, slice));
            let (_, mean, slice) =
                errors.fold((0.0, columns.low, 0), |one, next| if next.0 > one.0 { next } else { one });
            vec![apart(mean, slice, self.truth(bends, mean, deviation, hiding.lambdas()[slice])) as f32]
        };
        rows(lines.len(), worst).into_iter().fold(0.0, f32::max)
    }

    /// Balances the nodes between slices, and where f deviates by a column or more, so that colors are smooth along
    /// both, between rows and columns, too.
    fn balance(&self, texels: &mut [f32], lattice: Lattice) {
        let [width, height, depth] = lattice.0.map(|axis| axis.count);
        let (hull, column) = (self.hull(), self.means.value(1.0) - self.means.value(0.0));
        let smooth = (0..height).find(|&row| self.deviations.value(row as f64) >= column).unwrap_or(height);
        let (row, slice) = (width, width * height);
        let mut along = |starts: &mut dyn Iterator<Item = usize>, count, step| {
            starts.for_each(|start| balance(texels, Nodes { start, count, step }, hull));
        };
        along(&mut (0..slice), depth, slice);
        // The row before is a neighbor.
        let first = smooth.saturating_sub(1) * row;
        let slices = || (0..depth).map(|number| number * slice + first);
        along(&mut slices().flat_map(|start| (0..width).map(move |column| start + column)), height - first / row, row);
        let smooth_rows = |start: usize| (smooth..height).map(move |number| start - first + number * row);
        along(&mut slices().flat_map(smooth_rows), width, 1);
    }

    /// Where the color bends as a function of f, and by how much its slope changes there.
    pub(crate) fn changes(map: &PiecewiseLinear, curve: &HeightTransfer, range: (f64, f64)) -> Vec<(f64, f64)> {
        let near = 1e-4 * (range.1 - range.0);
        let color = |at: f64| map.value(curve.height(at));
        let change = |at: f64| {
            let [before, here, after] = [at - near, at, at + near].map(color);
            (0..4).map(|c| (before[c] - 2.0 * here[c] + after[c]).abs() / near).fold(0.0, f64::max)
        };
        bends(map, curve, range).into_iter().map(|at| (at, change(at))).collect()
    }

    /// The least and the largest color in every channel.
    fn hull(&self) -> [[f32; 4]; 2] {
        let ends = || self.map.knots.iter().flat_map(|knot| [knot.1, knot.2]);
        let most = |of: fn(f64, f64) -> f64, from: f64| {
            ends().fold([from; 4], |sum, color| std::array::from_fn(|channel| of(sum[channel], color[channel])))
        };
        let ends = [most(f64::min, f64::INFINITY), most(f64::max, f64::NEG_INFINITY)];
        ends.map(|end| end.map(|channel| channel as f32))
    }

    /// The lowest and the highest value that occur.
    fn values(&self) -> (f64, f64) {
        let far = REACH * self.deviations.high;
        (self.means.low - far, self.means.high + far)
    }

    /// Where it bends for the values that occur.
    fn bends(&self) -> Vec<f64> {
        bends(self.map, self.curve, self.values())
    }

    /// The mean color over what is visible of heights, by the reference's many parts.
    fn truth(&self, bends: &[f64], mean: f64, deviation: f64, lambda: f64) -> [f64; 4] {
        let curve = self.curve;
        let all = Transferred::new([mean, deviation], bends, |value| curve.height(value), |value| curve.slope(value));
        let shares = all.visible_heights(lambda);
        let mut color = [0.0; 4];
        for (part, share) in all.parts.iter().zip(shares) {
            for (sum, channel) in color.iter_mut().zip(self.map.value(part.height)) {
                *sum += share * channel;
            }
        }
        color
    }
}

/// Λ at a slice's number.
fn lambda(slice: f64) -> f64 {
    (HIDING.value(slice).exp2() - 1.0) / DENSER
}

/// Where the color bends as a function of f.
fn bends(map: &PiecewiseLinear, curve: &HeightTransfer, (low, high): (f64, f64)) -> Vec<f64> {
    let edges = map.knots.iter().flat_map(|knot| curve.crossings(low, high, knot.0));
    let mut all: Vec<f64> = edges.chain(curve.bends()).filter(|at| (low..=high).contains(at)).collect();
    all.sort_by(f64::total_cmp);
    all.dedup();
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::table::strip::Strip;

    fn map() -> PiecewiseLinear {
        let (black, white) = ([0.0, 0.3, 1.0, 1.0], [1.0, 0.4, 0.0, 1.0]);
        PiecewiseLinear {
            knots: vec![(0.1, black, black), (0.3, white, black), (0.6, black, white), (0.9, white, white)],
        }
    }

    /// Few columns and rows, spread as those of filters are: rows in even ratios, from a column's width on.
    fn plan<'a>(map: &'a PiecewiseLinear, curve: &'a HeightTransfer, [low, high]: [f64; 2], most: f64) -> Plan<'a> {
        let means = Axis { low, high, count: 32, spacing: Spacing::Linear };
        let narrow = (means.value(1.0) - means.value(0.0)).min(0.25 * most);
        let deviations = Axis { low: narrow, high: most, count: 8, spacing: Spacing::Ratio };
        Plan { map, curve, means, deviations }
    }

    /// A line leaves heights as they are.
    #[test]
    fn colors_over_a_line_are_those_without_a_curve() -> Result<(), crate::Error> {
        let (map, line) = (map(), HeightTransfer::power(1.0)?);
        let plan = plan(&map, &line, [-0.5, 1.5], 0.5);
        let layers = Layers::new(&map, &line, &plan.bends(), plan.values());
        for strip in [0.0, 0.7, 39.0, 1e3].map(Strip::new) {
            for (mean, deviation) in [(0.31, 0.02), (-0.4, 0.3), (0.7, 0.5), (1.2, 0.2), (0.31, 0.0)] {
                let expected = strip.color(&map, mean + deviation * strip.mean, deviation * strip.deviation);
                let found = layers.colors(mean, deviation, &Hiding::new([strip.lambda; 3], 3.0, 2))[1];
                let apart = found.iter().zip(expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                assert!(apart < 2e-4, "{}, {mean}, {deviation}: {apart:e}", strip.lambda);
            }
        }
        Ok(())
    }

    /// Curves that rise, turn and have level parts, against the mean over the parts of the surface that are visible.
    #[test]
    fn colors_are_those_of_the_reference() -> Result<(), crate::Error> {
        let map = map();
        let peaks = HeightTransfer::knots([(-0.5, 0.7), (0.1, 0.0), (0.4, 1.0), (0.9, 0.2)])?;
        for curve in [HeightTransfer::smoothstep(0.0, 1.2)?, HeightTransfer::absolute(), peaks] {
            let plan = plan(&map, &curve, [-0.5, 1.5], 0.5);
            let bends = plan.bends();
            let layers = Layers::new(&map, &curve, &bends, plan.values());
            for [mean, deviation] in [[0.31, 0.05], [-0.4, 0.3], [0.7, 0.5], [1.2, 0.2], [0.31, 0.0]] {
                for lambda in [0.0, 0.4, 5.0, 100.0, 1e4] {
                    let truth = plan.truth(&bends, mean, deviation, lambda);
                    let found = layers.colors(mean, deviation, &Hiding::new([lambda; 3], 3.0, 2))[1];
                    let apart = found.iter().zip(truth).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                    assert!(apart < 2e-3, "{curve:?}, {mean}, {deviation}, {lambda}: {apart:e}");
                }
            }
        }
        Ok(())
    }

    /// Values that occur may reach over a part of the curve and of the map alone, with few bends or none.
    #[test]
    fn values_may_lie_between_the_bends() -> Result<(), crate::Error> {
        let (black, white) = ([0.0, 0.3, 1.0, 1.0], [1.0, 0.4, 0.0, 1.0]);
        let map = PiecewiseLinear { knots: vec![(0.0, black, black), (0.5, white, white), (1.0, black, black)] };
        let curves = [HeightTransfer::smoothstep(0.2, 0.8)?, HeightTransfer::power(1.0)?];
        for (curve, low) in curves.iter().flat_map(|curve| [0.3, 0.4, 0.55].map(|low| (curve, low))) {
            let plan = plan(&map, curve, [low, low + 0.1], 0.01);
            let bends = plan.bends();
            let layers = Layers::new(&map, curve, &bends, plan.values());
            for mean in [low, low + 0.03, low + 0.1] {
                let truth = plan.truth(&bends, mean, 0.01, 5.0);
                let found = layers.colors(mean, 0.01, &Hiding::new([5.0; 3], 3.0, 2))[1];
                let apart = found.iter().zip(truth).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                assert!(apart < 2e-3, "{curve:?}, {mean}: {apart:e}");
            }
        }
        Ok(())
    }

    /// What a sampler reads between nodes, at other places than those that the table is judged at, is as far from the
    /// reference as filters say, which is twice as far as was measured.
    #[test]
    fn reads_are_as_near_as_the_table_says() -> Result<(), crate::Error> {
        let (map, curve) = (map(), HeightTransfer::smoothstep(0.0, 1.2)?);
        let plan = plan(&map, &curve, [-0.5, 1.5], 0.5);
        let (floor, bends) = (2.0 * plan.deviations.low, plan.bends());
        let table = plan.table("table", floor);
        let lattice = Lattice([plan.means, plan.deviations, HIDING]);
        let (most, mut worst) = (2.0 * f64::from(table.error), 0.0f64);
        for mean in (0..29).map(|place| 0.069 * f64::from(place) - 0.47) {
            for (deviation, lambda) in [(floor, 0.0), (floor, 2.7), (0.17, 0.3), (0.23, 93.0), (0.5, 7.0)] {
                let read = lattice.filtered(&table.levels[0].texels, [mean, deviation, (1.0 + DENSER * lambda).log2()]);
                let truth = plan.truth(&bends, mean, deviation, lambda);
                let apart = read.iter().zip(truth).map(|(read, truth)| (read - truth).abs()).fold(0.0, f64::max);
                assert!(apart <= most, "{mean}, {deviation}, {lambda}: {apart:e} of {most:e}");
                worst = worst.max(apart);
            }
        }
        assert!(4.0 * worst >= most, "{most:e} is more than four times too wide: {worst:e}");
        Ok(())
    }
}
