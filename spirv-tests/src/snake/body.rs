//! The body: a tube about a coiled curve, thin at the tail, with a neck and a head.
//!
//! Rings of the tube are numbered from the tail. A ring is as far from the next as its texels are wide, so that a map
//! wraps the tube without being stretched where the tube is straight; where it bends the map is shorter inside.

use super::mesh::Mesh;
use crate::imaging::vector::{across, between, cross, difference, dot, length, scaled, sum, unit, Vector};
use std::f64::consts::{PI, TAU};

/// Texels around the body.
pub const AROUND: usize = 512;

/// A ring of the body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ring {
    /// Its middle.
    pub middle: Vector,
    /// A unit vector along the body, to the head.
    pub along: Vector,
    /// A unit vector across the body, from which angles are counted; it turns no more than the body does.
    pub side: Vector,
    /// Change of the direction along the body with its length.
    pub curvature: Vector,
    /// The radius.
    pub radius: f64,
    /// Change of the radius with the length.
    pub growth: f64,
}

/// A place on the base surface, which heights displace.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Base {
    /// The middle of its ring.
    pub middle: Vector,
    /// A unit vector out of the body, across its curve.
    pub out: Vector,
    /// Unit vectors along the body, around it, and normal to the surface: a frame by the right hand.
    pub frame: [Vector; 3],
    /// How much longer along the body a texel is than around it.
    pub stretch: f64,
    /// The radius.
    pub radius: f64,
}

/// The body.
#[derive(Clone, Debug)]
pub struct Body {
    /// The rings, one for each row of texels.
    pub rings: Vec<Ring>,
}

/// Points that the curve follows, for a body of radius 1 on a ground at height −1: two turns inward, up over them, and
/// the head on top.
fn points() -> Vec<Vector> {
    let smooth = |from: f64, to: f64, at: f64| {
        let part = ((at - from) / (to - from)).clamp(0.0, 1.0);
        part * part * (3.0 - 2.0 * part)
    };
    let turn = PI / 6.0;
    let coil = (0..=30).map(|number| {
        let angle = turn * f64::from(number);
        let radius = 6.9 - 2.4 * angle / TAU + 1.2 * smooth(3.6 * PI, 5.0 * PI, angle);
        let height = 2.5 * smooth(3.2 * PI, 4.9 * PI, angle);
        [radius * angle.cos(), radius * angle.sin(), height]
    });
    coil.chain([[-3.0, -1.9, 2.75], [-1.6, -3.4, 2.7], [0.0, -4.9, 2.5], [1.1, -6.6, 2.35], [1.6, -8.4, 2.2]]).collect()
}

/// Point, first and second derivative of the uniform cubic B-spline at a parameter.
fn spline(points: &[Vector], at: f64) -> [Vector; 3] {
    let first = (at.floor() as usize).min(points.len() - 4);
    let t = at - first as f64;
    let s = 1.0 - t;
    let weights = [
        [s * s * s, 3.0 * t * t * t - 6.0 * t * t + 4.0, 3.0 * s * s * s - 6.0 * s * s + 4.0, t * t * t],
        [-3.0 * s * s, 9.0 * t * t - 12.0 * t, 12.0 * s - 9.0 * s * s, 3.0 * t * t],
        [6.0 * s, 18.0 * t - 12.0, 18.0 * s - 12.0, 6.0 * t],
    ];
    weights.map(|weights| {
        let parts = weights.iter().zip(&points[first..]);
        parts.fold([0.0; 3], |total, (weight, &point)| sum(total, scaled(point, weight / 6.0)))
    })
}

/// Distances from the tip of the nose and radii there: snout, head, neck and body, changing smoothly between.
const HEAD: [[f64; 2]; 4] = [[0.55, 0.52], [2.1, 0.98], [4.6, 0.66], [9.5, 1.0]];

/// Step of differences of the radius.
const STEP: f64 = 1e-5;

/// How far from the tip of the nose the last ring is, whose radius is a fortieth of the snout's.
const NOSE: f64 = 0.0002;

/// Length over which the tail becomes thicker.
const TAIL: f64 = 8.0;

