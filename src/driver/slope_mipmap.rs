//! Pyramids of mean slope and covariance of slopes, from maps of normals, of heights or of slopes.

use super::moment_mipmap::{check_size, Edge, LARGEST};
use super::pyramid::Grid;
use super::slope_grid::{mixed, Moments};
use crate::table::{Format, Level, Sampling, Table};
use crate::Error;

/// Mean and covariance of a surface's slopes at every size from the map's own down to one texel.
///
/// Slopes are the gradient of the height along x and y of texture space, x with the columns and y down the rows: the
/// normal is (−x, −y, 1) normalized. A texel of a level beyond the first holds the moments over the area that it
/// covers, and every level covers the whole map; level 0 holds points, the slopes with no covariance. Sizes halve and
/// round down; where they do not halve evenly a texel covers parts of texels, each weighted by the area covered. The
/// mean slope of every level is that of the map, and what the means of a level do not vary its covariances hold: their
/// sum is the same for all levels beyond the first.
///
/// Moments are central and combined by the law of total covariance in f64: none is a difference of squares. Covariances
/// are stored as their triangular factor F, with Σ = F Fᵀ: rounded factors are a covariance still, small deviations
/// survive in 16 bits, and so does the smaller axis of a slender covariance.
///
/// The length of a mean normal (Toksvig 2005) knows no axes. On gravel it states 0.99 of the mean variance of shallow
/// slopes and 0.76 to 0.83 of that of slopes ten times as steep; where the gravel is stretched four to one, half of the
/// larger variance and 7 to 11 times the smaller.
///
/// # Roughness of what a level no longer shows
///
/// The covariance is microgeometry to the level that is read, and a BRDF can take it as roughness. Slopes of a surface
/// on a surface add, and so do their covariances. *Beckmann* of roughness α₀ is a normal distribution of slopes of the
/// variance α₀²/2 both ways. With normal slopes of covariance Σ added it is Beckmann again, exactly: α² = α₀² + 2σ²
/// where Σ is round, and else α² = α₀² + 2λ along each axis of Σ, λ its eigenvalues. *GGX* has slopes of infinite
/// variance and does not stay GGX: the same α² = α₀² + 2σ² is a convention. It leaves the peak of the distribution too
/// high, by up to a quarter and 24 % where 2σ² = α₀²; where σ is far below α₀, α₀² + 4σ² keeps the peak. Mean slopes go
/// to the shading normal. The shelf's `roughness_round` and `roughness_axes` are these sums, and `curvature_covariance`
/// is what a bent mesh below the map adds to Σ.
///
/// ```
/// use prefilter::{Edge, SlopeMipmap};
///
/// // Waves along x: the map's slope is level, and its covariance along x only.
/// let heights: Vec<f32> = (0..64 * 64).map(|texel| (texel as f32 * std::f32::consts::TAU / 16.0).sin()).collect();
/// let slopes = SlopeMipmap::from_heights(64, 64, &heights, 1.0, Edge::Repeat)?;
/// let (mean, [xx, xy, yy]) = slopes.moments();
/// assert!(mean[0].abs() < 1e-6 && xy.abs() < 1e-6 && yy.abs() < 1e-6);
/// // Half the squared amplitude 2π/16, less the 1.3 % that straight lines from texel to texel lose.
/// assert!((xx / 0.0771 - 0.987).abs() < 0.001);
/// # Ok::<(), prefilter::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SlopeMipmap {
    levels: Vec<Level>,
}

/// Mean x and y and the factor's xx, yx, yy: what a texel of a level has.
const CHANNELS: usize = 5;

