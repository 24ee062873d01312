//! How fast a node of slopes is hidden, as the parts that it stands for are.

use super::slope_nodes::Node;

/// The Λ at which the share of a node that is hidden is exact.
const EXACT: [f64; 2] = [0.5, 4.0 * 0.5];

/// The spreads that a shader takes.
const SPREADS: [f64; 2] = [0.02, 64.0];

/// The largest rate that is stored: a node that is hidden as fast is gone beside any other, and an infinite one would
/// spoil what is read between its slice and the next.
pub(super) const FASTEST: f64 = 1e4;

/// A node of parts of the surface, each with how fast it is hidden.
pub(super) fn hidden(scale: f64, parts: &[(f64, f64)]) -> Node {
    let weight: f64 = parts.iter().map(|part| part.0).sum();
    if weight <= 1e-12 {
        return Node { scale, weight: 0.0, rate: 1.0, spread: 1.0 };
    }
    // The larger Λ is four times the other.
    let seen = parts.iter().fold([0.0; 2], |[less, more], (share, rate)| {
        let left = (-EXACT[0] * rate).exp();
        [less + share * left, more + share * (left * left) * (left * left)]
    });
    let [less, more] = seen.map(|seen| -(seen / weight).ln().min(0.0));
    // ln(1 + Λ spread) at both Λ are as the logarithms of what is left: their ratio falls from 4 to 1 as spread grows.
    let ratio = |spread: f64| (EXACT[1] * spread).ln_1p() / (EXACT[0] * spread).ln_1p();
    let [mut low, mut high] = SPREADS;
    // To 5e-7 of itself.
    for _ in 0..24 {
        let middle = (low * high).sqrt();
        if ratio(middle) * less > more {
            low = middle;
        } else {
            high = middle;
        }
    }
    let spread = (low * high).sqrt();
    // Where the spread ends, the larger Λ counts.
    let rate = more * spread / (EXACT[1] * spread).ln_1p();
    Node { scale, weight, rate: rate.min(FASTEST), spread }
}
