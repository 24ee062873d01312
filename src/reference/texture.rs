//! C0: the mean of a color map over a normal variable, equation 9 of Heitz et al. 2014, by two methods.

use super::normal::{cumulative, density, REACH};
use super::quadrature::integrate;

/// A piecewise-linear map of one variable to four channels, constant outside its knots.
#[derive(Clone, Debug, PartialEq)]
pub struct PiecewiseLinear {
    /// Position, value on the left and value on the right, by position; the values differ where the map jumps.
    pub knots: Vec<(f64, [f64; 4], [f64; 4])>,
}

impl PiecewiseLinear {
    /// The map's value; at a jump the one on the right.
    pub fn value(&self, at: f64) -> [f64; 4] {
        let next = self.knots.partition_point(|knot| knot.0 <= at);
        match (next.checked_sub(1).map(|last| self.knots[last]), self.knots.get(next)) {
            (None, None) => [0.0; 4],
            (None, Some(first)) => first.1,
            (Some(last), None) => last.2,
            (Some(before), Some(after)) => {
                let fraction = (at - before.0) / (after.0 - before.0);
                std::array::from_fn(|channel| before.2[channel] + fraction * (after.1[channel] - before.2[channel]))
            }
        }
    }
}

/// The mean of the map over a normal variable: the integral of the map times the density, piece by piece.
///
/// A deviation of 0 gives the map's value. Error below 1e-12 of the largest value.
pub fn mean(map: &PiecewiseLinear, mean: f64, deviation: f64) -> [f64; 4] {
    if deviation <= 0.0 {
        return map.value(mean);
    }
    let mut sum = [0.0; 4];
    // In standard units about the mean: positions would lose the digits of a small deviation.
    let standard = |at: f64| ((at - mean) / deviation).clamp(-REACH, REACH);
    let mut add = |from: f64, to: f64, start: (f64, [f64; 4]), slope: [f64; 4]| {
        let piece: [f64; 4] = integrate(from, to, 2.0, |z| {
            let along = (mean - start.0) + deviation * z;
            std::array::from_fn(|channel| density(z) * (start.1[channel] + along * slope[channel]))
        });
        for (total, value) in sum.iter_mut().zip(piece) {
            *total += value;
        }
    };
    if let (Some(first), Some(last)) = (map.knots.first(), map.knots.last()) {
        add(-REACH, standard(first.0), (first.0, first.1), [0.0; 4]);
        add(standard(last.0), REACH, (last.0, last.2), [0.0; 4]);
    }
    for pair in map.knots.windows(2) {
        let [(at, _, right), (next, left, _)] = [pair[0], pair[1]];
        let slope = std::array::from_fn(|channel| (left[channel] - right[channel]) / (next - at));
        add(standard(at), standard(next), (at, right), slope);
    }
    sum
}

/// The same mean by parts: the map's last value minus the integral of the cumulative function over the map's changes.
pub fn mean_by_parts(map: &PiecewiseLinear, mean: f64, deviation: f64) -> [f64; 4] {
    let below = |at: f64| cumulative((at - mean) / deviation);
    let mut sum = map.knots.last().map_or([0.0; 4], |knot| knot.2);
    for (number, knot) in map.knots.iter().enumerate() {
        if knot.1 != knot.2 {
            let jump = below(knot.0);
            for (channel, total) in sum.iter_mut().enumerate() {
                *total -= (knot.2[channel] - knot.1[channel]) * jump;
            }
        }
        let Some(next) = map.knots.get(number + 1).filter(|next| next.0 > knot.0) else { continue };
        // Φ is constant beyond its reach: the panels need to be fine only where it rises.
        let edges = [mean - 9.0 * deviation, mean + 9.0 * deviation].map(|edge| edge.clamp(knot.0, next.0));
        let panel = 0.5 * deviation;
        let [middle] = integrate(edges[0], edges[1], panel, |at| [below(at)]);
        let area = middle + (next.0 - edges[1]);
        for (channel, total) in sum.iter_mut().enumerate() {
            *total -= (next.1[channel] - knot.2[channel]) * area / (next.0 - knot.0);
        }
    }
    sum
}