impl SlopeMipmap {
    /// The pyramid of a map of slopes, row by row, which is reconstructed bilinearly.
    ///
    /// Takes time proportional to the number of texels where sizes halve evenly, and to that times the number of levels
    /// where they do not.
    ///
    /// # Errors
    /// [`Error::Size`] where a side is 0 or above 16384 or the number of slopes is not width times height;
    /// [`Error::Value`] for a slope that is no number or beyond ±1e15.
    pub fn from_slopes(width: u32, height: u32, slopes: &[[f32; 2]], edge: Edge) -> Result<Self, Error> {
        check_size(width, height, slopes.len())?;
        let values = slopes.iter().flatten().copied();
        check_values("slope", width as usize, 2, values)?;
        let points = slopes.to_vec();
        Ok(Self::new(&points, Grid::of_slopes(width as usize, height as usize, slopes, edge)))
    }

    /// The pyramid of a map of normals (x, y, z), row by row: their slopes, reconstructed bilinearly.
    ///
    /// Normals need not be of length one. Those of an image are 2 c − 1, its channels c from 0 to 1 and not sRGB; where
    /// green points up, against the rows, y changes its sign.
    ///
    /// # Errors
    /// As [`Self::from_slopes`], and [`Error::Value`] where z is not above 0.
    pub fn from_normals(width: u32, height: u32, normals: &[[f32; 3]], edge: Edge) -> Result<Self, Error> {
        check_size(width, height, normals.len())?;
        // Written so that NaN is refused.
        if let Some(at) = normals.iter().position(|normal| !(normal[2] > 0.0)) {
            let what = format!("the normal's z at {}", place(at, width as usize));
            return Err(Error::value(what, normals[at][2], "above 0"));
        }
        let slopes: Vec<_> = normals.iter().map(|[x, y, z]| [-x / z, -y / z]).collect();
        Self::from_slopes(width, height, &slopes, edge)
    }

    /// The pyramid of a map of heights, row by row: the gradient of their bilinear reconstruction.
    ///
    /// `texel_size` is the distance from texel to texel, in the unit of the heights. Moments beyond level 0 are those
    /// of the surface of straight lines from texel to texel; a texel of level 0 has the surface's mean slope over its
    /// area. At clamped edges the surface goes on with the slope that it has there.
    ///
    /// # Errors
    /// [`Error::Size`] where a side is 0 or above 16384 or the number of heights is not width times height;
    /// [`Error::Value`] for a height that is no number or beyond ±1e15, a texel's size that is not from 1e-15 to 1e15,
    /// or a slope beyond ±1e15.
    pub fn from_heights(width: u32, height: u32, heights: &[f32], texel_size: f32, edge: Edge) -> Result<Self, Error> {
        check_size(width, height, heights.len())?;
        check_values("height", width as usize, 1, heights.iter().copied())?;
        if !(1.0 / LARGEST..=LARGEST).contains(&texel_size) {
            let allowed = format!("{:e} to {LARGEST:e}", 1.0 / LARGEST);
            return Err(Error::value("the texel's size", texel_size, allowed));
        }
        let scale = 1.0 / f64::from(texel_size);
        let grid = Grid::of_heights(width as usize, height as usize, heights, scale, edge);
        let points: Vec<_> = grid.moments.iter().map(|&[x, y, ..]| [x as f32, y as f32]).collect();
        check_values("slope", width as usize, 2, points.iter().flatten().copied())?;
        Ok(Self::new(&points, grid))
    }

    fn new(points: &[[f32; 2]], base: Grid<5>) -> Self {
        let texels = points.iter().flat_map(|&[x, y]| [x, y, 0.0, 0.0, 0.0]).collect();
        let mut levels = vec![Level { width: base.width as u32, height: base.height as u32, depth: 1, texels }];
        levels.extend(base.halved(mixed, factored));
        Self { levels }
    }

    /// The levels, the map first: mean x and y of each texel and the factor's xx, yx and yy, the covariance being
    /// (xx², xx yx, yx² + yy²).
    pub fn levels(&self) -> &[Level] {
        &self.levels
    }

    /// Mean and covariance (xx, xy, yy) of the whole map.
    pub fn moments(&self) -> ([f32; 2], [f32; 3]) {
        match self.levels.last().map(|level| level.texels.as_slice()) {
            Some(&[x, y, first, cross, second]) => {
                ([x, y], [first * first, first * cross, cross * cross + second * second])
            }
            // Not reached: the last level is one texel of five channels.
            _ => ([0.0; 2], [0.0; 3]),
        }
    }

