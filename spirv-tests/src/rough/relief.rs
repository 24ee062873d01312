//! The whole surface as a relief that rays hit exactly: bilinear cells over a period of it, under a pyramid of maxima.

use super::surface::Surface;
use std::f64::consts::TAU;

/// Nodes a side of a period: the shortest wave has 21.
const NODES: usize = 2048;

/// How far a ray is pushed over the boundary of a cell, in cells: positions up to 1e6 are rounded to less.
const NUDGE: f64 = 1e-7;

/// The level that rays start at.
const START: usize = 4;

/// A periodic square of bilinear cells.
#[derive(Clone, Debug)]
pub struct Relief {
    /// Heights of the nodes, row by row.
    heights: Vec<f32>,
    /// Largest heights: of the cells, then of squares of 2 × 2 of those, up to the whole.
    largest: Vec<Vec<f32>>,
    /// Ground between nodes.
    spacing: f64,
}

impl Relief {
    /// The relief of a surface. Between nodes it differs from the waves by 0.0012 of the heights' deviation, RMS, as
    /// its test measures.
    pub fn new(surface: &Surface) -> Self {
        let mut heights = vec![0.0; NODES * NODES];
        for wave in &surface.waves {
            let table: Vec<f64> =
                (0..NODES).map(|node| wave.amplitude * (TAU * node as f64 / NODES as f64 + wave.phase).cos()).collect();
            let [across, down] = wave.periods.map(|count| count.rem_euclid(NODES as i32) as usize);
            for (row, nodes) in heights.chunks_exact_mut(NODES).enumerate() {
                let mut at = row * down % NODES;
                for height in nodes {
                    *height += table[at];
                    at = (at + across) % NODES;
                }
            }
        }
        let heights: Vec<f32> = heights.into_iter().map(|height| height as f32).collect();
        Self { largest: pyramid(&heights), heights, spacing: surface.period / NODES as f64 }
    }

    /// The greatest height.
    pub fn top(&self) -> f64 {
        f64::from(self.largest[self.largest.len() - 1][0])
    }

    /// The height over a place.
    pub fn height(&self, place: [f64; 2]) -> f64 {
        let [x, y] = place.map(|part| part / self.spacing);
        self.patch([x.floor(), y.floor()])([x, y])
    }

    /// Bilinear heights over the cell of a corner.
    fn patch(&self, [left, low]: [f64; 2]) -> impl Fn([f64; 2]) -> f64 {
        let node = |part: f64| (part as i64).rem_euclid(NODES as i64) as usize;
        let (columns, rows) = ([node(left), node(left + 1.0)], [node(low), node(low + 1.0)]);
        let corner = |row: usize, column: usize| f64::from(self.heights[rows[row] * NODES + columns[column]]);
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
        let top = self.top();
        let mut along = if from[2] > top { (top - from[2]) / way[2] } else { 0.0 };
        if along < 0.0 {
            return None;
        }
        let place = |along: f64| [0, 1].map(|axis| (from[axis] + along * way[axis]) / self.spacing);
        let level_at = |along: f64| from[2] + along * way[2];
        let nudge = NUDGE * self.spacing / way[0].hypot(way[1]).max(1e-9);
        let mut level = START;
        loop {
            let at = place(along);
            let size = (1u64 << level) as f64;
            let corner = at.map(|part| (part / size).floor());
            let leave = |axis: usize| match way[axis] {
                0.0 => f64::INFINITY,
                step => {
                    let edge = (corner[axis] + f64::from(step > 0.0)) * size;
                    (edge * self.spacing - from[axis]) / step
                }
            };
            // A ray straight down leaves no cell, but is below all at the mirrored top and bottom.
            let end = leave(0).min(leave(1)).min(along + 4.0 * top / way[2].abs().max(1e-9)).max(along);
            let lowest = level_at(along).min(level_at(end));
            let side = NODES >> level;
            let [column, row] = corner.map(|part| (part as i64).rem_euclid(side as i64) as usize);
            if lowest > f64::from(self.largest[level][row * side + column]) {
                along = end + nudge;
                if way[2] > 0.0 && level_at(along) > top {
                    return None;
                }
                level = (level + 1).min(self.largest.len() - 1);
            } else if level > 0 {
                level -= 1;
            } else {
                let patch = self.patch(corner);
                let above = |along: f64| level_at(along) - patch(place(along));
                if let Some(part) = first_root([above(along), above(0.5 * (along + end)), above(end)]) {
                    return Some(along + part * (end - along));
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

fn pyramid(heights: &[f32]) -> Vec<Vec<f32>> {
    let node = |row: usize, column: usize| heights[row % NODES * NODES + column % NODES];
    let cell = |index: usize| {
        let (row, column) = (index / NODES, index % NODES);
        let corners = [[0, 0], [0, 1], [1, 0], [1, 1]].map(|[down, across]| node(row + down, column + across));
        corners.into_iter().fold(f32::MIN, f32::max)
    };
    let cells: Vec<f32> = (0..NODES * NODES).map(cell).collect();
    std::iter::successors(Some(cells), |finer| {
        let wide = finer.len().isqrt();
        let side = wide / 2;
        let square = |index: usize| {
            let corner = index / side * 2 * wide + index % side * 2;
            [0, 1, wide, wide + 1].map(|next| finer[corner + next]).into_iter().fold(f32::MIN, f32::max)
        };
        (side > 0).then(|| (0..side * side).map(square).collect())
    })
    .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;

    fn relief() -> (Surface, Relief) {
        let surface = Surface::new(1);
        let relief = Relief::new(&surface);
        (surface, relief)
    }

    /// What the cells between nodes cost, in deviations of the heights.
    #[test]
    fn cells_are_near_the_waves() {
        let (surface, relief) = relief();
        let mut random = Random::new(7);
        let errors = (0..10_000).map(|_| {
            let place = [0, 1].map(|_| (4.0 * random.unit() - 2.0) * surface.period);
            relief.height(place) - surface.height(place)
        });
        let rms = (errors.map(|error| error * error).sum::<f64>() / 1e4).sqrt();
        println!("cells differ from the waves by {rms:.5} of the heights' deviation, RMS");
        assert!(rms < 0.0015, "{rms}");
    }

    /// Rays by small steps over the same cells: none comes to the surface earlier, and where they are hit it is.
    #[test]
    fn rays_miss_nothing() {
        let (surface, relief) = relief();
        let mut random = Random::new(8);
        let mut hits = 0;
        for number in 0..400 {
            let turn = 6.3 * random.unit();
            let rise = if number % 2 == 0 { -0.02 - random.unit() } else { 0.02 + 0.4 * random.unit() };
            let way = [turn.cos(), turn.sin(), rise];
            let place = [0, 1].map(|_| random.unit() * surface.period);
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
                hits += 1;
            }
        }
        assert!((250..400).contains(&hits), "{hits} rays are hit");
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
        let (_, relief) = relief();
        let place = [0.3, 170.1];
        let Some(along) = relief.hit([place[0], place[1], 10.0], [0.0, 0.0, -1.0]) else { panic!("nothing below") };
        assert!((10.0 - along - relief.height(place)).abs() < 1e-9);
        let level = Relief::new(&Surface { waves: Vec::new(), period: 100.0 });
        assert_eq!(level.hit([0.0, 0.0, 0.5], [0.3, 0.2, 0.1]), None);
        let Some(along) = level.hit([0.0, 0.0, 2.0], [1.0, 0.5, -0.25]) else { panic!("nothing below") };
        assert!((along - 8.0).abs() < 1e-9);
    }
}
