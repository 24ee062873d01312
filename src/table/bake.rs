//! Tables of filtered maps: baked from the f64 reference by one quadrature, judged by another.

use super::grid::Axis;
use super::{Format, Level, Sampling, Table};
use crate::reference::texture::{self, PiecewiseLinear};

/// A table of a map's means over an axis of means and an axis of deviations, as halves, with its error as measured over
/// the `judged` means; those beyond the axis read the border.
pub(crate) fn bake(name: &str, map: &PiecewiseLinear, means: Axis, deviations: Axis, judged: (f32, f32)) -> Table {
    let node = |row: usize, column: usize| {
        texture::mean(map, means.value(column as f64), deviations.value(row as f64)).map(half_rounded)
    };
    let texels: Vec<f32> =
        rows(deviations.count, |row| (0..means.count).flat_map(|column| node(row, column)).collect::<Vec<f32>>());
    let error = judge(map, means, deviations, judged, &texels);
    Table {
        name: name.to_owned(),
        format: Format::Rgba16Float,
        sampling: Sampling::Filtered,
        levels: vec![Level { width: means.count as u32, height: deviations.count as u32, depth: 1, texels }],
        error,
    }
}

pub(super) fn half_rounded(value: f64) -> f32 {
    half::f16::from_f64(value).to_f32()
}

/// The smallest deviation that tables are judged at: the shelf's floor.
const FLOOR: f64 = 1e-6;

/// The rows that are all judged.
const DENSE: usize = 32;

/// Parts of the judged means, so that those beyond the axis are judged too.
const EVEN: u32 = 64;

/// The largest difference between a bilinear read and the second quadrature, over the centers of all cells, and the
/// map's knots, where it bends, at every row and between rows, down to the smallest deviation.
fn judge(map: &PiecewiseLinear, means: Axis, deviations: Axis, judged: (f32, f32), texels: &[f32]) -> f32 {
    let error = |mean: f64, deviation: f64| {
        let read = bilinear(texels, means.count, means.number(mean), deviations.number(deviation));
        let truth = texture::mean_by_parts(map, mean, deviation);
        read.iter().zip(truth).map(|(read, truth)| (read - truth).abs()).fold(0.0, f64::max)
    };
    let centers = (0..means.count - 1).map(|column| means.value(column as f64 + 0.5));
    let knots = map.knots.iter().map(|knot| knot.0);
    let (low, high) = (f64::from(judged.0), f64::from(judged.1));
    let even = (0..=EVEN).map(|index| low + (high - low) * f64::from(index) / f64::from(EVEN));
    let all = centers.chain(knots).chain(even);
    let places: Vec<f64> = all.filter(|at| (low..=high).contains(at)).collect();
    // Between all of the lowest rows, where the error is largest, and between some of those above.
    let between = (0..deviations.count - 1).filter(|&row| row < DENSE || row % 8 == 0);
    let between = between.map(|row| deviations.value(row as f64 + 0.5));
    let lines: Vec<f64> =
        [FLOOR, deviations.value(0.0).max(FLOOR), deviations.high].into_iter().chain(between).collect();
    let lines =
        rows(lines.len(), |line| vec![places.iter().map(|&at| error(at, lines[line])).fold(0.0, f64::max) as f32]);
    lines.into_iter().fold(0.0, f32::max)
}

/// What a filtering sampler returns at fractional node numbers.
fn bilinear(texels: &[f32], width: usize, column: f64, row: f64) -> [f64; 4] {
    let rows = texels.len() / (4 * width);
    let (x, y) = (column.floor(), row.floor());
    let (fx, fy) = (column - x, row - y);
    let texel = |x: usize, y: usize, channel: usize| {
        f64::from(texels[4 * (y.min(rows - 1) * width + x.min(width - 1)) + channel])
    };
    let (x, y) = (x as usize, y as usize);
    std::array::from_fn(|channel| {
        let line = |y: usize| (1.0 - fx) * texel(x, y, channel) + fx * texel(x + 1, y, channel);
        (1.0 - fy) * line(y) + fy * line(y + 1)
    })
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
