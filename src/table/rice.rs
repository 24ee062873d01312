//! Tables of a map's means over distributions of Rice, baked with a polynomial for the Bessel function and judged by
//! quadrature over angles.

use super::bake::bends;
use super::grid::Axis;
use super::lattice::{Judged, Lattice, FLAT};
use super::Table;
use crate::reference::quadrature::integrate;
use crate::reference::steepness::rice_mean;
use crate::reference::texture::PiecewiseLinear;

/// Beyond this many deviations lies less than 1e-7 of a distribution.
const FAR: f64 = 5.5;

/// From so many deviations between 0 and the center on, the mean length is its series to 2e-6 deviations.
const SERIES: f64 = 10.0;

/// A map, the axes of its table, and what the table is judged over.
#[derive(Clone, Copy)]
pub(crate) struct Plan<'a> {
    /// The map.
    pub map: &'a PiecewiseLinear,
    /// The columns: lengths ν of the mean vector.
    pub centers: Axis,
    /// The rows: deviations σ of a component.
    pub deviations: Axis,
    /// The largest ν that occurs.
    pub highest: f64,
    /// The smallest σ that occurs.
    pub floor: f64,
}

impl Plan<'_> {
    /// The table, with its error as measured: by quadrature over angles where it is worst.
    pub(crate) fn table(self, name: &str) -> Table {
        let lattice = Lattice([self.centers, self.deviations, FLAT]);
        let farthest = self.highest.max(self.centers.high);
        let along = |deviation: f64| {
            let row = Row::new(self.map, deviation, farthest, self.centers.count);
            move |center: f64| row.mean(center)
        };
        let texels = lattice.texels(|_, deviation| along(deviation));
        let judged = Judged { low: 0.0, high: self.highest, least: self.floor, third: 0.0 };
        let truth = |at: f64, line: f64| rice_mean(self.map, at, line);
        let error = lattice.error(&texels, &bends(self.map), judged, along, truth);
        lattice.table(name, texels, error)
    }
}

/// Places a deviation at which the means along a row are known: the polynomial of degree 5 between them errs by 3e-6 of
/// an edge, as its six nearest do.
const PLACES: f64 = 4.0;

/// The means of one deviation.
struct Row<'a> {
    map: &'a PiecewiseLinear,
    deviation: f64,
    /// Those at every [`PLACES`]th of it, from two before the center 0 on; none where fewer are asked for.
    known: Vec<[f64; 4]>,
}

impl<'a> Row<'a> {
    /// For so many centers up to one.
    fn new(map: &'a PiecewiseLinear, deviation: f64, farthest: f64, asked: usize) -> Self {
        let last = farthest * PLACES / deviation;
        let known = |place: usize| mean(map, (place as f64 - 2.0).abs() * deviation / PLACES, deviation);
        let places = if last + 6.0 < asked as f64 { 0..last as usize + 6 } else { 0..0 };
        Self { map, deviation, known: places.map(known).collect() }
    }

    /// The mean of one center, which may stand on either side of 0.
    fn mean(&self, center: f64) -> [f64; 4] {
        let place = center.abs() * PLACES / self.deviation;
        let Some(&[a, b, c, d, e, f]) = self.known.get(place as usize..).and_then(<[_]>::first_chunk) else {
            return mean(self.map, center.abs(), self.deviation);
        };
        // Lagrange's polynomial through the places −2 to 3.
        let t = place.fract();
        let [p, q, r, s, u] = [t + 2.0, t + 1.0, t - 1.0, t - 2.0, t - 3.0];
        let (outer, inner) = (p * u, q * s);
        let weights = [
            -q * t * r * s * u / 120.0,
            outer * t * r * s / 24.0,
            -outer * q * r * s / 12.0,
            outer * inner * t / 12.0,
            -outer * q * t * r / 24.0,
            p * inner * t * r / 120.0,
        ];
        std::array::from_fn(|channel| {
            let colors = [a, b, c, d, e, f].map(|color: [f64; 4]| color[channel]);
            colors.iter().zip(weights).map(|(color, weight)| color * weight).sum()
        })
    }
}

