//! Pyramids of mean and deviation of an image.

use super::pyramid::{Grid, Reconstruction};
use crate::accuracy::Ranges;
use crate::table::{Format, Level, Sampling, Table};
use crate::Error;

/// What continues an image beyond its edges.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Edge {
    /// The texel at the edge, or the image mirrored there.
    #[default]
    Clamp,
    /// The image again.
    Repeat,
}

/// Mean and deviation of an image's bilinear reconstruction, at every size from the image's own down to one texel.
///
/// Level 0 holds the image itself: points, whose deviation is 0. A texel of a further level holds the mean and the
/// deviation of the bilinear reconstruction over the area that the texel covers, and every level covers the whole
/// image. Sizes halve and round down as the graphics interfaces want it; where they do not halve evenly a texel covers
/// parts of texels, each weighted by the area covered. The mean of every level is therefore the mean of the image.
///
/// Moments are central and combined by the law of total variance in f64; deviations, not variances, are stored, so
/// that small ones survive in 16 bits.
///
/// ```
/// use prefilter::driver::moment_mipmap::{Edge, MomentMipmap};
/// use prefilter::table::Format;
///
/// let stripes: Vec<f32> = (0..64 * 64).map(|texel| (texel / 4 % 2) as f32).collect();
/// let moments = MomentMipmap::new(64, 64, &stripes, Edge::Repeat)?;
/// let table = moments.table("stripes", Format::Rg32Float)?;
/// let [mean, deviation] = moments.moments();
/// assert_eq!((table.levels.len(), mean), (7, 0.5));
/// assert!(0.4 < deviation && deviation < 0.5); // the reconstruction ramps from stripe to stripe
/// # Ok::<(), prefilter::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct MomentMipmap {
    levels: Vec<Level>,
    values: (f32, f32),
}

/// Largest side of an image.
const WIDEST: u32 = 16_384;
/// Largest value: squares of differences stay far inside f32.
pub(super) const LARGEST: f32 = 1e15;

impl MomentMipmap {
    /// The pyramid of an image given row by row.
    ///
    /// Takes time proportional to the number of texels where sizes halve evenly, and to that times the number of levels
    /// where they do not.
    ///
    /// # Errors
    /// [`Error::Size`] where a side is 0 or above 16384 or the number of values is not width times height;
    /// [`Error::Value`] for a value that is no number or beyond ±1e15.
    pub fn new(width: u32, height: u32, values: &[f32], edge: Edge) -> Result<Self, Error> {
        check_size(width, height, values.len())?;
        check_values(width, values, LARGEST)?;
        let (wide, high) = (width as usize, height as usize);
        let points = values.iter().flat_map(|&value| [value, 0.0]).collect();
        let mut levels = vec![Level { width, height, depth: 1, texels: points }];
        let base = Grid::reconstruction(&Reconstruction { width: wide, height: high, values, edge });
        levels.extend(base.halved(mixed, |&[mean, variance]| [mean as f32, variance.sqrt() as f32]));
        Ok(Self { levels, values: range(values) })
    }

    /// The levels, the image first: mean and deviation of each texel.
    pub fn levels(&self) -> &[Level] {
        &self.levels
    }

    /// The image's smallest and largest value: no mean is outside.
    pub fn range(&self) -> (f32, f32) {
        self.values
    }

    /// The largest deviation that a footprint can have: half the range.
    pub fn largest_deviation(&self) -> f32 {
        0.5 * (self.values.1 - self.values.0)
    }

    /// The ranges of a scene that this image drives: its means and deviations, as wide at least as a scene accepts.
    ///
    /// ```
    /// use prefilter::{ColorMap, Edge, MomentMipmap, Scene};
    /// let moments = MomentMipmap::new(2, 1, &[230.0, 870.0], Edge::Clamp)?;
    /// let map = ColorMap::gradient([(200.0, [0.1, 0.3, 0.1]), (900.0, [0.9, 0.9, 0.9])])?;
    /// let module = Scene::new("hills").texture(map).ranges(moments.ranges()).module()?;
    /// assert!(module.explain().contains("means 230 to 870, deviations to 320"));
    /// # Ok::<(), prefilter::Error>(())
    /// ```
    pub fn ranges(&self) -> Ranges {
        ranges(self.values)
    }

    /// Mean and deviation of the whole image.
    pub fn moments(&self) -> [f32; 2] {
        match self.levels.last().map(|level| level.texels.as_slice()) {
            Some(&[mean, deviation]) => [mean, deviation],
            // Not reached: the last level is one texel of two channels.
            _ => [0.0; 2],
        }
    }