/// The radius at a distance from the tail's end, of a body of some length.
fn radius(at: f64, whole: f64) -> f64 {
    let left = (whole - at).max(0.0);
    let [snout, blunt] = HEAD[0];
    let head = if left < snout {
        blunt * (1.0 - (1.0 - left / snout).powi(2)).max(0.0).sqrt()
    } else {
        let pair = HEAD.windows(2).find(|pair| left < pair[1][0]);
        pair.map_or(HEAD[HEAD.len() - 1][1], |pair| {
            let part = (left - pair[0][0]) / (pair[1][0] - pair[0][0]);
            pair[0][1] + (pair[1][1] - pair[0][1]) * part * part * (3.0 - 2.0 * part)
        })
    };
    head * (0.02 + 0.98 * (1.0 - (-at / TAIL).exp()))
}

impl Default for Body {
    fn default() -> Self {
        Self::new()
    }
}

impl Body {
    /// The body.
    pub fn new() -> Self {
        let points = points();
        let spans = (points.len() - 3) as f64;
        let speed = |at: f64| length(spline(&points, at)[1]);
        let steps = 4000;
        let whole: f64 = (0..steps).map(|step| speed((f64::from(step) + 0.5) * spans / f64::from(steps))).sum::<f64>()
            * spans
            / f64::from(steps);
        let texel = TAU / AROUND as f64;
        let (mut rings, mut at, mut gone): (Vec<Ring>, f64, f64) = (Vec::new(), 0.0, 0.0);
        let mut side = [0.0, 0.0, 1.0];
        while gone < whole - NOSE && at < spans {
            let [middle, first, second] = spline(&points, at);
            let (along, pace) = (unit(first), length(first));
            side = unit(across(side, along));
            let radius = |along: f64| radius(gone + along, whole);
            let (growth, radius) = ((radius(STEP) - radius(-STEP)) / (2.0 * STEP), radius(0.0));
            let curvature = scaled(across(second, along), 1.0 / (pace * pace));
            rings.push(Ring { middle, along, side, curvature, radius, growth });
            // Half a step first: the midpoint rule.
            let step = texel * radius / (1.0 + growth * growth).sqrt();
            at += step / speed((at + 0.5 * step / pace).min(spans));
            gone += step;
        }
        Self { rings }
    }

    /// The base surface at a row and a column of texels, both of which may lie between.
    pub fn base(&self, row: f64, column: f64) -> Base {
        let ring = self.ring(row);
        let (sine, cosine) = (TAU * column / AROUND as f64).sin_cos();
        let other = cross(ring.side, ring.along);
        let out = sum(scaled(ring.side, cosine), scaled(other, sine));
        let around = difference(scaled(other, cosine), scaled(ring.side, sine));
        let bend = dot(ring.curvature, out);
        let inside = 1.0 - ring.radius * bend;
        let growth = ring.growth;
        let slanted = inside.hypot(growth);
        let along = unit(sum(scaled(ring.along, inside), scaled(out, growth)));
        Base {
            middle: ring.middle,
            out,
            frame: [along, around, cross(along, around)],
            stretch: slanted / 1f64.hypot(growth),
            radius: ring.radius,
        }
    }

    /// How the normal of the base surface turns from a place to one that is rows and columns farther, if it went on so.
    pub fn turn(&self, [row, column]: [f64; 2], [down, right]: [f64; 2]) -> Vector {
        let far = down.hypot(right).max(1e-9);
        let normal = |texels: f64| self.base(row + texels * down / far, column + texels * right / far).frame[2];
        scaled(difference(normal(1.0), normal(-1.0)), 0.5 * far)
    }

    fn ring(&self, row: f64) -> Ring {
        let first = (row.max(0.0) as usize).min(self.rings.len() - 2);
        let part = row - first as f64;
        let (a, b) = (&self.rings[first], &self.rings[first + 1]);
        let along = unit(between(a.along, b.along, part));
        Ring {
            middle: between(a.middle, b.middle, part),
            along,
            side: unit(across(between(a.side, b.side, part), along)),
            curvature: between(a.curvature, b.curvature, part),
            radius: a.radius + part * (b.radius - a.radius),
            growth: a.growth + part * (b.growth - a.growth),
        }
    }
}

