//! The tabulated driver of maps of bands: shares of each band over a footprint, from a pyramid.

use super::taps::{Pixel, Reader, Taps, SAMPLER};
use super::Called;

/// A driver that reads how much of the pixel's footprint each band of a map covers from an
/// [`IndicatorMipmap`](crate::IndicatorMipmap): maps of two to nine bands over an image, with no assumption about the
/// distribution of its values.
///
/// Root mean square errors of the color, in thousandths, against the integral over the image's bilinear reconstruction,
/// of six hard steps (minor deviations of 0.15, 0.6 and 2.5 texels; `spirv-tests/tests/driver/indicators.rs` measures
/// them again), beside those of one normal distribution a tap, [`Moments`](crate::Moments):
///
/// | image, aspect of the footprint | 1 tap | 2 | 4 | 8 | normal, 1 tap | 2 | 4 | 8 |
/// |---|---|---|---|---|---|---|---|---|
/// | gravel, 1:1 | 18 | 18 | 12 | 8 | 29 | 29 | 24 | 20 |
/// | gravel, 4:1 | 34 | 26 | 15 | 12 | 45 | 32 | 22 | 17 |
/// | gravel, 16:1 | 44 | 40 | 28 | 17 | 56 | 47 | 34 | 22 |
/// | brick, 1:1 | 15 | 15 | 11 | 8 | 49 | 49 | 41 | 32 |
/// | brick, 4:1 | 33 | 25 | 14 | 11 | 100 | 71 | 44 | 27 |
/// | brick, 16:1 | 40 | 35 | 26 | 16 | 141 | 118 | 95 | 63 |
///
/// What is left is the kernel of the pyramid's levels, boxes and tents that are not the footprint's Gaussian. Below a
/// deviation of half a texel the filter takes over, with the image's plane. A tap reads twelve texels, and eight more
/// where the map has more than five bands.
///
/// The pyramid belongs to the image and to the edges of the map, the colors of the bands are the scene's. Where they
/// never change, a mipmap of the colored image knows as much, in three channels.
///
/// Default: one tap and a pixel deviation of 0.5.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Indicators {
    /// Reads of the shares a pixel.
    pub taps: Taps,
    /// The filter that turns samples into a pixel.
    pub pixel: Pixel,
}

/// What a bound does not cover; the figures are over footprints from round to 16:1, and a test measures them.
pub(crate) const GAP: &str = "how far the pyramid's kernels are from the footprint: six hard bands on gravel have an \
                              RMS of 0.034 by\n    one tap and of 0.013 by eight; the map at a point has 0.15";

/// The names of the bands' colors, from the lowest.
const BANDS: [&str; 9] = ["a", "b", "c", "d", "e", "f", "g", "h", "i"];

/// The WGSL of `NAME_color`, which colors by shares and close up by the filter.
pub(crate) fn glue(called: &Called<'_>, indicators: &Indicators) -> String {
    let Called { name, color_type, given, parameters, edges, .. } = *called;
    let colors = middles(edges).into_iter().zip(BANDS);
    let colors = colors.map(|(at, band)| format!("    let band_{band} = {};\n", called.call(&format!("{at:?}, 0.0"))));
    let further = if edges.len() > 4 { ", shares_further" } else { "" };
    let tables = further.replace("further", "further: texture_2d<f32>");
    let (near, far) = (called.call("value.x, value.y"), mean(edges.len()));
    let found = |at: &str, over: &str| {
        let shares = |name: &str, table: &str| {
            format!("let {name} = indicators_shares({table}, shares_sampler, {at}, {over});\n")
        };
        let first = shares("above", "shares");
        let second = if further.is_empty() { String::new() } else { shares("further", "shares_further") };
        format!(
            "let value = indicators_value(image, image_sampler, {at}, {over});
let near = {near};
{first}{second}let far = {far};
let plane = indicators_plane({over});"
        )
    };
    let reader = Reader {
        image: "image",
        before: &colors.collect::<String>(),
        found: &found,
        color: "mix(far, near, plane)".to_owned(),
        weight: None,
    };
    let (points, body) = reader.body(color_type, indicators.taps, indicators.pixel);
    format!(
        "/// Mean color of `{name}` over a pixel's footprint on an image, by {points} of the shares of its bands.
///
/// `position` is in texture coordinates, `dpdx` and `dpdy` are its screen derivatives; `shares` holds how much of the
/// image is above each edge, read at texel centers: {SAMPLER}
fn {name}_color(position: vec2f, dpdx: vec2f, dpdy: vec2f{given}, image: texture_2d<f32>, image_sampler: sampler, \
         shares: texture_2d<f32>{tables}, shares_sampler: sampler{parameters}) -> {color_type} {{
{body}}}
"
    )
}

/// A value in each band, far from its edges.
fn middles(edges: &[f32]) -> Vec<f32> {
    let (Some(first), Some(last)) = (edges.first(), edges.last()) else { return Vec::new() };
    let away = |edge: &f32| edge.abs().max(1.0);
    let between = edges.windows(2).map(|pair| 0.5 * pair[0] + 0.5 * pair[1]);
    std::iter::once(first - away(first)).chain(between).chain(std::iter::once(last + away(last))).collect()
}

/// The mean of the bands' colors, each by the share above its lower edge that is not above its upper one.
fn mean(edges: usize) -> String {
    let share = |edge: usize| {
        let channel = ["x", "y", "z", "w"][edge % 4];
        if edge < 4 {
            format!("above.{channel}")
        } else {
            format!("further.{channel}")
        }
    };
    let mut sum = format!("(1.0 - {}) * band_{}", share(0), BANDS[0]);
    for edge in 0..edges {
        let own = if edge + 1 < edges { format!("({} - {})", share(edge), share(edge + 1)) } else { share(edge) };
        sum += &format!(" + {own} * band_{}", BANDS[edge + 1]);
    }
    sum
}
