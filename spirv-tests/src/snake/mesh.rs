//! A mesh of bilinear patches that rays hit exactly, under a pyramid of boxes.

use crate::imaging::vector::{cross, difference, dot, scaled, sum, unit, Vector};

/// A grid of points that is closed around: each four neighbors span a bilinear patch.
#[derive(Clone, Debug)]
pub struct Mesh {
    columns: usize,
    points: Vec<[f32; 3]>,
    /// Boxes of patches, then of squares of 2 × 2 of those, up to the whole.
    levels: Vec<Boxes>,
}

#[derive(Clone, Debug)]
struct Boxes {
    rows: usize,
    columns: usize,
    boxes: Vec<[[f32; 3]; 2]>,
}

/// Where a ray comes to the mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// The multiple of the ray's way.
    pub along: f64,
    /// Row and column of the place, between those of points.
    pub place: [f64; 2],
    /// The patch's unit normal there: rows to columns by the right hand.
    pub normal: Vector,
}

/// A ray with what is needed of it again and again.
struct Line {
    from: Vector,
    way: Vector,
    inverse: Vector,
    /// Two directions across the way and each other.
    across: [Vector; 2],
}

/// Parts of a patch that are on it: neighbors overlap, lest rounding leaves gaps.
const EDGES: std::ops::RangeInclusive<f64> = -1e-9..=1.0 + 1e-9;

impl Line {
    fn new(from: Vector, way: Vector) -> Self {
        // The axis that is least along the way.
        let least = (0..3).min_by(|&a, &b| way[a].abs().total_cmp(&way[b].abs())).unwrap_or(0);
        let mut axis = [0.0; 3];
        axis[least] = 1.0;
        let first = unit(cross(way, axis));
        // Of a part of 0 the largest inverse that is a number: 0 times it is no NaN.
        let inverse = way.map(|part| (1.0 / part).clamp(f64::MIN, f64::MAX));
        Self { from, way, inverse, across: [first, unit(cross(way, first))] }
    }

    /// Where the ray enters a box, if it does before `end`.
    fn enters(&self, [low, high]: &[[f32; 3]; 2], end: f64) -> Option<f64> {
        let (mut enter, mut leave) = (0.0f64, end);
        for axis in 0..3 {
            let one = (f64::from(low[axis]) - self.from[axis]) * self.inverse[axis];
            let other = (f64::from(high[axis]) - self.from[axis]) * self.inverse[axis];
            enter = enter.max(one.min(other));
            leave = leave.min(one.max(other));
        }
        // Boxes of flat patches are flat: rounding must not miss them.
        (enter <= leave * (1.0 + 1e-12)).then_some(enter)
    }
}

impl Mesh {
    /// The mesh of `points`, row by row with `columns` each.
    pub fn new(columns: usize, points: Vec<[f32; 3]>) -> Self {
        let rows = points.len() / columns - 1;
        let corners = |index: usize| {
            let (row, column) = (index / columns, index % columns);
            let next = (column + 1) % columns;
            [[row, column], [row, next], [row + 1, column], [row + 1, next]].map(|[row, column]| {
                let point = points[row * columns + column];
                [point, point]
            })
        };
        let patches = Boxes { rows, columns, boxes: (0..rows * columns).map(|index| united(corners(index))).collect() };
        let levels = std::iter::successors(Some(patches), Boxes::halved).collect();
        Self { columns, points, levels }
    }

    /// Where a ray first comes to the mesh, from whichever side.
    pub fn hit(&self, from: Vector, way: Vector) -> Option<Hit> {
        let line = Line::new(from, way);
        let (mut found, mut end) = (None, f64::INFINITY);
        let mut open = vec![(0.0, self.levels.len() - 1, 0, 0)];
        while let Some((enter, level, row, column)) = open.pop() {
            if enter > end {
                continue;
            }
            if level == 0 {
                if let Some(hit) = self.patch(&line, row, column, end) {
                    end = hit.along;
                    found = Some(hit);
                }
                continue;
            }
            let below = &self.levels[level - 1];
            let start = open.len();
            for (row, column) in
                [[0, 0], [0, 1], [1, 0], [1, 1]].map(|[down, right]| (2 * row + down, 2 * column + right))
            {
                if row < below.rows && column < below.columns {
                    if let Some(enter) = line.enters(&below.boxes[row * below.columns + column], end) {
                        open.push((enter, level - 1, row, column));
                    }
                }
            }
            // The nearest last, to be looked at first.
            open[start..].sort_by(|one, other| other.0.total_cmp(&one.0));
        }
        found
    }

