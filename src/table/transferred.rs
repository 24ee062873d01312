//! Tables of a map's means over the visible heights h = g(f) of a curve g, by mean and deviation of f.

use super::grid::{Axis, Spacing};
use super::lattice::{Judged, Lattice};
use super::Table;
use crate::reference::normal::cumulative;
use crate::reference::slope_nodes::Transferred;
use crate::reference::texture::PiecewiseLinear;
use crate::transfer::height_transfer::HeightTransfer;

/// Cells over the deviations of f on either side of its mean, besides those that bends cut.
const CELLS: usize = 128;

/// The most bends that are judged.
const JUDGED: usize = 48;

/// Beyond this many deviations of f there are 1e-11 of its values.
const REACH: f64 = 6.7;

/// The nodes of Gauss's rule of two over 0 to 1.
const NODES: [f64; 2] = [0.211_324_865_405_187_1, 0.788_675_134_594_812_9];

/// A map over the heights that a curve makes, and what its table covers.
pub(crate) struct Plan<'a> {
    /// Colors by height.
    pub map: &'a PiecewiseLinear,
    /// Heights by value.
    pub curve: &'a HeightTransfer,
    /// The columns, means of f.
    pub means: Axis,
    /// The rows, its deviations.
    pub deviations: Axis,
}

/// The slices: log₂(1 + Λ) of the sum of Smith's Λ of view and light.
pub(crate) const HIDING: Axis = Axis { low: 0.0, high: 10.0, count: 16, spacing: Spacing::Linear };

/// A part of the values of f, between two places where nothing bends.
struct Cell {
    /// The mean of its ends' heights.
    height: f64,
    /// How many of all values it holds.
    share: f64,
    /// |g′| at the nodes, the lower one first.
    steepness: [f64; 2],
    /// Logarithm of the density of f at its higher end over that at its lower one.
    rise: f64,
    /// The colors at the nodes, the lower one first.
    colors: [[f64; 4]; 2],
}

