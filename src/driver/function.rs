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

    /// The function that returns the statistics, of a scene or of a layer of that name.
    pub fn statistics(&self, name: &str) -> String {
        let (position, suffix, what, body) = (self.dimensions.position_type(), self.suffix(), &self.what, &self.body);
        let (result, says) = if self.surface { ("statistics_surface", SURFACE) } else { ("vec4f", VALUES) };
        format!(
            "/// {says} of {what} over a footprint.
///
/// Its covariance is the sum of the squares of `across` and `along`, for a pixel the screen derivatives of `position`
/// times the deviation of its filter.
fn {name}_{suffix}(position: {position}, across: {position}, along: {position}) -> {result} {{
{body}}}
"
        )
    }

    /// That function, and `NAME_color`, which calls a filter with the statistics.
    pub fn glue(&self, called: &Called<'_>) -> String {
        let Called { name, color_type, parameters, .. } = *called;
        let given = SLOPES.iter().filter(|_| self.surface).fold(called.given.to_owned(), |g, s| g.replace(s, ""));
        let tilted = called.function != "height" || called.given.contains(SLOPES[0]);
        let sees = self.surface && tilted && called.given.contains(" view: ");
        let pixel = Evaluation {
            reads: &[("m".to_owned(), format!("{name}_{}", self.suffix()))],
            named: &self.named(called),
            color: &called.call(self.arguments(called.function)),
            weight: sees.then(|| area("m.slope", "m.slope_covariance")),
            color_type,
            dimensions: self.dimensions,
            taps: self.taps,
            pixel: self.pixel,
        };
        let export = pixel.export(name, &self.what, &format!("{given}{parameters}"));
        format!("{}\n{export}", self.statistics(name))
    }

    /// The filter's first arguments.
    fn arguments(&self, function: &str) -> &'static str {
        match (self.surface, function) {
            (false, "pair") => "m.x, sqrt(max(m.y, 0.0)), m.z, m.w",
            (false, _) => "m.x, sqrt(max(m.y, 0.0))",
            (true, "pair") => "m.moments.x, sqrt(max(m.moments.y, 0.0)), m.moments.z, m.moments.w",
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
}

/// What is evaluated at each tap of a pixel.
#[derive(Clone)]
pub(crate) struct Evaluation<'a> {
    /// Names of statistics, each with the function that returns them.
    pub reads: &'a [(String, String)],
    /// Statements behind those.
    pub named: &'a [String],
    /// The expression of the color.
    pub color: &'a str,
    /// How much a tap counts beside its place, where not all count alike.
    pub weight: Option<String>,
    /// The type of the color.
    pub color_type: &'a str,
    /// The coordinates of positions.
    pub dimensions: Dimensions,
    /// Evaluations of the color a pixel.
    pub taps: Taps,
    /// The filter that turns samples into a pixel.
    pub pixel: Pixel,
}

impl Evaluation<'_> {
    /// `NAME_color`, on a driver in words, with its parameters behind the derivatives, each behind a comma.
    pub fn export(&self, name: &str, what: &str, parameters: &str) -> String {
        let (position, color_type, count) = (self.dimensions.position_type(), self.color_type, self.taps.count());
        let points = if count == 1 { "one tap".to_owned() } else { format!("{count} taps") };
        format!(
            "/// Mean color of `{name}` over a pixel's footprint on {what}, by {points}.
///
/// `dpdx` and `dpdy` are the screen derivatives of `position`.
fn {name}_color(position: {position}, dpdx: {position}, dpdy: {position}{parameters}) -> {color_type} {{
{}{}}}
",
            vectors(self.pixel, position),
            self.body()
        )
    }

    /// What stands behind the statements that name `across` and `along`.
    fn body(&self) -> String {
        let (taps, color) = (self.taps.count(), self.color);
        let found = |at: &str, across: &str, along: &str, indent: &str| {
            let read =
                |(name, function): &(String, String)| format!("let {name} = {function}({at}, {across}, {along});");
            self.reads.iter().map(read).chain(self.named.iter().cloned()).collect::<Vec<_>>().join(indent)
        };
        if taps == 1 {
            return format!("    {}\n    return {color};\n", found("position", "across", "along", "\n    "));
        }
        let read = found("at", "shares.x * major", "shares.y * minor", "\n        ");
        let found = format!("let at = position + place.x * major_spread + place.y * minor_spread;\n        {read}");
        let average = averaged(taps, self.color_type, &found, self.weight.as_deref(), color);
        format!(
            "    // The axes of the footprint, by those of the two vectors' products.
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
}

/// What a function of values returns.
const VALUES: &str = "Mean, variance, skewness and excess kurtosis, 0 where not known,";

/// What a function of heights returns.
const SURFACE: &str = "Moments of heights, mean and covariance of slopes";
