//! Images as functions: their bilinear reconstruction, its moments over a footprint, and the model of a pyramid's
//! reads.

use super::footprint::{axes, deviations};
use super::quadrature::integrate;

/// What an image is beyond its edges.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Beyond {
    /// The texel at the edge.
    Clamp,
    /// The image again.
    Repeat,
    /// The image mirrored.
    Mirror,
}

/// An image and what is beyond it.
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    /// Texels a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// Values row by row.
    pub values: Vec<f64>,
    /// Beyond the edges.
    pub beyond: Beyond,
}

/// The texel of a side of `size` that stands at a place, by walking there.
fn stands_at(place: i64, size: usize, beyond: Beyond) -> usize {
    let size = size as i64;
    let inside = match beyond {
        Beyond::Clamp => place.clamp(0, size - 1),
        Beyond::Repeat => place.rem_euclid(size),
        Beyond::Mirror => {
            let turn = place.rem_euclid(2 * size);
            turn.min(2 * size - 1 - turn)
        }
    };
    inside as usize
}

impl Image {
    /// The value of the texel at a place, which may be beyond the edges.
    fn texel(&self, x: i64, y: i64) -> f64 {
        let (x, y) = (stands_at(x, self.width, self.beyond), stands_at(y, self.height, self.beyond));
        self.values[y * self.width + x]
    }

    /// The bilinear reconstruction, positions in texels: the sum of the texels, each times a tent about its center.
    pub fn value(&self, x: f64, y: f64) -> f64 {
        let (left, top) = ((x - 0.5).floor(), (y - 0.5).floor());
        let mut sum = 0.0;
        for row in 0..2 {
            for column in 0..2 {
                let (i, j) = (left + f64::from(column), top + f64::from(row));
                let tent = (1.0 - (x - 0.5 - i).abs()) * (1.0 - (y - 0.5 - j).abs());
                sum += tent * self.texel(i as i64, j as i64);
            }
        }
        sum
    }

    /// The mean of a function of the reconstruction over a Gaussian footprint about a position, in texels.
    ///
    /// By the trapezoidal rule in `side`² points within 4.5 deviations along both axes of the footprint, turned a
    /// little so that no row of points lies along a row of texels.
    pub fn mean<const N: usize>(
        &self,
        position: [f64; 2],
        covariance: [f64; 3],
        side: usize,
        function: impl Fn(f64) -> [f64; N],
    ) -> [f64; N] {
        let [major, minor] = deviations(covariance);
        let [long, short] = axes(covariance);
        let (sin, cos) = libm::sincos(0.37);
        let at = |index: usize| 4.5 * ((2 * index + 1) as f64 / side as f64 - 1.0);
        let (mut sum, mut total) = ([0.0; N], 0.0);
        for row in 0..side {
            for column in 0..side {
                let (u, v) = (at(column), at(row));
                let weight = libm::exp(-0.5 * (u * u + v * v));
                let (a, b) = (major * (cos * u - sin * v), minor * (sin * u + cos * v));
                let [x, y] = [0, 1].map(|side| position[side] + a * long[side] + b * short[side]);
                for (sum, value) in sum.iter_mut().zip(function(self.value(x, y))) {
                    *sum += weight * value;
                }
                total += weight;
            }
        }
        sum.map(|sum| sum / total)
    }

    /// Mean and variance of the reconstruction over the area of a texel inside the image, by quadrature.
    pub fn over_texel(&self, x: usize, y: usize) -> [f64; 2] {
        let (x, y) = (x as f64, y as f64);
        // The reconstruction is one polynomial in each quarter: a panel each.
        let mean_of = |function: &dyn Fn(f64) -> f64| {
            let row = |at: f64| integrate(x, x + 1.0, 0.5, |along| [function(self.value(along, at))]);
            let [mean] = integrate(y, y + 1.0, 0.5, row);
            mean
        };
        let mean = mean_of(&|value| value);
        [mean, mean_of(&|value| (value - mean) * (value - mean))]
    }

