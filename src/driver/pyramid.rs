//! Levels of an image's moments, each of half the size of the one above.

use super::moment_mipmap::Edge;
use crate::table::Level;

/// An image's bilinear reconstruction.
pub(super) struct Reconstruction<'a> {
    pub width: usize,
    pub height: usize,
    /// Row by row.
    pub values: &'a [f32],
    /// What continues it.
    pub edge: Edge,
}

impl Reconstruction<'_> {
    /// The four quarters of a texel's area, in each of which the reconstruction is c + p x + q y + r x y about the
    /// quarter's center, x and y in [−½, ½]: c, p, q and r.
    pub fn quarters(&self, at: usize) -> [[f64; 4]; 4] {
        let (x, y) = (at % self.width, at / self.width);
        [(false, false), (true, false), (false, true), (true, true)].map(|(right, below)| {
            let (side, level) = (self.beside(x, right, self.width), self.beside(y, below, self.height));
            let center = self.value(x, y);
            // Relative to the texel: equal values leave exact zeros.
            let [across, down, corner] =
                [self.value(side, y), self.value(x, level), self.value(side, level)].map(|neighbor| neighbor - center);
            let (across, down, corner) = (0.5 * across, 0.5 * down, 0.25 * (across + down + corner));
            let mean = 0.25 * (across + down + corner);
            let [p, q] = [0.5 * (across - down + corner), 0.5 * (down - across + corner)];
            [center + mean, p, q, corner - across - down]
        })
    }

    fn value(&self, x: usize, y: usize) -> f64 {
        f64::from(self.values[y * self.width + x])
    }

    /// The texel next to one along a side, which may be beyond an edge.
    fn beside(&self, at: usize, forward: bool, size: usize) -> usize {
        match (self.edge, forward) {
            (Edge::Clamp, true) => (at + 1).min(size - 1),
            (Edge::Clamp, false) => at.saturating_sub(1),
            (Edge::Repeat, true) => (at + 1) % size,
            (Edge::Repeat, false) => (at + size - 1) % size,
        }
    }
}

/// Moments of every texel of a level.
pub(super) struct Grid<const N: usize> {
    pub width: usize,
    pub height: usize,
    pub moments: Vec<[f64; N]>,
}

/// The moments of a mixture of parts, whose weights sum to one.
pub(super) type Mix<const N: usize> = fn(&[(f64, [f64; N])]) -> [f64; N];

impl<const N: usize> Grid<N> {
    /// The levels below this one, down to a single texel, whose numbers `texel` gives.
    pub fn halved<const K: usize>(&self, mixed: Mix<N>, texel: impl Fn(&[f64; N]) -> [f32; K]) -> Vec<Level> {
        let mut levels = Vec::new();
        let mut above: Option<Self> = None;
        let (mut w, mut h) = (self.width, self.height);
        while w > 1 || h > 1 {
            (w, h) = ((w / 2).max(1), (h / 2).max(1));
            // Texels that nest in the level above need not go back to the image.
            let nested = above.take().filter(|grid| grid.width % w == 0 && grid.height % h == 0);
            let grid = nested.as_ref().unwrap_or(self).shrunk(w, h, mixed);
            let texels = grid.moments.iter().flat_map(&texel).collect();
            levels.push(Level { width: w as u32, height: h as u32, depth: 1, texels });
            above = Some(grid);
        }
        levels
    }

    /// The same area in fewer texels.
    fn shrunk(&self, width: usize, height: usize, mixed: Mix<N>) -> Self {
        let (columns, rows) = (spans(self.width, width), spans(self.height, height));
        let mut moments = Vec::with_capacity(width * height);
        let mut covered = Vec::new();
        for row in &rows {
            for column in &columns {
                covered.clear();
                for &(y, part) in row {
                    let texels = &self.moments[y * self.width..][..self.width];
                    covered.extend(column.iter().map(|&(x, share)| (part * share, texels[x])));
                }
                moments.push(mixed(&covered));
            }
        }
        Self { width, height, moments }
    }
}

/// Which of `from` texels each of `to` texels covers along one axis, and the share of its length: shares sum to one.
fn spans(from: usize, to: usize) -> Vec<Vec<(usize, f64)>> {
    // In units of 1/(from · to) of the side every edge is an integer.
    let span = |index: usize| {
        let (low, high) = (index * from, (index + 1) * from);
        let texels = low / to..high.div_ceil(to);
        let length = |texel: usize| high.min((texel + 1) * to) - low.max(texel * to);
        texels.map(|texel| (texel, length(texel) as f64 / from as f64)).collect()
    };
    (0..to).map(span).collect()
}
