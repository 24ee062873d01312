//! Patterns of two values: stripes, checkers and grids.

use super::function::{Dimensions, Evaluation, Function};
use super::moment_mipmap::LARGEST;
use super::taps::{Pixel, Taps};
use super::Called;
use crate::Error;

/// What a pattern's higher value covers.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Motif {
    /// Stripes across x that begin at whole numbers.
    Stripes {
        /// The share of the period 1 that they cover, 0 to 1; thin lines have a small one.
        duty: f32,
    },
    /// The squares of the side 1 that begin at an even sum of two whole numbers.
    #[default]
    Checker,
    /// Lines centered at whole numbers along x and along y.
    Grid {
        /// Widths of the lines across x and of those across y, 0 to 1.
        widths: [f32; 2],
    },
}

/// A driver that has one of two values: stripes, the squares of a checker, or the lines of a grid, in the plane.
///
/// Of a footprint it knows the share that has the second value, and with that all moments. The color map of a
/// [`texture`](crate::Scene::texture), alone or as a layer, is mixed from its colors at the two, which is exact for any
/// map: one tap is enough. As heights, values count as normal.
///
/// Shares over Gaussian footprints at any rotation, aspects up to 16 and minor deviations from 0.02 to 2 periods, root
/// mean square and largest error against the integral (`spirv-tests/tests/pattern/shares.rs` measures them again):
///
/// | motif | ours | product of the means along both axes | boxes along the axes |
/// |---|---|---|---|
/// | checker | 0.0001 (0.002) | 0.065 (0.45) | 0.074 (0.45) |
/// | grid, lines of 0.02 to 0.7 | 0.0002 (0.005) | 0.013 (0.18) | 0.039 (0.31) |
///
/// Stripes are exact to 2e-6, so that thin lines far away are the share that they cover.
///
/// ```
/// use prefilter::{ColorMap, Driver, Motif, Pattern, Scene};
/// let tiles = ColorMap::gradient([(0.0, [0.1, 0.1, 0.1]), (1.0, [0.8, 0.75, 0.7])])?;
/// let grid = Pattern { motif: Motif::Grid { widths: [0.05, 0.1] }, values: [1.0, 0.0], ..Pattern::default() };
/// let module = Scene::new("tiles").texture(tiles).driver(Driver::Pattern(grid)).module()?;
/// assert_eq!(module.exports()[2].signature, "fn tiles_color(position: vec2f, dpdx: vec2f, dpdy: vec2f) -> vec3f");
/// # Ok::<(), prefilter::Error>(())
/// ```
///
/// Default: a checker of the values 0 and 1, by one tap and with a pixel deviation of 0.5.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Pattern {
    /// Where the second value is.
    pub motif: Motif,
    /// The value beside the motif and the one on it, which differ; up to ±1e15.
    pub values: [f32; 2],
    /// Evaluations of the color a pixel.
    pub taps: Taps,
    /// The filter that turns samples into a pixel.
    pub pixel: Pixel,
}

impl Default for Pattern {
    fn default() -> Self {
        Self { motif: Motif::default(), values: [0.0, 1.0], taps: Taps::default(), pixel: Pixel::default() }
    }
}

impl Pattern {
    /// Whether the description can be used.
    ///
    /// # Errors
    /// [`Error::Value`] for a share or a width outside 0 to 1, or a value that is no number, too large or the other
    /// one.
    pub(crate) fn check(&self) -> Result<(), Error> {
        self.pixel.check()?;
        let (what, shares) = match self.motif {
            Motif::Stripes { duty } => ("the stripes' duty", [duty; 2]),
            Motif::Checker => ("", [0.5; 2]),
            Motif::Grid { widths } => ("the width of the grid's lines", widths),
        };
        // Written so that NaN is refused.
        if let Some(share) = shares.into_iter().find(|share| !(0.0..=1.0).contains(share)) {
            return Err(Error::value(what, share, "0 to 1".to_owned()));
        }
        if let Some(value) = self.values.into_iter().find(|value| !(value.abs() <= LARGEST)) {
            return Err(Error::value("the pattern's value", value, format!("-{LARGEST:e} to {LARGEST:e}")));
        }
        match self.values {
            [low, high] if low == high => {
                Err(Error::value("the pattern's second value", high, "another than its first".to_owned()))
            }
            _ => Ok(()),
        }
    }

