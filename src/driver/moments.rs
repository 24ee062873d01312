//! The tabulated driver: an image whose moments over a footprint are read from a pyramid.

use super::taps::{Pixel, Reader, Taps, SAMPLER};
use super::Called;

/// A driver that reads mean and deviation over the pixel's footprint from a
/// [`MomentMipmap`](crate::driver::moment_mipmap::MomentMipmap), and averages colors over taps about its major axis.
///
/// What one normal distribution cannot say of a long footprint, several can. Root mean square errors of the color, in
/// thousandths, against the integral over the image's bilinear reconstruction (minor deviations of 0.15, 0.6 and 2.5
/// texels; `spirv-tests/tests/driver` measures them again):
///
/// | image, map, aspect of the footprint | point | 1 tap | 2 | 4 | 8 |
/// |---|---|---|---|---|---|
/// | gravel, six hard steps, 1:1 | 121 | 29 | 29 | 24 | 20 |
/// | 4:1 | 151 | 45 | 32 | 22 | 17 |
/// | 16:1 | 181 | 56 | 47 | 34 | 22 |
/// | elevations, terrain, 1:1 | 37 | 9 | 9 | 6 | 4 |
/// | 4:1 | 67 | 32 | 19 | 8 | 6 |
/// | 16:1 | 113 | 52 | 41 | 25 | 14 |
///
/// With [`Distribution::Pair`](crate::Distribution::Pair) the pyramid is a
/// [`FourMomentMipmap`](crate::FourMomentMipmap) instead, from whose skewness and kurtosis each tap finds two normal
/// distributions and evaluates the color twice. The same errors, beside those of one distribution
/// (`spirv-tests/tests/driver/pairs.rs`):
///
/// | image, map, aspect of the footprint | 1 tap | 2 | 4 | 8 | one, 1 tap | 2 | 4 | 8 |
/// |---|---|---|---|---|---|---|---|---|
/// | gravel, six hard steps, 1:1 | 24 | 24 | 19 | 14 | 29 | 29 | 24 | 20 |
/// | gravel, six hard steps, 4:1 | 37 | 28 | 19 | 14 | 45 | 32 | 22 | 17 |
/// | gravel, six hard steps, 16:1 | 47 | 43 | 29 | 18 | 56 | 47 | 34 | 22 |
/// | gravel, terrain, 1:1 | 16 | 16 | 11 | 8 | 22 | 22 | 18 | 15 |
/// | gravel, terrain, 4:1 | 31 | 23 | 15 | 11 | 40 | 29 | 20 | 15 |
/// | gravel, terrain, 16:1 | 42 | 36 | 25 | 15 | 51 | 43 | 31 | 22 |
/// | brick, six hard steps, 1:1 | 25 | 25 | 20 | 15 | 49 | 49 | 41 | 32 |
/// | brick, six hard steps, 4:1 | 47 | 34 | 21 | 14 | 100 | 71 | 44 | 27 |
/// | brick, six hard steps, 16:1 | 63 | 53 | 40 | 25 | 141 | 118 | 95 | 63 |
/// | brick, terrain, 1:1 | 15 | 15 | 11 | 8 | 40 | 40 | 35 | 28 |
/// | brick, terrain, 4:1 | 31 | 25 | 14 | 10 | 80 | 57 | 35 | 23 |
/// | brick, terrain, 16:1 | 41 | 37 | 26 | 16 | 113 | 95 | 74 | 50 |
/// | elevations, terrain, 1:1 | 7 | 7 | 5 | 3 | 9 | 9 | 7 | 4 |
/// | elevations, terrain, 4:1 | 29 | 17 | 8 | 6 | 32 | 19 | 8 | 6 |
/// | elevations, terrain, 16:1 | 47 | 37 | 24 | 13 | 52 | 41 | 25 | 14 |
///
/// A tap reads eight texels. Over round footprints the deviation itself is 2% to 22% off, least where footprints are
/// wide or far below a texel.
///
/// Default: one tap and a pixel deviation of 0.5.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Moments {
    /// Evaluations of the color a pixel.
    pub taps: Taps,
    /// The filter that turns samples into a pixel.
    pub pixel: Pixel,
    /// Whether heights find the covariance of their slopes, and the mean slope where the surface has one, in the
    /// image's [`SlopeMipmap`](crate::SlopeMipmap) over the pixel's footprint: both pyramids are then of one image.
    /// Default: no, they are passed.
    #[cfg_attr(feature = "serde", serde(default))]
    pub slopes: bool,
}

