//! Heights h = g(f) in layers from the top, each of which hides what is below.

use std::sync::OnceLock;

use super::hiding::{Hiding, MOST};
use crate::reference::normal::cumulative;
use crate::reference::texture::PiecewiseLinear;
use crate::transfer::height_transfer::HeightTransfer;
use crate::transfer::polynomial::Piece;

/// The widest cells, in deviations of f, besides what bends cut: of curves that only rise or only fall, and of others,
/// of which cells on several slopes lie at one height.
const WIDEST: [f64; 2] = [0.16, 0.12];

/// By how much the logarithm of the density of f falls over a cell, at most: where most values are, and far from there.
const FALLS: [f64; 2] = [0.6, 1.5];

/// Beyond this many deviations of f there are 7e-6 of its values.
const SELDOM: f64 = 4.5;

/// Beyond this many there are 2e-11. Where all else is level, they alone hide.
pub(super) const REACH: f64 = 6.7;

/// What is left where the rest no longer counts.
const LEFT: f64 = 1e-6;

/// The nodes of Gauss's rule of two over 0 to 1, and how far they are apart.
const NODES: [f64; 2] = [0.211_324_865_405_187_1, 0.788_675_134_594_812_9];
const BETWEEN: f64 = NODES[1] - NODES[0];

/// Values of f between two bends, over which the curve is one piece and the map one line.
struct Stretch {
    /// The end of the values.
    to: f64,
    /// The piece of a curve that has such.
    piece: Option<Piece>,
    /// The curve has the slope 0.
    level: bool,
    /// A height of the map's line.
    height: f64,
    /// The color there, and its change with the height.
    line: [[f64; 4]; 2],
}

/// An end of cells.
#[derive(Clone, Copy)]
struct End {
    /// Where it is, in deviations of f.
    at: f64,
    /// How many of all values lie below.
    below: f64,
    /// The density there to the power of how far the nodes of a cell are apart: of two ends the one over the other is
    /// how much it falls between the nodes.
    density: f64,
}

impl End {
    fn new(at: f64) -> Self {
        Self { at, below: cumulative(at), density: (-0.5 * BETWEEN * at * at).exp() }
    }
}

/// A part of the values of f, between two places where nothing bends.
#[derive(Clone, Copy)]
struct Cell {
    /// The mean of its ends' heights.
    height: f64,
    /// How many of all values it holds.
    share: f64,
    /// |g′| at the nodes, the lower one first.
    steepness: [f64; 2],
    /// The part of its density that the lower node has of that of the higher one.
    fall: f64,
    /// The color at the lower node, and by how much that at the higher one differs.
    colors: [[f64; 4]; 2],
}

impl Cell {
    /// The mean of |g′| at the nodes, which count as the density does.
    fn mean(&self) -> f64 {
        let [low, high] = self.steepness;
        low + (high - low) / (1.0 + self.fall)
    }
}

/// A map over the heights that a curve makes, cut where either bends.
pub(super) struct Layers<'a> {
    curve: &'a HeightTransfer,
    /// It never falls.
    rises: bool,
    /// By rising values.
    stretches: Vec<Stretch>,
    /// The ends of cells besides the stretches'.
    ends: &'static [End],
}

impl<'a> Layers<'a> {
    /// `bends` rise, and between them, and from the lowest value that occurs up to the highest, map and curve are
    /// smooth.
    pub(super) fn new(
        map: &PiecewiseLinear,
        curve: &'a HeightTransfer,
        bends: &[f64],
        (low, high): (f64, f64),
    ) -> Self {
        let from = std::iter::once(low).chain(bends.iter().copied());
        let to = bends.iter().copied().chain([high]);
        let stretch = |(from, to): (f64, f64)| {
            let middle = 0.5 * (from + to);
            let pieces = curve.pieces().unwrap_or_default();
            let piece = pieces.iter().find(|piece| middle < piece.to).copied();
            let (height, line) = line(map, curve.height(middle));
            let level = piece.is_some_and(|piece| piece.is_level());
            Stretch { to: if to < high { to } else { f64::INFINITY }, piece, level, height, line }
        };
        let rises = curve.slopes(f64::NEG_INFINITY, f64::INFINITY).0 >= 0.0;
        Self { curve, rises, stretches: from.zip(to).map(stretch).collect(), ends: ends(curve.is_monotone()) }
    }

    /// The mean color over what is visible of heights of values of the given mean and deviation, for each Λ.
    pub(super) fn colors(&self, mean: f64, deviation: f64, hiding: &Hiding) -> Vec<[f64; 4]> {
        if deviation <= 0.0 {
            let stretch = self.stretches.partition_point(|stretch| stretch.to <= mean);
            return vec![self.stretches[stretch].at(self.curve, mean).2; hiding.lambdas().len()];
        }
        let mut cells = self.cells(mean, deviation);
        if !self.rises {
            cells.sort_by(|a, b| a.height.total_cmp(&b.height));
        }
        seen(&cells, hiding)
    }

    fn cells(&self, mean: f64, deviation: f64) -> Vec<Cell> {
        let mut cells = Vec::with_capacity(self.ends.len() + self.stretches.len());
        let [mut from, last] = [self.ends[0], self.ends[self.ends.len() - 1]];
        let mut ends = self.ends[1..].iter().copied().peekable();
        for stretch in &self.stretches {
            let to = (stretch.to - mean) / deviation;
            if to <= from.at {
                continue;
            }
            let to = if to < last.at { End::new(to) } else { last };
            let mut cell = |ends: [End; 2]| cells.push(stretch.cell(self.curve, [mean, deviation], ends));
            while let Some(end) = ends.next_if(|end| end.at < to.at) {
                // What is level is one cell.
                if !stretch.level {
                    cell([from, end]);
                    from = end;
                }
            }
            cell([from, to]);
            from = to;
            if from.at >= last.at {
                break;
            }
        }
        cells
    }
}

