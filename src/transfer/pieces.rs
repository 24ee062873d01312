//! A color map as a sum of kinks, narrow ramps and steps: the terms whose means the shelf knows in closed form.

use super::color_map::ColorMap;

/// Color below the first knot, and what is added from each position on.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Pieces {
    /// The color below the first knot.
    pub base: [f32; 4],
    /// Slope changes: color a unit.
    pub kinks: Vec<Kink>,
    /// Segments too narrow for a difference of kinks.
    pub ramps: Vec<Ramp>,
    /// Hard edges.
    pub steps: Vec<Step>,
}

/// `change · max(f − position, 0)`
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Kink {
    pub position: f32,
    pub change: [f32; 4],
}

/// `change · clamp((f − position)/width, 0, 1)`
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Ramp {
    pub position: f32,
    pub width: f32,
    pub change: [f32; 4],
}

/// `change` where f > position
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Step {
    pub position: f32,
    pub change: [f32; 4],
}

impl Pieces {
    /// The pieces of a map; `narrow` says of which widths and rises a difference of kinks would lose too much: those
    /// segments become ramps.
    pub fn new(map: &ColorMap, narrow: impl Fn(f64, [f32; 4]) -> bool) -> Self {
        let knots = map.knots();
        let mut pieces = Self { base: knots[0].left, kinks: Vec::new(), ramps: Vec::new(), steps: Vec::new() };
        let mut slope = [0.0f64; 4]; // that the rounded kinks so far add up to
        let residue = residue(map);
        for (index, knot) in knots.iter().enumerate() {
            let jump = difference(knot.left, knot.right);
            if jump != [0.0; 4] {
                pieces.steps.push(Step { position: knot.position, change: jump });
            }
            let mut target = [0.0f64; 4];
            if let Some(next) = knots.get(index + 1) {
                let rise = difference(knot.right, next.left);
                let width = f64::from(next.position) - f64::from(knot.position);
                if !narrow(width, rise) {
                    target = rise.map(|channel| f64::from(channel) / width);
                } else if rise != [0.0; 4] {
                    pieces.ramps.push(Ramp { position: knot.position, width: width as f32, change: rise });
                }
            }
            // Each change makes up for the rounding of those before it, so that errors of the slope do not add up along
            // the map; what only rounding would change stays for the next.
            let change: [f32; 4] = std::array::from_fn(|channel| {
                let change = target[channel] - slope[channel];
                if change.abs() > residue[channel] {
                    change as f32
                } else {
                    0.0
                }
            });
            if change != [0.0; 4] {
                pieces.kinks.push(Kink { position: knot.position, change });
                slope = std::array::from_fn(|channel| slope[channel] + f64::from(change[channel]));
            }
        }
        pieces
    }
}

/// The slope of each channel that is left out: [`RESIDUE`] hulls over the length of the map.
fn residue(map: &ColorMap) -> [f64; 4] {
    let (low, high) = map.hull();
    let knots = map.knots();
    let length = f64::from(knots[knots.len() - 1].position) - f64::from(knots[0].position);
    std::array::from_fn(|channel| RESIDUE * (f64::from(high[channel]) - f64::from(low[channel])) / length)
}

/// The part of a map's hull that left out slopes may add up to from its first to its last knot.
pub(crate) const RESIDUE: f64 = 3e-7;

fn difference(from: [f32; 4], to: [f32; 4]) -> [f32; 4] {
    std::array::from_fn(|channel| (f64::from(to[channel]) - f64::from(from[channel])) as f32)
}
