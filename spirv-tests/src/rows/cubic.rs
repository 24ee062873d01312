//! What cubics between two values add to moments over a normal variable, by quadrature.

use super::piece::{piece, polynomial};
use super::Row;

/// Sums over three values with their weights.
fn nodes(x: &[f64]) -> [f64; 4] {
    let each = [0, 1, 2].map(|node| {
        let ([value, slope], part) = (polynomial(&x[6..10], x[node]), x[3 + node]);
        [value, value.powi(2), slope - x[10], (slope - x[10]).powi(2)].map(|result| part * result)
    });
    [0, 1, 2, 3].map(|result| each.iter().map(|node| node[result]).sum())
}

pub(super) fn rows() -> Vec<Row> {
    // Where nodes and moments take turns, and where a piece is out of reach.
    let turns = [[0.5, 0.4], [1.25, 0.1], [-0.5, 0.1], [0.3, 1e-4]];
    let turns = turns.map(|[mean, deviation]| [mean, deviation, 0.3, 0.7, -0.4, 0.9, -0.2, 0.4]);
    vec![Row::new("cubic_nodes", nodes), Row::new("cubic_piece", |x| piece::<3>(x, 1.0)).at(turns)]
}
