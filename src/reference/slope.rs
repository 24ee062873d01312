//! Cs: the mean of a color map over one component of the visible slopes of a rough surface, by two methods.
//!
//! The component is that along a horizontal vector; facing a direction is one too: with the normal n ∝ (−s, 1) of a
//! slope s, n · d / n.z = d.z − d.xy · s. Equation 18 of Heitz et al. 2014, for a map of one variable.

use super::quadrature::integrate;
use super::slopes::Visible;
use super::texture::{self, PiecewiseLinear};

/// The mean of the map over the visible slopes' components along a vector: the map's mean over the normal distribution
/// that slopes with one component along the view have, averaged along the view.
pub fn mean(map: &PiecewiseLinear, visible: &Visible, direction: [f64; 2]) -> [f64; 4] {
    let edges: Vec<f64> = map.knots.iter().map(|knot| knot.0).collect();
    visible.component(direction, &edges, |mean, deviation| texture::mean(map, mean, deviation))
}

/// The same mean by parts: the map's last value minus the integral of the cumulative function over the map's changes.
pub fn mean_by_parts(map: &PiecewiseLinear, visible: &Visible, direction: [f64; 2]) -> [f64; 4] {
    let below = |at: f64| visible.below(direction, at);
    let [middle, deviation, _] = visible.moments_along(direction);
    let mut sum = map.knots.last().map_or([0.0; 4], |knot| knot.2);
    for (number, knot) in map.knots.iter().enumerate() {
        let jump = if knot.1 == knot.2 { 0.0 } else { below(knot.0) };
        for (channel, total) in sum.iter_mut().enumerate() {
            *total -= (knot.2[channel] - knot.1[channel]) * jump;
        }
        let Some(next) = map.knots.get(number + 1).filter(|next| next.0 > knot.0) else { continue };
        // Beyond 40 deviations, of which the tail of a gamma distribution has 1e-23, the function is 0 or 1.
        let ends = [middle - 40.0 * deviation, middle + 40.0 * deviation].map(|end| end.clamp(knot.0, next.0));
        let [part] = integrate(ends[0], ends[1], 0.5 * deviation, |at| [below(at)]);
        let area = part + (next.0 - ends[1]);
        for (channel, total) in sum.iter_mut().enumerate() {
            *total -= (next.1[channel] - knot.2[channel]) * area / (next.0 - knot.0);
        }
    }
    sum
}