    /// The pyramid as two textures: `NAME`, the mean and the factor's xx and yy, and `NAME_cross`, its yx and 0.
    ///
    /// [`Format::Rgba32Float`] keeps every digit, with [`Format::Rg32Float`] for the second. [`Format::Rgba16Float`]
    /// and [`Format::Rg16Float`] halve the memory: eleven bits of each number, whose error the tables state. The
    /// shelf's `slope_moments_read` reads texels at their centers: factors, unlike means, do not interpolate.
    ///
    /// # Errors
    /// [`Error::Conflict`] for a format without four floats, [`Error::Value`] where a number does not fit 16 bits.
    pub fn tables(&self, name: &str, format: Format) -> Result<[Table; 2], Error> {
        let (cross, halves) = match format {
            Format::Rgba32Float => (Format::Rg32Float, false),
            Format::Rgba16Float => (Format::Rg16Float, true),
            Format::Rg32Float | Format::Rg16Float | Format::Rgb10a2Unorm => {
                let message = format!("the table `{name}` of slopes has four floats a texel, {format:?} has not");
                return Err(Error::Conflict(message));
            }
        };
        let stored = || self.levels.iter().flat_map(|level| level.texels.iter().copied());
        let largest = stored().fold(0.0, |most: f32, value| most.max(value.abs()));
        if halves && largest > half::f16::MAX.to_f32() {
            let what = format!("the largest slope or deviation for `{name}`");
            return Err(Error::value(what, largest, format!("up to {}", half::f16::MAX)));
        }
        let table = |name: String, format: Format, channels: [Option<usize>; 4]| {
            let channels = &channels[..format.channels()];
            let pick = |level: &Level| Level {
                texels: level.texels.chunks(CHANNELS).flat_map(|texel| picked(texel, channels)).collect(),
                ..*level
            };
            let levels: Vec<Level> = self.levels.iter().map(pick).collect();
            let error = |value: &f32| (half::f16::from_f32(*value).to_f32() - value).abs();
            let texels = levels.iter().flat_map(|level| &level.texels);
            let error = if halves { texels.map(error).fold(0.0, f32::max) } else { 0.0 };
            Table { name, format, sampling: Sampling::Loaded, levels, error }
        };
        Ok([
            table(name.to_owned(), format, [Some(0), Some(1), Some(2), Some(4)]),
            table(format!("{name}_cross"), cross, [Some(3), None, None, None]),
        ])
    }
}

/// The channels of a texel that a table holds, 0 for none.
fn picked(texel: &[f32], channels: &[Option<usize>]) -> Vec<f32> {
    channels.iter().map(|channel| channel.map_or(0.0, |channel| texel[channel])).collect()
}

/// Mean and the triangular factor of the covariance.
fn factored(&[x, y, xx, xy, yy]: &Moments) -> [f32; CHANNELS] {
    let first = xx.sqrt();
    // No variance along x, no covariance; along y as much as singular covariances round to.
    let cross = if first > 0.0 { xy / first } else { 0.0 };
    let second = (yy - cross * cross).max(0.0).sqrt();
    [x, y, first, cross, second].map(|value| value as f32)
}

/// Where a number of a map is.
fn place(at: usize, width: usize) -> String {
    format!("({}, {})", at % width, at / width)
}

/// Whether all numbers of a map, some of them a texel, are ones that squares of differences stay far inside f32 of.
fn check_values(of: &str, width: usize, each: usize, values: impl Iterator<Item = f32>) -> Result<(), Error> {
    // Written so that NaN is refused.
    match values.enumerate().find(|(_, value)| !(value.abs() <= LARGEST)) {
        Some((at, value)) => {
            let what = format!("the {of} at {}", place(at / each, width));
            Err(Error::value(what, value, format!("-{LARGEST:e} to {LARGEST:e}")))
        }
        None => Ok(()),
    }
}
