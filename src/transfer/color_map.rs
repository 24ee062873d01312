//! Color maps: piecewise-linear functions from a value to a color.

use super::srgb::color_to_linear;
use crate::reference::texture::PiecewiseLinear;
use crate::Error;

/// The most knots of a map: as wide as the narrowest texture limit among WebGPU, WebGL2 and Vulkan hosts.
pub const MAX_KNOTS: usize = 2048;

/// The largest magnitude of a color channel: the largest finite half, since tables may store colors as halves.
pub const MAX_COLOR: f32 = 65504.0;

/// A piecewise-linear map from a value (a noise, a height) to three or four linear channels.
///
/// The map is constant below its first and above its last knot. Colors are linear inside; the `_srgb` constructors
/// decode sRGB first. A fourth channel is premultiplied alpha or a material value such as roughness, and is never
/// decoded. Positions share their unit with the mean that the module is called with.
///
/// ```
/// use prefilter::ColorMap;
/// let lichen = ColorMap::gradient([
///     (0.00, [0.05, 0.09, 0.03]),
///     (0.45, [0.21, 0.24, 0.10]),
///     (0.45, [0.42, 0.40, 0.37]), // the same position twice: a hard edge
///     (1.00, [0.71, 0.69, 0.66]),
/// ])?;
/// assert_eq!(lichen.channels(), 3);
/// # Ok::<(), prefilter::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(into = "super::serial::Parts", try_from = "super::serial::Parts"))]
pub struct ColorMap {
    pub(super) knots: Vec<Knot>,
    pub(super) channels: usize,
}

/// A position where a map bends or jumps.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Knot {
    /// Where.
    pub position: f32,
    /// The color that the map reaches from the left; unused channels are 0.
    pub left: [f32; 4],
    /// The color with which it goes on to the right; differs from `left` at a hard edge.
    pub right: [f32; 4],
}

/// Where a module finds a map's colors.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Colors {
    /// Unrolled into the text: no binding, the fastest for a handful of stops.
    #[default]
    Constant,
    /// In a texture: materials that differ only in colors, stops and stop count share one text and one pipeline. Name
    /// the tier then, and the ranges where maps leave [0, 1]: what is chosen, and so the text, differs from map to map.
    Dynamic,
}

impl ColorMap {
    /// A gradient through linear colors at positions that do not fall; the same position twice is a hard edge.
    ///
    /// # Errors
    /// No stop, more than [`MAX_KNOTS`], channels other than three or four, a position or color that is not finite or
    /// beyond [`MAX_COLOR`], positions out of order, more than two stops at one position.
    pub fn gradient<const N: usize>(stops: impl IntoIterator<Item = (f32, [f32; N])>) -> Result<Self, Error> {
        let mut knots: Vec<Knot> = Vec::new();
        let mut doubled = false;
        for (index, (position, color)) in stops.into_iter().enumerate() {
            let color = four(color)?;
            within(&format!("stop {index}"), position, &[color])?;
            let refused = |allowed: &str| Err(Error::value(format!("stop {index}'s position"), position, allowed));
            match knots.last_mut() {
                Some(last) if position < last.position => {
                    return refused(&format!("not below the position before it, {}", last.position))
                }
                Some(last) if position == last.position && doubled => {
                    return refused("at most two stops at one position")
                }
                Some(last) if position == last.position => {
                    last.right = color;
                    doubled = true;
                }
                _ => {
                    knots.push(Knot { position, left: color, right: color });
                    doubled = false;
                }
            }
        }
        Self::from_knots(knots, N)
    }

    /// [`Self::gradient`] with sRGB-encoded colors; the gradient between the stops is linear in light.
    ///
    /// # Errors
    /// As [`Self::gradient`].
    pub fn gradient_srgb<const N: usize>(stops: impl IntoIterator<Item = (f32, [f32; N])>) -> Result<Self, Error> {
        Self::gradient(stops.into_iter().map(|(position, color)| (position, color_to_linear(color))))
    }

    /// Bands of one linear color each: the color below the first edge, then each edge with the color above it.
    ///
    /// # Errors
    /// As [`Self::gradient`]; edges rise strictly.
    pub fn bands<const N: usize>(
        lowest: [f32; N],
        edges: impl IntoIterator<Item = (f32, [f32; N])>,
    ) -> Result<Self, Error> {
        let mut left = four(lowest)?;
        let mut knots = Vec::new();
        for (position, color) in edges {
            let right = four(color)?;
            knots.push(Knot { position, left, right });
            left = right;
        }
        Self::from_knots(knots, N)
    }

    /// [`Self::bands`] with sRGB-encoded colors.
    ///
    /// # Errors
    /// As [`Self::bands`].
    pub fn bands_srgb<const N: usize>(
        lowest: [f32; N],
        edges: impl IntoIterator<Item = (f32, [f32; N])>,
    ) -> Result<Self, Error> {
        let edges = edges.into_iter().map(|(position, color)| (position, color_to_linear(color)));
        Self::bands(color_to_linear(lowest), edges)
    }

