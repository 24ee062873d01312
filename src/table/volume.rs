//! Tables of a map's means over visible heights: a slice a skewness, baked from tabulated distributions and judged by
//! quadrature.

use std::sync::OnceLock;

use super::bake::{half_rounded, rows};
use super::grid::{Axis, Spacing};
use super::strip::Strip;
use super::{Format, Level, Sampling, Table};
use crate::reference::height;
use crate::reference::heights::lambda_of_skewness;
use crate::reference::texture::PiecewiseLinear;

/// Slices, even in the skewness up to that of a Λ of 1e4: they stand in `wgsl/filter/height.wgsl` too.
const SKEWNESSES: Axis = Axis { low: 0.0, high: 0.862467, count: 4, spacing: Spacing::Linear };

/// The visible heights of each slice and of each middle between two, which are the same for every map.
fn strips() -> &'static [Strip] {
    static STRIPS: OnceLock<Vec<Strip>> = OnceLock::new();
    STRIPS.get_or_init(|| {
        let halves = 0..2 * SKEWNESSES.count - 1;
        halves.map(|half| Strip::new(lambda_of_skewness(SKEWNESSES.value(0.5 * half as f64)))).collect()
    })
}

/// A table of a map's means over visible heights, as halves, with its error as measured for deviations of all heights
/// from `floor` on.
pub(crate) fn bake(name: &str, map: &PiecewiseLinear, means: Axis, deviations: Axis, floor: f64) -> Table {
    let slice = |strip: &Strip| {
        rows(deviations.count, |row| {
            let deviation = deviations.value(row as f64);
            let texel = |column: usize| strip.color(map, means.value(column as f64), deviation).map(half_rounded);
            (0..means.count).flat_map(texel).collect()
        })
    };
    let texels: Vec<f32> = strips().iter().step_by(2).flat_map(slice).collect();
    let judged = strips().iter().take(1).chain(strips().iter().skip(1).step_by(2));
    let axes = [means, deviations, SKEWNESSES];
    let error = judged.map(|strip| judge(map, axes, floor, &texels, strip)).fold(0.0, f32::max);
    let [width, height, depth] = axes.map(|axis| axis.count as u32);
    Table {
        name: name.to_owned(),
        format: Format::Rgba16Float,
        sampling: Sampling::Filtered,
        levels: vec![Level { width, height, depth, texels }],
        error,
    }
}

/// The largest difference between a trilinear read and the mean, for the skewness of one distribution: on the last row,
/// between rows and at the smallest deviation, over the centers of all cells of means and the map's knots, where it
/// bends. The quadrature has the last word on the worst place of each line.
fn judge(map: &PiecewiseLinear, axes: [Axis; 3], floor: f64, texels: &[f32], strip: &Strip) -> f32 {
    let [means, deviations, _] = axes;
    let centers = (0..means.count - 1).map(|column| means.value(column as f64 + 0.5));
    let places: Vec<f64> = centers.chain(map.knots.iter().map(|knot| knot.0)).collect();
    let least = floor * strip.deviation;
    let between = (0..deviations.count - 1).map(|row| deviations.value(row as f64 + 0.5));
    let lines: Vec<f64> = between.filter(|&line| line > least).chain([least, deviations.high]).collect();
    let error = |at: f64, line: f64, truth: [f64; 4]| {
        let read = trilinear(texels, axes, [at, line, strip.skewness]);
        read.iter().zip(truth).map(|(read, truth)| (read - truth).abs()).fold(0.0, f64::max)
    };
    let worst = |line: usize| {
        let line = lines[line];
        let errors = places.iter().map(|&at| (error(at, line, strip.color(map, at, line)), at));
        let (_, at) = errors.fold((0.0, means.low), |worst, next| if next.0 > worst.0 { next } else { worst });
        let scale = line / strip.deviation;
        let truth = height::mean_by_parts(map, at - scale * strip.mean, scale, strip.lambda);
        vec![error(at, line, truth) as f32]
    };
    rows(lines.len(), worst).into_iter().fold(0.0, f32::max)
}

/// What a filtering sampler returns at a mean, a deviation and a skewness.
fn trilinear(texels: &[f32], axes: [Axis; 3], at: [f64; 3]) -> [f64; 4] {
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
