//! The largest error of a map's mean over a distribution that stands for another one.
//!
//! With F and G their cumulative functions the error is |∫ (F − G) dC|. Where |F − G| is at most d(z) at z deviations
//! from their mean, falling with z, no more of the map's variation counts in full than lies within reach: with a d of
//! steps the error is at most Σ (d of a step − d of the next) times the map's variation in a window as wide as the
//! step, wherever that is largest.

use super::height::variation;
use crate::transfer::color_map::{ColorMap, Knot};

/// How far a cumulative function is off: from so many deviations from the mean on, either way, at most by so much; the
/// first from 0 on.
pub(crate) type Envelope = [[f64; 2]];

/// The largest error of a map's mean for deviations up to one.
pub(crate) fn largest_error(map: &ColorMap, envelope: &Envelope, deviation: f64) -> f64 {
    let far = envelope.last().map_or(0.0, |step| step[1]);
    let steps = envelope.windows(2).map(|pair| {
        let [[_, near], [until, beyond]] = [pair[0], pair[1]];
        (near - beyond) * variation_within(map, 2.0 * until * deviation)
    });
    far * variation(map) + steps.sum::<f64>()
}

/// What a bound says of the variation that it counts, which may be the whole.
pub(crate) fn varied(map: &ColorMap, counted: f64) -> String {
    let whole = variation(map);
    if counted > 0.999 * whole {
        return format!("the total variation {whole:.3}");
    }
    format!("{counted:.3} of the total variation {whole:.3}, as no more is within reach at once")
}

/// The most that a channel rises and falls between two positions so far apart.
fn variation_within(map: &ColorMap, width: f64) -> f64 {
    let channel = |channel: usize| {
        let sums = Sums::new(map, channel);
        let ends = map.knots().iter().map(|knot| f64::from(knot.position));
        // It is largest where an end of the window is at a knot.
        let windows = ends.flat_map(|end| [[end, end + width], [end - width, end]]);
        windows.map(|[low, high]| sums.at(high)[1] - sums.at(low)[0]).fold(0.0, f64::max)
    };
    // Widths are rounded.
    1.000_001 * (0..map.channels()).map(channel).fold(0.0, f64::max)
}

/// What a channel rose and fell from the first knot on: at each, its position, the sum before and the sum behind it.
struct Sums(Vec<[f64; 3]>);

impl Sums {
    fn new(map: &ColorMap, channel: usize) -> Self {
        let (mut sum, mut last) = (0.0, None);
        let mut change = |to: f32| {
            sum += last.map_or(0.0, |last: f32| (f64::from(to) - f64::from(last)).abs());
            last = Some(to);
            sum
        };
        let at = |knot: &Knot| [f64::from(knot.position), change(knot.left[channel]), change(knot.right[channel])];
        Self(map.knots().iter().map(at).collect())
    }

    /// The sums before and behind a position.
    fn at(&self, position: f64) -> [f64; 2] {
        let Self(knots) = self;
        let next = knots.partition_point(|knot| knot[0] < position);
        match (next.checked_sub(1).and_then(|last| knots.get(last)), knots.get(next)) {
            (_, Some(knot)) if knot[0] == position => [knot[1], knot[2]],
            (Some(last), Some(next)) => {
                let part = (position - last[0]) / (next[0] - last[0]);
                [last[2] + part * (next[1] - last[2]); 2]
            }
            (Some(last), None) => [last[2]; 2],
            (None, _) => [0.0; 2],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Error;

    #[test]
    fn what_is_out_of_reach_does_not_count() -> Result<(), Error> {
        let map = ColorMap::gradient([(0.0, [0.0; 3]), (1.0, [0.5; 3]), (1.0, [0.7; 3]), (3.0, [0.3; 3])])?;
        for (width, variation) in [(0.0, 0.2), (0.5, 0.45), (1.0, 0.7), (2.0, 0.9), (3.0, 1.1), (9.0, 1.1)] {
            let found = variation_within(&map, width);
            assert!((found - variation).abs() < 1e-5, "{width}: {found}");
        }
        // All of it within half a deviation, and of what is farther the last step.
        let envelope = [[0.0, 0.1], [0.5, 0.04], [1.0, 0.01]];
        let found = largest_error(&map, &envelope, 0.5);
        let expected = 0.01 * 1.1 + 0.06 * 0.45 + 0.03 * 0.7;
        assert!((found - expected).abs() < 1e-6, "{found} {expected}");
        assert!((largest_error(&map, &envelope, 1e3) - 0.11).abs() < 1e-6);
        Ok(())
    }
}