/// What the slopes' pyramid gives in place of the caller: parameters of a scene of heights, and what they are of it.
const OF_SLOPES: [(&str, &str); 2] = [
    ("mean_slope: vec2f", "let mean_slope = slope.mean;"),
    ("slope_covariance: vec3f", "let slope_covariance = slope.covariance;"),
];

/// What a bound does not cover: footprints hold other distributions than the taps' normal ones.
///
/// The figures are those of `docs/demo.csv`, against stratified brute force; a test of `spirv-tests` compares.
pub(crate) fn gap(taps: Taps) -> String {
    let (terrain, gravel) = match taps {
        Taps::One => (0.057, 0.061),
        Taps::Two => (0.042, 0.046),
        Taps::Four => (0.028, 0.033),
        Taps::Eight => (0.019, 0.024),
    };
    format!(
        "how far footprints are from normal distributions. `cargo xtask demo` measures, all in all,\n    an RMS of \
         {terrain} on a terrain and {gravel} on gravel with hard edges; the naive map has 0.18 and 0.22"
    )
}

/// The WGSL of `NAME_color`, which drives a filter by the moments of an image.
pub(crate) fn glue(called: &Called<'_>, moments: &Moments) -> String {
    let Called { name, color_type, parameters, .. } = *called;
    let (mut given, mut before) = (called.given.to_owned(), String::new());
    let (mut tables, mut said) = (String::new(), "");
    if moments.slopes {
        before += "    let slope = slope_moments_read(slopes, slopes_cross, slopes_sampler, position, footprint);\n";
        for (parameter, statement) in OF_SLOPES.into_iter().filter(|(parameter, _)| called.given.contains(parameter)) {
            given = given.replace(&format!(", {parameter}"), "");
            before += &format!("    {statement}\n");
        }
        tables += ", slopes: texture_2d<f32>, slopes_cross: texture_2d<f32>, slopes_sampler: sampler";
        said = SLOPES;
    }
    let shaped = called.function == "pair";
    let of = if shaped { "mean, deviation, skewness and kurtosis" } else { "mean and deviation" };
    let reader = Reader {
        image: "moments",
        before: &before,
        found: &|at, over| {
            let read = format!("moments_read(moments, moments_sampler, {at}, {over})");
            if shaped {
                format!("let m = four_moments_standard(four_{read});")
            } else {
                format!("let m = {read};")
            }
        },
        color: called.call(if shaped { "m.x, sqrt(max(m.y, 0.0)), m.z, m.w" } else { "m.x, m.y" }),
        weight: None,
    };
    let (points, body) = reader.body(color_type, moments.taps, moments.pixel);
    format!(
        "/// Mean color of `{name}` over a pixel's footprint on an image, by {points}.
///
/// `position` is in texture coordinates, `dpdx` and `dpdy` are its screen derivatives; `moments` is the image's
/// pyramid of {of}, read at texel centers: {SAMPLER}{said}
fn {name}_color(position: vec2f, dpdx: vec2f, dpdy: vec2f{given}, moments: texture_2d<f32>, moments_sampler: \
         sampler{tables}{parameters}) -> {color_type} {{
{body}}}
"
    )
}

/// What `NAME_color` says of slopes.
const SLOPES: &str = "
///
/// `slopes` and `slopes_cross` are the pyramid of mean slope and covariance of the same image, which gives the slopes
/// of the whole footprint.";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn writes_valid_glue_for_every_number_of_taps() {
        let texture = "fn rock_texture(mean: f32, deviation: f32, knots: texture_2d<f32>) -> vec4f {
            return textureLoad(knots, vec2i(0, 0), 0) * mean * deviation;
        }\n";
        for taps in [Taps::One, Taps::Two, Taps::Four, Taps::Eight] {
            for pixel in [Pixel::Round(1.0), Pixel::Covariance([0.25, 0.0, 1e-5])] {
                let called = Called {
                    name: "rock",
                    function: "texture",
                    color_type: "vec4f",
                    given: "",
                    parameters: ", knots: texture_2d<f32>",
                    arguments: ", knots",
                    edges: &[],
                };
                let glue = glue(&called, &Moments { taps, pixel, slopes: false });
                let text = prefilter_wgsl::link(&format!("{texture}{glue}")).unwrap();
                let module =
                    naga::front::wgsl::parse_str(&text).unwrap_or_else(|e| panic!("{}", e.emit_to_string(&text)));
                let mut validator = naga::valid::Validator::new(
                    naga::valid::ValidationFlags::all(),
                    naga::valid::Capabilities::empty(),
                );
                validator.validate(&module).unwrap();
                assert!(glue.lines().all(|line| line.len() <= 160), "{glue}");
                assert_eq!(glue.contains("for ("), taps != Taps::One);
            }
        }
    }
}
