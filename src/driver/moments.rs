//! The tabulated driver: an image whose moments over a footprint are read from a pyramid.

use super::Called;
use crate::Error;

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
/// A tap reads eight texels. Over round footprints the deviation itself is 2% to 22% off, least where footprints are
/// wide or far below a texel.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Moments {
    /// Evaluations of the color a pixel.
    pub taps: Taps,
    /// The filter that turns samples into a pixel.
    pub pixel: Pixel,
}

/// How many points of a footprint are evaluated: along its major axis, four and eight of them in two rows where it is
/// about round.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Taps {
    /// One, for the whole footprint.
    #[default]
    One,
    /// Two.
    Two,
    /// Four.
    Four,
    /// Eight.
    Eight,
}

impl Taps {
    /// The number.
    pub fn count(self) -> u32 {
        match self {
            Self::One => 1,
            Self::Two => 2,
            Self::Four => 4,
            Self::Eight => 8,
        }
    }
}

/// The pixel's filter: a Gaussian of the same covariance stands for it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Pixel {
    /// The same deviation along x and y, 0 to 16 pixels: box 0.289, Mitchell 0.333, tent 0.408, Gaussian resolve 0.5.
    Round(f32),
    /// The covariance xx, xy, yy in pixels²: positive semi-definite, variances up to 256.
    Covariance([f32; 3]),
}

impl Default for Moments {
    /// One tap and a pixel deviation of 0.5.
    fn default() -> Self {
        Self { taps: Taps::One, pixel: Pixel::Round(0.5) }
    }
}

/// Largest deviation of a pixel's filter, in pixels.
const WIDEST: f32 = 16.0;

impl Moments {
    /// Whether the description can be used.
    ///
    /// # Errors
    /// [`Error::Value`] where the pixel's filter has a deviation that is negative, no number or beyond 16 pixels, or a
    /// covariance that is not positive semi-definite.
    pub(crate) fn check(&self) -> Result<(), Error> {
        let refuse = |what: &str, value: f32, allowed: String| Err(Error::value(what, value, allowed));
        match self.pixel {
            Pixel::Round(deviation) if !(0.0..=WIDEST).contains(&deviation) => {
                refuse("the pixel's deviation", deviation, format!("0 to {WIDEST} pixels"))
            }
            Pixel::Round(_) => Ok(()),
            Pixel::Covariance([xx, xy, yy]) => {
                let variances = 0.0..=WIDEST * WIDEST;
                for (name, variance) in [("xx", xx), ("yy", yy)] {
                    if !variances.contains(&variance) {
                        let what = format!("the pixel's covariance {name}");
                        return refuse(&what, variance, format!("0 to {} pixels²", variances.end()));
                    }
                }
                // Rounded entries of a singular covariance may miss by an ulp.
                if xy * xy <= xx * yy * (1.0 + 1e-6) {
                    return Ok(());
                }
                refuse("the pixel's covariance xy", xy, format!("at most √(xx yy) = {} either way", (xx * yy).sqrt()))
            }
        }
    }
}

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
    let Called { name, color_type, given, parameters, .. } = *called;
    let footprint = match moments.pixel {
        Pixel::Round(deviation) => {
            format!("footprint_covariance_round(dpdx * size, dpdy * size, {deviation:?})")
        }
        Pixel::Covariance([xx, xy, yy]) => {
            format!("footprint_covariance(dpdx * size, dpdy * size, vec3f({xx:?}, {xy:?}, {yy:?}))")
        }
    };
    let taps = moments.taps.count();
    let (points, body) = match taps {
        1 => (
            "one tap".to_owned(),
            format!(
                "    let m = moments_read(moments, moments_sampler, position, footprint);
    return {};
",
                called.call()
            ),
        ),
        _ => (format!("{taps} taps"), taps_loop(called, taps)),
    };
    format!(
        "/// Mean color of `{name}` over a pixel's footprint on an image, by {points}.
///
/// `position` is in texture coordinates, `dpdx` and `dpdy` are its screen derivatives; `moments` is the image's
/// pyramid of mean and deviation, read at texel centers: its sampler may be of any kind.
fn {name}_color(position: vec2f, dpdx: vec2f, dpdy: vec2f{given}, moments: texture_2d<f32>, moments_sampler: \
         sampler{parameters}) -> {color_type} {{
    let size = vec2f(textureDimensions(moments, 0));
    let footprint = {footprint};
{body}}}
"
    )
}

/// The body for several taps; the number of turns is a literal, so that costs can be counted.
fn taps_loop(called: &Called<'_>, taps: u32) -> String {
    let (color_type, call) = (called.color_type, called.call());
    format!(
        "    let deviations = footprint_deviations(footprint);
    let axis = footprint_direction(footprint);
    let tap_footprint = taps_covariance(axis, deviations.x, deviations.y, {taps}.0);
    let spread = sqrt(taps_spread(deviations.x, deviations.y, {taps}.0));
    let along = axis * spread.x / size;
    let across = vec2f(-axis.y, axis.x) * spread.y / size;
    var sum = {color_type}();
    var low = {color_type}(3e38);
    var high = {color_type}(-3e38);
    for (var tap = 0; tap < {taps}; tap++) {{
        let place = taps_place(f32(tap), {taps}.0);
        let at = position + place.x * along + place.y * across;
        let m = moments_read(moments, moments_sampler, at, tap_footprint);
        let color = {call};
        sum += place.z * color;
        low = min(low, color);
        high = max(high, color);
    }}
    return clamp(sum, low, high); // rounded weights may add up to more than one
"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn refuses_filters_that_are_none() {
        let check = |pixel| Moments { pixel, ..Moments::default() }.check();
        for pixel in [
            Pixel::Round(-0.1),
            Pixel::Round(f32::NAN),
            Pixel::Round(f32::INFINITY),
            Pixel::Covariance([0.25, 0.3, 0.25]),
            Pixel::Covariance([0.25, f32::NAN, 0.25]),
            Pixel::Covariance([-0.25, 0.0, 0.25]),
        ] {
            assert!(matches!(check(pixel), Err(Error::Value { .. })), "{pixel:?}");
        }
        assert_eq!(Moments::default().check(), Ok(()));
        assert_eq!(check(Pixel::Round(0.0)), Ok(()));
        assert_eq!(check(Pixel::Covariance([0.3, 0.1 * 0.3, 0.003])), Ok(()));
    }

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
                };
                let glue = glue(&called, &Moments { taps, pixel });
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
