//! Ch of a map over percentiles, the share P(h) of a rough surface below a height, by two methods.

use super::height::PANELS;
use super::heights::{density, range};
use super::normal::{cumulative, density as normal_density, surprisal, REACH};
use super::quadrature::integrate;
use super::texture::PiecewiseLinear;
use std::f64::consts::LN_2;

/// The height below which a share of standard normal heights lies, by Newton's steps for what is rarer: below or above.
pub fn quantile(share: f64) -> f64 {
    if !(share > cumulative(-REACH)) {
        return -REACH;
    }
    if share > 0.5 {
        return -quantile(1.0 - share);
    }
    let bits = -share.log2();
    // Below 0 the share is less than ½ e^(−h²/2), and its surprisal is convex: steps from there stay on one side.
    let mut height = -(2.0 * LN_2 * (bits - 1.0)).sqrt();
    for _ in 0..8 {
        height += (surprisal(height) - bits) * LN_2 * cumulative(height) / normal_density(height);
    }
    height
}

/// The mean of the map of P(h) over the visible heights: the integral over heights, piece by piece.
///
/// `lambda` is the sum of Smith's Λ of view and light.
pub fn mean(map: &PiecewiseLinear, lambda: f64) -> [f64; 4] {
    let [low, high] = range(lambda);
    let mut sum = [0.0; 4];
    let mut add = |from: f64, to: f64, color: &dyn Fn(f64) -> [f64; 4]| {
        let piece: [f64; 4] = integrate(from, to, (high - low) / PANELS, |height| {
            let density = density(height, lambda);
            color(height).map(|channel| density * channel)
        });
        for (total, value) in sum.iter_mut().zip(piece) {
            *total += value;
        }
    };
    let at = |share: f64| quantile(share).clamp(low, high);
    if let (Some(first), Some(last)) = (map.knots.first(), map.knots.last()) {
        add(low, at(first.0), &|_| first.1);
        add(at(last.0), high, &|_| last.2);
    }
    for pair in map.knots.windows(2) {
        let [(from, _, right), (to, left, _)] = [pair[0], pair[1]];
        // Next to 1 a share's distance from a knot is that of the rests, which keep their digits.
        let along = |height: f64| {
            let distance = if height < 0.0 { cumulative(height) - from } else { (1.0 - from) - cumulative(-height) };
            (distance / (to - from)).clamp(0.0, 1.0)
        };
        add(at(from), at(to), &|height| {
            let along = along(height);
            std::array::from_fn(|channel| right[channel] + along * (left[channel] - right[channel]))
        });
    }
    sum
}

/// The same mean over ranks, without heights: P^(1+Λ) of the visible heights is even in [0, 1], its logarithm
/// exponential.
pub fn mean_by_ranks(map: &PiecewiseLinear, lambda: f64) -> [f64; 4] {
    let n = 1.0 + lambda;
    let rank = |share: f64| if share > 0.0 { (-n * share.ln()).min(45.0) } else { 45.0 };
    let mut ends: Vec<f64> = map.knots.iter().map(|knot| rank(knot.0)).collect();
    ends.extend([0.0, 45.0]);
    ends.sort_by(f64::total_cmp);
    let mut sum = [0.0; 4];
    for pair in ends.windows(2) {
        let piece: [f64; 4] = integrate(pair[0], pair[1], 1.0, |rank| {
            let color = map.value((-rank / n).exp());
            color.map(|channel| (-rank).exp() * channel)
        });
        for (total, value) in sum.iter_mut().zip(piece) {
            *total += value;
        }
    }
    sum
}