impl Plan<'_> {
    /// The table, with its error as measured between texels for deviations from `floor` on.
    pub(crate) fn table(&self, name: &str, floor: f64) -> Table {
        let lattice = Lattice([self.means, self.deviations, HIDING]);
        let bends = self.bends();
        let lambda = |slice: f64| HIDING.value(slice).exp2() - 1.0;
        let texels = lattice.texels(|slice, mean, deviation| self.color(&bends, mean, deviation, lambda(slice as f64)));
        // Of many bends some stand for all: each costs as much as a column.
        let places: Vec<f64> = bends.iter().copied().step_by(bends.len().div_ceil(JUDGED).max(1)).collect();
        let between = (0..HIDING.count - 1).map(|slice| slice as f64 + 0.5);
        let errors = [0.0].into_iter().chain(between).map(|slice| {
            let Axis { low, high, .. } = self.means;
            let judged = Judged { low, high, least: floor, third: HIDING.value(slice) };
            let near = |mean: f64, deviation: f64| self.color(&bends, mean, deviation, lambda(slice));
            let truth = |mean: f64, deviation: f64| self.truth(&bends, mean, deviation, lambda(slice));
            lattice.error(&texels, &places, judged, near, truth)
        });
        let error = errors.fold(0.0, f32::max);
        lattice.table(name, texels, error)
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

    /// Where it bends for the values that occur.
    fn bends(&self) -> Vec<f64> {
        let far = REACH * self.deviations.high;
        bends(self.map, self.curve, (self.means.low - far, self.means.high + far))
    }

    /// The mean color over what is visible of heights of values of the given mean and deviation.
    fn color(&self, bends: &[f64], mean: f64, deviation: f64, lambda: f64) -> [f64; 4] {
        if deviation <= 0.0 {
            return self.map.value(self.curve.height(mean));
        }
        let mut cells = self.cells(bends, mean, deviation);
        let total: f64 = cells.iter().map(|cell| 0.5 * cell.share * (cell.steepness[0] + cell.steepness[1])).sum();
        cells.sort_by(|a, b| b.height.total_cmp(&a.height));
        let (mut below, mut hiding, mut seen, mut color) = (1.0f64, 0.0f64, 1.0f64, [0.0; 4]);
        for cell in &cells {
            let rest = (below - cell.share).max(0.0);
            let [low, high] = cell.steepness.map(|steepness| if total > 0.0 { steepness / total } else { 1.0 });
            let relative = 0.5 * (low + high);
            let hidden = if relative > 0.0 { relative * (below / rest.max(f64::MIN_POSITIVE)).ln() } else { 0.0 };
            hiding += hidden;
            let left = rest * (-lambda * hiding).exp();
            // Of what is visible of the cell the part at its higher node, where the density is that of f times
            // (1 + Λ |g′|/E|g′|) e^(−ΛX), the first and the last even in their logarithms.
            let fall = (-(NODES[1] - NODES[0]) * (cell.rise + lambda * hidden)).exp();
            let (low, high) = (fall * (1.0 + lambda * low), 1.0 + lambda * high);
            let higher = high / (low + high);
            for (channel, sum) in color.iter_mut().enumerate() {
                let [low, high] = cell.colors.map(|color| color[channel]);
                *sum += (seen - left) * (low + higher * (high - low));
            }
            (below, seen) = (rest, left);
        }
        // What rounding leaves below the lowest cell.
        let lowest = cells.last().map_or([0.0; 4], |cell| cell.colors[0]);
        std::array::from_fn(|channel| color[channel] + seen * lowest[channel])
    }

    /// The same by the reference's many parts.
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

    fn cells(&self, bends: &[f64], mean: f64, deviation: f64) -> Vec<Cell> {
        let even = (0..=CELLS).map(|index| REACH * (2.0 * index as f64 / CELLS as f64 - 1.0));
        let bends = bends.iter().map(|at| (at - mean) / deviation).filter(|z| z.abs() < REACH);
        let mut ends: Vec<f64> = even.chain(bends).collect();
        ends.sort_by(f64::total_cmp);
        let mut last = 0.0;
        let cell = |pair: &[f64]| {
            let next = cumulative(pair[1]);
            let share = next - last;
            last = next;
            let at = NODES.map(|part| mean + deviation * (pair[0] + part * (pair[1] - pair[0])));
            let heights = at.map(|value| self.curve.height(value));
            let mut colors = heights.map(|height| self.map.value(height));
            let mut steepness = at.map(|value| self.curve.slope(value).abs());
            let mut rise = 0.5 * (pair[0] * pair[0] - pair[1] * pair[1]);
            if heights[1] < heights[0] {
                colors.reverse();
                steepness.reverse();
                rise = -rise;
            }
            Cell { height: 0.5 * (heights[0] + heights[1]), share, steepness, rise, colors }
        };
        ends.windows(2).map(cell).collect()
    }
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

    fn plan<'a>(map: &'a PiecewiseLinear, curve: &'a HeightTransfer) -> Plan<'a> {
        let means = Axis { low: -0.5, high: 1.5, count: 32, spacing: Spacing::Linear };
        let deviations = Axis { low: 0.0, high: 0.5, count: 8, spacing: Spacing::CubeRoot };
        Plan { map, curve, means, deviations }
    }

    /// A line leaves heights as they are.
    #[test]
    fn colors_over_a_line_are_those_without_a_curve() -> Result<(), crate::Error> {
        let (map, line) = (map(), HeightTransfer::power(1.0)?);
        let plan = plan(&map, &line);
        let bends = plan.bends();
        for strip in [0.0, 0.7, 39.0, 1e3].map(Strip::new) {
            for (mean, deviation) in [(0.31, 0.02), (-0.4, 0.3), (0.7, 0.5), (1.2, 0.2), (0.31, 0.0)] {
                let expected = strip.color(&map, mean + deviation * strip.mean, deviation * strip.deviation);
                let found = plan.color(&bends, mean, deviation, strip.lambda);
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
            let plan = plan(&map, &curve);
            let bends = plan.bends();
            for [mean, deviation] in [[0.31, 0.05], [-0.4, 0.3], [0.7, 0.5], [1.2, 0.2], [0.31, 0.0]] {
                for lambda in [0.0, 0.4, 5.0, 100.0, 1e4] {
                    let truth = plan.truth(&bends, mean, deviation, lambda);
                    let found = plan.color(&bends, mean, deviation, lambda);
                    let apart = found.iter().zip(truth).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                    assert!(apart < 2e-3, "{curve:?}, {mean}, {deviation}, {lambda}: {apart:e}");
                }
            }
        }
        Ok(())
    }
}
