//! Heights h = g(f) in layers from the top, each of which hides what is below.

use std::sync::OnceLock;

use crate::reference::normal::cumulative;
use crate::reference::texture::PiecewiseLinear;
use crate::transfer::height_transfer::HeightTransfer;

/// The widest cells, in deviations of f, besides what bends cut: of curves that only rise or only fall, and of others,
/// of which cells on several slopes lie at one height.
const WIDEST: [f64; 2] = [0.16, 0.12];

/// By how much the logarithm of the density of f falls over a cell, at most.
const FALL: f64 = 0.6;

/// Beyond this many deviations of f there are 2e-11 of its values.
pub(super) const REACH: f64 = 6.7;

/// What is left where the rest no longer counts.
const LEFT: f64 = 1e-6;

/// The nodes of Gauss's rule of two over 0 to 1.
const NODES: [f64; 2] = [0.211_324_865_405_187_1, 0.788_675_134_594_812_9];

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
    /// The part of its values that the higher node stands for.
    higher: f64,
    /// The colors at the nodes, the lower one first.
    colors: [[f64; 4]; 2],
}

/// The mean color over what is visible of heights of values of the given mean and deviation, for each of some Λ;
/// `bends` rise, and between them map and curve are smooth.
pub(super) fn colors(
    map: &PiecewiseLinear,
    curve: &HeightTransfer,
    bends: &[f64],
    [mean, deviation]: [f64; 2],
    lambdas: &[f64],
) -> Vec<[f64; 4]> {
    if deviation <= 0.0 {
        return vec![map.value(curve.height(mean)); lambdas.len()];
    }
    let mut cells = cells(map, curve, bends, [mean, deviation]);
    cells.sort_by(|a, b| b.height.total_cmp(&a.height));
    let total: f64 = cells.iter().map(|cell| cell.share * cell.mean(cell.steepness)).sum();
    let mut below = 1.0f64;
    let layer = |cell: &Cell| {
        let rest = (below - cell.share).max(0.0);
        let steepness = cell.steepness.map(|steepness| if total > 0.0 { steepness / total } else { 1.0 });
        let relative = cell.mean(steepness);
        let hidden = if relative > 0.0 { relative * (below / rest.max(f64::MIN_POSITIVE)).ln() } else { 0.0 };
        below = rest;
        Layer { rest, steepness, hidden, rise: cell.rise, colors: cell.colors }
    };
    let layers: Vec<Layer> = cells.iter().map(layer).collect();
    lambdas.iter().map(|&lambda| seen(&layers, lambda)).collect()
}

fn cells(map: &PiecewiseLinear, curve: &HeightTransfer, bends: &[f64], [mean, deviation]: [f64; 2]) -> Vec<Cell> {
    let given = ends(curve.is_monotone());
    let mut ends = Vec::with_capacity(given.len() + bends.len());
    let mut inner = bends.iter().map(|at| (at - mean) / deviation).filter(|z| z.abs() < REACH).peekable();
    for &end in given {
        while let Some(z) = inner.next_if(|&z| z < end[0]) {
            ends.push([z, cumulative(z)]);
        }
        ends.push(end);
    }
    let mut last = 0.0;
    let cell = |pair: &[[f64; 2]]| {
        let [[from, _], [to, next]] = [pair[0], pair[1]];
        let share = next - last;
        last = next;
        let at = NODES.map(|part| mean + deviation * (from + part * (to - from)));
        let heights = at.map(|value| curve.height(value));
        let mut colors = heights.map(|height| map.value(height));
        let mut steepness = at.map(|value| curve.slope(value).abs());
        let mut rise = 0.5 * (from * from - to * to);
        if heights[1] < heights[0] {
            colors.reverse();
            steepness.reverse();
            rise = -rise;
        }
        let higher = 1.0 / (1.0 + (-(NODES[1] - NODES[0]) * rise).exp());
        Cell { height: 0.5 * (heights[0] + heights[1]), share, steepness, rise, higher, colors }
    };
    ends.windows(2).map(cell).collect()
}

impl Cell {
    /// The mean of what is known at the nodes, which count as the density does.
    fn mean(&self, [low, high]: [f64; 2]) -> f64 {
        low + self.higher * (high - low)
    }
}

/// A cell below those that hide it.
struct Layer {
    /// How many of all values are lower.
    rest: f64,
    /// |g′|/E|g′| at the nodes, the lower one first.
    steepness: [f64; 2],
    /// How much it hides of what is below, in Λ.
    hidden: f64,
    /// As of its cell.
    rise: f64,
    /// As of its cell.
    colors: [[f64; 4]; 2],
}

/// The mean color of layers from the top.
fn seen(layers: &[Layer], lambda: f64) -> [f64; 4] {
    let (mut hiding, mut seen, mut color) = (0.0, 1.0f64, [0.0; 4]);
    for Layer { rest, steepness: [low, high], hidden, rise, colors } in layers {
        hiding += hidden;
        let left = if seen > LEFT { rest * (-lambda * hiding).exp() } else { 0.0 };
        // Of what is visible of the cell the part at its higher node, where the density is that of f times
        // (1 + Λ |g′|/E|g′|) e^(−ΛX), the first and the last even in their logarithms.
        let higher = if colors[0] == colors[1] {
            0.0
        } else {
            let fall = (-(NODES[1] - NODES[0]) * (rise + lambda * hidden)).exp();
            let (low, high) = (fall * (1.0 + lambda * low), 1.0 + lambda * high);
            high / (low + high)
        };
        for (channel, sum) in color.iter_mut().enumerate() {
            let [low, high] = [colors[0][channel], colors[1][channel]];
            *sum += (seen - left) * (low + higher * (high - low));
        }
        seen = left;
        if seen <= 0.0 {
            break;
        }
    }
    // What rounding leaves below the lowest cell.
    let lowest = layers.last().map_or([0.0; 4], |layer| layer.colors[0]);
    std::array::from_fn(|channel| color[channel] + seen * lowest[channel])
}

/// The ends of cells in deviations of f, with the probabilities below them.
fn ends(monotone: bool) -> &'static [[f64; 2]] {
    static ENDS: OnceLock<[Vec<[f64; 2]>; 2]> = OnceLock::new();
    let [few, many] = ENDS.get_or_init(|| {
        WIDEST.map(|widest| {
            let next = |z: &f64| (*z < REACH).then(|| (z + widest.min(FALL / z)).min(REACH));
            let above: Vec<f64> = std::iter::successors(Some(0.0), next).collect();
            let below = above.iter().skip(1).rev().map(|z| -z);
            below.chain(above.iter().copied()).map(|z| [z, cumulative(z)]).collect()
        })
    });
    if monotone {
        few
    } else {
        many
    }
}
