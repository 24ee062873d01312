//! A log: a cylinder that heights displace, and rays to them.

use crate::imaging::vector::{dot, scaled, sum, Vector};
use std::f64::consts::TAU;

/// A cylinder about the x axis. Places on it are x and the way around, counted from −y toward z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Log {
    /// The radius.
    pub radius: f64,
}

/// How far below the lowest height rays are followed: what is lowest is hit, too.
const UNDER: f64 = 1e-3;

impl Log {
    /// Axes of a place: along the log, around it, and out of it, by the right hand.
    pub fn frame(&self, around: f64) -> [Vector; 3] {
        let (sine, cosine) = (around / self.radius).sin_cos();
        [[1.0, 0.0, 0.0], [0.0, sine, cosine], [0.0, -cosine, sine]]
    }

    /// A direction in the axes of a place.
    pub fn turned(&self, around: f64, direction: Vector) -> Vector {
        self.frame(around).map(|axis| dot(axis, direction))
    }

    /// The point over a place at a height.
    pub fn point(&self, [x, around, height]: [f64; 3]) -> Vector {
        sum([x, 0.0, 0.0], scaled(self.frame(around)[2], self.radius + height))
    }

    /// The place below a point, and its height.
    pub fn place(&self, [x, y, z]: Vector) -> [f64; 3] {
        [x, self.radius * z.atan2(-y), y.hypot(z) - self.radius]
    }

    /// How far along a ray it enters and leaves the cylinder of a height, its way being a unit vector; where it passes
    /// by, twice where it is nearest, and false.
    pub fn crossings(&self, from: Vector, way: Vector, height: f64) -> ([f64; 2], bool) {
        let square = (way[1] * way[1] + way[2] * way[2]).max(1e-12);
        let nearest = -(from[1] * way[1] + from[2] * way[2]) / square;
        let left = from[1] * from[1] + from[2] * from[2] - square * nearest * nearest;
        let half = ((self.radius + height).powi(2) - left) / square;
        let root = half.max(0.0).sqrt();
        ([nearest - root, nearest + root], half >= 0.0)
    }

    /// The first place and height at which a ray comes to a surface between two heights.
    ///
    /// The ray is followed by steps: `visit` is given the places and heights at both ends of each, and returns the part
    /// of it at which the surface is. Between them the ray is taken for straight over the unwrapped log, which it
    /// misses by up to step²/(8 radius).
    pub fn first(
        &self,
        from: Vector,
        way: Vector,
        [low, high]: [f64; 2],
        step: f64,
        mut visit: impl FnMut([f64; 3], [f64; 3]) -> Option<f64>,
    ) -> Option<[f64; 3]> {
        let ([enter, leave], meets) = self.crossings(from, way, high);
        if !meets || leave <= 0.0 {
            return None;
        }
        let ([under, _], reaches) = self.crossings(from, way, low - UNDER);
        let (start, end) = (enter.max(0.0), if reaches && under > 0.0 { under } else { leave });
        let at = |along: f64| self.place(sum(from, scaled(way, along)));
        let steps = ((end - start) / step).ceil().max(1.0);
        let mut before = at(start);
        for number in 1..=steps as usize {
            let mut after = at(start + (end - start) * number as f64 / steps);
            // The same way around.
            let whole = TAU * self.radius;
            after[1] -= whole * ((after[1] - before[1]) / whole).round();
            if let Some(part) = visit(before, after) {
                return Some(std::array::from_fn(|axis| before[axis] + part * (after[axis] - before[axis])));
            }
            before = after;
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::imaging::vector::{cross, difference, length, unit};
    use crate::random::Random;

    const LOG: Log = Log { radius: 20.0 };

    #[test]
    fn places_and_points_are_inverse() {
        for place in [[3.0, 0.0, 0.1], [-1.0, 25.0, 0.2], [0.5, -50.0, 0.0]] {
            let found = LOG.place(LOG.point(place));
            assert!((0..3).all(|axis| (found[axis] - place[axis]).abs() < 1e-9), "{found:?} {place:?}");
            let [along, around, out] = LOG.frame(place[1]);
            assert!(length(difference(cross(along, around), out)) < 1e-12);
            let moved = difference(LOG.point([place[0], place[1] + 1e-6, 0.0]), LOG.point([place[0], place[1], 0.0]));
            assert!(length(difference(scaled(moved, 1e6), around)) < 1e-6, "{moved:?}");
        }
    }

    /// Rays by small steps over a wavy log: none comes to it earlier than where it is found, and there it is.
    #[test]
    fn rays_end_on_the_surface() {
        let height = |place: [f64; 3]| 0.1 * (1.0 + (3.0 * place[0]).sin() * (2.0 * place[1]).cos());
        let over = |place: [f64; 3]| place[2] - height(place);
        let between =
            |a: [f64; 3], b: [f64; 3], part: f64| std::array::from_fn(|axis| a[axis] + part * (b[axis] - a[axis]));
        let visit = |a: [f64; 3], b: [f64; 3]| {
            let at = |number: i32| f64::from(number) / 200.0;
            (0..=200).map(at).find(|&part| over(between(a, b, part)) <= 0.0)
        };
        let (mut random, mut hits) = (Random::new(2), 0);
        for number in 0..300 {
            let mut draw = |width: f64| width * (2.0 * random.unit() - 1.0);
            let (eye, target) = ([draw(20.0), -60.0 + draw(20.0), draw(40.0)], [draw(20.0), 0.0, draw(22.0)]);
            let way = unit(difference(target, eye));
            let found = LOG.first(eye, way, [0.0, 0.2], 0.2, visit);
            let far = found.map_or(120.0, |place| length(difference(LOG.point(place), eye)) - 0.02);
            let early = (0..24_000).map(|step| 0.005 * f64::from(step)).take_while(|&along| along < far);
            let early = early.map(|along| LOG.place(sum(eye, scaled(way, along)))).find(|&place| over(place) < -2e-3);
            assert_eq!(early, None, "{number}: {found:?}");
            hits += usize::from(found.is_some());
            assert!(found.is_none_or(|place| over(place).abs() < 4e-3), "{number}: {found:?}");
        }
        assert!((200..300).contains(&hits), "{hits} rays hit");
    }
}
