//! A surface as a relief that rays hit exactly: bilinear cells over a period of it, under a pyramid of maxima.

/// How far a ray is pushed over the boundary of a cell, in cells: positions up to 1e6 are rounded to less.
const NUDGE: f64 = 1e-7;

/// The level that rays start at.
const START: usize = 4;

/// A periodic rectangle of bilinear cells.
#[derive(Clone, Debug)]
pub struct Relief {
    /// Nodes along x and along y.
    sides: [usize; 2],
    /// Heights of the nodes, row by row.
    heights: Vec<f32>,
    /// Largest heights: of the cells, then of squares of 2 × 2 of those, as long as they fill the period.
    largest: Vec<Vec<f32>>,
    /// The greatest height and the lowest.
    ends: [f64; 2],
    /// Ground between nodes, along both axes.
    spacing: [f64; 2],
}

impl Relief {
    /// The relief whose nodes have these heights, row by row; the first is at the origin.
    pub fn new(sides: [usize; 2], heights: Vec<f32>, spacing: [f64; 2]) -> Self {
        let end = |pick: fn(f32, f32) -> f32| heights.iter().copied().reduce(pick).map_or(f64::NAN, f64::from);
        let ends = [end(f32::max), end(f32::min)];
        Self { sides, largest: pyramid(sides, &heights), heights, ends, spacing }
    }

    /// The greatest height.
    pub fn top(&self) -> f64 {
        self.ends[0]
    }

    /// The height over a place.
    pub fn height(&self, place: [f64; 2]) -> f64 {
        let at = self.cells(place);
        self.patch(at.map(f64::floor))(at)
    }

    /// The slopes along both axes over a place.
    pub fn slope(&self, place: [f64; 2]) -> [f64; 2] {
        let at = self.cells(place);
        let corner = at.map(f64::floor);
        let patch = self.patch(corner);
        // Bilinear heights are straight along either axis.
        let ends = |axis: usize| {
            let end =
                |side: f64| std::array::from_fn(|other| if other == axis { corner[axis] + side } else { at[other] });
            [end(0.0), end(1.0)]
        };
        std::array::from_fn(|axis| {
            let [start, stop] = ends(axis).map(&patch);
            (stop - start) / self.spacing[axis]
        })
    }

    /// A place in cells.
    fn cells(&self, place: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|axis| place[axis] / self.spacing[axis])
    }

    /// Bilinear heights over the cell of a corner.
    fn patch(&self, [left, low]: [f64; 2]) -> impl Fn([f64; 2]) -> f64 {
        let [wide, deep] = self.sides;
        let node = |part: f64, side: usize| {
            let first = (part as i64).rem_euclid(side as i64) as usize;
            [first, if first + 1 == side { 0 } else { first + 1 }]
        };
        let (columns, rows) = (node(left, wide), node(low, deep));
        let corner = |row: usize, column: usize| f64::from(self.heights[rows[row] * wide + columns[column]]);
        let [[a, b], [c, d]] = [[corner(0, 0), corner(0, 1)], [corner(1, 0), corner(1, 1)]];
        move |[x, y]| {
            let (across, up) = (x - left, y - low);
            let (near, far) = (a + across * (b - a), c + across * (d - c));
            near + up * (far - near)
        }
    }

    /// Where a ray first comes to the surface, as a multiple of its way. None where it rises above everything.
    ///
    /// A ray passes over a square at once where it is higher than all of it, and is solved for in every cell that is
    /// left: nothing is stepped over.
    pub fn hit(&self, from: [f64; 3], way: [f64; 3]) -> Option<f64> {
        self.hit_within(from, way, f64::INFINITY)
    }

    /// The same up to a multiple of the way; none where it does not come to the surface before.
    pub fn hit_within(&self, from: [f64; 3], way: [f64; 3], most: f64) -> Option<f64> {
        let top = self.top();
        let mut along = if from[2] > top { (top - from[2]) / way[2] } else { 0.0 };
        if along < 0.0 {
            return None;
        }
        let within = |along: f64| (along <= most).then_some(along);
        let place = |along: f64| self.cells([0, 1].map(|axis| from[axis] + along * way[axis]));
        let level_at = |along: f64| from[2] + along * way[2];
        let nudge = NUDGE * self.spacing[0].min(self.spacing[1]) / way[0].hypot(way[1]).max(1e-9);
        let highest = self.largest.len() - 1;
        let deepest = 2.0 * (top - self.ends[1]) / way[2].abs().max(1e-9);
        let mut level = START.min(highest);
        loop {
            let at = place(along);
            let size = (1u64 << level) as f64;
            let corner = at.map(|part| (part / size).floor());
            let leave = |axis: usize| match way[axis] {
                0.0 => f64::INFINITY,
                step => {
                    let edge = (corner[axis] + f64::from(step > 0.0)) * size;
                    (edge * self.spacing[axis] - from[axis]) / step
                }
            };
            // A ray straight down leaves no cell, but is below all at last.
            let end = leave(0).min(leave(1)).min(along + deepest).max(along);
            let lowest = level_at(along).min(level_at(end));
            let square = |axis: usize| (corner[axis] as i64).rem_euclid((self.sides[axis] >> level) as i64) as usize;
            if lowest > f64::from(self.largest[level][square(1) * (self.sides[0] >> level) + square(0)]) {
                along = end + nudge;
                if along > most || (way[2] > 0.0 && level_at(along) > top) {
                    return None;
                }
                level = (level + 1).min(highest);
            } else if level > 0 {
                level -= 1;
            } else {
                let patch = self.patch(corner);
                let above = |along: f64| level_at(along) - patch(place(along));
                if let Some(part) = first_root([above(along), above(0.5 * (along + end)), above(end)]) {
                    return within(along + part * (end - along));
                }
                along = end + nudge;
            }
        }
    }
}

