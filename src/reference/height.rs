//! Ch: the mean of a color map over the visible heights of a rough surface, by two methods.
//!
//! Heights have a mean and a deviation; the visible ones, in deviations from the mean, are distributed as D_h: equation
//! 15 of Heitz et al. 2014, without the share that is visible.

use super::heights::{cumulative, density, moments, range};
use super::quadrature::integrate;
use super::texture::PiecewiseLinear;

/// Panels over the range of visible heights.
const PANELS: f64 = 16.0;

/// The mean of the map over the visible heights: the integral of the map times their density, piece by piece.
///
/// `lambda` is the sum of Smith's Λ of view and light. A deviation of 0 gives the map's value at the mean.
pub fn mean(map: &PiecewiseLinear, mean: f64, deviation: f64, lambda: f64) -> [f64; 4] {
    if deviation <= 0.0 {
        return map.value(mean);
    }
    let [low, high] = range(lambda);
    let mut sum = [0.0; 4];
    let standard = |at: f64| ((at - mean) / deviation).clamp(low, high);
    let mut add = |from: f64, to: f64, start: (f64, [f64; 4]), slope: [f64; 4]| {
        let piece: [f64; 4] = integrate(from, to, (high - low) / PANELS, |z| {
            let along = (mean - start.0) + deviation * z;
            let density = density(z, lambda);
            std::array::from_fn(|channel| density * (start.1[channel] + along * slope[channel]))
        });
        for (total, value) in sum.iter_mut().zip(piece) {
            *total += value;
        }
    };
    if let (Some(first), Some(last)) = (map.knots.first(), map.knots.last()) {
        add(low, standard(first.0), (first.0, first.1), [0.0; 4]);
        add(standard(last.0), high, (last.0, last.2), [0.0; 4]);
    }
    for pair in map.knots.windows(2) {
        let [(at, _, right), (next, left, _)] = [pair[0], pair[1]];
        let slope = std::array::from_fn(|channel| (left[channel] - right[channel]) / (next - at));
        add(standard(at), standard(next), (at, right), slope);
    }
    sum
}

/// The same mean by parts: the map's last value minus the integral of the cumulative function over the map's changes.
pub fn mean_by_parts(map: &PiecewiseLinear, mean: f64, deviation: f64, lambda: f64) -> [f64; 4] {
    let below = |at: f64| cumulative((at - mean) / deviation, lambda);
    let ends = range(lambda).map(|end| mean + deviation * end);
    let mut sum = map.knots.last().map_or([0.0; 4], |knot| knot.2);
    for (number, knot) in map.knots.iter().enumerate() {
        let jump = below(knot.0);
        for (channel, total) in sum.iter_mut().enumerate() {
            *total -= (knot.2[channel] - knot.1[channel]) * jump;
        }
        let Some(next) = map.knots.get(number + 1) else { continue };
        let edges = ends.map(|end| end.clamp(knot.0, next.0));
        let [middle] = integrate(edges[0], edges[1], (ends[1] - ends[0]) / PANELS, |at| [below(at)]);
        let area = middle + (next.0 - edges[1]);
        for (channel, total) in sum.iter_mut().enumerate() {
            *total -= (next.1[channel] - knot.2[channel]) * area / (next.0 - knot.0);
        }
    }
    sum
}

/// The spacing and the number of the deviations at which [`nearest_tails`] compares.
const SPACING: f64 = 0.125;
const COMPARED: usize = 32;

/// Visible heights by the logarithms of their mean excess: the reciprocal of the given deviation, the mean excess over
/// the mean, and for the thresholds above it, then below it, the four coefficients of the polynomial p of the distance
/// x in deviations, from x on, for which peak · 2^−p(x) is nearest to the mean excess, or to what falls short, in the
/// mean square.
pub fn nearest_tails(deviation: f64, lambda: f64) -> [f64; 10] {
    let [mean, own, ..] = moments(lambda);
    tails(deviation, [mean, own], range(lambda), |height| cumulative(height, lambda))
}

/// The same of any distribution with a mean, a deviation and ends.
pub(super) fn tails(
    deviation: f64,
    [mean, own]: [f64; 2],
    [from, to]: [f64; 2],
    cumulative: impl Fn(f64) -> f64,
) -> [f64; 10] {
    let at = |index: usize| own * SPACING * index as f64;
    let area = |low: f64, high: f64, share: fn(f64) -> f64| {
        let [area] = integrate(low, high, (to - from) / PANELS, |height| [share(cumulative(height))]);
        area / own
    };
    let above = excesses(|index| {
        area(mean + at(index), if index < COMPARED { mean + at(index + 1) } else { to }, |below| 1.0 - below)
    });
    let below = excesses(|index| {
        area(if index < COMPARED { mean - at(index + 1) } else { from }, mean - at(index), |below| below)
    });
    let mut all = [0.0; 10];
    all[0] = 1.0 / deviation;
    all[1] = deviation * above[0];
    all[2..6].copy_from_slice(&coefficients(&above));
    all[6..].copy_from_slice(&coefficients(&below));
    all
}

/// The sums of what lies from each compared deviation to the next, and behind the last.
fn excesses(part: impl Fn(usize) -> f64) -> [f64; COMPARED + 1] {
    let mut excess = [0.0; COMPARED + 1];
    let mut sum = 0.0;
    for index in (0..=COMPARED).rev() {
        sum += part(index);
        excess[index] = sum;
    }
    excess
}

/// The polynomial of degree 4 without a constant that is nearest to the bits that an excess loses from its first value
/// on: by the normal equations, weighted so that the excess is what is compared.
fn coefficients(excess: &[f64; COMPARED + 1]) -> [f64; 4] {
    let mut rows = [[0.0; 5]; 4];
    for (index, value) in excess.iter().enumerate().skip(1).filter(|(_, value)| **value > 0.0) {
        let x = SPACING * index as f64;
        let powers = [x, x * x, x.powi(3), x.powi(4), (excess[0] / value).log2()];
        for (row, power) in rows.iter_mut().zip(powers) {
            for (sum, other) in row.iter_mut().zip(powers) {
                *sum += value * value * power * other;
            }
        }
    }
    for pivot in 0..4 {
        let own = rows[pivot].map(|value| value / rows[pivot][pivot]);
        for (number, row) in rows.iter_mut().enumerate() {
            let factor = if number == pivot { 0.0 } else { row[pivot] };
            for (value, pivot) in row.iter_mut().zip(own) {
                *value -= factor * pivot;
            }
        }
        rows[pivot] = own;
    }
    rows.map(|row| row[4])
}
