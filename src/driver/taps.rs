//! The pixel's footprint on an image, and the points of it that are evaluated.

use crate::Error;

/// What exports say of the samplers of pyramids, behind the end of a sentence's first half.
pub(super) const SAMPLER: &str = "a sampler
/// has the address mode of the pyramid's `Edge`, and where texels have 32 bits a channel it is a nearest one.";

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

impl Default for Pixel {
    /// A deviation of 0.5.
    fn default() -> Self {
        Self::Round(0.5)
    }
}

/// Largest deviation of a pixel's filter, in pixels.
const WIDEST: f32 = 16.0;

impl Pixel {
    /// Whether the description can be used.
    ///
    /// # Errors
    /// [`Error::Value`] where the pixel's filter has a deviation that is negative, no number or beyond 16 pixels, or a
    /// covariance that is not positive semi-definite.
    pub(crate) fn check(&self) -> Result<(), Error> {
        let refuse = |what: &str, value: f32, allowed: String| Err(Error::value(what, value, allowed));
        match *self {
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

/// Two vectors whose squares sum to the pixel's footprint, from the position's screen derivatives: a Cholesky factor of
/// the pixel's filter.
pub(crate) fn vectors(pixel: Pixel, position_type: &str) -> String {
    let limited = |derivative: &str| format!("clamp({derivative}, {position_type}(-1e9), {position_type}(1e9))");
    let (right, down) = (limited("dpdx"), limited("dpdy"));
    match pixel {
        Pixel::Round(deviation) => format!(
            "    let across = {right} * {deviation:?};
    let along = {down} * {deviation:?};
"
        ),
        Pixel::Covariance([xx, xy, yy]) => {
            let [xx, xy, yy] = [xx, xy, yy].map(f64::from);
            let column = xx.max(1e-30).sqrt();
            let shear = xy / column;
            let rest = (yy - shear * shear).max(0.0).sqrt();
            let [column, shear, rest] = [column, shear, rest].map(|factor| factor as f32);
            format!(
                "    let across = {right} * {column:?} + {down} * {shear:?};
    let along = {down} * {rest:?};
"
            )
        }
    }
}

/// What of an image a driver reads for a point, and what it makes of that.
pub(super) struct Reader<'a> {
    /// The image, whose size scales derivatives.
    pub image: &'a str,
    /// Statements behind the one that names the footprint.
    pub before: &'a str,
    /// Statements that find what the color is made of, from the names of a position and a footprint.
    pub found: &'a dyn Fn(&str, &str) -> String,
    /// The expression of the color.
    pub color: String,
    /// How much a point counts beside its place, where not all count alike.
    pub weight: Option<&'a str>,
}

impl Reader<'_> {
    /// The body of `NAME_color`, and its number of taps in words.
    pub fn body(&self, color_type: &str, taps: Taps, pixel: Pixel) -> (String, String) {
        let (image, before, count) = (self.image, self.before, taps.count());
        let footprint = match pixel {
            Pixel::Round(deviation) => {
                format!("footprint_covariance_round(dpdx * size, dpdy * size, {deviation:?})")
            }
            Pixel::Covariance([xx, xy, yy]) => {
                format!("footprint_covariance(dpdx * size, dpdy * size, vec3f({xx:?}, {xy:?}, {yy:?}))")
            }
        };
        let (points, body) = match count {
            1 => {
                let found = (self.found)("position", "footprint").replace('\n', "\n    ");
                ("one tap".to_owned(), format!("    {found}\n    return {};\n", self.color))
            }
            _ => (format!("{count} taps"), self.taps_loop(color_type, count)),
        };
        (
            points,
            format!(
                "    let size = vec2f(textureDimensions({image}, 0));
    let footprint = {footprint};
{before}{body}"
            ),
        )
    }

    /// The body for several taps.
    fn taps_loop(&self, color_type: &str, taps: u32) -> String {
        let found = (self.found)("at", "tap_footprint").replace('\n', "\n        ");
        let found = format!("let at = position + place.x * along + place.y * across;\n        {found}");
        let average = averaged(taps, color_type, &found, self.weight, &self.color);
        format!(
            "    let deviations = footprint_deviations(footprint);
    let axis = footprint_direction(footprint);
    let tap_footprint = taps_covariance(axis, deviations.x, deviations.y, {taps}.0);
    let spread = sqrt(taps_spread(deviations.x, deviations.y, {taps}.0));
    let along = axis * spread.x / size;
    let across = vec2f(-axis.y, axis.x) * spread.y / size;
{average}"
        )
    }
}

/// The loop that averages a color over several taps, behind the statements that find what it is of at a `place`; the
/// number of turns is a literal, so that costs can be counted.
pub(super) fn averaged(taps: u32, color_type: &str, found: &str, weight: Option<&str>, color: &str) -> String {
    let (total, sum, mean) = match weight {
        None => (String::new(), "        sum += place.z * color;\n".to_owned(), "sum"),
        Some(weight) => (
            "    var total = 0.0;\n".to_owned(),
            format!(
                "        let weight = place.z * {weight};
        sum += weight * color;
        total += weight;
"
            ),
            "sum / total",
        ),
    };
    format!(
        "    var sum = {color_type}();
{total}    var low = {color_type}(3e38);
    var high = {color_type}(-3e38);
    for (var tap = 0; tap < {taps}; tap++) {{
        let place = taps_place(f32(tap), {taps}.0);
        {found}
        let color = {color};
{sum}        low = min(low, color);
        high = max(high, color);
    }}
    return clamp({mean}, low, high); // rounded weights may add up to more than one
"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn refuses_filters_that_are_none() {
        for pixel in [
            Pixel::Round(-0.1),
            Pixel::Round(f32::NAN),
            Pixel::Round(f32::INFINITY),
            Pixel::Covariance([0.25, 0.3, 0.25]),
            Pixel::Covariance([0.25, f32::NAN, 0.25]),
            Pixel::Covariance([-0.25, 0.0, 0.25]),
        ] {
            assert!(matches!(pixel.check(), Err(Error::Value { .. })), "{pixel:?}");
        }
        for pixel in [Pixel::default(), Pixel::Round(0.0), Pixel::Covariance([0.3, 0.1 * 0.3, 0.003])] {
            assert_eq!(pixel.check(), Ok(()));
        }
    }
}
