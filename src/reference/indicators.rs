//! Shares of images above edges, by counting along lines, and what a pyramid of any numbers reads.

use super::moments::Image;

/// A level of a pyramid: an image for each channel.
pub type Channels = [Image; 4];

impl Image {
    /// How much of the reconstruction is above an edge over the area of a texel inside the image: along `lines` columns
    /// of each half of it, on which the reconstruction is straight from row center to row center.
    pub fn above_over_texel(&self, x: usize, y: usize, edge: f64, lines: usize) -> f64 {
        let mut sum = 0.0;
        for line in 0..2 * lines {
            let at = x as f64 + (line as f64 + 0.5) / (2 * lines) as f64;
            for half in 0..2 {
                let top = y as f64 + 0.5 * f64::from(half);
                let ends = [self.value(at, top), self.value(at, top + 0.5)].map(|value| value - edge);
                let [low, high] = [ends[0].min(ends[1]), ends[0].max(ends[1])];
                let share = if low > 0.0 {
                    1.0
                } else if high <= 0.0 {
                    0.0
                } else {
                    high / (high - low)
                };
                sum += share;
            }
        }
        sum / (4 * lines) as f64
    }
}

/// The variance of the kernel of each level: a box of a part's width with a tent of it, in texels of the first level.
pub fn kernels(levels: &[Channels]) -> Vec<f64> {
    let size = |level: &Channels| [level[0].width, level[0].height].map(|side| side as f64);
    let first = size(&levels[0]);
    let widest = |level: &Channels| (first[0] / size(level)[0]).max(first[1] / size(level)[1]);
    levels.iter().map(|level| widest(level).powi(2) / 12.0 + widest(level).powi(2) / 6.0).collect()
}

/// What a level has at a position in texture coordinates.
pub fn at_level(level: &Channels, position: [f64; 2]) -> [f64; 4] {
    let value = |image: &Image| image.value(position[0] * image.width as f64, position[1] * image.height as f64);
    [0, 1, 2, 3].map(|channel| value(&level[channel]))
}

/// What the two levels have whose kernels enclose half the trace of a footprint, mixed to that variance.
pub fn read(levels: &[Channels], position: [f64; 2], covariance: [f64; 3]) -> [f64; 4] {
    let wanted = 0.5 * (covariance[0] + covariance[2]);
    let kernels = kernels(levels);
    let fine = kernels.iter().take_while(|&&kernel| kernel <= wanted).count().saturating_sub(1);
    let coarse = (fine + 1).min(kernels.len() - 1);
    let apart = kernels[coarse] - kernels[fine];
    let share = if apart > 0.0 { ((wanted - kernels[fine]) / apart).clamp(0.0, 1.0) } else { 0.0 };
    let [low, high] = [fine, coarse].map(|level| at_level(&levels[level], position));
    [0, 1, 2, 3].map(|channel| (1.0 - share) * low[channel] + share * high[channel])
}
