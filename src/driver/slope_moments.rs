//! The tabulated driver of slopes: a map whose slopes' moments over a footprint are read from a pyramid.

use super::taps::{Pixel, Reader, Taps, SAMPLER};
use super::Called;

/// A driver that reads mean and covariance of slopes over the pixel's footprint from a
/// [`SlopeMipmap`](crate::SlopeMipmap), and averages colors over taps about its major axis.
///
/// Taps count by the area of their facets in the picture, so that all of them together are the slopes that are seen of
/// the whole footprint. Root mean square errors of the color by one component of the slope, in thousandths, against the
/// integral over the map's bilinear reconstruction, facets counted by that area (views from 14 degrees above the mesh
/// up, minor deviations of 0.15, 0.6 and 2.5 texels; `spirv-tests/tests/driver/slope_colors.rs` measures them again):
///
/// | map of heights, colors, aspect of the footprint | point | 1 tap | 2 | 4 | 8 |
/// |---|---|---|---|---|---|
/// | gravel, six hard steps, 1:1 | 169 | 48 | 48 | 40 | 34 |
/// | 4:1 | 201 | 59 | 47 | 34 | 27 |
/// | 16:1 | 230 | 65 | 58 | 46 | 31 |
/// | elevations, terrain, 1:1 | 97 | 28 | 28 | 24 | 21 |
/// | 4:1 | 131 | 45 | 33 | 23 | 19 |
/// | 16:1 | 170 | 59 | 49 | 36 | 22 |
///
/// The tangent frame of view, light and direction has x along the columns of the map, y down its rows, and z along the
/// mesh's normal. A tap reads sixteen texels.
///
/// Default: one tap and a pixel deviation of 0.5.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct SlopeMoments {
    /// Evaluations of the color a pixel.
    pub taps: Taps,
    /// The filter that turns samples into a pixel.
    pub pixel: Pixel,
}

/// What a bound does not cover: footprints hold other distributions of slopes than the taps' normal ones.
///
/// The figures are over footprints from round to 16:1; a test of `spirv-tests` measures them.
pub(crate) fn gap(taps: Taps) -> String {
    let (elevations, gravel) = match taps {
        Taps::One => (0.045, 0.059),
        Taps::Two => (0.037, 0.050),
        Taps::Four => (0.027, 0.039),
        Taps::Eight => (0.020, 0.029),
    };
    format!(
        "how far the slopes of footprints are from normal distributions. Color by one component has an RMS of \
         {elevations:.3} on\n    elevations and {gravel:.3} on gravel with hard edges; \
         that of a point has 0.135 and 0.202"
    )
}

/// A tap's area in the picture for a unit of area of the mesh; where all taps are hidden they count alike.
pub(crate) fn area(mean: &str, covariance: &str) -> String {
    format!("max(slopes_area(view, {mean}, slopes_factor(view, {covariance})), 1e-20)")
}

/// The WGSL of `NAME_color`, which drives a filter by the moments of a map's slopes.
pub(crate) fn glue(called: &Called<'_>, moments: &SlopeMoments) -> String {
    let Called { name, function, color_type, given, parameters, .. } = *called;
    let area = area("m.mean", "m.covariance");
    let reader = Reader {
        image: "slopes",
        before: "",
        found: &|at, over| format!("let m = slope_moments_read(slopes, slopes_cross, slopes_sampler, {at}, {over});"),
        color: called.call("m.mean, m.covariance"),
        weight: given.contains(" view: ").then_some(area.as_str()),
    };
    let (points, body) = reader.body(color_type, moments.taps, moments.pixel);
    format!(
        "/// The mean of `{name}_{function}` over a pixel's footprint on a map of slopes, by {points}.
///
/// `position` is in texture coordinates, `dpdx` and `dpdy` are its screen derivatives; `slopes` and `slopes_cross` are
/// the pyramid of the map's mean slope and covariance, read at texel centers: {SAMPLER}
/// Slopes are along the columns and down the rows of the map.
fn {name}_color(position: vec2f, dpdx: vec2f, dpdy: vec2f{given}, slopes: texture_2d<f32>, slopes_cross: \
         texture_2d<f32>, slopes_sampler: sampler{parameters}) -> {color_type} {{
{body}}}
"
    )
}
