//! Tables of a map's means over normal values or over visible heights, baked from tabulated distributions and judged by
//! quadrature.

use std::sync::OnceLock;

use super::grid::{Axis, Spacing};
use super::strip::Strip;
use super::{Format, Level, Sampling, Table};
use crate::reference::height;
use crate::reference::heights::lambda_of_skewness;
use crate::reference::texture::PiecewiseLinear;

/// The slices of a table of heights, even in the skewness up to that of a Λ of 1e4: they stand in
/// `wgsl/filter/height.wgsl` too.
const SLICES: Axis = Axis { low: 0.0, high: 0.862467, count: 4, spacing: Spacing::Linear };

/// The only slice of a table of values, which are normal.
const NORMAL: Axis = Axis { count: 1, ..SLICES };

/// The smallest deviation that tables of values are judged at: the shelf's floor.
const FLOOR: f64 = 1e-6;

/// Parts of the judged means, so that those beyond the axis are judged too.
const EVEN: u32 = 64;

/// A map, the axes of its table, and what the table is judged over.
#[derive(Clone, Copy)]
pub(crate) struct Plan<'a> {
    /// The map.
    pub map: &'a PiecewiseLinear,
    /// The columns.
    pub means: Axis,
    /// The rows.
    pub deviations: Axis,
    /// The means that occur; those beyond the axis read the border.
    pub judged: (f32, f32),
}

/// The distributions of each slice and of each middle between two, which are the same for every map.
fn strips() -> &'static [Strip] {
    static STRIPS: OnceLock<Vec<Strip>> = OnceLock::new();
    STRIPS.get_or_init(|| {
        let halves = 0..2 * SLICES.count - 1;
        halves.map(|half| Strip::new(lambda_of_skewness(SLICES.value(0.5 * half as f64)))).collect()
    })
}

impl Plan<'_> {
    /// A table of means over normal values, with its error as measured.
    pub(crate) fn of_values(self, name: &str) -> Table {
        let normal = &strips()[..1];
        let texels = self.texels(normal);
        let error = self.judge(FLOOR, &texels, NORMAL, &normal[0]);
        self.table(name, texels, 1, error)
    }

    /// A table of means over visible heights, a slice a skewness, with its error as measured for deviations of all
    /// heights from `floor` on.
    pub(crate) fn of_heights(self, name: &str, floor: f64) -> Table {
        let texels = self.texels(strips());
        let judged = strips().iter().take(1).chain(strips().iter().skip(1).step_by(2));
        let error = judged.map(|strip| self.judge(floor, &texels, SLICES, strip)).fold(0.0, f32::max);
        self.table(name, texels, SLICES.count, error)
    }

    fn table(self, name: &str, texels: Vec<f32>, depth: usize, error: f32) -> Table {
        let [width, height, depth] = [self.means.count, self.deviations.count, depth].map(|count| count as u32);
        Table {
            name: name.to_owned(),
            format: Format::Rgba16Float,
            sampling: Sampling::Filtered,
            levels: vec![Level { width, height, depth, texels }],
            error,
        }
    }

    /// The means at the nodes, as halves: a slice for every other distribution.
    fn texels(self, strips: &[Strip]) -> Vec<f32> {
        let slice = |strip: &Strip| {
            rows(self.deviations.count, |row| {
                let deviation = self.deviations.value(row as f64);
                let texel = |column: usize| strip.color(self.map, self.means.value(column as f64), deviation);
                (0..self.means.count).flat_map(|column| texel(column).map(half_rounded)).collect()
            })
        };
        strips.iter().step_by(2).flat_map(slice).collect()
    }

    /// The largest difference between a filtered read and the mean, for one distribution: on the first and the last
    /// row, between rows and at the smallest deviation, over the centers of all cells of means, the map's knots, where
    /// it bends, and even means. The quadrature has the last word on the worst place of each line.
    fn judge(self, floor: f64, texels: &[f32], slices: Axis, strip: &Strip) -> f32 {
        let (low, high) = (f64::from(self.judged.0), f64::from(self.judged.1));
        let centers = (0..self.means.count - 1).map(|column| self.means.value(column as f64 + 0.5));
        let knots = self.map.knots.iter().map(|knot| knot.0);
        let even = (0..=EVEN).map(|index| low + (high - low) * f64::from(index) / f64::from(EVEN));
        let places: Vec<f64> = centers.chain(knots).chain(even).filter(|at| (low..=high).contains(at)).collect();
        let least = floor * strip.deviation;
        let between = (0..self.deviations.count - 1).map(|row| self.deviations.value(row as f64 + 0.5));
        let ends = [least, self.deviations.value(0.0), self.deviations.high];
        let lines: Vec<f64> = between.chain(ends).filter(|&line| line >= least).collect();
        let error = |at: f64, line: f64, truth: [f64; 4]| {
            let read = filtered(texels, [self.means, self.deviations, slices], [at, line, strip.skewness]);
            read.iter().zip(truth).map(|(read, truth)| (read - truth).abs()).fold(0.0, f64::max)
        };
        let worst = |line: usize| {
            let line = lines[line];
            let errors = places.iter().map(|&at| (error(at, line, strip.color(self.map, at, line)), at));
            let (_, at) = errors.fold((0.0, low), |worst, next| if next.0 > worst.0 { next } else { worst });
            let scale = line / strip.deviation;
            let truth = height::mean_by_parts(self.map, at - scale * strip.mean, scale, strip.lambda);
            vec![error(at, line, truth) as f32]
        };
        rows(lines.len(), worst).into_iter().fold(0.0, f32::max)
    }
}

pub(super) fn half_rounded(value: f64) -> f32 {
    half::f16::from_f64(value).to_f32()
}

/// What a filtering sampler returns at a mean, a deviation and a skewness.
pub(super) fn filtered(texels: &[f32], axes: [Axis; 3], at: [f64; 3]) -> [f64; 4] {
    let numbers = [0, 1, 2].map(|axis| axes[axis].number(at[axis]));
    let mut sum = [0.0; 4];
    for corner in 0..8 {
        let (mut weight, mut index) = (1.0, 0);
        for axis in (0..3).rev() {
            let far = (corner >> axis) & 1;
            let fraction = numbers[axis].fract();
            weight *= if far == 1 { fraction } else { 1.0 - fraction };
            index = index * axes[axis].count + (numbers[axis] as usize + far).min(axes[axis].count - 1);
        }
        for (channel, total) in sum.iter_mut().enumerate() {
            *total += weight * f64::from(texels[4 * index + channel]);
        }
    }
    sum
}

/// The results of all rows in order, on as many threads as the machine has.
pub(super) fn rows(count: usize, row: impl Fn(usize) -> Vec<f32> + Sync) -> Vec<f32> {
    let threads = std::thread::available_parallelism().map_or(1, |threads| threads.get()).min(count.max(1));
    let mut results: Vec<Vec<f32>> = vec![Vec::new(); count];
    let share = count.div_ceil(threads).max(1);
    std::thread::scope(|scope| {
        for (first, chunk) in results.chunks_mut(share).enumerate() {
            let row = &row;
            let start = first * share;
            scope.spawn(move || {
                for (offset, result) in chunk.iter_mut().enumerate() {
                    *result = row(start + offset);
                }
            });
        }
    });
    results.concat()
}
