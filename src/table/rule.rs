//! Gauss's quadrature rule of weighted values: the few nodes whose weighted powers sum up as those of all values do, up
//! to the power 2 n − 1.

/// Values within this part of their size of each other count as one.
const SAME: f64 = 1e-9;

/// The weights of the rules of Gauss and Hermite, of 1 to 4 nodes: those of values that are nearly one.
///
/// Source: Abramowitz and Stegun 1964, "Handbook of Mathematical Functions", table 25.10, over √π.
const NORMAL: [&[f64]; 4] = [
    &[1.0],
    &[0.5, 0.5],
    &[1.0 / 6.0, 2.0 / 3.0, 1.0 / 6.0],
    &[0.045_875_854_768, 0.454_124_145_232, 0.454_124_145_232, 0.045_875_854_768],
];

/// The nodes, rising, with their weights, which sum to 1: `count` of them, from 1 to 4, of which those that the values
/// do not determine have the weight 0.
pub(super) fn rule(values: &[(f64, f64)], count: usize) -> Vec<[f64; 2]> {
    let whole: f64 = values.iter().map(|value| value.1).sum();
    let mean = values.iter().map(|(value, weight)| value * weight).sum::<f64>() / whole;
    let variance = values.iter().map(|(value, weight)| weight * (value - mean).powi(2)).sum::<f64>() / whole;
    let deviation = variance.sqrt();
    if !(deviation > SAME * mean.abs()) {
        return NORMAL[count - 1].iter().map(|&weight| [mean, weight]).collect();
    }
    let standard: Vec<(f64, f64)> =
        values.iter().map(|(value, weight)| ((value - mean) / deviation, weight / whole)).collect();
    let recurrence = recurrence(&standard, count);
    let roots = roots(&recurrence);
    let mut nodes: Vec<[f64; 2]> =
        roots.iter().map(|&root| [mean + deviation * root, weight(&recurrence, root)]).collect();
    let last = nodes.last().map_or(mean, |node| node[0]);
    nodes.resize(count, [last, 0.0]);
    nodes
}

/// The coefficients a and b of the orthogonal polynomials p′ = (x − a) p − b p″, each from the two before it, by
/// Stieltjes' procedure; fewer than `count` of as few values.
fn recurrence(values: &[(f64, f64)], count: usize) -> Vec<[f64; 2]> {
    let mut polynomials: Vec<[f64; 2]> = vec![[0.0, 1.0]; values.len()];
    let (mut before, mut coefficients) = (1.0, Vec::with_capacity(count));
    for order in 0..count {
        let square: f64 = polynomials.iter().zip(values).map(|(p, value)| value.1 * p[1] * p[1]).sum();
        if square < 1e-13 * before {
            break;
        }
        let moment: f64 = polynomials.iter().zip(values).map(|(p, value)| value.1 * value.0 * p[1] * p[1]).sum();
        let [a, b] = [moment / square, if order == 0 { 0.0 } else { square / before }];
        coefficients.push([a, b]);
        before = square;
        for (p, value) in polynomials.iter_mut().zip(values) {
            *p = [p[1], (value.0 - a) * p[1] - b * p[0]];
        }
    }
    coefficients
}

/// The last polynomial at a place.
fn last(recurrence: &[[f64; 2]], x: f64) -> f64 {
    recurrence.iter().fold([0.0, 1.0], |[before, p], [a, b]| [p, (x - a) * p - b * before])[1]
}

/// The roots of the last polynomial: one between each two neighbors of those of the polynomial before it.
fn roots(recurrence: &[[f64; 2]]) -> Vec<f64> {
    // Gershgorin's circles of Jacobi's matrix hold them all.
    let reach = recurrence.iter().map(|[a, b]| a.abs() + 2.0 * b.sqrt()).fold(1.0, f64::max);
    let mut found: Vec<f64> = Vec::new();
    for order in 1..=recurrence.len() {
        let ends: Vec<f64> = [-2.0 * reach].into_iter().chain(found).chain([2.0 * reach]).collect();
        let root = |pair: &[f64]| {
            let (mut low, mut high) = (pair[0], pair[1]);
            let falling = last(&recurrence[..order], low) > 0.0;
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if (last(&recurrence[..order], middle) > 0.0) == falling {
                    low = middle;
                } else {
                    high = middle;
                }
            }
            0.5 * (low + high)
        };
        found = ends.windows(2).map(root).collect();
    }
    found
}

/// The weight of a node: the reciprocal of the sum of the squares there of all polynomials of norm 1.
fn weight(recurrence: &[[f64; 2]], x: f64) -> f64 {
    let (mut sum, mut norm, mut p) = (0.0, 1.0, [0.0, 1.0]);
    for (order, [a, b]) in recurrence.iter().enumerate() {
        norm *= if order == 0 { 1.0 } else { *b };
        sum += p[1] * p[1] / norm;
        p = [p[1], (x - a) * p[1] - b * p[0]];
    }
    1.0 / sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_sum_up_as_those_of_all_values() {
        let values: Vec<(f64, f64)> = (0..40).map(|k| (0.1 * f64::from(k * k % 23), 0.3 + f64::from(k % 7))).collect();
        let whole: f64 = values.iter().map(|value| value.1).sum();
        for count in 1..=4 {
            let nodes = rule(&values, count);
            for power in 0..2 * count as i32 {
                let truth = values.iter().map(|(value, weight)| value.powi(power) * weight).sum::<f64>() / whole;
                let found: f64 = nodes.iter().map(|[node, weight]| node.powi(power) * weight).sum();
                assert!((found - truth).abs() < 1e-10 * (1.0 + truth), "{count}, {power}: {found} {truth}");
            }
            assert!(nodes.windows(2).all(|pair| pair[0][0] < pair[1][0]) && nodes.iter().all(|node| node[1] > 0.0));
        }
    }

    #[test]
    fn few_values_are_their_own_nodes() {
        let nodes = rule(&[(2.0, 1.0), (-1.0, 2.0), (2.0, 1.0)], 4);
        for (found, expected) in nodes.iter().zip([[-1.0, 0.5], [2.0, 0.5], [2.0, 0.0], [2.0, 0.0]]) {
            assert!((found[0] - expected[0]).abs() < 1e-9 && (found[1] - expected[1]).abs() < 1e-9, "{nodes:?}");
        }
        // Nearly one value: nodes as of a narrow normal distribution, on one place.
        assert_eq!(rule(&[(0.7, 0.4), (0.7, 0.6)], 2), [[0.7, 0.5], [0.7, 0.5]]);
    }
}
