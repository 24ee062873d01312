//! Tables of the moments of a height transfer over normal values, baked and judged by two quadratures.

use super::grid::{Axis, Spacing};
use super::lattice::{Lattice, FLAT};
use super::threads::rows;
use super::Table;
use crate::reference::normal::{density, REACH};
use crate::reference::piece::moments;
use crate::reference::quadrature::integrate;
use crate::transfer::height_transfer::HeightTransfer;

/// Columns and rows.
const SIZE: [usize; 2] = [512, 48];

/// A curve, and the values over which its table reaches.
///
/// A row of the table, at the deviation that a noise has over all of the plane, is what the paper calls a preconvolved
/// texture: Heitz et al. 2014, "Filtering Non-Linear Transfer Functions on Surfaces", section 7. It holds deviations in
/// place of second moments, which halves keep and which grow evenly with narrow distributions.
#[derive(Clone, Copy)]
pub(crate) struct Plan<'a> {
    curve: &'a HeightTransfer,
    means: Axis,
    deviations: Axis,
    /// Between which heights and slopes are.
    ranges: [(f64, f64); 2],
    /// What height and slope 0 stand for in the table.
    pub middles: [f64; 2],
    /// What height and slope 1 are above that.
    pub radii: [f64; 2],
}

impl<'a> Plan<'a> {
    /// The plan for means between two ends and deviations up to one.
    pub(crate) fn new(curve: &'a HeightTransfer, (low, high): (f32, f32), deviation: f32) -> Self {
        let [low, high, most] = [low, high, deviation].map(f64::from);
        let means = Axis { low, high, count: SIZE[0], spacing: Spacing::Linear };
        let deviations = Axis { low: 0.0, high: most, count: SIZE[1], spacing: Spacing::SquareRoot };
        // As a shader knows them.
        let middle = |(low, high): (f64, f64)| f64::from((0.5 * (low + high)) as f32);
        let radius = |(low, high): (f64, f64)| f64::from((0.5 * (high - low)).max(1e-30) as f32);
        let ends = [low - REACH * most, high + REACH * most];
        let ranges = [curve.range(ends[0], ends[1]), curve.slopes(ends[0], ends[1])];
        Self { curve, means, deviations, ranges, middles: ranges.map(middle), radii: ranges.map(radius) }
    }

    /// The largest magnitude of a height and of a slope.
    pub(crate) fn largest(&self) -> [f64; 2] {
        self.ranges.map(|(low, high)| low.abs().max(high.abs()))
    }

    /// Mean and deviation of the height and of the slope, in parts of their ranges, with the largest error between
    /// nodes of any of the four.
    pub(crate) fn table(self, name: &str) -> Table {
        let (lattice, bends) = (Lattice([self.means, self.deviations, FLAT]), self.curve.bends());
        let texels = lattice.texels(|_, deviation| {
            let bends = &bends;
            move |mean| self.parts(self.near(bends, mean, deviation))
        });
        let error = self.error(lattice, &bends, &texels);
        lattice.table(name, texels, error)
    }

    /// The largest error: between rows, at the centers of cells and at bends, where [`moments`] has the last word.
    fn error(self, lattice: Lattice, bends: &[f64], texels: &[f32]) -> f32 {
        let Self { means, deviations, curve, .. } = self;
        let centers = (0..means.count - 1).map(|column| means.value(column as f64 + 0.5));
        let within = bends.iter().copied().filter(|bend| (means.low..=means.high).contains(bend));
        let places: Vec<f64> = centers.chain(within).collect();
        let worst = |line: usize| {
            let deviation = deviations.value(line as f64 + 0.5);
            let error = |mean: f64, moments: [f64; 4]| {
                let read = lattice.filtered(texels, [mean, deviation, 0.0]);
                let apart = read.iter().zip(self.parts(moments)).map(|(read, truth)| (read - truth).abs());
                apart.fold(0.0, f64::max)
            };
            let errors = places.iter().map(|&mean| (error(mean, self.near(bends, mean, deviation)), mean));
            let (_, mean) = errors.fold((0.0, means.low), |worst, next| if next.0 > worst.0 { next } else { worst });
            let truth = moments(bends, |value| [curve.height(value), curve.slope(value)], mean, deviation);
            vec![error(mean, truth) as f32]
        };
        rows(deviations.count - 1, worst).into_iter().fold(0.0, f32::max)
    }

    /// Means and deviations in parts of the ranges, from means and variances.
    fn parts(self, [height, variance, slope, spread]: [f64; 4]) -> [f64; 4] {
        let deviation = |variance: f64| variance.max(0.0).sqrt();
        let Self { middles, radii, .. } = self;
        [
            (height - middles[0]) / radii[0],
            deviation(variance) / radii[0],
            (slope - middles[1]) / radii[1],
            deviation(spread) / radii[1],
        ]
    }

    /// The moments, by the rule of Gauss and Legendre between bends.
    fn near(self, bends: &[f64], mean: f64, deviation: f64) -> [f64; 4] {
        let curve = self.curve;
        let center = [curve.height(mean), curve.slope(mean)];
        if deviation <= 0.0 {
            return [center[0], 0.0, center[1], 0.0];
        }
        let [low, high] = [mean - REACH * deviation, mean + REACH * deviation];
        let inner = bends.iter().copied().filter(|&bend| low < bend && bend < high);
        let ends: Vec<f64> = [low].into_iter().chain(inner).chain([high]).collect();
        let mut sum = [0.0; 4];
        for pair in ends.windows(2) {
            let part: [f64; 4] = integrate(pair[0], pair[1], 2.0 * deviation, |value| {
                let weight = density((value - mean) / deviation) / deviation;
                let [height, slope] = [curve.height(value) - center[0], curve.slope(value) - center[1]];
                [height, height * height, slope, slope * slope].map(|result| weight * result)
            });
            for (total, part) in sum.iter_mut().zip(part) {
                *total += part;
            }
        }
        [center[0] + sum[0], sum[1] - sum[0] * sum[0], center[1] + sum[2], sum[3] - sum[2] * sum[2]]
    }
}
