//! Tables of a map's means over visible heights: a slice a skewness, baked from tabulated distributions and judged by
//! quadrature.

use super::bake::{half_rounded, rows};
use super::grid::Axis;
use super::strip::Strip;
use super::{Format, Level, Sampling, Table};
use crate::reference::height;
use crate::reference::heights::{lambda_of_skewness, moments};
use crate::reference::texture::PiecewiseLinear;

/// The axes of a volume: the mean, the deviation and the skewness of visible heights.
#[derive(Clone, Copy)]
pub(crate) struct Axes {
    pub means: Axis,
    pub deviations: Axis,
    pub skewnesses: Axis,
}

/// A table of a map's means over visible heights, as halves, with its error as measured for deviations of all heights
/// from `floor` on.
pub(crate) fn bake(name: &str, map: &PiecewiseLinear, axes: Axes, floor: f64) -> Table {
    let Axes { means, deviations, skewnesses } = axes;
    let slice = |number: usize| {
        let strip = Strip::new(lambda_of_skewness(skewnesses.value(number as f64)));
        rows(deviations.count, |row| {
            let deviation = deviations.value(row as f64);
            let texel = |column: usize| strip.color(map, means.value(column as f64), deviation).map(half_rounded);
            (0..means.count).flat_map(texel).collect()
        })
    };
    let texels: Vec<f32> = (0..skewnesses.count).flat_map(slice).collect();
    let error = judge(map, axes, floor, &texels);
    let [width, height, depth] = [means, deviations, skewnesses].map(|axis| axis.count as u32);
    Table {
        name: name.to_owned(),
        format: Format::Rgba16Float,
        sampling: Sampling::Filtered,
        levels: vec![Level { width, height, depth, texels }],
        error,
    }
}

/// The largest difference between a trilinear read and the quadrature, over the centers of all cells of means and the
/// map's knots, where it bends: on the first slice and between slices, on the last row, between rows, and at the
/// smallest deviation.
fn judge(map: &PiecewiseLinear, axes: Axes, floor: f64, texels: &[f32]) -> f32 {
    let Axes { means, deviations, skewnesses } = axes;
    let centers = (0..means.count - 1).map(|column| means.value(column as f64 + 0.5));
    let places: Vec<f64> = centers.chain(map.knots.iter().map(|knot| knot.0)).collect();
    let between = (0..skewnesses.count - 1).map(|slice| skewnesses.value(slice as f64 + 0.5));
    let slice = |skewness: f64| {
        let lambda = lambda_of_skewness(skewness);
        let [mean, deviation, skewness, _] = moments(lambda);
        let least = floor * deviation;
        let lines = (0..deviations.count - 1).map(|row| deviations.value(row as f64 + 0.5));
        let lines: Vec<f64> = lines.filter(|&line| line > least).chain([least, deviations.high]).collect();
        let error = |at: f64, line: f64| {
            let scale = line / deviation;
            let read = trilinear(texels, axes, [at, line, skewness]);
            let truth = height::mean_by_parts(map, at - scale * mean, scale, lambda);
            read.iter().zip(truth).map(|(read, truth)| (read - truth).abs()).fold(0.0, f64::max)
        };
        let worst = |line| vec![places.iter().map(|&at| error(at, lines[line])).fold(0.0, f64::max) as f32];
        rows(lines.len(), worst).into_iter().fold(0.0, f32::max)
    };
    [skewnesses.low].into_iter().chain(between).map(slice).fold(0.0, f32::max)
}

/// What a filtering sampler returns at a mean, a deviation and a skewness.
fn trilinear(texels: &[f32], axes: Axes, at: [f64; 3]) -> [f64; 4] {
    let Axes { means, deviations, skewnesses } = axes;
    let numbers = [means.number(at[0]), deviations.number(at[1]), skewnesses.number(at[2])];
    let counts = [means.count, deviations.count, skewnesses.count];
    let mut sum = [0.0; 4];
    for corner in 0..8 {
        let (mut weight, mut index) = (1.0, 0);
        for axis in (0..3).rev() {
            let far = (corner >> axis) & 1;
            let fraction = numbers[axis].fract();
            weight *= if far == 1 { fraction } else { 1.0 - fraction };
            index = index * counts[axis] + (numbers[axis] as usize + far).min(counts[axis] - 1);
        }
        for (channel, total) in sum.iter_mut().enumerate() {
            *total += weight * f64::from(texels[4 * index + channel]);
        }
    }
    sum
}
