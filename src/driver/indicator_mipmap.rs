//! Pyramids of the shares of an image that are above edges.

use super::moment_mipmap::{check_size, check_values, Edge, LARGEST};
use super::pyramid::{Grid, Reconstruction};
use crate::table::{Format, Level, Sampling, Table};
use crate::Error;

/// How much of an image's bilinear reconstruction is above each of one to eight edges, at every size from the image's
/// own down to one texel: what a map of bands needs of an image, exactly.
///
/// A texel of a level, of the first one too, holds the shares of the area that it covers. Sizes halve and round down;
/// where they do not halve evenly a texel covers parts of texels, each weighted by the area covered. Shares of areas
/// add, so that no level is worth less than the image; what is left is the kernel that reading a level applies.
///
/// ```
/// use prefilter::{ColorMap, Edge, IndicatorMipmap};
///
/// // A ramp from 0 to 1 and back: evenly spread over its values.
/// let values: Vec<f32> = (0..64).map(|texel| 1.0 - (texel as f32 / 32.0 - 1.0).abs()).collect();
/// let map = ColorMap::bands([0.1, 0.2, 0.1], [(0.25, [0.5; 3]), (0.75, [0.9; 3])])?;
/// let shares = IndicatorMipmap::new(64, 1, &values, Edge::Repeat, &map.edges().unwrap_or_default())?;
/// assert_eq!(shares.shares(), [0.75, 0.25]);
/// # Ok::<(), prefilter::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct IndicatorMipmap {
    image: Level,
    levels: Vec<Level>,
    edges: usize,
}

/// The most edges of one pyramid: two textures of four channels.
pub(crate) const MOST_EDGES: usize = 8;

type Shares = [f64; MOST_EDGES];

impl IndicatorMipmap {
    /// The pyramid of an image given row by row, for edges that rise: those of a map are
    /// [`ColorMap::edges`](crate::ColorMap::edges).
    ///
    /// # Errors
    /// [`Error::Size`] where a side is 0 or above 16384, the number of values is not width times height or that of
    /// edges not from 1 to 8; [`Error::Value`] for a value that is no number or beyond ±1e15, or an edge that is no
    /// number or not above the one before it.
    pub fn new(width: u32, height: u32, values: &[f32], edge: Edge, edges: &[f32]) -> Result<Self, Error> {
        check_size(width, height, values.len())?;
        check_values(width, values, LARGEST)?;
        check_edges(edges)?;
        let image = Reconstruction { width: width as usize, height: height as usize, values, edge };
        let base = Grid::<MOST_EDGES>::above(&image, edges);
        let mut levels = vec![Level { width, height, depth: 1, texels: texels(&base) }];
        levels.extend(base.halved(mixed, |shares| shares.map(|share| share as f32)));
        let points = values.iter().flat_map(|&value| [value, 0.0]).collect();
        Ok(Self { image: Level { width, height, depth: 1, texels: points }, levels, edges: edges.len() })
    }

    /// The shares of the whole image that are above each edge.
    pub fn shares(&self) -> &[f32] {
        self.levels.last().map_or(&[], |level| &level.texels[..self.edges])
    }

    /// What `NAME_color` reads: `image`, the image itself in the first channel, and `shares` above the first four
    /// edges, with `shares_further` where there are more.
    ///
    /// `format` is that of the shares: [`Format::Rgba16Float`], whose eleven bits [`Table::error`] states, or
    /// [`Format::Rgba32Float`]. The image is [`Format::Rg32Float`].
    ///
    /// # Errors
    /// [`Error::Conflict`] for a format without four floats.
    pub fn tables(&self, format: Format) -> Result<Vec<Table>, Error> {
        if !matches!(format, Format::Rgba32Float | Format::Rgba16Float) {
            let message = format!("the table `shares` of bands has four floats a texel, {format:?} has not");
            return Err(Error::Conflict(message));
        }
        let table = |name: &str, format: Format, levels: Vec<Level>, error: f32| Table {
            name: name.to_owned(),
            format,
            sampling: Sampling::Loaded,
            levels,
            error,
        };
        let mut tables = vec![table("image", Format::Rg32Float, vec![self.image.clone()], 0.0)];
        for (name, first) in [("shares", 0), ("shares_further", 4)].into_iter().filter(|(_, first)| *first < self.edges)
        {
            let four = |level: &Level| Level {
                texels: level.texels.chunks(MOST_EDGES).flat_map(|shares| shares[first..first + 4].to_vec()).collect(),
                ..*level
            };
            let levels: Vec<Level> = self.levels.iter().map(four).collect();
            let rounded = |share: &f32| (half::f16::from_f32(*share).to_f32() - share).abs();
            let shares = levels.iter().flat_map(|level| &level.texels).map(rounded);
            let error = if format == Format::Rgba16Float { shares.fold(0.0, f32::max) } else { 0.0 };
            tables.push(table(name, format, levels, error));
        }
        Ok(tables)
    }
}

