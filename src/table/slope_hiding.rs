//! How fast a node of slopes is hidden, as the parts that it stands for are.

use super::slope_nodes::Node;

/// The Λ at which the share of a node that is hidden is exact.
const EXACT: [f64; 2] = [0.5, 4.0 * 0.5];

/// The spreads that a shader takes.
const SPREADS: [f64; 2] = [0.02, 64.0];

/// How close ratios of logarithms come, and the most steps to there: seven are seen.
const CLOSE: f64 = 1e-8;
const STEPS: usize = 40;

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
    let spread = spread(more / less);
    // Where the spread ends, the larger Λ counts.
    let rate = more * spread / (EXACT[1] * spread).ln_1p();
    Node { scale, weight, rate: rate.min(FASTEST), spread }
}

/// The spread at which ln(1 + Λ spread) at the two Λ have a ratio, to 2e-7 of itself.
fn spread(ratio: f64) -> f64 {
    // It falls from 4 to 1 as the spread grows, nearly along a line in spread / (1 + spread).
    let above = |spread: f64| (EXACT[1] * spread).ln_1p() / (EXACT[0] * spread).ln_1p() - ratio;
    let [mut low, mut high] = SPREADS.map(|spread| (spread / (1.0 + spread), above(spread)));
    // Written so that what nothing hides, or all, has the least spread.
    if !(low.1 > 0.0) {
        return SPREADS[0];
    }
    if high.1 >= 0.0 {
        return SPREADS[1];
    }
    let (mut found, mut before) = (SPREADS[0], None);
    for _ in 0..STEPS {
        let place = low.0 + (high.0 - low.0) * low.1 / (low.1 - high.1);
        found = place / (1.0 - place);
        let height = above(found);
        if height.abs() < CLOSE {
            break;
        }
        // An end that stays twice counts half, so that the next line ends beyond the root.
        let rises = height > 0.0;
        let part = if before == Some(rises) { 0.5 } else { 1.0 };
        if rises {
            (low, high.1) = ((place, height), part * high.1);
        } else {
            (high, low.1) = ((place, height), part * low.1);
        }
        before = Some(rises);
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spreads_have_their_ratios() {
        for index in 0..=400 {
            let truth = SPREADS[0] * (SPREADS[1] / SPREADS[0]).powf(f64::from(index) / 400.0);
            let ratio = (EXACT[1] * truth).ln_1p() / (EXACT[0] * truth).ln_1p();
            let found = spread(ratio);
            assert!((found / truth - 1.0).abs() < 2e-7, "{truth}: {found}");
        }
        assert_eq!([4.0, f64::INFINITY, f64::NAN, 1.0].map(spread), [0.02, 0.02, 0.02, 64.0]);
    }
}
