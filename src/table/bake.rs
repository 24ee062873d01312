//! Tables of a map's means over normal and bounded values or over visible heights, baked in f64 and judged by a second
//! quadrature.

use std::sync::OnceLock;

use super::grid::{Axis, Spacing};
use super::lattice::{Judged, Lattice, FLAT};
use super::learned::Learned;
use super::strip::Strip;
use super::Table;
use crate::reference::beta::Beta;
use crate::reference::height;
use crate::reference::heights::lambda_of_skewness;
use crate::reference::texture::{mean_by_parts, PiecewiseLinear};

/// The slices of a table of heights, even in the skewness up to that of a Λ of 1e4: they stand in
/// `wgsl/filter/height.wgsl` too.
const SLICES: Axis = Axis { low: 0.0, high: 0.862467, count: 4, spacing: Spacing::Linear };

/// The smallest deviation that tables of values are judged at: the shelf's floor.
const FLOOR: f64 = 1e-6;

/// A map, the axes of its table, and what the table is judged over.
#[derive(Clone, Copy)]
pub(crate) struct Plan<'a> {
    /// The map.
    pub map: &'a PiecewiseLinear,
    /// The columns.
    pub means: Axis,
    /// The rows.
    pub deviations: Axis,
    /// The means that occur; those beyond the axis read the border.
    pub judged: (f32, f32),
}

/// The normal distribution.
fn normal() -> &'static Strip {
    static NORMAL: OnceLock<Strip> = OnceLock::new();
    NORMAL.get_or_init(|| Strip::new(0.0))
}

/// The distributions of each slice and of each middle between two, which are the same for every map.
fn strips() -> &'static [Strip] {
    static STRIPS: OnceLock<Vec<Strip>> = OnceLock::new();
    STRIPS.get_or_init(|| {
        let halves = 0..2 * SLICES.count - 1;
        halves.map(|half| Strip::new(lambda_of_skewness(SLICES.value(0.5 * half as f64)))).collect()
    })
}

/// Where a map bends.
pub(super) fn bends(map: &PiecewiseLinear) -> Vec<f64> {
    map.knots.iter().map(|knot| knot.0).collect()
}

/// The smallest and the largest value of each channel.
type Hull = [[f64; 2]; 4];

/// That of a map.
fn hull(map: &PiecewiseLinear) -> Hull {
    std::array::from_fn(|channel| {
        let values = map.knots.iter().flat_map(|knot| [knot.1[channel], knot.2[channel]]);
        [values.clone().fold(f64::INFINITY, f64::min), values.fold(f64::NEG_INFINITY, f64::max)]
    })
}

/// The nearest color in a hull: sums of what stops close to each other leave round beyond it.
fn inside(hull: &Hull, color: [f64; 4]) -> [f64; 4] {
    std::array::from_fn(|channel| color[channel].clamp(hull[channel][0], hull[channel][1]))
}

