//! Pyramids of four moments of an image: mean, deviation, skewness and kurtosis.

use super::moment_mipmap::{check_size, check_values, range, ranges, Edge};
use super::pyramid::{Grid, Reconstruction};
use crate::accuracy::Ranges;
use crate::table::{Format, Level, Sampling, Table};
use crate::Error;

/// Mean, deviation, skewness and excess kurtosis of an image's bilinear reconstruction, at every size from the image's
/// own down to one texel: what two normal distributions need to stand for values in two heaps.
///
/// Levels are those of [`MomentMipmap`](crate::MomentMipmap), with the same means and deviations. Moments are central,
/// mixed in f64 by the formulas for moved centers, and stored standardized, so that 16 bits keep eleven bits of each:
/// raw moments E\[x²\] … E\[x⁴\] in 16 bits would lose deviations below a tenth of the values. Where there is no
/// deviation, skewness and kurtosis are 0.
///
/// ```
/// use prefilter::{Edge, FourMomentMipmap};
///
/// // One bright texel in four: a lone heap above the rest.
/// let values: Vec<f32> = (0..64 * 64).map(|texel| f32::from(texel % 2 == 0 && texel / 64 % 2 == 0)).collect();
/// let [mean, _, skewness, _] = FourMomentMipmap::new(64, 64, &values, Edge::Repeat)?.moments();
/// assert!(mean == 0.25 && skewness > 0.5);
/// # Ok::<(), prefilter::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct FourMomentMipmap {
    levels: Vec<Level>,
    values: (f32, f32),
}

/// Largest value: fourth powers stay far inside f32.
const LARGEST: f32 = 1e7;
/// The largest number of 16 bits.
const LARGEST_HALF: f32 = 65_504.0;

/// Mean, and second to fourth central moment.
type Central = [f64; 4];

impl FourMomentMipmap {
    /// The pyramid of an image given row by row.
    ///
    /// Takes time proportional to the number of texels where sizes halve evenly, and to that times the number of levels
    /// where they do not.
    ///
    /// # Errors
    /// [`Error::Size`] where a side is 0 or above 16384 or the number of values is not width times height;
    /// [`Error::Value`] for a value that is no number or beyond ±1e7.
    pub fn new(width: u32, height: u32, values: &[f32], edge: Edge) -> Result<Self, Error> {
        check_size(width, height, values.len())?;
        check_values(width, values, LARGEST)?;
        let points = values.iter().flat_map(|&value| [value, 0.0, 0.0, 0.0]).collect();
        let mut levels = vec![Level { width, height, depth: 1, texels: points }];
        let image = Reconstruction { width: width as usize, height: height as usize, values, edge };
        levels.extend(Grid::<4>::reconstruction(&image).halved(mixed, standardized));
        Ok(Self { levels, values: range(values) })
    }

    /// The levels, the image first: mean, deviation, skewness and excess kurtosis of each texel.
    pub fn levels(&self) -> &[Level] {
        &self.levels
    }

    /// The ranges of a scene that this image drives, as [`MomentMipmap::ranges`](crate::MomentMipmap::ranges).
    pub fn ranges(&self) -> Ranges {
        ranges(self.values)
    }

    /// Mean, deviation, skewness and excess kurtosis of the whole image.
    pub fn moments(&self) -> [f32; 4] {
        match self.levels.last().map(|level| level.texels.as_slice()) {
            Some(&[mean, deviation, skewness, kurtosis]) => [mean, deviation, skewness, kurtosis],
            // Not reached: the last level is one texel of four channels.
            _ => [0.0; 4],
        }
    }

    /// The pyramid as a texture of four channels.
    ///
    /// [`Format::Rgba32Float`] keeps every digit. [`Format::Rgba16Float`] halves the memory: eleven bits of each
    /// number, which [`Table::error`] states of mean and deviation; larger kurtoses than 65504 are stored as that.
    ///
    /// # Errors
    /// [`Error::Conflict`] for a format without four floats, [`Error::Value`] where a value does not fit 16 bits.
    pub fn table(&self, name: &str, format: Format) -> Result<Table, Error> {
        if !matches!(format, Format::Rgba32Float | Format::Rgba16Float) {
            let message = format!("the table `{name}` of four moments has four floats a texel, {format:?} has not");
            return Err(Error::Conflict(message));
        }
        let halves = format == Format::Rgba16Float;
        let largest = self.values.0.abs().max(self.values.1.abs());
        if halves && largest > LARGEST_HALF {
            let what = format!("the largest value of the image for `{name}`");
            return Err(Error::value(what, largest, format!("up to {LARGEST_HALF}")));
        }
        let held = |level: &Level| Level {
            texels: level.texels.iter().map(|value| if halves { value.min(LARGEST_HALF) } else { *value }).collect(),
            ..*level
        };
        let levels: Vec<Level> = self.levels.iter().map(held).collect();
        let texels = levels.iter().flat_map(|level| level.texels.chunks(4)).flat_map(|texel| &texel[..2]);
        let error = |value: &f32| (half::f16::from_f32(*value).to_f32() - value).abs();
        let error = if halves { texels.map(error).fold(0.0, f32::max) } else { 0.0 };
        Ok(Table { name: name.to_owned(), format, sampling: Sampling::Loaded, levels, error })
    }
}

impl Grid<4> {
    /// Moments of the bilinear reconstruction over the area of each texel of the image.
    ///
    /// Over a quarter x and y are uniform: E\[x²\] is 1/12, E\[x⁴\] 1/80 and odd moments are 0.
    fn reconstruction(image: &Reconstruction<'_>) -> Self {
        let quarter = |[c, p, q, r]: [f64; 4]| {
            let [a, b, d] = [p, q, r].map(|slope| slope * slope);
            let fourth = (a * a + b * b) / 80.0 + d * d / 6400.0 + a * b / 24.0 + (a + b) * d / 160.0;
            (0.25, [c, (a + b) / 12.0 + d / 144.0, p * q * r / 24.0, fourth])
        };
        let texel = |at: usize| mixed(&image.quarters(at).map(quarter));
        let &Reconstruction { width, height, .. } = image;
        Self { width, height, moments: (0..width * height).map(texel).collect() }
    }
}

/// Central moments of a mixture: those of its parts about its mean; weights sum to one.
fn mixed(parts: &[(f64, Central)]) -> Central {
    let Some(&(_, [first, ..])) = parts.first() else { return [0.0; 4] };
    let mean = first + parts.iter().map(|(weight, [mean, ..])| weight * (mean - first)).sum::<f64>();
    let mut sums = [0.0; 3];
    for &(weight, [center, second, third, fourth]) in parts {
        let apart = center - mean;
        let square = apart * apart;
        sums[0] += weight * (second + square);
        sums[1] += weight * (third + apart * (3.0 * second + square));
        sums[2] += weight * (fourth + apart * (4.0 * third + apart * (6.0 * second + square)));
    }
    [mean, sums[0], sums[1], sums[2]]
}

/// Mean, deviation, skewness and excess kurtosis.
fn standardized(&[mean, variance, third, fourth]: &Central) -> [f32; 4] {
    let deviation = variance.sqrt();
    // Below, what the shader takes for no deviation.
    if deviation < 1e-9 {
        return [mean as f32, deviation as f32, 0.0, 0.0];
    }
    let skewness = third / (variance * deviation);
    [mean, deviation, skewness, fourth / (variance * variance) - 3.0].map(|value| value as f32)
}
