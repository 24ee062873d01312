//! Mean and covariance of slopes over the texels of an image.

use super::moment_mipmap::Edge;
use super::pyramid::Grid;

/// Mean x and y and covariance xx, xy, yy of slopes.
pub(super) type Moments = [f64; 5];

/// The quarters of a texel: the steps to the neighbors across and down.
const QUARTERS: [[i64; 2]; 4] = [[-1, -1], [1, -1], [-1, 1], [1, 1]];

impl Grid<5> {
    /// Moments of the bilinear reconstruction of slopes over the area of each texel.
    ///
    /// In a quarter of a texel a slope is c + a u + b v + d u v, u and v from the texel's center in [0, ½] towards the
    /// neighbors. With both as ¼ + ½ ξ that is a mean and p ξ + q η + r ξ η, and two slopes have the covariance
    /// (p p′ + q q′)/12 + r r′/144.
    pub fn of_slopes(width: usize, height: usize, slopes: &[[f32; 2]], edge: Edge) -> Self {
        let place = |at: i64, size: usize| match edge {
            Edge::Clamp => at.clamp(0, size as i64 - 1) as usize,
            Edge::Repeat => at.rem_euclid(size as i64) as usize,
        };
        let slope = |x: i64, y: i64| slopes[place(y, height) * width + place(x, width)].map(f64::from);
        let quarter = |x: i64, y: i64, [side, level]: [i64; 2]| {
            let center = slope(x, y);
            // Relative to the texel: equal slopes leave exact zeros.
            let from_center = |x, y| {
                let neighbor = slope(x, y);
                [0, 1].map(|axis| neighbor[axis] - center[axis])
            };
            let (across, down) = (from_center(x + side, y), from_center(x, y + level));
            let corner = from_center(x + side, y + level);
            let [first, second] = [0, 1].map(|axis| {
                let (a, b) = (across[axis], down[axis]);
                let d = corner[axis] - a - b;
                let mean = center[axis] + 0.25 * (a + b + 0.25 * d);
                (mean, [0.5 * (a + 0.25 * d), 0.5 * (b + 0.25 * d), 0.25 * d])
            });
            let covariance = |one: [f64; 3], other: [f64; 3]| {
                let [p, q, r] = [0, 1, 2].map(|term| one[term] * other[term]);
                (p + q) / 12.0 + r / 144.0
            };
            let [xx, xy, yy] =
                [(first, first), (first, second), (second, second)].map(|(one, other)| covariance(one.1, other.1));
            [first.0, second.0, xx, xy, yy]
        };
        Self::of_quarters(width, height, quarter)
    }

    /// Moments of the gradient of the bilinear reconstruction of heights over the area of each texel; heights and
    /// texels are in the same unit when heights are multiplied by `scale`.
    ///
    /// In a quarter the surface is c + a u + b v + d u v, as for slopes: its gradient (a + d v, b + d u) has the mean
    /// (a + ¼ d, b + ¼ d), the variances d²/48 and no covariance.
    pub fn of_heights(width: usize, height: usize, heights: &[f32], scale: f64, edge: Edge) -> Self {
        // Beyond an edge the surface goes on with the slope that it has there, or begins anew.
        let along = |at: i64, size: usize| {
            let last = size as i64 - 1;
            let inside = at.clamp(0, last);
            match edge {
                Edge::Repeat => (at.rem_euclid(size as i64) as usize, None),
                Edge::Clamp if inside == at => (at as usize, None),
                Edge::Clamp => (inside as usize, Some((2 * inside - at).clamp(0, last) as usize)),
            }
        };
        let row = |x: i64, y: usize| {
            let value = |x: usize| scale * f64::from(heights[y * width + x]);
            let (inside, before) = along(x, width);
            before.map_or(value(inside), |before| 2.0 * value(inside) - value(before))
        };
        let surface = |x: i64, y: i64| {
            let (inside, before) = along(y, height);
            before.map_or(row(x, inside), |before| 2.0 * row(x, inside) - row(x, before))
        };
        let quarter = |x: i64, y: i64, [side, level]: [i64; 2]| {
            let center = surface(x, y);
            let (a, b) = (surface(x + side, y) - center, surface(x, y + level) - center);
            let d = surface(x + side, y + level) - center - a - b;
            let variance = d * d / 48.0;
            [side as f64 * (a + 0.25 * d), level as f64 * (b + 0.25 * d), variance, 0.0, variance]
        };
        Self::of_quarters(width, height, quarter)
    }

    fn of_quarters(width: usize, height: usize, quarter: impl Fn(i64, i64, [i64; 2]) -> Moments) -> Self {
        let texel = |at: usize| {
            let (x, y) = ((at % width) as i64, (at / width) as i64);
            mixed(&QUARTERS.map(|steps| (0.25, quarter(x, y, steps))))
        };
        Self { width, height, moments: (0..width * height).map(texel).collect() }
    }
}

/// Moments of a mixture, by the law of total covariance; weights sum to one.
pub(super) fn mixed(parts: &[(f64, Moments)]) -> Moments {
    let Some(&(_, [x, y, ..])) = parts.first() else { return [0.0; 5] };
    let mut mean = [x, y];
    for (weight, part) in parts {
        mean[0] += weight * (part[0] - x);
        mean[1] += weight * (part[1] - y);
    }
    let [mut xx, mut xy, mut yy] = [0.0; 3];
    for (weight, part) in parts {
        let apart = [part[0] - mean[0], part[1] - mean[1]];
        xx += weight * (part[2] + apart[0] * apart[0]);
        xy += weight * (part[3] + apart[0] * apart[1]);
        yy += weight * (part[4] + apart[1] * apart[1]);
    }
    [mean[0], mean[1], xx, xy, yy]
}