impl Plan<'_> {
    /// A table of means over normal values, with its error as measured; not baked where its narrowest rows err by more
    /// than `most`.
    pub(crate) fn of_values(self, name: &str, most: f32) -> Table {
        let (lattice, normal) = (self.lattice(FLAT), normal());
        if let Some(error) = self.narrow_error_beyond(FLOOR, most) {
            return lattice.unbaked(name, error);
        }
        let hull = hull(self.map);
        let texels = lattice.texels(|_, deviation| move |mean| inside(&hull, normal.color(self.map, mean, deviation)));
        let error = self.judge(lattice, FLOOR, &texels, normal);
        lattice.table(name, texels, error)
    }

    /// A table of means over Beta distributions between the ends of the columns, with its error as measured; its rows
    /// are parts of the largest deviation that a mean has.
    pub(crate) fn of_bounded_values(self, name: &str) -> Table {
        let lattice = self.lattice(FLAT);
        let Axis { low, high, .. } = self.means;
        let beta = |mean: f64, part: f64| Beta::new([low, high], mean, part * ((mean - low) * (high - mean)).sqrt());
        let near = |part: f64| move |mean: f64| beta(mean, part).mean(self.map);
        let truth = |mean: f64, part: f64| beta(mean, part).mean_by_parts(self.map);
        let texels = lattice.texels(|_, part| near(part));
        let judged = Judged { low, high, least: FLOOR, third: 0.0 };
        let error = lattice.error(&texels, &bends(self.map), judged, near, truth);
        lattice.table(name, texels, error)
    }

    /// A table of means over values as those of an image, with its error as measured between texels.
    pub(crate) fn of_learned_values(self, name: &str, image: &Learned) -> Table {
        let (lattice, normal) = (self.lattice(FLAT), normal());
        let lesson = image.lesson(self.map, |mean, deviation| normal.color(self.map, mean, deviation));
        let hull = hull(self.map);
        let taught = |color: [f64; 4], mean: f64, deviation: f64| -> [f64; 4] {
            let more = lesson.at(mean, deviation);
            inside(&hull, std::array::from_fn(|channel| color[channel] + more[channel]))
        };
        let taught = &taught;
        let near = |deviation: f64| move |mean: f64| taught(normal.color(self.map, mean, deviation), mean, deviation);
        let truth = |mean: f64, deviation: f64| taught(mean_by_parts(self.map, mean, deviation), mean, deviation);
        let texels = lattice.texels(|_, deviation| near(deviation));
        let judged = Judged { low: self.judged.0.into(), high: self.judged.1.into(), least: FLOOR, third: 0.0 };
        let error = lattice.error(&texels, &bends(self.map), judged, near, truth);
        lattice.table(name, texels, error)
    }

    /// A table of means over visible heights, a slice a skewness, with its error as measured for deviations of all
    /// heights from `floor` on: on the first slice and between slices. Not baked where the narrowest rows of all
    /// heights err by more than `most`.
    pub(crate) fn of_heights(self, name: &str, floor: f64, most: f32) -> Table {
        let lattice = self.lattice(SLICES);
        if let Some(error) = self.narrow_error_beyond(floor, most) {
            return lattice.unbaked(name, error);
        }
        let strips = strips();
        let hull = hull(self.map);
        let color = |slice: usize, mean: f64, deviation: f64| strips[2 * slice].color(self.map, mean, deviation);
        let color = &color;
        let texels = lattice.texels(|slice, deviation| move |mean| inside(&hull, color(slice, mean, deviation)));
        let judged = strips.iter().take(1).chain(strips.iter().skip(1).step_by(2));
        let error = judged.map(|strip| self.judge(lattice, floor, &texels, strip)).fold(0.0, f32::max);
        lattice.table(name, texels, error)
    }

    /// The error of the rows up to the first beyond `floor`, of all values or heights, if it is more than `most`. The
    /// whole table has these rows, so that it errs by no less; all others are left out then, and `most` is what a table
    /// may err by for its bound, twice the error and what the tier adds, to be within what may be chosen.
    fn narrow_error_beyond(self, floor: f64, most: f32) -> Option<f32> {
        if most == f32::INFINITY {
            return None;
        }
        let rows = self.deviations.number(floor).ceil() as usize + 1;
        let first = Self { deviations: self.deviations.first(rows.max(2)), ..self };
        let (lattice, normal) = (first.lattice(FLAT), normal());
        let hull = hull(self.map);
        let texels = lattice.texels(|_, deviation| move |mean| inside(&hull, normal.color(self.map, mean, deviation)));
        Some(first.judge(lattice, floor, &texels, normal)).filter(|error| *error > most)
    }

    fn lattice(self, slices: Axis) -> Lattice {
        Lattice([self.means, self.deviations, slices])
    }

    /// The error for one distribution, for deviations of all values from `floor` on.
    fn judge(self, lattice: Lattice, floor: f64, texels: &[f32], strip: &Strip) -> f32 {
        let (low, high) = (f64::from(self.judged.0), f64::from(self.judged.1));
        let judged = Judged { low, high, least: floor * strip.deviation, third: strip.skewness };
        let near = |line: f64| move |at: f64| strip.color(self.map, at, line);
        let truth = |at: f64, line: f64| {
            let scale = line / strip.deviation;
            height::mean_by_parts(self.map, at - scale * strip.mean, scale, strip.lambda)
        };
        lattice.error(texels, &bends(self.map), judged, near, truth)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A table that is given up errs by no more than the whole would, and one that is close enough has its texels.
    #[test]
    fn a_part_of_a_table_tells_that_it_is_not_worth_its_baking() {
        let (black, white) = ([0.0, 0.3, 1.0, 1.0], [1.0, 0.4, 0.0, 1.0]);
        let map = PiecewiseLinear { knots: vec![(0.1, black, black), (0.433, white, black), (0.9, white, white)] };
        let means = Axis { low: -0.5, high: 1.5, count: 64, spacing: Spacing::Linear };
        let deviations = Axis { low: 0.0, high: 0.5, count: 16, spacing: Spacing::CubeRoot };
        let plan = Plan { map: &map, means, deviations, judged: (-0.5, 1.5) };
        let of_heights = |most| plan.of_heights("table", 2e-3, most);
        let bakes: [&dyn Fn(f32) -> Table; 2] = [&|most| plan.of_values("table", most), &of_heights];
        for bake in bakes {
            let (whole, part) = (bake(f32::INFINITY), bake(0.1));
            assert!(whole.is_baked() && !part.is_baked() && whole.bytes() == part.bytes());
            assert!((0.1..=whole.error).contains(&part.error), "{} {}", part.error, whole.error);
            assert_eq!(bake(whole.error), whole);
        }
    }

    /// Rows of parts of the largest deviation are several times as close as rows of deviations, along whose columns the
    /// color bends where all values are at the ends.
    #[test]
    fn bounded_values_are_read_by_parts_of_the_largest_deviation() {
        let color = |value: f64| [value, 1.0 - value, value * value, 1.0];
        let knots = (0..=10).map(|knot| 0.1 * f64::from(knot)).map(|at| (at, color(at * at), color(at * at))).collect();
        let map = PiecewiseLinear { knots };
        let means = Axis { low: 0.0, high: 1.0, count: 128, spacing: Spacing::Linear };
        let parts = Axis { low: 0.0, high: 1.0, count: 16, spacing: Spacing::SquareRoot };
        let by_parts = Plan { map: &map, means, deviations: parts, judged: (0.0, 1.0) }.of_bounded_values("table");
        let deviations = Axis { low: 0.0, high: 0.5, count: 16, spacing: Spacing::CubeRoot };
        let lattice = Lattice([means, deviations, FLAT]);
        let near = |deviation: f64| {
            let map = &map;
            move |mean: f64| Beta::new([0.0, 1.0], mean, deviation).mean(map)
        };
        let truth = |mean: f64, deviation: f64| Beta::new([0.0, 1.0], mean, deviation).mean_by_parts(&map);
        let texels = lattice.texels(|_, deviation| near(deviation));
        let judged = Judged { low: 0.0, high: 1.0, least: FLOOR, third: 0.0 };
        let by_deviations = lattice.error(&texels, &bends(&map), judged, near, truth);
        assert!(by_parts.error * 3.0 < by_deviations, "{} {by_deviations}", by_parts.error);
    }
}