    /// Where a ray comes to a patch before `end`.
    ///
    /// Seen along the ray the patch is flat, and the ray a point: where bilinear weights mix the corners into it.
    fn patch(&self, line: &Line, row: usize, column: usize, end: f64) -> Option<Hit> {
        let next = (column + 1) % self.columns;
        let point =
            |row: usize, column: usize| difference(self.points[row * self.columns + column].map(f64::from), line.from);
        let corners = [point(row, column), point(row, next), point(row + 1, column), point(row + 1, next)];
        let [a, b, c, d] = corners.map(|corner| line.across.map(|axis| dot(axis, corner)));
        for axis in 0..2 {
            let sides = [a, b, c, d].map(|corner| corner[axis]);
            if sides.iter().all(|&side| side > 0.0) || sides.iter().all(|&side| side < 0.0) {
                return None;
            }
        }
        // a + right u + down v + both u v = 0, u along the row and v to the next.
        let minus = |one: [f64; 2], other: [f64; 2]| [one[0] - other[0], one[1] - other[1]];
        let (right, down) = (minus(b, a), minus(c, a));
        let both = minus(minus(d, b), down);
        let turn = |one: [f64; 2], other: [f64; 2]| one[0] * other[1] - one[1] * other[0];
        let roots = roots(turn(right, both), turn(a, both) + turn(right, down), turn(a, down));
        let mut nearest: Option<Hit> = None;
        for u in roots.into_iter().filter(|root| EDGES.contains(root)) {
            let side = [down[0] + both[0] * u, down[1] + both[1] * u];
            let start = [a[0] + right[0] * u, a[1] + right[1] * u];
            let axis = usize::from(side[0].abs() < side[1].abs());
            let v = -start[axis] / side[axis];
            if !EDGES.contains(&v) {
                continue;
            }
            let mix = |one: Vector, other: Vector, part: f64| sum(scaled(one, 1.0 - part), scaled(other, part));
            let ends = [mix(corners[0], corners[1], u), mix(corners[2], corners[3], u)];
            let along = dot(mix(ends[0], ends[1], v), line.way) / dot(line.way, line.way);
            if along > 0.0 && along < nearest.map_or(end, |hit| hit.along) {
                let over_row = difference(mix(corners[1], corners[3], v), mix(corners[0], corners[2], v));
                let normal = unit(cross(difference(ends[1], ends[0]), over_row));
                nearest = Some(Hit { along, place: [row as f64 + v, column as f64 + u], normal });
            }
        }
        nearest
    }
}

/// The real roots of a x² + b x + c; NaN where there is none.
fn roots(a: f64, b: f64, c: f64) -> [f64; 2] {
    let under = b * b - 4.0 * a * c;
    // The larger part without a difference of near numbers; what is no number passes no comparison.
    let part = -0.5 * (b + under.sqrt().copysign(b));
    [part / a, c / part]
}

fn united<const N: usize>(boxes: [[[f32; 3]; 2]; N]) -> [[f32; 3]; 2] {
    let empty = [[f32::INFINITY; 3], [f32::NEG_INFINITY; 3]];
    boxes.iter().fold(empty, |[low, high], next| {
        [
            std::array::from_fn(|axis| low[axis].min(next[0][axis])),
            std::array::from_fn(|axis| high[axis].max(next[1][axis])),
        ]
    })
}

