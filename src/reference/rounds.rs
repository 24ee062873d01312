//! A normal distribution as a sum of narrower ones, by the least largest error of a step.

use crate::reference::normal::{cumulative, density};

/// Where errors are looked at: in deviations of the whole, of which they are odd functions.
const STEP: f64 = 0.02;
const PLACES: u32 = 300;

/// Pairs of normal distributions about one on the mean: how far from the mean they stand, then the weight of each.
type Pairs<const N: usize> = [f64; N];

/// The error of the cumulative function at a place, and its derivatives by the places and weights of the pairs.
fn error<const N: usize>(part: f64, pairs: &Pairs<N>, at: f64) -> (f64, [f64; N]) {
    let (half, middle) = (N / 2, cumulative(at / part));
    let (mut error, mut gradient) = (middle - cumulative(at), [0.0; N]);
    for pair in 0..half {
        let [low, high] = [(at + pairs[pair]) / part, (at - pairs[pair]) / part];
        let gain = cumulative(low) + cumulative(high) - 2.0 * middle;
        error += pairs[half + pair] * gain;
        gradient[pair] = pairs[half + pair] * (density(low) - density(high)) / part;
        gradient[half + pair] = gain;
    }
    (error, gradient)
}

/// The places of the largest errors, one of each sign after another.
fn peaks<const N: usize>(part: f64, pairs: &Pairs<N>) -> Vec<(f64, f64)> {
    let mut peaks: Vec<(f64, f64)> = Vec::new();
    for at in (1..=PLACES).map(|place| STEP * f64::from(place)) {
        let next = error(part, pairs, at).0;
        match peaks.last_mut() {
            Some(last) if (last.1 < 0.0) == (next < 0.0) => {
                if next.abs() > last.1.abs() {
                    *last = (at, next);
                }
            }
            _ => peaks.push((at, next)),
        }
    }
    peaks
}

fn largest(peaks: &[(f64, f64)]) -> f64 {
    peaks.iter().map(|peak| peak.1.abs()).fold(0.0, f64::max)
}

/// The solution of a system of equations by elimination, with the right side in the last column; none where it has
/// no single one.
fn solved(mut rows: Vec<Vec<f64>>) -> Option<Vec<f64>> {
    let count = rows.len();
    for column in 0..count {
        let pivot = (column..count).max_by(|&a, &b| rows[a][column].abs().total_cmp(&rows[b][column].abs()))?;
        rows.swap(column, pivot);
        if rows[column][column].abs() < 1e-300 {
            return None;
        }
        let taken = rows[column].clone();
        for (_, row) in rows.iter_mut().enumerate().filter(|(row, _)| *row != column) {
            let share = row[column] / taken[column];
            for (entry, taken) in row.iter_mut().zip(&taken) {
                *entry -= share * taken;
            }
        }
    }
    Some((0..count).map(|row| rows[row][count] / rows[row][row]).collect())
}

/// The sum nearest to a standard normal distribution, of ones with the deviation `part`: one on the mean and half as
/// many pairs as there are numbers. From a sum that is near it, by exchange: errors as large as each other, of
/// alternating signs, at one place more than there are numbers.
pub fn nearest<const N: usize>(part: f64, from: Pairs<N>) -> Pairs<N> {
    let mut pairs = from;
    'exchange: for _ in 0..60 {
        let mut found = peaks(part, &pairs);
        let before = largest(&found);
        // The largest that follow each other.
        while found.len() > N + 1 {
            let [first, last] = [found[0].1.abs(), found[found.len() - 1].1.abs()];
            found.remove(if first < last { 0 } else { found.len() - 1 });
        }
        if found.len() < N + 1 {
            break;
        }
        let row = |&(at, size): &(f64, f64)| {
            let (error, gradient) = error(part, &pairs, at);
            gradient.into_iter().chain([-size.signum(), -error]).collect()
        };
        let Some(change) = solved(found.iter().map(row).collect()) else { break };
        for halvings in 0..12 {
            let share = 0.5f64.powi(halvings);
            let next: Pairs<N> = std::array::from_fn(|number| pairs[number] + share * change[number]);
            if largest(&peaks(part, &next)) < before * (1.0 - 1e-7) {
                pairs = next;
                continue 'exchange;
            }
        }
        break;
    }
    pairs
}