fn check_edges(edges: &[f32]) -> Result<(), Error> {
    if !(1..=MOST_EDGES).contains(&edges.len()) {
        let (what, allowed) = ("the edges of an image's shares".to_owned(), format!("1 to {MOST_EDGES}"));
        return Err(Error::Size { what, count: edges.len(), allowed });
    }
    let mut low = -LARGEST;
    for (number, &edge) in edges.iter().enumerate() {
        // Written so that NaN is refused.
        if !(low < edge && edge <= LARGEST) {
            let allowed = format!("above {low:e} and at most {LARGEST:e}");
            return Err(Error::value(format!("edge {number} of an image's shares"), edge, allowed));
        }
        low = edge;
    }
    Ok(())
}

fn texels(grid: &Grid<MOST_EDGES>) -> Vec<f32> {
    grid.moments.iter().flat_map(|shares| shares.map(|share| share as f32)).collect()
}

/// The shares of a mixture of areas; weights sum to one.
fn mixed(parts: &[(f64, Shares)]) -> Shares {
    std::array::from_fn(|edge| parts.iter().map(|(weight, shares)| weight * shares[edge]).sum::<f64>().min(1.0))
}

impl Grid<MOST_EDGES> {
    /// Shares of the bilinear reconstruction over the area of each texel of the image that are above each edge.
    fn above(image: &Reconstruction<'_>, edges: &[f32]) -> Self {
        let texel = |at: usize| {
            let quarters = image.quarters(at);
            let share = |edge: f32| quarters.iter().map(|quarter| 0.25 * above(*quarter, f64::from(edge))).sum();
            std::array::from_fn(|number| edges.get(number).map_or(0.0, |&edge| share(edge)))
        };
        let &Reconstruction { width, height, .. } = image;
        Self { width, height, moments: (0..width * height).map(texel).collect() }
    }
}

/// The share of x and y in [−½, ½] where c + p x + q y + r x y is above an edge.
///
/// Along y it is ½ + a/b where that is in [0, 1], with a = c − edge + p x and b = |q + r x|; between the x where it
/// becomes 0 or 1 that is a ratio of linear functions, of which the integral is a logarithm.
fn above([c, p, q, r]: [f64; 4], edge: f64) -> f64 {
    let a = |x: f64| c - edge + p * x;
    let b = |x: f64| q + r * x;
    let corners = [(-0.5, -0.5), (-0.5, 0.5), (0.5, -0.5), (0.5, 0.5)].map(|(x, y)| a(x) + b(x) * y);
    if corners.iter().all(|corner| *corner > 0.0) {
        return 1.0;
    }
    if corners.iter().all(|corner| *corner <= 0.0) {
        return 0.0;
    }
    // Where the line y = ½ or −½ crosses the edge, and where f is level along y.
    let roots = [(edge - c - 0.5 * q) / (p + 0.5 * r), (edge - c + 0.5 * q) / (p - 0.5 * r), -q / r];
    let mut ends =
        [-0.5, roots[0], roots[1], roots[2], 0.5].map(|x| if x.is_finite() { x.clamp(-0.5, 0.5) } else { 0.5 });
    ends.sort_by(f64::total_cmp);
    let piece = |[from, to]: [f64; 2]| {
        let middle = 0.5 * (from + to);
        let share = 0.5 + a(middle) / b(middle).abs();
        // A level line along y, 0/0 or ±∞, is all or nothing.
        if !(0.0 < share && share < 1.0) {
            return if a(middle) > 0.0 { to - from } else { 0.0 };
        }
        0.5 * (to - from) + b(middle).signum() * ratio([a(from), a(to)], [b(from), b(to)], to - from)
    };
    ends.windows(2).map(|pair| piece([pair[0], pair[1]])).sum()
}

/// The integral of a/b over a length, of linear functions with these ends and no root of b between them.
fn ratio(a: [f64; 2], b: [f64; 2], length: f64) -> f64 {
    let (middle, rise) = (0.5 * (b[0] + b[1]), b[1] - b[0]);
    let flat = 0.5 * (a[0] + a[1]) / middle;
    let t = rise / middle;
    // In u from −½ to ½: (ā + α u)/(b̄ (1 + t u)), α = a₁ − a₀.
    if t.abs() < 1e-2 {
        let slope = (a[1] - a[0]) / middle;
        // Powers of t to the fourth: 1e-10 of what is left.
        return length * (flat * (1.0 + t * t / 12.0 + t.powi(4) / 80.0) - slope * (t / 12.0 + t.powi(3) / 80.0));
    }
    let slope = (a[1] - a[0]) / middle;
    let logarithm = libm::log(b[1].abs().max(1e-300) / b[0].abs().max(1e-300));
    length * (slope / t + (flat - slope / t) * logarithm / t)
}
