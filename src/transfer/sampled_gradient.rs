//! Color maps from `colorgrad` gradients.

use super::color_map::{ColorMap, MAX_KNOTS};
use crate::Error;

impl ColorMap {
    /// A `colorgrad` gradient over its own domain, sampled at `stops` evenly spaced positions, ends included.
    ///
    /// Between them the map is linear in light. A gradient that is opaque everywhere gives three channels, any other
    /// four, premultiplied.
    ///
    /// # Errors
    /// Fewer than two stops or more than [`MAX_KNOTS`]; a domain that [`ColorMap::gradient`] refuses.
    pub fn colorgrad(gradient: &impl colorgrad::Gradient, stops: usize) -> Result<Self, Error> {
        if !(2..=MAX_KNOTS).contains(&stops) {
            let what = "the stops of a color map".into();
            return Err(Error::Size { what, count: stops, allowed: format!("2 to {MAX_KNOTS}") });
        }
        let (low, high) = gradient.domain();
        let position = |index: usize| low + (high - low) * index as f32 / (stops - 1) as f32;
        let texels: Vec<(f32, [f32; 4])> =
            (0..stops).map(position).map(|at| (at, gradient.at(at).to_linear_rgba())).collect();
        if texels.iter().all(|(_, color)| color[3] >= 1.0) {
            return Self::gradient(texels.iter().map(|&(at, [r, g, b, _])| (at, [r, g, b])));
        }
        Self::gradient(texels.iter().map(|&(at, [r, g, b, a])| (at, [r * a, g * a, b * a, a])))
    }
}