    /// Mean and deviation that reading a pyramid of the image is to give, from the image alone.
    ///
    /// Level l divides the image into max(size >> l, 1) equal parts a side. Reading it weights the reconstruction by
    /// the areas of the four parts around the position, bilinearly; level 0 is the reconstruction at the position. The
    /// kernel of a level has the variance w²/4, w the longer side of its parts in texels (0 at level 0), and the
    /// levels on either side of half the covariance's trace are mixed to that variance. `texels` are
    /// [`Self::over_texel`] of all texels. Below a texel the plane of the four texels takes over.
    pub fn read(&self, texels: &[[f64; 2]], position: [f64; 2], covariance: [f64; 3]) -> [f64; 2] {
        let [mean, mut variance] = self.mixture(texels, position, covariance);
        let wanted = 0.5 * (covariance[0] + covariance[2]);
        if wanted < 1.0 {
            // All of the plane up to a deviation of ¼, none from 1, linear in the logarithm.
            let texel = [position[0] * self.width as f64, position[1] * self.height as f64];
            let share = (libm::log(wanted.sqrt() / 0.25) / libm::log(4.0)).clamp(0.0, 1.0);
            variance = share * variance + (1.0 - share) * self.plane(texel, covariance);
        }
        [mean, variance.max(0.0).sqrt()]
    }

    /// Mean and variance of the two levels that [`Self::read`] mixes, whatever the footprint's size.
    pub fn mixture(&self, texels: &[[f64; 2]], position: [f64; 2], covariance: [f64; 3]) -> [f64; 2] {
        total(&self.mixed_parts(texels, position, covariance, |value| [value, 0.0]))
    }

    /// The parts of the two levels that are mixed, with their weights and what is known of each: at level 0 of a point.
    pub(super) fn mixed_parts<const N: usize>(
        &self,
        texels: &[[f64; N]],
        position: [f64; 2],
        covariance: [f64; 3],
        point: fn(f64) -> [f64; N],
    ) -> Vec<(f64, [f64; N])> {
        let wanted = 0.5 * (covariance[0] + covariance[2]);
        let kernels = self.kernels();
        let above = kernels.iter().take_while(|&&kernel| kernel <= wanted).count();
        let fine = above.saturating_sub(1);
        let coarse = above.min(kernels.len() - 1);
        let share = match kernels[coarse] - kernels[fine] {
            apart if apart > 0.0 => ((wanted - kernels[fine]) / apart).clamp(0.0, 1.0),
            _ => 1.0,
        };
        let mut parts = self.parts(texels, position, fine, 1.0 - share, point);
        parts.extend(self.parts(texels, position, coarse, share, point));
        parts
    }

    /// The variance of the kernel of each level.
    pub fn kernels(&self) -> Vec<f64> {
        let mut kernels = vec![0.0];
        let mut level = 1;
        while (self.width.max(self.height) >> (level - 1)) > 1 {
            let [width, height] = self.level(level);
            let part = (self.width as f64 / width as f64).max(self.height as f64 / height as f64);
            kernels.push(part * part / 4.0);
            level += 1;
        }
        kernels
    }

    /// The number of parts of a level, across and down.
    pub fn level(&self, level: usize) -> [usize; 2] {
        [self.width, self.height].map(|size| (size >> level).max(1))
    }

    /// Parts of the reconstruction that a level mixes at a position: the weight, and what is known of it.
    pub(super) fn parts<const N: usize>(
        &self,
        texels: &[[f64; N]],
        position: [f64; 2],
        level: usize,
        share: f64,
        point: fn(f64) -> [f64; N],
    ) -> Vec<(f64, [f64; N])> {
        let [x, y] = [position[0] * self.width as f64, position[1] * self.height as f64];
        if level == 0 {
            return vec![(share, point(self.value(x, y)))];
        }
        let [width, height] = self.level(level);
        let (left, right) = between(position[0], width);
        let (above, below) = between(position[1], height);
        let mut parts = Vec::new();
        for (row, down) in [(above, 1.0 - (below - above)), (above + 1.0, below - above)] {
            for (column, across) in [(left, 1.0 - (right - left)), (left + 1.0, right - left)] {
                let weight = share * down * across;
                let covered = self.covered(texels, level, column as i64, row as i64);
                parts.extend(covered.into_iter().map(|(area, moments)| (weight * area, moments)));
            }
        }
        parts
    }

