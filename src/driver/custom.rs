//! A driver of your own: WGSL that says what a footprint holds.

use super::function::{Dimensions, Function};
use super::taps::{Pixel, Taps};
use crate::Error;

/// A function of your own in WGSL, which says of a footprint what it holds of the driving function.
///
/// Its signature is
/// ```wgsl
/// fn NAME(position: vec2f, across: vec2f, along: vec2f) -> vec4f
/// ```
/// or that with `vec3f` for the positions of a solid. The footprint is the normal distribution about `position` whose
/// covariance is across acrossᵀ + along alongᵀ. The result is the mean, the variance, the skewness and the excess
/// kurtosis of the values there; the last two are 0 where they are not known.
///
/// For filters of slopes, and for heights that shall find their slopes, it has two more functions of the same
/// parameters: `NAME_slope`, which returns the mean slope, a `vec2f`, and `NAME_slope_covariance`, the covariance xx,
/// xy, yy about that, a `vec3f`.
///
/// The text may mention the shelf. [`Module::cost`](crate::Module::cost) counts its loops as one turn. A text that is
/// linked with the module and declares the same names takes their place: the function may as well be part of your
/// shader.
///
/// ```
/// use prefilter::{ColorMap, Custom, Driver, Scene};
/// let ripple = "fn ripple(position: vec2f, across: vec2f, along: vec2f) -> vec4f {
///     let fade = exp(-0.5 * (across.x * across.x + along.x * along.x));
///     return vec4f(0.5 + 0.5 * fade * sin(position.x), 0.125 * (1.0 - fade * fade), 0.0, 0.0);
/// }";
/// let map = ColorMap::gradient([(0.0, [0.0, 0.1, 0.2]), (1.0, [1.0, 0.9, 0.8])])?;
/// let module = Scene::new("sand").texture(map).driver(Driver::Custom(Custom::new(ripple, "ripple"))).module()?;
/// assert_eq!(module.exports()[2].signature, "fn sand_color(position: vec2f, dpdx: vec2f, dpdy: vec2f) -> vec3f");
/// # Ok::<(), prefilter::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Custom {
    /// The functions in WGSL, with what they call that is not of the shelf.
    pub text: String,
    /// The name of the function.
    pub function: String,
    /// Evaluations of the color a pixel.
    pub taps: Taps,
    /// The filter that turns samples into a pixel.
    pub pixel: Pixel,
}

impl Custom {
    /// The function of that name in a text, by one tap and with a pixel deviation of 0.5.
    pub fn new(text: impl Into<String>, function: impl Into<String>) -> Self {
        Self { text: text.into(), function: function.into(), taps: Taps::default(), pixel: Pixel::default() }
    }

    /// Whether the description can be used.
    ///
    /// # Errors
    /// A function that the text does not declare, one with another signature, or a pixel's filter that is none.
    pub(crate) fn check(&self) -> Result<(), Error> {
        self.pixel.check()?;
        let dimensions = self.dimensions()?;
        match (self.signature("_slope"), self.signature("_slope_covariance")) {
            (None, None) => Ok(()),
            _ => self
                .matches("_slope", dimensions, "vec2f")
                .and_then(|()| self.matches("_slope_covariance", dimensions, "vec3f")),
        }
    }

    /// Whether the text declares the slopes.
    pub(crate) fn knows_slopes(&self) -> bool {
        self.signature("_slope").is_some()
    }

    /// What it says of a footprint, with its slopes or without.
    pub(crate) fn function(&self, slopes: bool) -> Function {
        let name = &self.function;
        let call = |suffix: &str| format!("{name}{suffix}(position, across, along)");
        let body = match slopes {
            false => format!("    return {};\n", call("")),
            true => format!(
                "    return statistics_surface({}, {}, {});\n",
                call(""),
                call("_slope"),
                call("_slope_covariance")
            ),
        };
        Function {
            what: format!("`{name}`"),
            dimensions: self.dimensions().unwrap_or(Dimensions::Plane),
            body,
            surface: slopes,
            trips: 1,
            taps: self.taps,
            pixel: self.pixel,
            gap: format!("what `{name}` errs by, which is yours to measure"),
        }
    }

    /// The coordinates of the positions, by the function's signature.
    fn dimensions(&self) -> Result<Dimensions, Error> {
        self.matches("", Dimensions::Solid, "vec4f")
            .map(|()| Dimensions::Solid)
            .or_else(|_| self.matches("", Dimensions::Plane, "vec4f").map(|()| Dimensions::Plane))
    }

    /// Whether a function of the text has the signature that it needs.
    fn matches(&self, suffix: &str, dimensions: Dimensions, result: &str) -> Result<(), Error> {
        let (name, p) = (format!("{}{suffix}", self.function), dimensions.position_type());
        let needed = format!("fn {name}(position: {p}, across: {p}, along: {p}) -> {result}");
        // What stands behind each colon, and behind the arrow.
        let types = |signature: &str| -> Vec<String> {
            let short = signature.replace("<f32>", "f");
            let ends = [',', ')', '{'];
            let word = |text: &str| text.split(ends).next().unwrap_or_default().trim().to_owned();
            let result = short.split("->").skip(1).map(|text| format!("-> {}", word(text)));
            short.split(':').skip(1).map(word).chain(result).collect()
        };
        match self.signature(suffix) {
            Some(signature) if types(&signature) == types(&needed) => Ok(()),
            Some(signature) => {
                Err(Error::Conflict(format!("the driver's `{signature}` does not match; allowed is `{needed}`")))
            }
            None => Err(Error::Conflict(format!("the driver's text declares no `{name}`; it needs `{needed}`"))),
        }
    }

    /// The signature of a function of the text.
    fn signature(&self, suffix: &str) -> Option<String> {
        let name = format!("{}{suffix}", self.function);
        let found = prefilter_wgsl::declarations(&self.text).into_iter().find(|declaration| declaration.name == name);
        found.map(|declaration| declaration.signature)
    }
}
