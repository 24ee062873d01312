//! The visible heights of one Λ, tabulated, so that a table's many means cost little each.

use crate::reference::heights::{cumulative, density, moments, range};
use crate::reference::quadrature::integrate;
use crate::reference::texture::PiecewiseLinear;

/// Steps of the tabulation: the cubic between two nodes is off by less than 1e-9.
const STEPS: usize = 1024;

/// The distribution of visible heights at one Λ, for heights of mean 0 and deviation 1.
pub(crate) struct Strip {
    /// The sum of Smith's Λ of view and light.
    pub lambda: f64,
    /// The mean of the visible heights.
    pub mean: f64,
    /// Their deviation.
    pub deviation: f64,
    /// Their skewness.
    pub skewness: f64,
    low: f64,
    high: f64,
    /// At even steps from `low` to `high`: the density, its integral, and the integral of that.
    nodes: Vec<[f64; 3]>,
}

impl Strip {
    /// The distribution for the sum of Smith's Λ of view and light.
    pub(crate) fn new(lambda: f64) -> Self {
        let [mean, deviation, skewness, _] = moments(lambda);
        let [low, high] = range(lambda);
        let step = (high - low) / STEPS as f64;
        let mut area = 0.0;
        let node = |index: usize| {
            let at = low + step * index as f64;
            let [more] = integrate(at - step, at, step, |height| [cumulative(height, lambda)]);
            area += if index == 0 { 0.0 } else { more };
            [density(at, lambda), cumulative(at, lambda), area]
        };
        Self { lambda, mean, deviation, skewness, low, high, nodes: (0..=STEPS).map(node).collect() }
    }

    /// The mean of a map over visible heights of the given mean and deviation.
    pub(crate) fn color(&self, map: &PiecewiseLinear, mean: f64, deviation: f64) -> [f64; 4] {
        if deviation <= 0.0 {
            return map.value(mean);
        }
        // Those of all heights, of which these are the visible ones.
        let scale = deviation / self.deviation;
        let center = mean - scale * self.mean;
        let mut sum = map.knots.last().map_or([0.0; 4], |knot| knot.2);
        let mut before: Option<(f64, f64, [f64; 4])> = None;
        for knot in &map.knots {
            let at = (knot.0 - center) / scale;
            let [below, area] = self.integrals(at);
            if let Some((start, start_area, from)) = before {
                let share = if at > start { (area - start_area) / (at - start) } else { below };
                subtract(&mut sum, from, knot.1, share);
            }
            subtract(&mut sum, knot.1, knot.2, below);
            before = Some((at, area, knot.2));
        }
        sum
    }

    /// The integral of the density up to a height, and the integral of that.
    fn integrals(&self, height: f64) -> [f64; 2] {
        if height <= self.low {
            return [0.0, 0.0];
        }
        if height >= self.high {
            return [1.0, height - self.mean];
        }
        let step = (self.high - self.low) / STEPS as f64;
        let place = (height - self.low) / step;
        let index = (place as usize).min(STEPS - 1);
        let (from, to, t) = (self.nodes[index], self.nodes[index + 1], place - index as f64);
        // The cubic through both values with both slopes.
        let between = |at: usize| {
            let rise = to[at] - from[at];
            let (start, end) = (step * from[at - 1] - rise, rise - step * to[at - 1]);
            from[at] + t * (rise + (1.0 - t) * ((1.0 - t) * start + t * end))
        };
        [between(1), between(2)]
    }
}

/// Takes the part of a change of colors that lies above the share `below`.
fn subtract(sum: &mut [f64; 4], from: [f64; 4], to: [f64; 4], below: f64) {
    for (channel, total) in sum.iter_mut().enumerate() {
        *total -= (to[channel] - from[channel]) * below;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reference::height;

    /// Against the quadrature of the map times the density.
    #[test]
    fn colors_are_those_of_the_reference() {
        let (black, white) = ([0.0, 0.3, 1.0, 1.0], [1.0, 0.4, 0.0, 1.0]);
        let knots = vec![(0.1, black, black), (0.3, white, black), (0.300_02, black, white), (0.9, white, white)];
        let map = PiecewiseLinear { knots };
        for lambda in [0.0, 0.7, 39.0, 1e4] {
            let strip = Strip::new(lambda);
            for (mean, deviation) in [(0.31, 0.02), (-0.4, 0.3), (0.7, 0.5), (1.4, 0.2), (0.3, 1e-6)] {
                let scale = deviation / strip.deviation;
                let truth = height::mean(&map, mean - scale * strip.mean, scale, lambda);
                let found = strip.color(&map, mean, deviation);
                for channel in 0..4 {
                    let apart = (found[channel] - truth[channel]).abs();
                    assert!(apart < 1e-7, "{lambda}, {mean}, {deviation}: {found:?} {truth:?}");
                }
            }
        }
    }
}
