//! Levels of an image's moments, each of half the size of the one above.

use crate::table::Level;

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
