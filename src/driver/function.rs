//! Drivers that are functions of the position, of which nothing is stored: what they write into a module.

use super::slope_moments::area;
use super::taps::{averaged, vectors, Pixel, Taps};
use super::Called;

/// The coordinates of a driver's positions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Dimensions {
    /// Two, such as texture coordinates.
    Plane,
    /// Three, of a solid that the surface cuts.
    Solid,
}

impl Dimensions {
    /// The WGSL type of a position.
    pub(crate) fn position_type(self) -> &'static str {
        match self {
            Self::Plane => "vec2f",
            Self::Solid => "vec3f",
        }
    }
}

/// What a driver that is a function says of a footprint, in WGSL.
pub(crate) struct Function {
    /// What it is, for the documentation of the export: "noise".
    pub what: String,
    /// The coordinates of its positions.
    pub dimensions: Dimensions,
    /// The body of the function of `position`, `across` and `along` that returns the statistics.
    pub body: String,
    /// Whether that are those of a height field and its slopes, a `statistics_surface`; else a vec4f of the values.
    pub surface: bool,
    /// Turns of the loops in the body.
    pub trips: usize,
    /// Evaluations of the color a pixel.
    pub taps: Taps,
    /// The filter that turns samples into a pixel.
    pub pixel: Pixel,
    /// What no bound of a filter covers, and how much that was measured to be.
    pub gap: String,
}

/// What a scene of heights takes besides its statistics, where the driver does not know slopes.
const SLOPES: [&str; 2] = [", mean_slope: vec2f", ", slope_covariance: vec3f"];

impl Function {
    /// The name of the function that returns the statistics, behind that of the scene.
    pub fn suffix(&self) -> &'static str {
        if self.surface {
            "surface"
        } else {
            "statistics"
        }
    }

    /// The function that returns the statistics, and `NAME_color`, which calls a filter with them.
    pub fn glue(&self, called: &Called<'_>) -> String {
        let Called { name, color_type, parameters, .. } = *called;
        let (position, suffix) = (self.dimensions.position_type(), self.suffix());
        let (result, says) = if self.surface { ("statistics_surface", SURFACE) } else { ("vec4f", VALUES) };
        let (what, body, taps) = (&self.what, &self.body, self.taps.count());
        let given = SLOPES.iter().filter(|_| self.surface).fold(called.given.to_owned(), |g, s| g.replace(s, ""));
        let points = if taps == 1 { "one tap".to_owned() } else { format!("{taps} taps") };
        format!(
            "/// {says} of {what} over a footprint.
///
/// Its covariance is the sum of the squares of `across` and `along`, for a pixel the screen derivatives of `position`
/// times the deviation of its filter.
fn {name}_{suffix}(position: {position}, across: {position}, along: {position}) -> {result} {{
{body}}}

/// Mean color of `{name}` over a pixel's footprint on {what}, by {points}.
///
/// `dpdx` and `dpdy` are the screen derivatives of `position`.
fn {name}_color(position: {position}, dpdx: {position}, dpdy: {position}{given}{parameters}) -> {color_type} {{
{}}}
",
            self.color(called)
        )
    }

    /// The body of `NAME_color`.
    fn color(&self, called: &Called<'_>) -> String {
        let (vectors, taps) = (vectors(self.pixel, self.dimensions.position_type()), self.taps.count());
        let read = |at: &str, across: &str, along: &str| {
            let (name, suffix) = (called.name, self.suffix());
            let mut read = vec![format!("let m = {name}_{suffix}({at}, {across}, {along});")];
            read.extend(self.named(called));
            read
        };
        let color = called.call(self.arguments(called.function));
        if taps == 1 {
            let found = read("position", "across", "along").join("\n    ");
            return format!("{vectors}    {found}\n    return {color};\n");
        }
        let found = read("at", "shares.x * major", "shares.y * minor").join("\n        ");
        let found = format!("let at = position + place.x * major_spread + place.y * minor_spread;\n        {found}");
        let weight = self.sees(called).then(|| area("m.slope", "m.slope_covariance"));
        let average = averaged(taps, called.color_type, &found, weight.as_deref(), &color);
        format!(
            "{vectors}    // The axes of the footprint, by those of the two vectors' products.
    let products = vec3f(dot(across, across), dot(across, along), dot(along, along));
    let turn = footprint_direction(products);
    let major = turn.x * across + turn.y * along;
    let minor = turn.x * along - turn.y * across;
    let deviations = footprint_deviations(products);
    let shares = taps_shares(deviations.x, deviations.y, {taps}.0);
    let major_spread = sqrt(shares.z) * major;
    let minor_spread = sqrt(shares.w) * minor;
{average}"
        )
    }

    /// The filter's first arguments.
    fn arguments(&self, function: &str) -> &'static str {
        match (self.surface, function) {
            (false, _) => "m.x, sqrt(max(m.y, 0.0))",
            (true, "texture" | "height") => "m.moments.x, sqrt(max(m.moments.y, 0.0))",
            (true, _) => "m.slope, m.slope_covariance",
        }
    }

    /// Statements that name what a scene of heights takes of the slopes.
    fn named(&self, called: &Called<'_>) -> Vec<String> {
        let of = |slope: &&str| self.surface && called.given.contains(*slope);
        let name = |slope: &str| slope.trim_start_matches(", ").split(':').next().unwrap_or_default().to_owned();
        let field = |name: &str| name.replace("mean_", "");
        let names = SLOPES.iter().filter(|slope| of(slope)).map(|slope| name(slope));
        names.map(|name| format!("let {name} = m.{};", field(&name))).collect()
    }

    /// Whether taps count by the area of their facets in the picture.
    fn sees(&self, called: &Called<'_>) -> bool {
        let tilted = called.function != "height" || called.given.contains(SLOPES[0]);
        self.surface && tilted && called.given.contains(" view: ")
    }
}

/// What a function of values returns.
const VALUES: &str = "Mean, variance, skewness and excess kurtosis, 0 where not known,";

/// What a function of heights returns.
const SURFACE: &str = "Moments of heights, mean and covariance of slopes";
