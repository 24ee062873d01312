//! Tables of the moments of a power over normal values: of its two variables only their ratio matters.

use super::{Format, Level, Sampling, Table};
use crate::reference::piece::moments;

/// Nodes, even in the share that the deviation has in |mean| + deviation.
const NODES: usize = 512;

/// Mean and deviation of |f|^exponent with the sign of f, and of its slope, where mean and deviation of f sum up to 1,
/// with the largest error between nodes in parts of the largest of each.
pub(crate) fn table(name: &str, exponent: f64) -> Table {
    let at = |node: f64| -> [f64; 4] {
        let share = node / (NODES - 1) as f64;
        let curve =
            |value: f64| [value.signum() * value.abs().powf(exponent), exponent * value.abs().powf(exponent - 1.0)];
        let [height, variance, slope, spread] = moments(&[0.0], curve, 1.0 - share, share);
        [height, variance.max(0.0).sqrt(), slope, spread.max(0.0).sqrt()]
    };
    let nodes: Vec<[f64; 4]> = (0..NODES).map(|node| at(node as f64)).collect();
    let largest: [f64; 4] = std::array::from_fn(|part| nodes.iter().map(|node| node[part]).fold(0.0, f64::max));
    let error = |pair: (usize, &[[f64; 4]])| {
        let truth = at(pair.0 as f64 + 0.5);
        let apart = |part: usize| (0.5 * (pair.1[0][part] + pair.1[1][part]) - truth[part]).abs() / largest[part];
        (0..4).map(apart).fold(0.0, f64::max)
    };
    let error = nodes.windows(2).enumerate().map(error).fold(0.0, f64::max) as f32;
    let texels = nodes.iter().flatten().map(|&part| part as f32).collect();
    let levels = vec![Level { width: NODES as u32, height: 1, depth: 1, texels }];
    Table { name: name.to_owned(), format: Format::Rgba32Float, sampling: Sampling::Loaded, levels, error }
}