    /// The map that a linearly filtered, clamped row of linear texels is, spread from `low` to `high`: texel i of n
    /// lies on the center of its cell, at `low + (high − low)(i + ½)/n`.
    ///
    /// # Errors
    /// As [`Self::gradient`]; `low` below `high`, both finite.
    pub fn sampled<const N: usize>(low: f32, high: f32, texels: &[[f32; N]]) -> Result<Self, Error> {
        if !(low < high && low.is_finite() && high.is_finite()) {
            return Err(Error::value(
                "the high end of a sampled map",
                high,
                format!("finite and above the low end {low}"),
            ));
        }
        count(texels.len())?;
        let (start, span) = (f64::from(low), f64::from(high) - f64::from(low));
        let center = |index: usize| (start + span * (index as f64 + 0.5) / texels.len() as f64) as f32;
        Self::gradient(texels.iter().enumerate().map(|(index, &texel)| (center(index), texel)))
    }

    /// [`Self::sampled`] with sRGB-encoded texels; as sRGB textures do, it filters the decoded ones.
    ///
    /// # Errors
    /// As [`Self::sampled`].
    pub fn sampled_srgb<const N: usize>(low: f32, high: f32, texels: &[[f32; N]]) -> Result<Self, Error> {
        let linear: Vec<[f32; N]> = texels.iter().map(|&texel| color_to_linear(texel)).collect();
        Self::sampled(low, high, &linear)
    }

    /// The map with these knots and three or four channels, checked: what every constructor ends in.
    pub(super) fn from_knots(knots: Vec<Knot>, channels: usize) -> Result<Self, Error> {
        count(knots.len())?;
        for (index, knot) in knots.iter().enumerate() {
            within(&format!("knot {index}"), knot.position, &[knot.left, knot.right])?;
        }
        for (index, pair) in knots.windows(2).enumerate() {
            if pair[1].position <= pair[0].position {
                let allowed = format!("above the position before it, {}", pair[0].position);
                return Err(Error::value(format!("knot {}'s position", index + 1), pair[1].position, allowed));
            }
        }
        Ok(Self { knots, channels })
    }

    /// Three or four.
    pub fn channels(&self) -> usize {
        self.channels
    }

    /// The knots by position; at least one.
    pub fn knots(&self) -> &[Knot] {
        &self.knots
    }

    /// Where the bands of a map of bands meet, from the lowest; none for a map with a gradient.
    pub fn edges(&self) -> Option<Vec<f32>> {
        let flat = self.knots.windows(2).all(|pair| pair[0].right == pair[1].left);
        flat.then(|| self.knots.iter().map(|knot| knot.position).collect())
    }

    /// The smallest and the largest value of each channel: no filtered color leaves this box.
    pub fn hull(&self) -> ([f32; 4], [f32; 4]) {
        let colors = || self.knots.iter().flat_map(|knot| [knot.left, knot.right]);
        let fold = |start: f32, pick: fn(f32, f32) -> f32| {
            std::array::from_fn(|channel| colors().map(|color| color[channel]).fold(start, pick))
        };
        (fold(f32::INFINITY, f32::min), fold(f32::NEG_INFINITY, f32::max))
    }

    /// How far apart the hull's ends are in each channel.
    pub(crate) fn spans(&self) -> [f64; 4] {
        let (low, high) = self.hull();
        std::array::from_fn(|channel| f64::from(high[channel]) - f64::from(low[channel]))
    }

    /// The largest of the hull's spans: no two colors of the map differ by more in any channel.
    pub(crate) fn widest_span(&self) -> f32 {
        self.spans().into_iter().fold(0.0, f64::max) as f32
    }

    /// The same map for the f64 reference.
    pub fn reference(&self) -> PiecewiseLinear {
        let wide = |color: [f32; 4]| color.map(f64::from);
        let knot = |knot: &Knot| (f64::from(knot.position), wide(knot.left), wide(knot.right));
        PiecewiseLinear { knots: self.knots.iter().map(knot).collect() }
    }
}

/// A color of three or four channels with four.
pub(super) fn four<const N: usize>(color: [f32; N]) -> Result<[f32; 4], Error> {
    if N != 3 && N != 4 {
        return Err(Error::Size { what: "the channels of a color".into(), count: N, allowed: "3 or 4".into() });
    }
    Ok(std::array::from_fn(|channel| color.get(channel).copied().unwrap_or(0.0)))
}

/// Whether a position and its colors are in the limits.
fn within(what: &str, position: f32, colors: &[[f32; 4]]) -> Result<(), Error> {
    let allowed = format!("a number from -{MAX_COLOR} to {MAX_COLOR}");
    if !(position.abs() <= MAX_COLOR) {
        return Err(Error::value(format!("{what}'s position"), position, allowed));
    }
    match colors.iter().flatten().find(|channel| !(channel.abs() <= MAX_COLOR)) {
        Some(&channel) => Err(Error::value(format!("a color channel of {what}"), channel, allowed)),
        None => Ok(()),
    }
}

fn count(count: usize) -> Result<(), Error> {
    if !(1..=MAX_KNOTS).contains(&count) {
        let what = "the stops of a color map".into();
        return Err(Error::Size { what, count, allowed: format!("1 to {MAX_KNOTS}") });
    }
    Ok(())
}
