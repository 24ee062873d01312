//! Ch: the mean of a color map over the visible heights of a rough surface, by two methods.
//!
//! Heights have a mean and a deviation; the visible ones, in deviations from the mean, are distributed as D_h: equation
//! 15 of Heitz et al. 2014, without the share that is visible.

use super::heights::{cumulative, density, range};
use super::quadrature::integrate;
use super::texture::PiecewiseLinear;

/// Panels over the range of visible heights.
pub(super) const PANELS: f64 = 10.0;

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
