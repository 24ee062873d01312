//! A color map as a sum of kinks, narrow ramps and steps: the terms whose means the shelf knows in closed form.

use super::color_map::ColorMap;

/// Color below the first knot, and what is added from each position on.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Pieces {
    /// The color below the first knot.
    pub base: [f32; 4],
    /// Slope changes: color a unit.
    pub kinks: Vec<Kink>,
    /// Segments too narrow for a difference of kinks.
    pub ramps: Vec<Ramp>,
    /// Hard edges.
    pub steps: Vec<Step>,
    /// The slope that the rounded kinks add up to: beyond the last knot, what should be 0.
    tail: [f64; 4],
    /// The largest difference between the pieces and the map up to the last knot, and the present one.
    misfit: [f64; 4],
    astray: [f64; 4],
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
    pub fn new(map: &ColorMap, narrow: impl Fn(f64, [f64; 4]) -> bool) -> Self {
        let knots = map.knots();
        let mut pieces = Self { base: knots[0].left, ..Self::default() };
        let residue = residue(map);
        for (index, knot) in knots.iter().enumerate() {
            pieces.step(knot.position, difference(knot.left, knot.right));
            let mut target = [0.0f64; 4];
            let mut width = 0.0;
            if let Some(next) = knots.get(index + 1) {
                let rise = difference(knot.right, next.left);
                width = f64::from(next.position) - f64::from(knot.position);
                if width < f64::from(f32::MIN_POSITIVE) {
                    pieces.step(knot.position, rise); // devices flush such a width to zero
                } else if narrow(width, rise) {
                    pieces.ramp(knot.position, width, rise);
                } else {
                    target = rise.map(|channel| channel / width);
                }
            }
            pieces.kink(knot.position, target, residue);
            pieces.drift(|channel, tail| (tail - target[channel]) * width);
        }
        pieces
    }

    /// Whether nothing is added to the base.
    pub fn is_constant(&self) -> bool {
        self.kinks.is_empty() && self.ramps.is_empty() && self.steps.is_empty()
    }

    fn step(&mut self, position: f32, jump: [f64; 4]) {
        let change = jump.map(|channel| channel as f32);
        if change != [0.0; 4] {
            self.steps.push(Step { position, change });
        }
        self.drift(|channel, _| f64::from(change[channel]) - jump[channel]);
    }

    fn ramp(&mut self, position: f32, width: f64, rise: [f64; 4]) {
        let change = rise.map(|channel| channel as f32);
        if change != [0.0; 4] {
            self.ramps.push(Ramp { position, width: width as f32, change });
        }
        self.drift(|channel, _| f64::from(change[channel]) - rise[channel]);
    }

    /// Turns the slope towards `target`. Each change makes up for the rounding of those before it, so that errors of
    /// the slope do not add up along the map; what only rounding would change stays for the next.
    fn kink(&mut self, position: f32, target: [f64; 4], residue: [f64; 4]) {
        let change: [f32; 4] = std::array::from_fn(|channel| {
            let change = target[channel] - self.tail[channel];
            if change.abs() > residue[channel] {
                change as f32
            } else {
                0.0
            }
        });
        if change != [0.0; 4] {
            self.kinks.push(Kink { position, change });
            self.tail = std::array::from_fn(|channel| self.tail[channel] + f64::from(change[channel]));
        }
    }

    /// Follows the distance of the pieces from the map, to which a number from the channel and its slope is added.
    fn drift(&mut self, added: impl Fn(usize, f64) -> f64) {
        for channel in 0..4 {
            self.astray[channel] += added(channel, self.tail[channel]);
            self.misfit[channel] = self.misfit[channel].max(self.astray[channel].abs());
        }
    }

    /// The color above the last knot, but for the slope that the rounded kinks leave.
    pub fn last(&self) -> [f32; 4] {
        let color = |channel: usize| {
            let kinks = self.kinks.iter().map(|kink| -f64::from(kink.position) * f64::from(kink.change[channel]));
            let ramps = self.ramps.iter().map(|ramp| f64::from(ramp.change[channel]));
            let steps = self.steps.iter().map(|step| f64::from(step.change[channel]));
            f64::from(self.base[channel]) + kinks.chain(ramps).chain(steps).sum::<f64>()
        };
        std::array::from_fn(|channel| color(channel) as f32)
    }

    /// The largest difference of the pieces from the map in [0, 1], summed from [`Self::last`] down.
    pub fn misfit(&self, channel: usize) -> f64 {
        self.misfit[channel] + self.tail[channel].abs() + ROUNDING * f64::from(self.last()[channel].abs())
    }

    /// The most that rounding to f32 adds to a channel of `base` plus the kinks, ramps and steps in this order: the
    /// misfit of their numbers, two roundings of a kink or a step, eight of a ramp (its division is off by five), and
    /// one of each partial sum.
    ///
    /// `reach` is the largest mean of `max(f − position, 0)` that a shader is asked for.
    pub fn rounding(&self, channel: usize, reach: impl Fn(f32) -> f64) -> f64 {
        let mut error = 0.0;
        let (mut value, mut slope) = (f64::from(self.base[channel]), 0.0);
        let mut largest = value.abs();
        let mut place = None;
        for kink in &self.kinks {
            let (at, change) = (f64::from(kink.position), f64::from(kink.change[channel]));
            value += slope * (at - place.unwrap_or(at));
            place = Some(at);
            slope += change;
            largest = largest.max(value.abs());
            let reach = reach(kink.position);
            error += 2.0 * change.abs() * reach + largest + slope.abs() * reach;
        }
        let ramps = self.ramps.iter().map(|ramp| (8.0, ramp.change));
        let mut level = 0.0f64;
        let mut highest = 0.0f64;
        for (roundings, change) in ramps.chain(self.steps.iter().map(|step| (2.0, step.change))) {
            let change = f64::from(change[channel]);
            level += change;
            highest = highest.max(level.abs());
            error += roundings * change.abs() + largest + highest;
        }
        let tail = self.kinks.last().map_or(0.0, |kink| self.tail[channel].abs() * reach(kink.position));
        error * ROUNDING + self.misfit[channel] + tail
    }
}

/// Half a unit in the last place, relative to a number.
pub(crate) const ROUNDING: f64 = 1.0 / 16_777_216.0;

/// The slope of each channel that is left out: [`RESIDUE`] hulls over the length of the map.
fn residue(map: &ColorMap) -> [f64; 4] {
    let knots = map.knots();
    let length = f64::from(knots[knots.len() - 1].position) - f64::from(knots[0].position);
    map.spans().map(|span| RESIDUE * span / length)
}

/// The part of a map's hull that left out slopes may add up to from its first to its last knot.
const RESIDUE: f64 = 3e-7;

fn difference(from: [f32; 4], to: [f32; 4]) -> [f64; 4] {
    std::array::from_fn(|channel| f64::from(to[channel]) - f64::from(from[channel]))
}
