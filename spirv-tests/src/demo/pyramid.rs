//! Mip pyramids as the competing methods want them: every texel is the mean of the area that it covers.

use super::heights::Heights;
use prefilter::reference::texture::PiecewiseLinear;
use prefilter::table::{Format, Level, Sampling, Table};

/// The pyramid of (f, f²) of a height map, in 32-bit floats: no variance is lost to storage.
pub fn raw_moments(heights: &Heights) -> Table {
    let texels = heights.texels.iter().flat_map(|&height| [height, height * height]).collect();
    pyramid("heights", Format::Rg32Float, heights, texels)
}

/// The pyramid of the colors that a map gives to the texels of a height map.
pub fn colored(heights: &Heights, map: &PiecewiseLinear) -> Table {
    let colors = heights.texels.iter().flat_map(|&height| map.value(f64::from(height)));
    pyramid("colored", Format::Rgba32Float, heights, colors.map(|channel| channel as f32).collect())
}

fn pyramid(name: &str, format: Format, heights: &Heights, texels: Vec<f32>) -> Table {
    let first = Level { width: heights.width as u32, height: heights.height as u32, depth: 1, texels };
    let levels = std::iter::successors(Some(first), |level| halved(level, format.channels())).collect();
    Table { name: name.into(), format, sampling: Sampling::Filtered, levels, error: 0.0 }
}

/// The next smaller level; none after a single texel.
fn halved(level: &Level, channels: usize) -> Option<Level> {
    if level.width * level.height == 1 {
        return None;
    }
    let (width, height) = ((level.width / 2).max(1), (level.height / 2).max(1));
    let mut texels = Vec::with_capacity((width * height) as usize * channels);
    for row in 0..height {
        let rows = covered(row, height, level.height);
        for column in 0..width {
            let mut sum = [0.0; 4];
            for &(from_row, down) in &rows {
                for (from_column, across) in covered(column, width, level.width) {
                    let at = (from_row * level.width + from_column) as usize * channels;
                    for (total, &value) in sum.iter_mut().zip(&level.texels[at..at + channels]) {
                        *total += down * across * f64::from(value);
                    }
                }
            }
            texels.extend(sum[..channels].iter().map(|&total| total as f32));
        }
    }
    Some(Level { width, height, depth: 1, texels })
}

/// The texels of a row of `from` that texel `at` of `to` covers, with the parts of it that each fills.
fn covered(at: u32, to: u32, from: u32) -> Vec<(u32, f64)> {
    let ratio = f64::from(from) / f64::from(to);
    let (start, end) = (f64::from(at) * ratio, f64::from(at + 1) * ratio);
    let part = |texel: u32| (end.min(f64::from(texel + 1)) - start.max(f64::from(texel))) / ratio;
    let texels = start as u32..from.min(end.ceil() as u32);
    texels.map(|texel| (texel, part(texel))).filter(|&(_, part)| part > 1e-9).collect()
}

#[cfg(test)]
mod tests {
    use super::super::heights::Address;
    use super::*;

    #[test]
    fn every_level_keeps_the_mean_and_the_square() {
        let texels: Vec<f32> = (0..7 * 5).map(|number| ((number * 29) % 31) as f32 / 31.0).collect();
        let heights = Heights { width: 7, height: 5, texels, address: Address::Mirror };
        let table = raw_moments(&heights);
        let sizes: Vec<_> = table.levels.iter().map(|level| (level.width, level.height)).collect();
        assert_eq!(sizes, [(7, 5), (3, 2), (1, 1)]);
        let mean = |level: &Level, channel: usize| {
            let values = level.texels.iter().skip(channel).step_by(2).map(|&value| f64::from(value));
            values.sum::<f64>() / f64::from(level.width * level.height)
        };
        for level in &table.levels {
            for channel in 0..2 {
                let difference = mean(level, channel) - mean(&table.levels[0], channel);
                assert!(difference.abs() < 1e-6, "{channel}: {difference}");
            }
        }
    }

    #[test]
    fn parts_of_a_texel_sum_to_one() {
        for (to, from) in [(201, 403), (1, 3), (172, 344), (1, 1)] {
            for at in 0..to {
                let parts: f64 = covered(at, to, from).iter().map(|covered| covered.1).sum();
                assert!((parts - 1.0).abs() < 1e-12, "{at} of {to} from {from}: {parts}");
            }
        }
    }
}
