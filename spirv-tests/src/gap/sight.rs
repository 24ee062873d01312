//! What of a height field is in sight along its rows, exactly, on the profile of straight segments between nodes.

use super::field::Field;
use super::histogram::Histogram;
use std::f64::consts::SQRT_2;

/// A visibility parameter so large that all is in sight and every part counts by its length.
pub const OVERHEAD: f64 = 1e7;

/// Sums over the parts of a field that are in sight.
#[derive(Clone, Debug, Default)]
pub struct Sight {
    /// The heights in sight, by projected area.
    pub heights: Histogram,
    /// The slopes in sight towards the viewer, in deviations of all slopes, by projected area: negative ones face it.
    pub slopes: Histogram,
    /// The length on the ground of the segments that face the viewer.
    pub facing: f64,
    /// The length on the ground of what is in sight.
    pub visible: f64,
    /// The projected area of the segments that face the viewer, hidden or not.
    pub facing_area: f64,
    /// The projected area of the ground.
    pub ground_area: f64,
}

impl Sight {
    /// The field seen from the far end of its rows. Only the parameter a = cot θ / (√2 σ_s) matters: stretching the
    /// heights stretches the slopes of surface and ray alike.
    pub fn along_rows(field: &Field, parameter: f64) -> Self {
        let deviation = field.slope_deviation();
        let ray = SQRT_2 * parameter * deviation;
        let mut sight = Self::default();
        field.rows().for_each(|row| sight.add_row(row, ray, 1.0 / deviation));
        sight
    }

    fn add_row(&mut self, row: &[f64], ray: f64, per_slope: f64) {
        let count = row.len();
        for (index, from) in row.iter().enumerate() {
            let drop = from - row[(index + 1) % count] + ray;
            if drop > 0.0 {
                self.facing += 1.0;
                self.facing_area += drop;
            }
        }
        in_sight(row, ray, |index, area| {
            let (from, to) = (row[index], row[(index + 1) % count]);
            let share = (area / (from - to + ray)).min(1.0);
            self.visible += share;
            self.heights.add_ramp(from, from + share * (to - from), area);
            self.slopes.add_height((to - from) * per_slope, area);
        });
        self.ground_area += ray * count as f64;
    }

    /// Adds the sums of another field.
    pub fn add(&mut self, other: &Self) {
        self.heights.add(&other.heights);
        self.slopes.add(&other.slopes);
        self.facing += other.facing;
        self.visible += other.visible;
        self.facing_area += other.facing_area;
        self.ground_area += other.ground_area;
    }
}

/// Finds the segments of a row that are in sight from its far end, at least in part, with their projected areas.
///
/// Relative to the ray through a node, others sink by `ray` a texel ahead: those that still stand higher hide it.
pub(super) fn in_sight(row: &[f64], ray: f64, mut see: impl FnMut(usize, f64)) {
    let lifted = |index: usize| row[index] - ray * index as f64;
    // Ahead of the row lies the next period, lower by a whole row of rays.
    let mut horizon = (0..row.len()).map(lifted).fold(f64::NEG_INFINITY, f64::max) - ray * row.len() as f64;
    for index in (0..row.len()).rev() {
        let area = lifted(index) - horizon;
        if area > 0.0 {
            see(index, area);
            horizon = lifted(index);
        }
    }
}

/// A point as a distant viewer finds it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Point {
    /// It lies on a slope that faces away.
    Averted,
    /// It faces the viewer but others hide it.
    Hidden,
    /// It is in sight.
    Visible,
}

/// The middles of the segments as seen from the far end of their rows, or from the near end.
pub fn middles(field: &Field, parameter: f64, from_near_end: bool) -> Vec<Point> {
    let ray = SQRT_2 * parameter * field.slope_deviation();
    let mut points = Vec::with_capacity(field.heights.len());
    for row in field.rows() {
        let count = row.len();
        let at = |step: usize| row[if from_near_end { step } else { count - step } % count];
        // Steps lead away from the viewer: hidden is what lies below the rays over the nodes before.
        let lifted = |step: usize| at(step) + ray * step as f64;
        let mut horizon = (1..=count).map(lifted).fold(f64::NEG_INFINITY, f64::max) - ray * count as f64;
        let start = points.len();
        for step in 1..=count {
            let (before, after) = (lifted(step - 1), lifted(step));
            points.push(match after > before {
                false => Point::Averted,
                true if 0.5 * (before + after) <= horizon => Point::Hidden,
                true => Point::Visible,
            });
            horizon = horizon.max(after);
        }
        if !from_near_end {
            points[start..].reverse();
        }
    }
    points
}
