//! Maps of slopes: colors on a grid of slopes.

use super::color_map::{four, MAX_COLOR};
use crate::reference::slope_map::Bilinear;
use crate::Error;

/// The most cells of a map along either component of the slope.
pub const MAX_SIZE: usize = 512;

/// Where a map has its colors: at slopes whose components are those of the centers of even cells.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum SlopeDomain {
    /// Cells of each component are even from −reach to reach, from 0.001 to 65504. For maps that are constant beyond.
    Within(f32),
    /// Cells are even in p = s/(1 + |s|) of each component s, which runs from −1 to 1: all slopes, half of the cells
    /// for those below 1. For maps that depend on the direction of slopes however steep they are, such as wheels of
    /// aspects.
    All,
}

/// A map from a slope to three or four linear channels: bilinear between the nodes of a square grid of slopes, and
/// constant along either component beyond its last nodes.
///
/// The slope s of a facet is the gradient of its height: its normal is along (−s.x, −s.y, 1). A fourth channel is
/// premultiplied alpha or a material value.
///
/// ```
/// use prefilter::{SlopeDomain, SlopeMap};
/// // Snow on what falls towards −y, from the steepness of 0.2 on.
/// let snow = SlopeMap::from_function(64, SlopeDomain::Within(1.0), |[_, y]| {
///     let covered = ((y - 0.2) / 0.3).clamp(0.0, 1.0);
///     [0.3 + 0.6 * covered, 0.3 + 0.6 * covered, 0.3 + 0.65 * covered]
/// })?;
/// assert_eq!((snow.size(), snow.channels()), (64, 3));
/// # Ok::<(), prefilter::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(into = "super::serial::Grid", try_from = "super::serial::Grid"))]
pub struct SlopeMap {
    pub(super) domain: SlopeDomain,
    pub(super) size: usize,
    pub(super) colors: Vec<[f32; 4]>,
    pub(super) channels: usize,
}

impl SlopeMap {
    /// The map with these colors at the centers of `size` × `size` even cells from −reach to reach: row by row from the
    /// lowest y, each from the lowest x.
    ///
    /// # Errors
    /// A size other than 1 to [`MAX_SIZE`] or than that of the texels, a reach other than 0.001 to 65504, channels
    /// other than three or four, a color that is not finite or beyond ±65504.
    pub fn from_texels<const N: usize>(size: usize, reach: f32, texels: &[[f32; N]]) -> Result<Self, Error> {
        let colors = texels.iter().map(|&color| four(color)).collect::<Result<_, _>>()?;
        Self::checked(SlopeDomain::Within(reach), size, colors, N)
    }

    /// The map whose nodes have the colors of a function of the slope.
    ///
    /// Between nodes it is bilinear, so that the function is blurred by the width of a cell.
    ///
    /// # Errors
    /// As [`Self::from_texels`].
    pub fn from_function<const N: usize>(
        size: usize,
        domain: SlopeDomain,
        color: impl Fn([f32; 2]) -> [f32; N],
    ) -> Result<Self, Error> {
        sized(size)?;
        let nodes = nodes(domain, size);
        let slopes = nodes.iter().flat_map(|&y| nodes.iter().map(move |&x| [x as f32, y as f32]));
        let colors = slopes.map(|slope| four(color(slope))).collect::<Result<_, _>>()?;
        Self::checked(domain, size, colors, N)
    }

    /// The map in the picture of a lit sphere: an image over the normals' x and y from −1 to 1, rows from the top,
    /// where y is 1, each from the left. All slopes are covered by `size` × `size` cells.
    ///
    /// The image is read bilinearly between the centers of those texels that lie on the sphere.
    ///
    /// # Errors
    /// An image without texels, or of another width and height than the texels have; otherwise as
    /// [`Self::from_texels`].
    pub fn from_normals<const N: usize>(
        size: usize,
        width: usize,
        height: usize,
        texels: &[[f32; N]],
    ) -> Result<Self, Error> {
        if texels.is_empty() || width.checked_mul(height) != Some(texels.len()) {
            let (what, allowed) =
                ("the texels of an image of normals".into(), format!("{width} times {height}, not 0"));
            return Err(Error::Size { what, count: texels.len(), allowed });
        }
        Self::from_function(size, SlopeDomain::All, |slope| on_sphere(slope, width, height, texels))
    }