    /// The texels that a part of a level covers, weighted by the area; the part may be beyond the edges.
    fn covered<const N: usize>(
        &self,
        texels: &[[f64; N]],
        level: usize,
        column: i64,
        row: i64,
    ) -> Vec<(f64, [f64; N])> {
        let [width, height] = self.level(level);
        let columns = shares(stands_at(column, width, self.beyond), width, self.width);
        let rows = shares(stands_at(row, height, self.beyond), height, self.height);
        let mut covered = Vec::new();
        for &(y, down) in &rows {
            covered.extend(columns.iter().map(|&(x, across)| (down * across, texels[y * self.width + x])));
        }
        covered
    }

    /// The four parts of a level around a position (means, then deviations), and the position's place between their
    /// centers.
    pub fn cell(&self, texels: &[[f64; 2]], position: [f64; 2], level: usize) -> [f64; 10] {
        let [width, height] = self.level(level);
        let (left, x) = between(position[0], width);
        let (above, y) = between(position[1], height);
        let mut cell = [0.0; 10];
        for (number, (i, j)) in [(0, 0), (1, 0), (0, 1), (1, 1)].into_iter().enumerate() {
            let (column, row) = (left as i64 + i, above as i64 + j);
            let parts = match level {
                0 => vec![(1.0, [self.texel(column, row), 0.0])],
                _ => self.covered(texels, level, column, row),
            };
            let [mean, variance] = total(&parts);
            (cell[number], cell[4 + number]) = (mean, variance.sqrt());
        }
        (cell[8], cell[9]) = (x - left, y - above);
        cell
    }

    /// The variance of the plane that the reconstruction's cell is at a position in texels, at most a quarter of the
    /// squared range of its corners.
    pub fn plane(&self, position: [f64; 2], covariance: [f64; 3]) -> f64 {
        let [x, y] = position;
        let (left, top) = ((x - 0.5).floor() + 0.5, (y - 0.5).floor() + 0.5);
        // A bilinear cell is linear along rows and columns: differences from side to side are its derivatives.
        let gradient = [self.value(left + 1.0, y) - self.value(left, y), self.value(x, top + 1.0) - self.value(x, top)];
        let along = |i: usize, j: usize| gradient[i] * gradient[j];
        let variance = covariance[0] * along(0, 0) + 2.0 * covariance[1] * along(0, 1) + covariance[2] * along(1, 1);
        let corners = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)].map(|(i, j)| self.value(left + i, top + j));
        let [least, most] =
            [corners.iter().copied().fold(f64::MAX, f64::min), corners.iter().copied().fold(f64::MIN, f64::max)];
        variance.min(0.25 * (most - least) * (most - least))
    }
}

/// The center below a position among those of `count` equal parts, and the position, both in parts from the first
/// center.
fn between(position: f64, count: usize) -> (f64, f64) {
    let at = position * count as f64 - 0.5;
    (at.floor(), at)
}

/// Which of `size` texels one of `count` equal parts of a side covers, and the share of its length.
fn shares(part: usize, count: usize, size: usize) -> Vec<(usize, f64)> {
    let length = size as f64 / count as f64;
    let (from, to) = (part as f64 * length, (part as f64 + 1.0) * length);
    let covered = |texel: usize| (to.min(texel as f64 + 1.0) - from.max(texel as f64)).max(0.0) / length;
    (0..size).map(|texel| (texel, covered(texel))).filter(|(_, share)| *share > 0.0).collect()
}

/// Mean and variance of weighted parts.
fn total(parts: &[(f64, [f64; 2])]) -> [f64; 2] {
    let mean: f64 = parts.iter().map(|(weight, [mean, _])| weight * mean).sum();
    let from_mean = |(weight, [center, own]): &(f64, [f64; 2])| weight * (own + (center - mean) * (center - mean));
    [mean, parts.iter().map(from_mean).sum()]
}