impl Boxes {
    /// Boxes of 2 × 2 of these; None for one.
    fn halved(&self) -> Option<Self> {
        let (rows, columns) = (self.rows.div_ceil(2), self.columns.div_ceil(2));
        let square = |index: usize| {
            let (row, column) = (2 * (index / columns), 2 * (index % columns));
            let (last_row, last_column) = ((row + 1).min(self.rows - 1), (column + 1).min(self.columns - 1));
            united(
                [[row, column], [row, last_column], [last_row, column], [last_row, last_column]]
                    .map(|[row, column]| self.boxes[row * self.columns + column]),
            )
        };
        (self.rows * self.columns > 1).then(|| Self { rows, columns, boxes: (0..rows * columns).map(square).collect() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::imaging::vector::length;
    use crate::random::Random;
    use std::f64::consts::TAU;

    const ROWS: usize = 37;
    const COLUMNS: usize = 21;

    /// A tube with bumps.
    fn tube() -> Mesh {
        let mut random = Random::new(3);
        let point = |index: usize| {
            let (sine, cosine) = (TAU * (index % COLUMNS) as f64 / COLUMNS as f64).sin_cos();
            let radius = 0.7 + 0.3 * random.unit();
            [(index / COLUMNS) as f64 * 0.1, radius * cosine, radius * sine].map(|part| part as f32)
        };
        Mesh::new(COLUMNS, (0..ROWS * COLUMNS).map(point).collect())
    }

    /// The point of a place by the definition of bilinear patches.
    fn point(mesh: &Mesh, [row, column]: [f64; 2]) -> Vector {
        let first = [(row as usize).min(ROWS - 2), (column as usize).min(COLUMNS - 1)];
        let part = [row - first[0] as f64, column - first[1] as f64];
        let mut sum = [0.0; 3];
        for (down, right) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            let weight = |step: usize, part: f64| if step == 1 { part } else { 1.0 - part };
            let corner = mesh.points[(first[0] + down) * COLUMNS + (first[1] + right) % COLUMNS];
            for (total, value) in sum.iter_mut().zip(corner) {
                *total += weight(down, part[0]) * weight(right, part[1]) * f64::from(value);
            }
        }
        sum
    }

    /// Rays to points of the mesh come to it there or before; where they come to it the mesh is, with that normal.
    #[test]
    fn rays_miss_nothing() {
        let (mesh, mut random) = (tube(), Random::new(4));
        let mut before = 0;
        for number in 0..4000 {
            let place = [(ROWS - 1) as f64 * random.unit(), COLUMNS as f64 * random.unit()];
            let target = point(&mesh, place);
            let mut around = || 8.0 * random.unit() - 4.0;
            let from = [around() + 2.0, around(), around()];
            let way = difference(target, from);
            let Some(hit) = mesh.hit(from, way) else { panic!("ray {number} to {place:?} is not hit") };
            assert!(hit.along < 1.0 + 1e-9, "{number}: {}", hit.along);
            before += usize::from(hit.along < 1.0 - 1e-9);
            let found = sum(from, scaled(way, hit.along));
            assert!(length(difference(found, point(&mesh, hit.place))) < 1e-9, "{number}: {hit:?}");
            let [row, column] = hit.place;
            let inside = |part: f64| part.fract() > 1e-3 && part.fract() < 1.0 - 1e-3;
            if inside(row) && inside(column) {
                let step = 1e-4;
                let change = |[down, right]: [f64; 2]| {
                    let ends = [1.0, -1.0].map(|sign| point(&mesh, [row + sign * down, column + sign * right]));
                    difference(ends[0], ends[1])
                };
                let normal = unit(cross(change([step, 0.0]), change([0.0, step])));
                assert!(length(difference(normal, hit.normal)) < 1e-6, "{number}: {normal:?} {hit:?}");
            }
        }
        assert!((500..3500).contains(&before), "{before} rays are hit before their points");
    }

    /// What is beside the mesh, before it and behind the eye is not hit.
    #[test]
    fn rays_beside_the_mesh_pass() {
        let mesh = tube();
        assert_eq!(mesh.hit([1.0, 0.0, 5.0], [0.3, 1.0, 0.05]), None);
        assert_eq!(mesh.hit([1.0, 0.0, 5.0], [0.0, 0.1, 1.0]), None);
        assert!(mesh.hit([1.0, 0.0, 5.0], [0.0, 0.1, -1.0]).is_some());
    }

    #[test]
    fn roots_of_parabolas_and_lines() {
        let mut found = roots(2.0, -3.0, 1.0);
        found.sort_by(f64::total_cmp);
        assert_eq!(found, [0.5, 1.0]);
        assert!(roots(0.0, -4.0, 1.0).contains(&0.25));
        assert!(roots(1.0, 0.0, 1.0).iter().all(|root| root.is_nan()));
    }
}