    /// The map with these colors, checked: what every constructor ends in.
    pub(super) fn checked(
        domain: SlopeDomain,
        size: usize,
        colors: Vec<[f32; 4]>,
        channels: usize,
    ) -> Result<Self, Error> {
        sized(size)?;
        if let SlopeDomain::Within(reach) = domain {
            if !(1e-3..=MAX_COLOR).contains(&reach) {
                return Err(Error::value("the reach of a map of slopes", reach, "0.001 to 65504"));
            }
        }
        if size * size != colors.len() {
            let (what, allowed) = ("the texels of a map of slopes".into(), format!("{size} times {size}"));
            return Err(Error::Size { what, count: colors.len(), allowed });
        }
        let wrong = colors.iter().enumerate().find_map(|(index, color)| {
            color.iter().find(|channel| !(channel.abs() <= MAX_COLOR)).map(|&channel| (index, channel))
        });
        if let Some((index, channel)) = wrong {
            let what = format!("a color channel at column {} of row {}", index % size, index / size);
            return Err(Error::value(what, channel, "a number from -65504 to 65504"));
        }
        Ok(Self { domain, size, colors, channels })
    }

    /// Three or four.
    pub fn channels(&self) -> usize {
        self.channels
    }

    /// Cells along either component.
    pub fn size(&self) -> usize {
        self.size
    }

    /// Which slopes the cells are of.
    pub fn domain(&self) -> SlopeDomain {
        self.domain
    }

    /// The smallest and the largest value of each channel: no filtered color leaves this box, but for the rounding of
    /// halves.
    pub fn hull(&self) -> ([f32; 4], [f32; 4]) {
        let fold = |start: f32, pick: fn(f32, f32) -> f32| {
            std::array::from_fn(|channel| self.colors.iter().map(|color| color[channel]).fold(start, pick))
        };
        (fold(f32::INFINITY, f32::min), fold(f32::NEG_INFINITY, f32::max))
    }

    /// The largest difference of two colors in any channel.
    pub(crate) fn widest_span(&self) -> f64 {
        let (low, high) = self.hull();
        (0..4).map(|channel| f64::from(high[channel]) - f64::from(low[channel])).fold(0.0, f64::max)
    }

    /// The same map for the f64 reference.
    pub fn reference(&self) -> Bilinear {
        let colors = self.colors.iter().map(|color| color.map(f64::from)).collect();
        Bilinear { nodes: nodes(self.domain, self.size), colors }
    }
}

/// The components of the slopes at the centers of the cells, rising.
fn nodes(domain: SlopeDomain, size: usize) -> Vec<f64> {
    let center = |index: usize| (2 * index + 1) as f64 / size as f64 - 1.0;
    let slope = |part: f64| match domain {
        SlopeDomain::Within(reach) => f64::from(reach) * part,
        SlopeDomain::All => part / (1.0 - part.abs()),
    };
    (0..size).map(|index| slope(center(index))).collect()
}

fn sized(size: usize) -> Result<(), Error> {
    if !(1..=MAX_SIZE).contains(&size) {
        let what = "the cells of a map of slopes along a component".into();
        return Err(Error::Size { what, count: size, allowed: format!("1 to {MAX_SIZE}") });
    }
    Ok(())
}