/// The modified Bessel function I₀ times e^−x, within 5e-7 of itself.
///
/// Source: Abramowitz and Stegun 1964, "Handbook of Mathematical Functions", equations 9.8.1 and 9.8.2.
fn bessel(x: f64) -> f64 {
    const SMALL: [f64; 7] = [1.0, 3.515_622_9, 3.089_942_4, 1.206_749_2, 0.265_973_2, 0.036_076_8, 0.004_581_3];
    const LARGE: [f64; 9] = [
        0.398_942_28,
        0.013_285_92,
        0.002_253_19,
        -0.001_575_65,
        0.009_162_81,
        -0.020_577_06,
        0.026_355_37,
        -0.016_476_33,
        0.003_923_77,
    ];
    let sum = |coefficients: &[f64], t: f64| coefficients.iter().rev().fold(0.0, |sum, value| sum * t + value);
    if x < 3.75 {
        (-x).exp() * sum(&SMALL, (x / 3.75).powi(2))
    } else {
        sum(&LARGE, 3.75 / x) / x.sqrt()
    }
}

/// The mean of a map over a distribution of Rice, within 1e-6 of the largest color.
fn mean(map: &PiecewiseLinear, center: f64, deviation: f64) -> [f64; 4] {
    if deviation <= 0.0 {
        return map.value(center);
    }
    let [low, high] = [(center - FAR * deviation).max(0.0), center + (FAR + 0.5) * deviation];
    if center > SERIES * deviation && !map.knots.iter().any(|knot| (low..=high).contains(&knot.0)) {
        // On a line the color of the mean is the mean color.
        let part = (deviation / center).powi(2);
        return map.value(center * (1.0 + part * (0.5 + 0.125 * part)));
    }
    let mut sum = [0.0; 4];
    // Of a color and its change with the length beyond `start`.
    let mut add = |from: f64, to: f64, start: f64, [color, change]: [[f64; 4]; 2]| {
        let [share, along] = integrate(from.clamp(low, high), to.clamp(low, high), 8.0 * deviation, |length| {
            let apart = (length - center) / deviation;
            let x = length * center / (deviation * deviation);
            let density = length / (deviation * deviation) * (-0.5 * apart * apart).exp() * bessel(x);
            [density, density * (length - start)]
        });
        for (channel, total) in sum.iter_mut().enumerate() {
            *total += share * color[channel] + along * change[channel];
        }
    };
    if let (Some(first), Some(last)) = (map.knots.first(), map.knots.last()) {
        add(low, first.0, first.0, [first.1, [0.0; 4]]);
        add(last.0, high, last.0, [last.2, [0.0; 4]]);
    }
    for pair in map.knots.windows(2) {
        let [(from, _, right), (to, left, _)] = [pair[0], pair[1]];
        let change = std::array::from_fn(|channel| (left[channel] - right[channel]) / (to - from));
        add(from, to, from, [right, change]);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn means_are_those_of_the_reference() {
        let (black, white) = ([0.0, 0.3, 1.0, 1.0], [1.0, 0.4, 0.0, 1.0]);
        let knots = vec![(-0.2, white, black), (0.3, white, black), (0.300_02, black, white), (0.9, white, white)];
        let map = PiecewiseLinear { knots };
        for (center, deviation) in [(0.0, 0.2), (0.31, 0.02), (0.7, 0.5), (1.4, 0.2), (0.3, 1e-4), (0.01, 0.7)] {
            let (truth, found) = (rice_mean(&map, center, deviation), mean(&map, center, deviation));
            for channel in 0..4 {
                let apart = (found[channel] - truth[channel]).abs();
                assert!(apart < 2e-6, "{center}, {deviation}: {found:?} {truth:?}");
            }
        }
    }

    /// Between known places means err by the polynomial alone, on either side of 0.
    #[test]
    fn means_along_a_row_are_those_of_each_center() {
        let (black, white) = ([0.0, 0.3, 1.0, 1.0], [1.0, 0.4, 0.0, 1.0]);
        let map = PiecewiseLinear { knots: vec![(0.3, black, white), (0.9, white, black)] };
        for deviation in [0.05, 0.3, 0.75] {
            let row = Row::new(&map, deviation, 2.0, 256);
            assert!(!row.known.is_empty(), "{deviation}");
            for index in -3..=200 {
                let center = 0.01 * f64::from(index);
                let (truth, found) = (mean(&map, center.abs(), deviation), row.mean(center));
                let apart = (0..4).map(|channel| (found[channel] - truth[channel]).abs()).fold(0.0, f64::max);
                assert!(apart < 5e-6, "{center}, {deviation}: {apart:e}");
            }
        }
    }
}
