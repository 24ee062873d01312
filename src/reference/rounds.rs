//! A normal distribution as a sum of narrower ones, by the least largest error of a step, or with those of a kink.

use crate::reference::least::{least, solved};
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

/// The mean of max(at − x, 0) over a normal variable x about 0.
fn below(at: f64, deviation: f64) -> f64 {
    at * cumulative(at / deviation) + deviation * density(at / deviation)
}

/// Errors of steps, and twice those of kinks, of a sum of normal distributions of the deviation `part`: pairs of a
/// place and a weight, and one on the mean with the rest.
fn errors(part: f64, pairs: &[[f64; 2]]) -> Vec<f64> {
    let middle = 1.0 - 2.0 * pairs.iter().map(|pair| pair[1]).sum::<f64>();
    let sum = |of: &dyn Fn(f64) -> f64, at: f64| {
        pairs.iter().map(|[place, weight]| weight * (of(at - place) + of(at + place))).sum::<f64>() + middle * of(at)
    };
    let places = || (0..=PLACES / 2).map(|place| 2.0 * STEP * f64::from(place));
    let steps = places().map(|at| sum(&|from| cumulative(from / part), at) - cumulative(at));
    steps.chain(places().map(|at| 2.0 * (sum(&|from| below(from, part), at) - below(at, 1.0)))).collect()
}

/// Pairs about one on the mean, as [`nearest`], but with the least sum of eighth powers of the errors of steps and of
/// twice those of kinks, in deviations of the whole.
pub fn smoothest<const N: usize>(part: f64, from: Pairs<N>) -> Pairs<N> {
    least(from, |pairs| {
        let (places, weights) = pairs.split_at(N / 2);
        errors(part, &places.iter().zip(weights).map(|(&place, &weight)| [place, weight]).collect::<Vec<_>>())
    })
}

/// Pairs with none on the mean, and the least sum as [`smoothest`]: one place more than there are weights, as the
/// nearest pair has the rest.
pub fn paired<const N: usize>(part: f64, from: [f64; N]) -> [f64; N] {
    least(from, |numbers| {
        let (places, weights) = numbers.split_at(N.div_ceil(2));
        let rest = 0.5 - weights.iter().sum::<f64>();
        let weights = std::iter::once(rest).chain(weights.iter().copied());
        errors(part, &places.iter().zip(weights).map(|(&place, weight)| [place, weight]).collect::<Vec<_>>())
    })
}