    /// The pyramid as a texture: mean and deviation in the first two channels, further ones 0.
    ///
    /// [`Format::Rg32Float`] keeps every digit. [`Format::Rg16Float`] halves the memory: eleven bits of the largest
    /// value, which [`Table::error`] states; it serves where the values' distance from 0 is of the order of their
    /// range. The shelf reads texels at their centers, so that no format needs to be filterable.
    ///
    /// # Errors
    /// [`Error::Conflict`] for [`Format::Rgb10a2Unorm`], [`Error::Value`] where a value does not fit 16 bits.
    pub fn table(&self, name: &str, format: Format) -> Result<Table, Error> {
        if format == Format::Rgb10a2Unorm {
            return Err(Error::Conflict(format!("the table `{name}` of moments has floats, {format:?} has none")));
        }
        let halves = matches!(format, Format::Rg16Float | Format::Rgba16Float);
        let largest = self.values.0.abs().max(self.values.1.abs());
        if halves && largest > half::f16::MAX.to_f32() {
            let what = format!("the largest value of the image for `{name}`");
            return Err(Error::value(what, largest, format!("up to {}", half::f16::MAX)));
        }
        let error = |value: &f32| (half::f16::from_f32(*value).to_f32() - value).abs();
        let stored = self.levels.iter().flat_map(|level| &level.texels);
        let error = if halves { stored.map(error).fold(0.0, f32::max) } else { 0.0 };
        let further = vec![0.0; format.channels() - 2];
        let widen = |level: &Level| Level {
            texels: level.texels.chunks(2).flat_map(|texel| [texel, &further].concat()).collect(),
            ..*level
        };
        let levels = self.levels.iter().map(widen).collect();
        Ok(Table { name: name.to_owned(), format, sampling: Sampling::Loaded, levels, error })
    }
}

/// Mean and variance of every texel.
impl Grid<2> {
    /// Moments of the bilinear reconstruction over the area of each texel of the image.
    ///
    /// Over a quarter c + p x + q y + r x y has the mean c and the variance p²/12 + q²/12 + r²/144.
    fn reconstruction(image: &Reconstruction<'_>) -> Self {
        let moments = |[c, p, q, r]: [f64; 4]| (0.25, [c, (p * p + q * q) / 12.0 + r * r / 144.0]);
        let texel = |at: usize| mixed(&image.quarters(at).map(moments));
        let &Reconstruction { width, height, .. } = image;
        Self { width, height, moments: (0..width * height).map(texel).collect() }
    }
}

/// Whether a side is one of an image's, and every texel has its value.
///
/// # Errors
/// [`Error::Size`] otherwise.
pub(crate) fn check_size(width: u32, height: u32, count: usize) -> Result<(), Error> {
    for (side, size) in [("width", width), ("height", height)] {
        if !(1..=WIDEST).contains(&size) {
            let (what, allowed) = (format!("the image's {side}"), format!("1 to {WIDEST}"));
            return Err(Error::Size { what, count: size as usize, allowed });
        }
    }
    let texels = width as usize * height as usize;
    if count != texels {
        let allowed = format!("{texels}, width times height");
        return Err(Error::Size { what: "the image's number of values".into(), count, allowed });
    }
    Ok(())
}

/// Whether every value of an image is a number within ±`largest`.
///
/// # Errors
/// [`Error::Value`] otherwise.
pub(super) fn check_values(width: u32, values: &[f32], largest: f32) -> Result<(), Error> {
    // Written so that NaN is refused.
    let Some(at) = values.iter().position(|value| !(value.abs() <= largest)) else { return Ok(()) };
    let what = format!("the image's value at ({}, {})", at % width as usize, at / width as usize);
    Err(Error::value(what, values[at], format!("-{largest:e} to {largest:e}")))
}

/// The smallest and the largest value.
pub(super) fn range(values: &[f32]) -> (f32, f32) {
    let least = values.iter().copied().fold(f32::INFINITY, f32::min);
    (least, values.iter().copied().fold(f32::NEG_INFINITY, f32::max))
}

/// The ranges of a scene that an image of these values drives.
pub(super) fn ranges((mut low, mut high): (f32, f32)) -> Ranges {
    let deviation = (0.5 * (high - low)).max(1e-3);
    // Twice what is asked for, and two numbers where numbers are farther apart; towards 0, within the limits.
    let least = (2e-3f32).max(high.abs() * 2.4e-7);
    if high - low < least && high > 0.0 {
        low = high - least;
    } else if high - low < least {
        high = low + least;
    }
    Ranges { mean: (low, high), deviation }
}

/// Mean and variance of a mixture, by the law of total variance; weights sum to one.
fn mixed(parts: &[(f64, [f64; 2])]) -> [f64; 2] {
    let Some(&(_, [first, _])) = parts.first() else { return [0.0; 2] };
    let mean = first + parts.iter().map(|(weight, [mean, _])| weight * (mean - first)).sum::<f64>();
    let variance = parts.iter().map(|(weight, [center, variance])| weight * (variance + (center - mean).powi(2))).sum();
    [mean, variance]
}