/// A height and a color of the map's line about another height, and the change of color with the height.
fn line(map: &PiecewiseLinear, height: f64) -> (f64, [[f64; 4]; 2]) {
    let next = map.knots.partition_point(|knot| knot.0 <= height);
    match (next.checked_sub(1).map(|last| map.knots[last]), map.knots.get(next)) {
        (Some((from, _, color)), Some((to, end, _))) => {
            let change = std::array::from_fn(|channel| (end[channel] - color[channel]) / (to - from));
            (from, [color, change])
        }
        _ => (height, [map.value(height), [0.0; 4]]),
    }
}

impl Stretch {
    /// Height, slope and color at a value.
    fn at(&self, curve: &HeightTransfer, value: f64) -> (f64, f64, [f64; 4]) {
        let (height, slope) = match &self.piece {
            Some(piece) => piece.at(value),
            None => (curve.height(value), curve.slope(value)),
        };
        let above = height - self.height;
        let [color, change] = self.line;
        (height, slope, std::array::from_fn(|channel| color[channel] + above * change[channel]))
    }

    /// The cell between two ends within it.
    fn cell(&self, curve: &HeightTransfer, [mean, deviation]: [f64; 2], [from, to]: [End; 2]) -> Cell {
        let at = NODES.map(|part| self.at(curve, mean + deviation * (from.at + part * (to.at - from.at))));
        let ([mut low, mut high], mut fall) = (at, from.density / to.density);
        if high.0 < low.0 {
            (low, high) = (high, low);
            fall = to.density / from.density;
        }
        let more = std::array::from_fn(|channel| high.2[channel] - low.2[channel]);
        Cell {
            height: 0.5 * (low.0 + high.0),
            share: to.below - from.below,
            steepness: [low.1.abs(), high.1.abs()],
            fall,
            colors: [low.2, more],
        }
    }
}

/// The mean colors of cells, of which the last is on top.
fn seen(cells: &[Cell], hiding: &Hiding) -> Vec<[f64; 4]> {
    let total: f64 = cells.iter().map(|cell| cell.share * cell.mean()).sum();
    // Colors are summed up less that of the lowest cell, so that a channel that is the same everywhere costs nothing;
    // by channels, so that the Λ of each stand next to each other.
    let lowest = cells.first().map_or([0.0; 4], |cell| cell.colors[0]);
    let (mut sums, mut seen) = ([[0.0; MOST]; 4], [1.0f64; MOST]);
    let (mut below, mut depth, mut count) = (1.0f64, 0.0, hiding.lambdas().len());
    for cell in cells.iter().rev() {
        let rest = (below - cell.share).max(0.0);
        let relative = |steepness: f64| if total > 0.0 { steepness / total } else { 1.0 };
        let mean = relative(cell.mean());
        let hidden = if mean > 0.0 { mean * (below / rest.max(f64::MIN_POSITIVE)).ln() } else { 0.0 };
        (below, depth) = (rest, depth + hidden);
        let mut shares = [0.0; MOST];
        let left = hiding.left(depth, count);
        for index in 0..count {
            let left = if seen[index] > LEFT { rest * left[index] } else { 0.0 };
            shares[index] = seen[index] - left;
            seen[index] = left;
        }
        let [color, more] = cell.colors;
        add(&mut sums, std::array::from_fn(|channel| color[channel] - lowest[channel]), &shares[..count]);
        if more != [0.0; 4] {
            // Of what is visible of the cell the part at its higher node, where the density is that of f times
            // (1 + Λ |g′|/E|g′|) e^(−ΛX), the first and the last even in their logarithms.
            let [low, high] = cell.steepness.map(relative);
            let falls = hiding.left(BETWEEN * hidden, count);
            for index in 0..count {
                let lambda = hiding.lambdas()[index];
                let [low, high] = [cell.fall * falls[index] * (1.0 + lambda * low), 1.0 + lambda * high];
                shares[index] *= high / (low + high);
            }
            add(&mut sums, more, &shares[..count]);
        }
        // As Λ rises, less is left.
        while count > 0 && seen[count - 1] <= 0.0 {
            count -= 1;
        }
        if count == 0 {
            break;
        }
    }
    let color = |index: usize| std::array::from_fn(|channel| lowest[channel] + sums[channel][index]);
    (0..hiding.lambdas().len()).map(color).collect()
}

/// Adds shares of a color.
fn add(sums: &mut [[f64; MOST]; 4], color: [f64; 4], shares: &[f64]) {
    for (sums, channel) in sums.iter_mut().zip(color).filter(|(_, channel)| *channel != 0.0) {
        sums.iter_mut().zip(shares).for_each(|(sum, share)| *sum += share * channel);
    }
}

/// The ends of cells where nothing bends.
fn ends(monotone: bool) -> &'static [End] {
    static ENDS: OnceLock<[Vec<End>; 2]> = OnceLock::new();
    let [few, many] = ENDS.get_or_init(|| {
        WIDEST.map(|widest| {
            let [near, far] = FALLS;
            let fall = |z: f64| if z < SELDOM { near } else { far };
            let next = |&z: &f64| (z < REACH).then(|| (z + widest.min(fall(z) / z)).min(REACH));
            let above: Vec<f64> = std::iter::successors(Some(0.0), next).collect();
            let below = above.iter().skip(1).rev().map(|z| -z);
            below.chain(above.iter().copied()).map(End::new).collect()
        })
    });
    if monotone {
        few
    } else {
        many
    }
}