impl Base {
    /// The point that a height over the surface, in radii, displaces.
    pub fn displaced(&self, height: f64) -> Vector {
        let surface = sum(self.middle, scaled(self.out, self.radius));
        sum(surface, scaled(self.frame[2], self.radius * height))
    }

    /// A direction in the frame.
    pub fn turned(&self, direction: Vector) -> Vector {
        self.frame.map(|axis| dot(axis, direction))
    }
}

impl Body {
    /// The body with a map of heights in radii, `SIDE >> level` texels a side, x along the body, which it repeats
    /// along.
    pub fn mesh(&self, heights: &[f32], level: usize) -> Mesh {
        let columns = AROUND >> level;
        let size = (1usize << level) as f64;
        // A coarse texel's middle among those of level 0.
        let middle = |texel: usize| (texel as f64 + 0.5) * size - 0.5;
        let rows = self.rings.len() >> level;
        let point = |index: usize| {
            let (row, column) = (index / columns, index % columns);
            let height = f64::from(heights[column * columns + row % columns]);
            self.base(middle(row), middle(column)).displaced(height).map(|part| part as f32)
        };
        Mesh::new(columns, (0..rows * columns).map(point).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;

    /// Places over the body, but for the tip of the nose, where a row is no small step.
    fn places(body: &Body) -> Vec<[f64; 2]> {
        let mut random = Random::new(5);
        let rows = 0.9 * body.rings.len() as f64;
        (0..500).map(|_| [3.0 + rows * random.unit(), AROUND as f64 * random.unit()]).collect()
    }

    /// Frames, stretches and turns are the base surface's, by differences.
    #[test]
    fn frames_are_derivatives() {
        let body = Body::new();
        let texel = TAU / AROUND as f64;
        for [row, column] in places(&body) {
            let base = body.base(row, column);
            let change = |of: &dyn Fn(&Base) -> Vector, [down, right]: [f64; 2]| {
                let ends = [1.0, -1.0].map(|sign| of(&body.base(row + sign * down, column + sign * right)));
                scaled(difference(ends[0], ends[1]), 0.5)
            };
            let [along, around] = [[1.0, 0.0], [0.0, 1.0]].map(|step| change(&|base| base.displaced(0.0), step));
            let width = texel * base.radius;
            let near = |found: Vector, expected: Vector| length(difference(found, expected)) < 2e-3;
            assert!(near(scaled(along, 1.0 / (width * base.stretch)), base.frame[0]), "{row} {column}: {along:?}");
            assert!(near(scaled(around, 1.0 / width), base.frame[1]), "{row} {column}: {around:?}");
            assert!(dot(base.frame[2], base.out) > 0.5, "{row} {column}: the normal points inside");
            let turned = dot(body.turn([row, column], [0.0, 3.0]), base.frame[1]);
            let expected = 3.0 * texel * dot(base.frame[2], base.out);
            assert!((turned / expected - 1.0).abs() < 0.01, "{row} {column}: {turned} {base:?}");
            let turned = dot(body.turn([row, column], [2.0, 0.0]), base.frame[0]);
            let bent = 2.0 * dot(change(&|base| base.frame[2], [1.0, 0.0]), base.frame[0]);
            assert!((turned - bent).abs() < 1e-9, "{row} {column}: {turned} {bent}");
        }
    }

    /// The body lies on the ground or above it, and no turn runs through another.
    #[test]
    fn turns_do_not_meet() {
        let body = Body::new();
        let rings: Vec<&Ring> = body.rings.iter().step_by(40).collect();
        for (number, one) in rings.iter().enumerate() {
            assert!(one.middle[2] > -1e-9, "{number}: {one:?}");
            // Beyond half a turn along the body.
            for other in rings.iter().skip(number + 8) {
                let apart = length(difference(one.middle, other.middle));
                let far = (other.middle[2] - one.middle[2]).abs() > 1.5 || apart > 3.0;
                let least = if far { one.radius + other.radius } else { 0.0 };
                assert!(apart > 0.95 * least, "{number}: {apart} {one:?} {other:?}");
            }
        }
    }
}