/// The color of the picture of a sphere at the normal of a slope.
fn on_sphere<const N: usize>([x, y]: [f32; 2], width: usize, height: usize, texels: &[[f32; N]]) -> [f32; N] {
    let [x, y] = [f64::from(x), f64::from(y)];
    let length = libm::sqrt(1.0 + x * x + y * y);
    // The normal is along (−x, −y, 1), and rows go down.
    let place = |part: f64, count: usize| ((0.5 + 0.5 * part) * count as f64 - 0.5).clamp(0.0, count as f64 - 1.0);
    let [column, row] = [place(-x / length, width), place(y / length, height)];
    let center = |index: usize, count: usize| (2 * index + 1) as f64 / count as f64 - 1.0;
    let (mut sum, mut whole) = ([0.0; N], 0.0);
    for corner in 0..4 {
        let [i, j] = [(column as usize + corner % 2).min(width - 1), (row as usize + corner / 2).min(height - 1)];
        let weight = (1.0 - (i as f64 - column).abs()).max(0.0) * (1.0 - (j as f64 - row).abs()).max(0.0);
        let outside = libm::hypot(center(i, width), center(j, height)) > 1.0;
        // Where a picture is too small to have a texel on the sphere here, one beside it counts.
        let weight = if outside { 1e-9 * weight } else { weight };
        whole += weight;
        for (total, &value) in sum.iter_mut().zip(&texels[j * width + i]) {
            *total += weight * f64::from(value);
        }
    }
    sum.map(|total| (total / whole) as f32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nodes_are_the_centers_of_cells() {
        assert_eq!(nodes(SlopeDomain::Within(2.0), 4), [-1.5, -0.5, 0.5, 1.5]);
        assert_eq!(nodes(SlopeDomain::All, 4), [-3.0, -1.0 / 3.0, 1.0 / 3.0, 3.0]);
    }

    #[test]
    fn pictures_of_spheres_are_read_by_the_normal() -> Result<(), Error> {
        // Red grows with the normal's x, green with its y; what is off the sphere is blue.
        let count = 64;
        let texel = |index: usize| {
            let [x, y] = [index % count, index / count].map(|at| (2 * at + 1) as f32 / count as f32 - 1.0);
            [x, -y, if x.hypot(y) > 1.0 { 1e3 } else { 0.0 }]
        };
        let texels: Vec<[f32; 3]> = (0..count * count).map(texel).collect();
        let map = SlopeMap::from_normals(32, count, count, &texels)?;
        let nodes = nodes(SlopeDomain::All, 32);
        for (index, color) in map.colors.iter().enumerate() {
            let [x, y] = [nodes[index % 32], nodes[index / 32]];
            let length = (1.0 + x * x + y * y).sqrt();
            assert!((f64::from(color[0]) + x / length).abs() < 0.03, "{x} {y}: {color:?}");
            assert!((f64::from(color[1]) + y / length).abs() < 0.03, "{x} {y}: {color:?}");
            assert!(color[2] < 1e-4, "{x} {y}: {color:?}");
        }
        Ok(())
    }

    #[test]
    fn what_cannot_be_a_map_is_refused() {
        let gray = [[0.5; 3]; 4];
        let message = |map: Result<SlopeMap, Error>| map.map_or_else(|error| error.to_string(), |_| String::new());
        assert!(message(SlopeMap::from_texels(2, 0.0, &gray)).contains("the reach of a map of slopes is 0.0"));
        assert!(message(SlopeMap::from_texels(3, 1.0, &gray)).contains("is 4; allowed is 3 times 3"));
        assert!(message(SlopeMap::from_texels(0, 1.0, &gray)).contains("allowed is 1 to 512"));
        assert!(message(SlopeMap::from_texels(2, 1.0, &[[0.5; 2]; 4])).contains("allowed is 3 or 4"));
        let hole = [[0.5; 3], [0.5; 3], [0.5, f32::NAN, 0.5], [0.5; 3]];
        assert!(message(SlopeMap::from_texels(2, 1.0, &hole)).contains("column 0 of row 1"));
        assert!(message(SlopeMap::from_normals(8, 2, 3, &gray)).contains("2 times 3"));
        assert!(message(SlopeMap::from_normals(8, 0, 0, &gray[..0])).contains("0 times 0, not 0"));
    }
}