    /// What it says of a footprint.
    pub(crate) fn function(&self) -> Function {
        let covariance = "footprint_covariance_round(across, along, 1.0)";
        let (what, share) = match self.motif {
            Motif::Stripes { duty } => {
                ("stripes", format!("pulse_train(position.x, {duty:?}, length(vec2f(across.x, along.x)))"))
            }
            Motif::Checker => ("a checker", format!("pattern_checker(position, {covariance})")),
            Motif::Grid { widths: [x, y] } => {
                ("a grid", format!("pattern_grid(position, vec2f({x:?}, {y:?}), {covariance})"))
            }
        };
        let [beside, on] = self.values;
        let apart = on - beside;
        let scaled = match self.values {
            [0.0, 1.0] => "    return m;\n".to_owned(),
            _ => {
                let turned = if apart < 0.0 { "-m.z" } else { "m.z" };
                format!("    return vec4f({beside:?} + {apart:?} * m.x, {:?} * m.y, {turned}, m.w);\n", apart * apart)
            }
        };
        Function {
            what: what.to_owned(),
            dimensions: Dimensions::Plane,
            body: format!("    let m = pattern_moments({share});\n{scaled}"),
            surface: false,
            trips: 1,
            taps: self.taps,
            pixel: self.pixel,
            gap: self.gap(),
        }
    }

    /// A function of these values, and `NAME_color`, which mixes the colors of both where it filters values.
    pub(crate) fn glue(&self, called: &Called<'_>, function: &Function) -> String {
        if called.function != "texture" {
            return function.glue(called);
        }
        let Called { name, color_type, given, parameters, .. } = *called;
        let pixel = Evaluation {
            reads: &[("m".to_owned(), format!("{name}_{}", function.suffix()))],
            named: &[],
            color: &self.mixed("m.x", |statistics| called.call(statistics)),
            weight: None,
            color_type,
            dimensions: function.dimensions,
            taps: self.taps,
            pixel: self.pixel,
        };
        let export = pixel.export(name, &function.what, &format!("{given}{parameters}"));
        format!("{}\n{export}", function.statistics(name))
    }

    /// The mean color where the values have this mean: that of each of both by its share; `call` filters a value.
    pub(crate) fn mixed(&self, mean: &str, call: impl Fn(&str) -> String) -> String {
        let [beside, on] = self.values;
        let share = match self.values {
            [0.0, 1.0] => mean.to_owned(),
            _ => format!("clamp(({mean} - {beside:?}) / {:?}, 0.0, 1.0)", on - beside),
        };
        let [beside, on] = self.values.map(|value| call(&format!("{value:?}, 0.0")));
        format!("mix({beside}, {on}, {share})")
    }

    /// What a bound does not cover: the figures of the documentation, which a test of `spirv-tests` measures.
    fn gap(&self) -> String {
        match self.motif {
            Motif::Stripes { .. } => "the share of stripes, which is exact to 2e-6".to_owned(),
            Motif::Checker => "the share of a checker's squares, with an RMS of 0.0001 and up to 0.002".to_owned(),
            Motif::Grid { .. } => "the share of a grid's lines, with an RMS of 0.0002 and up to 0.005".to_owned(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn refuses_what_is_no_pattern() {
        let whole = Pattern::default();
        for pattern in [
            Pattern { motif: Motif::Stripes { duty: f32::NAN }, ..whole },
            Pattern { motif: Motif::Stripes { duty: -0.1 }, ..whole },
            Pattern { motif: Motif::Grid { widths: [0.1, 1.5] }, ..whole },
            Pattern { values: [0.3, 0.3], ..whole },
            Pattern { values: [0.0, f32::INFINITY], ..whole },
            Pattern { values: [f32::NAN, 1.0], ..whole },
            Pattern { pixel: Pixel::Round(-1.0), ..whole },
        ] {
            assert!(matches!(pattern.check(), Err(Error::Value { .. })), "{pattern:?}");
        }
        for pattern in [whole, Pattern { motif: Motif::Grid { widths: [0.0, 1.0] }, values: [5.0, -3.0], ..whole }] {
            assert_eq!(pattern.check(), Ok(()));
        }
    }
}
