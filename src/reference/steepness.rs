//! Steepness: the length |s| of the slopes s of a rough surface that a view sees, and of slopes whose normal
//! distribution is round, which is the distribution of Rice.

use std::f64::consts::{FRAC_PI_8, PI};

use super::normal::cumulative;
use super::quadrature::integrate;
use super::slopes::Visible;
use super::texture::PiecewiseLinear;

/// Beyond this many deviations lies less than 1e-17 of a distribution.
const FAR: f64 = 9.0;

/// Mean of |s|² over the visible slopes, and its variance over the square of that.
pub fn moments(visible: &Visible) -> [f64; 2] {
    let square = |[x, y]: [f64; 2]| x * x + y * y;
    let [mean] = visible.average_along(|slope| [square(slope)]);
    // Of degree four: the quadrature is exact across the view.
    let [variance] = visible.average_along(|slope| [(square(slope) - mean).powi(2)]);
    [mean, variance / (mean * mean)]
}

/// The probability that a visible slope is shorter than a length: along the view by quadrature, across it the normal
/// distribution between the two slopes of that length. Where the two meet, their distance has the infinite slope of a
/// root, which the sine of the variable of integration takes away.
pub fn below(visible: &Visible, length: f64) -> f64 {
    let [ex, ey, fx, fy] = visible.factor();
    let across = libm::hypot(fx, fy);
    let [fx, fy] = [fx / across, fy / across];
    let [start, pace] = [visible.mean, [ex, ey]].map(|[x, y]| [x * fx + y * fy, y * fx - x * fy]);
    let (rise, reach) = (visible.rise(), visible.reach());
    let from = if reach > 0.0 { (-rise / reach).max(-FAR) } else { -FAR };
    let (to, offset) = ((from.max(0.0).powi(2) + 90.0).sqrt(), 0.5 * from.max(0.0).powi(2));
    let weight = |u: f64| (rise + reach * u).max(0.0) * (offset - 0.5 * u * u).exp();
    let [whole] = integrate(from, to, (to - from) / 14.0, |u| [weight(u)]);
    let (middle, half) = (-start[1] / pace[1], (length / pace[1]).abs());
    let [low, high] = [from, to].map(|end| ((end - middle) / half).clamp(-1.0, 1.0).asin());
    let panel = FRAC_PI_8.min((across / libm::hypot(ex, ey)).min(1.0) / half);
    let [part] = integrate(low, high, panel, |angle| {
        let u = middle + half * angle.sin();
        let (center, wide) = (start[0] + pace[0] * u, length * angle.cos());
        let inside = cumulative((wide - center) / across) - cumulative((-wide - center) / across);
        [weight(u) * inside * half * angle.cos()]
    });
    part / whole
}

/// The mean of a map of |s| over the visible slopes, by parts: the map's last value minus the integral of the
/// cumulative function over the map's changes.
pub fn mean(map: &PiecewiseLinear, visible: &Visible) -> [f64; 4] {
    let panel = 0.5 * libm::sqrt((visible.covariance[0] + visible.covariance[2]).max(0.0));
    let mut sum = map.knots.last().map_or([0.0; 4], |knot| knot.2);
    for (number, knot) in map.knots.iter().enumerate() {
        let jump = if knot.1 == knot.2 || knot.0 <= 0.0 { 0.0 } else { below(visible, knot.0) };
        for (channel, total) in sum.iter_mut().enumerate() {
            *total -= (knot.2[channel] - knot.1[channel]) * jump;
        }
        let Some(next) = map.knots.get(number + 1).filter(|next| next.0 > knot.0) else { continue };
        let [area] = integrate(knot.0.max(0.0), next.0.max(0.0), panel, |at| [below(visible, at)]);
        for (channel, total) in sum.iter_mut().enumerate() {
            *total -= (next.1[channel] - knot.2[channel]) * area / (next.0 - knot.0);
        }
    }
    sum
}

/// The density of Rice, of the length of a vector with independent normal components, by quadrature over its angle with
/// their mean, which is `center` long.
pub fn rice_density(length: f64, center: f64, deviation: f64) -> f64 {
    let pull = length * center / (deviation * deviation);
    let apart = (length - center) / deviation;
    // |length e^iα − center|² is (length − center)² + 4 length center sin²(α/2).
    let far = if pull > 40.0 { 2.0 * libm::asin((20.0 / pull).sqrt()) } else { PI };
    let [ring] = integrate(0.0, far, 2.0 / (1.0 + pull).sqrt(), |angle| {
        let turn = (0.5 * angle).sin();
        [(-0.5 * apart * apart - 2.0 * pull * turn * turn).exp()]
    });
    length * ring / (PI * deviation * deviation)
}

/// The mean of a map over the distribution of Rice.
pub fn rice_mean(map: &PiecewiseLinear, center: f64, deviation: f64) -> [f64; 4] {
    let [low, high] = [center - FAR * deviation, center + (FAR + 1.0) * deviation].map(|end| end.max(0.0));
    let mut ends: Vec<f64> = map.knots.iter().map(|knot| knot.0.clamp(low, high)).collect();
    ends.extend([low, high]);
    ends.sort_by(f64::total_cmp);
    let mut sum = [0.0; 4];
    for pair in ends.windows(2).filter(|pair| pair[1] > pair[0]) {
        let piece: [f64; 4] = integrate(pair[0], pair[1], 2.0 * deviation, |length| {
            map.value(length).map(|channel| channel * rice_density(length, center, deviation))
        });
        for (total, value) in sum.iter_mut().zip(piece) {
            *total += value;
        }
    }
    sum
}
