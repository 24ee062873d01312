//! Means over normal variables of functions that are linear between nodes and constant beyond: the weights of the
//! nodes, and sums of rows of colors by them.

use super::normal::excess;

/// Beyond this many deviations lies less than 6e-7 of a distribution.
const FAR: f64 = 5.0;

/// The nodes of a function, which rise.
pub(super) struct Hats<'a>(pub &'a [f64]);

/// Weights of nodes that follow each other.
pub(super) struct Weights {
    /// The first node that has one.
    pub first: usize,
    /// The weights.
    pub weights: Vec<f32>,
}

impl Hats<'_> {
    /// The weights of the nodes in the mean over a normal variable.
    ///
    /// The mean of the ramp from 0 at a node to 1 at the next is the difference of the means of max(v − x, 0) at both,
    /// over their distance; a node's hat is the difference of the ramps on its sides.
    fn weights(&self, mean: f64, deviation: f64) -> Weights {
        let (nodes, reach) = (self.0, FAR * deviation);
        let first = nodes.partition_point(|&node| node <= mean - reach).saturating_sub(1);
        let last = nodes.partition_point(|&node| node < mean + reach).min(nodes.len() - 1);
        let (mut left, mut above) = (1.0, mean_above(mean - nodes[first], deviation));
        let weight = |node: usize| {
            let mut right = 0.0;
            if node < last {
                let next = mean_above(mean - nodes[node + 1], deviation);
                right = (above - next) / (nodes[node + 1] - nodes[node]);
                above = next;
            }
            let weight = left - right;
            left = right;
            weight as f32
        };
        Weights { first, weights: (first..=last).map(weight).collect() }
    }

    /// The weights in the means at some places.
    pub(super) fn all(&self, means: &[f64], deviation: f64) -> Vec<Weights> {
        means.iter().map(|&mean| self.weights(mean, deviation)).collect()
    }

    /// The same by a variance of less for each place, where there is so much.
    pub(super) fn narrowed(&self, means: &[f64], variance: f64, less: &[f64]) -> Vec<Weights> {
        let weights = |(&mean, less): (&f64, &f64)| self.weights(mean, (variance - less).max(0.0).sqrt());
        means.iter().zip(less).map(weights).collect()
    }
}

/// The mean of max(v − node, 0) over a normal v so far from the node.
fn mean_above(from: f64, deviation: f64) -> f64 {
    from.max(0.0) + deviation * excess(from.abs() / deviation)
}

/// Weighted sums of whole rows of so many numbers.
pub(super) fn of_rows(sums: &[Weights], rows: &[f32], length: usize) -> Vec<f32> {
    let mut all = vec![0.0; sums.len() * length];
    for (sum, total) in sums.iter().zip(all.chunks_exact_mut(length)) {
        let mut rows = rows[sum.first * length..].chunks_exact(length);
        for weights in sum.weights.chunks(4) {
            let taken = [0; 4].map(|_| rows.next());
            match (weights, taken) {
                (&[a, b, c, d], [Some(one), Some(two), Some(three), Some(four)]) => {
                    let numbers = one.iter().zip(two).zip(three.iter().zip(four));
                    for (total, ((one, two), (three, four))) in total.iter_mut().zip(numbers) {
                        *total += (a * one + b * two) + (c * three + d * four);
                    }
                }
                _ => {
                    for (weight, row) in weights.iter().zip(taken.into_iter().flatten()) {
                        total.iter_mut().zip(row).for_each(|(total, number)| *total += weight * number);
                    }
                }
            }
        }
    }
    all
}

/// Weighted sums of the colors within each row of so many numbers, row by row.
pub(super) fn of_colors(sums: &[Weights], rows: &[f32], length: usize, mut color: impl FnMut(usize, usize, [f32; 4])) {
    for (number, row) in rows.chunks_exact(length).enumerate() {
        for (column, sum) in sums.iter().enumerate() {
            // Two sums beside each other wait half as long for their last addition.
            let mut halves = [[0.0f32; 4]; 2];
            let (colors, weights) = (&row[4 * sum.first..], &sum.weights[..]);
            for (weights, two) in weights.chunks_exact(2).zip(colors.chunks_exact(8)) {
                for channel in 0..4 {
                    halves[0][channel] += weights[0] * two[channel];
                    halves[1][channel] += weights[1] * two[4 + channel];
                }
            }
            if let (&[weight], Some(last)) =
                (weights.chunks_exact(2).remainder(), colors.chunks_exact(4).nth(weights.len() - 1))
            {
                (0..4).for_each(|channel| halves[0][channel] += weight * last[channel]);
            }
            color(number, column, std::array::from_fn(|channel| halves[0][channel] + halves[1][channel]));
        }
    }
}
