//! How far steps over the slopes in sight of a transferred surface are, by nodes, from those by all its parts.

use super::lattice::Lattice;
use super::normal;
use super::slope_nodes::{ends, Node, Nodes, FOLLOWS, SLICES};
use super::threads::rows;
use crate::reference::slope_nodes::{Ends, Part, Transferred};

/// Degrees of the views from the normal.
const VIEWS: [f64; 4] = [0.0, 45.0, 75.0, 85.0];

/// The deviation of the slopes of h where they are steepest: with the views they have visibility parameters from 0.17.
const DEVIATION: f64 = 0.5;

/// Edges on each side of the slope 0, even in their logarithm from the first, in that deviation.
const EDGES: usize = 14;
const FIRST: f64 = 0.004;
const LAST: f64 = 3.0;

/// Parts of no larger share count for nothing.
const NOTHING: f64 = 1e-8;

/// Shares of the surface with their scales.
type Shares = Vec<(f64, f64)>;

/// Columns and rows between which a table is judged: one in so many.
const JUDGED: [usize; 2] = [3, 4];

/// The largest step error between the texels.
pub(super) fn error(nodes: Nodes<'_>, lattice: Lattice, texels: &[f32]) -> f32 {
    let Lattice([means, deviations, _]) = lattice;
    let few = Ends::even(1);
    let square = |row: usize| {
        let deviation = deviations.value(row as f64);
        let of = |column: usize| nodes.between(&few, means.value(column as f64), deviation);
        let squares = (0..means.count).map(|column| of(column).average(|part| part.scale * part.scale));
        vec![squares.fold(0.0, f64::max) as f32]
    };
    let steepest = f64::from(rows(deviations.count, square).into_iter().fold(0.0, f32::max)).sqrt();
    let column = means.value(1.0) - means.value(0.0);
    let halves = (1..2 * deviations.count - 1).rev().map(|half| deviations.value(0.5 * half as f64));
    let lines: Vec<f64> = halves.filter(|&deviation| deviation >= column).step_by(JUDGED[1]).chain([column]).collect();
    let worst = |line: usize| {
        let columns = (line % JUDGED[0]..means.count - 1).step_by(JUDGED[0]).map(|cell| means.value(cell as f64 + 0.5));
        let errors = columns.map(|mean| {
            let slices: [[f64; 4]; SLICES] =
                std::array::from_fn(|slice| lattice.filtered(texels, [mean, lines[line], slice as f64]));
            let [scales, weights, rates, spreads] = slices;
            let read = std::array::from_fn(|node| Node {
                scale: scales[node],
                weight: weights[node],
                rate: rates[node],
                spread: spreads[node],
            });
            step_error(&nodes.between(ends(), mean, lines[line]), &read, steepest)
        });
        vec![errors.fold(0.0, f64::max) as f32]
    };
    rows(lines.len(), worst).into_iter().fold(0.0, f32::max)
}

/// The largest difference over all views and edges between nodes and parts, `steepest` being the root of the mean g′²
/// where that is largest.
pub(super) fn step_error(surface: &Transferred, nodes: &[Node; 4], steepest: f64) -> f64 {
    let deviation = DEVIATION / steepest.max(1e-12);
    let side = (0..EDGES).map(|edge| FIRST * (LAST / FIRST).powf(edge as f64 / (EDGES - 1) as f64));
    let edges: Vec<f64> = side.map(|edge| DEVIATION * edge).collect();
    let counts = |(part, _): &(&Part, f64)| part.share > NOTHING;
    let (counted, rates): (Vec<&Part>, Vec<f64>) =
        surface.parts.iter().zip(surface.rates(FOLLOWS)).filter(counts).unzip();
    let parts: Shares = counted.iter().map(|part| (deviation * part.scale.abs(), part.share)).collect();
    let few: Shares = nodes.iter().map(|node| (deviation * node.scale.abs(), node.weight)).collect();
    let truth = below(&parts, &edges, |lambda, part| (-lambda * rates[part]).exp());
    let found = below(&few, &edges, |lambda, node| {
        let Node { rate, spread, .. } = nodes[node];
        (-rate / spread * (lambda * spread).ln_1p()).exp()
    });
    truth.iter().zip(found).map(|(truth, found)| (truth - found).abs()).fold(0.0, f64::max)
}

/// The shares in sight below each edge on either side of 0, for each view.
fn below(shares: &Shares, edges: &[f64], seen: impl Fn(f64, usize) -> f64) -> Vec<f64> {
    let ends = |deviation: f64, edge: f64| normal::below(edge / deviation.max(1e-12));
    // Of each share the probability below an edge, and its density there in deviations.
    let of_share = |edge: f64| {
        shares.iter().map(move |share| {
            let [probability, density] = ends(share.0, edge);
            [probability, share.0 * density]
        })
    };
    let known: Vec<Vec<[f64; 2]>> = edges.iter().map(|&edge| of_share(edge).collect()).collect();
    let view = |degrees: f64| {
        let (sin, cos) = libm::sincos(degrees.to_radians());
        // E[max(t, 0)] of t = cos − sin · slope, over slopes below an edge or below where they face away.
        let horizon = cos / sin.max(1e-12);
        let areas: Vec<f64> = of_share(horizon).map(|[below, density]| cos * below + sin * density).collect();
        let whole: f64 = shares.iter().zip(&areas).map(|(share, area)| share.1 * area).sum();
        let lambda = (whole / (cos * shares.iter().map(|share| share.1).sum::<f64>()) - 1.0).max(0.0);
        let weights: Vec<f64> = shares.iter().enumerate().map(|(index, share)| share.1 * seen(lambda, index)).collect();
        let weight: f64 = weights.iter().sum();
        let all: f64 = weights.iter().zip(&areas).map(|(weight, area)| weight * area).sum();
        let below = |(known, &edge): (&Vec<[f64; 2]>, &f64)| {
            let sum = |[below, dense]: [f64; 2], (weight, [probability, density]): (&f64, &[f64; 2])| {
                [below + weight * probability, dense + weight * density]
            };
            let [below, density] = weights.iter().zip(known).fold([0.0; 2], sum);
            let [lower, upper] = [weight - below, below].map(|below| cos * below + sin * density);
            [lower / all, if edge < horizon { upper / all } else { 1.0 }]
        };
        known.iter().zip(edges).flat_map(below).collect::<Vec<_>>()
    };
    VIEWS.into_iter().flat_map(view).collect()
}