/// The first place in [0, 1] where a parabola with these values at 0, ½ and 1 is not positive.
fn first_root([start, middle, end]: [f64; 3]) -> Option<f64> {
    if start <= 0.0 {
        return Some(0.0);
    }
    let square = 2.0 * start - 4.0 * middle + 2.0 * end;
    let linear = 4.0 * middle - 3.0 * start - end;
    let under = linear * linear - 4.0 * square * start;
    if under < 0.0 {
        return None;
    }
    // The root of the smaller parameter, without a difference of near numbers: start is positive.
    let root = 2.0 * start / (-linear + under.sqrt());
    (root > 0.0 && root <= 1.0).then_some(root)
}

fn pyramid([wide, deep]: [usize; 2], heights: &[f32]) -> Vec<Vec<f32>> {
    let most = |corners: [f32; 4]| corners.into_iter().fold(f32::MIN, f32::max);
    let node = |row: usize, column: usize| heights[row % deep * wide + column % wide];
    let cell = |index: usize| {
        let (row, column) = (index / wide, index % wide);
        most([[0, 0], [0, 1], [1, 0], [1, 1]].map(|[down, across]| node(row + down, column + across)))
    };
    let mut levels: Vec<Vec<f32>> = vec![(0..wide * deep).map(cell).collect()];
    let (mut wide, mut deep) = (wide, deep);
    while wide % 2 == 0 && deep % 2 == 0 {
        let finer = &levels[levels.len() - 1];
        let side = wide / 2;
        let square = |index: usize| {
            let corner = index / side * 2 * wide + index % side * 2;
            most([0, 1, wide, wide + 1].map(|next| finer[corner + next]))
        };
        let coarser = (0..side * (deep / 2)).map(square).collect();
        levels.push(coarser);
        (wide, deep) = (side, deep / 2);
    }
    levels
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;

    /// Hills of several sizes over cells that are no squares, and as many along the axes as do not halve to one.
    fn relief() -> Relief {
        let sides = [96, 160];
        let mut random = Random::new(8);
        let heights = (0..sides[0] * sides[1]).map(|node| {
            let [x, y] = [node % sides[0], node / sides[0]].map(|part| 0.0654498 * part as f64); // τ/96
            (x.sin() + (1.2 * y).cos() + 0.4 * (5.0 * x).cos() * (3.0 * y).sin() + 0.3 * random.unit()) as f32
        });
        Relief::new(sides, heights.collect(), [0.17, 0.23])
    }

    /// Rays by small steps over the same cells: none comes to the surface earlier, and where they are hit it is.
    #[test]
    fn rays_miss_nothing() {
        let relief = relief();
        let mut random = Random::new(8);
        let mut hits = 0;
        for number in 0..400 {
            let turn = 6.3 * random.unit();
            let rise = if number % 2 == 0 { -0.02 - random.unit() } else { 0.02 + 0.4 * random.unit() };
            let way = [turn.cos(), turn.sin(), rise];
            let place = [0, 1].map(|_| 100.0 * random.unit() - 50.0);
            let from = [place[0], place[1], if number % 2 == 0 { 5.0 } else { relief.height(place) + 1e-6 }];
            let at = |along: f64| std::array::from_fn::<f64, 3, _>(|axis| from[axis] + along * way[axis]);
            let under = |along: f64| {
                let [x, y, z] = at(along);
                z < relief.height([x, y]) - 1e-9
            };
            let found = relief.hit(from, way);
            let end = found.unwrap_or(10.0 / rise.abs());
            let early = (1..20_000).map(|step| end * f64::from(step) / 20_000.0).find(|&along| under(along));
            assert_eq!(early, None, "ray {number} is hit at {end}");
            if let Some(along) = found {
                let [x, y, z] = at(along);
                assert!((z - relief.height([x, y])).abs() < 1e-6, "{number}: {z}");
                let [before, behind] = [0.99, 1.01].map(|part| relief.hit_within(from, way, part * along));
                assert!(before.is_none() && behind == found, "{number}: {before:?} {behind:?}");
                hits += 1;
            }
        }
        assert!((230..400).contains(&hits), "{hits} rays are hit");
    }

    #[test]
    fn slopes_are_the_derivatives_of_heights() {
        let (relief, mut random) = (relief(), Random::new(9));
        for _ in 0..100 {
            let place = [0, 1].map(|_| 100.0 * random.unit() - 50.0);
            for (axis, slope) in relief.slope(place).into_iter().enumerate() {
                let moved = |step: f64| relief.height(std::array::from_fn(|a| place[a] + step * f64::from(a == axis)));
                let found = (moved(1e-7) - moved(-1e-7)) / 2e-7;
                assert!((slope - found).abs() < 1e-6, "{place:?}: {slope} {found}");
            }
        }
    }

    #[test]
    fn the_first_root_is_the_first() {
        // (s − 0.25)(s − 0.75), a line, and curves without a root in sight.
        assert_eq!(first_root([0.1875, -0.0625, 0.1875]), Some(0.25));
        assert_eq!(first_root([1.0, 0.5, 0.0]), Some(1.0));
        assert_eq!(first_root([1.0, 0.5, 0.5]), None);
        assert_eq!(first_root([1.0, 2.0, 3.0]), None);
        assert_eq!(first_root([-1.0, 2.0, 3.0]), Some(0.0));
        // 1 + s − 8 s²: one root before and one behind the start.
        let Some(root) = first_root([1.0, -0.5, -6.0]) else { panic!("no root") };
        assert!((1.0 + root - 8.0 * root * root).abs() < 1e-12 && root > 0.0);
    }

    /// A ray straight down and a level surface: the ends of what the traversal can meet.
    #[test]
    fn rays_straight_down_and_level_ground() {
        let relief = relief();
        let place = [0.3, 170.1];
        let Some(along) = relief.hit([place[0], place[1], 10.0], [0.0, 0.0, -1.0]) else { panic!("nothing below") };
        assert!((10.0 - along - relief.height(place)).abs() < 1e-9);
        let level = Relief::new([4, 4], vec![0.0; 16], [25.0, 25.0]);
        assert_eq!(level.hit([0.0, 0.0, 0.5], [0.3, 0.2, 0.1]), None);
        let Some(along) = level.hit([0.0, 0.0, 2.0], [1.0, 0.5, -0.25]) else { panic!("nothing below") };
        assert!((along - 8.0).abs() < 1e-9);
    }
}
