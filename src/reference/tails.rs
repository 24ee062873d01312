//! Visible heights by the logarithms of their mean excess: the polynomials nearest to them in the mean square.

use super::heights::{cumulative, moments, range};
use super::quadrature::integrate;

/// Panels over the range of visible heights.
const PANELS: f64 = 16.0;

/// The spacing and the number of the deviations at which tails are compared.
const SPACING: f64 = 0.125;
const COMPARED: usize = 32;

/// The reciprocal of the given deviation, the mean excess over the mean, and for the thresholds above it, then below
/// it, the four coefficients of the polynomial p of the distance x in deviations, from x on, for which peak · 2^−p(x)
/// is nearest to the mean excess, or to what falls short, in the mean square.
pub fn nearest_tails(deviation: f64, lambda: f64) -> [f64; 10] {
    let [mean, own, ..] = moments(lambda);
    tails(deviation, [mean, own], range(lambda), |height| cumulative(height, lambda))
}

/// The same of polynomials with three coefficients.
pub fn nearest_short_tails(deviation: f64, lambda: f64) -> [f64; 8] {
    let [mean, own, ..] = moments(lambda);
    let [above, below] = excesses([mean, own], range(lambda), |height| cumulative(height, lambda));
    let mut all = [0.0; 8];
    all[0] = 1.0 / deviation;
    all[1] = deviation * above[0];
    all[2..5].copy_from_slice(&coefficients::<3>(&above));
    all[5..].copy_from_slice(&coefficients::<3>(&below));
    all
}

/// [`nearest_tails`] of any distribution with a mean, a deviation and ends.
pub(super) fn tails(deviation: f64, spread: [f64; 2], ends: [f64; 2], cumulative: impl Fn(f64) -> f64) -> [f64; 10] {
    let [above, below] = excesses(spread, ends, cumulative);
    let mut all = [0.0; 10];
    all[0] = 1.0 / deviation;
    all[1] = deviation * above[0];
    all[2..6].copy_from_slice(&coefficients::<4>(&above));
    all[6..].copy_from_slice(&coefficients::<4>(&below));
    all
}

/// The mean excess over thresholds above the mean, and what falls short of those below it, in deviations.
fn excesses([mean, own]: [f64; 2], [from, to]: [f64; 2], cumulative: impl Fn(f64) -> f64) -> [[f64; COMPARED + 1]; 2] {
    let at = |index: usize| own * SPACING * index as f64;
    let area = |low: f64, high: f64, share: fn(f64) -> f64| {
        let [area] = integrate(low, high, (to - from) / PANELS, |height| [share(cumulative(height))]);
        area / own
    };
    let above = sums(|index| {
        area(mean + at(index), if index < COMPARED { mean + at(index + 1) } else { to }, |below| 1.0 - below)
    });
    let below =
        sums(|index| area(if index < COMPARED { mean - at(index + 1) } else { from }, mean - at(index), |below| below));
    [above, below]
}

/// The sums of what lies from each compared deviation to the next, and behind the last.
fn sums(part: impl Fn(usize) -> f64) -> [f64; COMPARED + 1] {
    let mut sums = [0.0; COMPARED + 1];
    let mut sum = 0.0;
    for index in (0..=COMPARED).rev() {
        sum += part(index);
        sums[index] = sum;
    }
    sums
}

/// The polynomial of degree N without a constant that is nearest to the bits that an excess loses from its first value
/// on: by the normal equations, weighted so that the excess is what is compared.
fn coefficients<const N: usize>(excess: &[f64; COMPARED + 1]) -> [f64; N] {
    let mut rows = [([0.0; N], 0.0); N];
    for (index, value) in excess.iter().enumerate().skip(1).filter(|(_, value)| **value > 0.0) {
        let x = SPACING * index as f64;
        let powers: [f64; N] = std::array::from_fn(|power| x.powi(power as i32 + 1));
        let weight = value * value;
        for ((row, sum), power) in rows.iter_mut().zip(powers) {
            row.iter_mut().zip(powers).for_each(|(sum, other)| *sum += weight * power * other);
            *sum += weight * power * (excess[0] / value).log2();
        }
    }
    for pivot in 0..N {
        let (mut own, mut sum) = rows[pivot];
        let size = own[pivot];
        own.iter_mut().chain([&mut sum]).for_each(|value| *value /= size);
        for (_, (row, total)) in rows.iter_mut().enumerate().filter(|(number, _)| *number != pivot) {
            let factor = row[pivot];
            row.iter_mut().zip(own).for_each(|(value, pivot)| *value -= factor * pivot);
            *total -= factor * sum;
        }
        rows[pivot] = (own, sum);
    }
    rows.map(|(_, sum)| sum)
}
