//! The functions of a scene of heights: their parameters, what they say, and what they call.

use super::surface::{shared, Microsurface, RISE};
use super::tier::HeightTier;
use crate::filter::shared::{statements, Shared};
use crate::filter::texture::{color_type, Filter};
use crate::transfer::color_map::ColorMap;

/// What the functions of a scene of heights are made from.
pub(crate) struct Glue<'a> {
    /// The scene's name.
    pub name: &'a str,
    /// What colors the heights.
    pub map: &'a ColorMap,
    /// How the visible heights are represented.
    pub tier: HeightTier,
    /// The tier in words, with that of the color map.
    pub label: &'a str,
    /// What hides parts of the surface.
    pub surface: Microsurface,
    /// The map's positions are percentiles, for which the heights' mean and deviation do not matter.
    pub percentile: bool,
    /// The parameters of the tables, each behind a comma.
    pub parameters: &'a str,
}

impl Glue<'_> {
    /// Every function but `NAME_texture`; the body of `NAME_height` is the filter's.
    pub(crate) fn text(&self, filter: &Filter) -> String {
        let Self { name, tier, surface, .. } = *self;
        self.height(&filter.body) + &shares(name, tier, surface)
    }

    fn height(&self, body: &str) -> String {
        let Self { name, map, tier, label, surface, percentile, parameters } = *self;
        let (light, who) = if surface.shadowing { (", light: vec3f", "seen and lit") } else { ("", "seen") };
        format!(
            "/// Mean color of `{name}` over the heights that are {who},
/// by {label}.
///
/// {}{}{}
fn {name}_height({}{}{}, view: vec3f{light}{parameters}) -> {} {{
{}{body}}}
",
            if percentile { PERCENTILE } else { HEIGHTS },
            if surface.perturbed { PERTURBED } else { "" },
            if surface.mean_slope { TILTED } else { "" },
            if percentile { "" } else { "mean: f32, deviation: f32, " },
            if surface.perturbed { "noise_mean: f32, noise_deviation: f32, " } else { "" },
            slopes(surface),
            color_type(map.channels()),
            statements(&shared(tier, surface))
        )
    }
}

/// `NAME_visibility` and `NAME_masking`, where the surface has them, by Smith's model of normal slopes.
pub(crate) fn shares(name: &str, tier: HeightTier, surface: Microsurface) -> String {
    let within = [false, true].map(|hotspot| within(tier, hotspot, surface));
    Shares { name, surface, before: "", shared: shared(tier, surface), statistics: "", tables: "", within }.text()
}

/// What the functions of the shares that are seen and lit are made from.
pub(crate) struct Shares<'a> {
    /// The scene's name.
    pub name: &'a str,
    /// What hides parts of the surface.
    pub surface: Microsurface,
    /// Statements before those of what is shared.
    pub before: &'a str,
    /// `seen` and `lit`.
    pub shared: Vec<Shared>,
    /// Parameters before the slopes', each with a comma behind.
    pub statistics: &'a str,
    /// Parameters of tables, each with a comma in front.
    pub tables: &'a str,
    /// What is said of the error, without and with a correlation of view and light.
    pub within: [String; 2],
}

impl Shares<'_> {
    /// `NAME_visibility` and `NAME_masking`, where the surface has them.
    pub(crate) fn text(&self) -> String {
        let Self { name, surface, before, shared, statistics, tables, within: [within, correlated] } = self;
        let slopes = slopes(*surface);
        let mut text = String::new();
        if surface.shadowing {
            text += &format!(
                "
/// Share of what the view sees of `{name}` that is lit: 0 below a horizon. {}
fn {name}_visibility({statistics}{slopes}, view: vec3f, light: vec3f{tables}) -> f32 {{
{before}{}    return visibility_shadowing(seen, lit);
}}
",
                if surface.hotspot { correlated } else { within },
                statements(shared)
            );
        }
        if surface.masking {
            text += &format!(
                "
/// Share of `{name}` that the view sees: 0 below the horizon. {within}
fn {name}_masking({statistics}{slopes}, view: vec3f{tables}) -> f32 {{
{before}{}    return visibility_masking(seen);
}}
",
                statements(&shared[..1])
            );
        }
        text
    }
}

/// What shares may be off by: the error of a Λ relative to 1 + Λ, and twice that and that of the independence of
/// azimuths where view and light are correlated; and the rounding of quotients.
fn within(tier: HeightTier, hotspot: bool, surface: Microsurface) -> String {
    let own = if tier == HeightTier::Exact { LAMBDA } else { FAST };
    let error = own + CORRELATED + if surface.mean_slope { ROUNDED } else { 0.0 };
    let error = if hotspot { 2.0 * (error + QUOTIENT) + INDEPENDENCE } else { error + QUOTIENT };
    let rise = if surface.mean_slope {
        format!(" and directions that\n/// win {RISE} over the mean surface")
    } else {
        String::new()
    };
    format!("Within {} of Smith's\n/// model for slope correlations up to {CORRELATION}{rise}.", rounded_up(error))
}

/// The number with two digits, no less than it is.
fn rounded_up(error: f64) -> String {
    let unit = 10f64.powf(error.log10().floor() - 1.0);
    // Less what the quotient may be rounded by.
    let digits = (error / unit - 1e-9).ceil() / 10.0;
    format!("{digits}e{}", error.log10().floor())
}

/// What the shelf promises: of `smith_lambda` and its fast form relative to 1 + Λ, of a parameter over a tilted surface
/// for directions that win [`RISE`], of `visibility_independence`, and of a quotient of sums.
const LAMBDA: f64 = 1e-6;
const FAST: f64 = 9e-5;
const ROUNDED: f64 = 1e-6 + 1e-7 / RISE;
const INDEPENDENCE: f64 = 6e-6;
const QUOTIENT: f64 = 2e-7;

/// The largest correlation of slopes for which shares keep that, and what it costs a Λ, as `smith_parameter` says.
const CORRELATION: f64 = 0.98;
const CORRELATED: f64 = 1.5e-7 / (1.0 - CORRELATION);

/// What `NAME_height` says of its parameters, where the map is one of heights.
const HEIGHTS: &str = "\
`mean` and `deviation` of the heights are in the unit of the map's positions. Directions are unit vectors away from
/// the surface, z along its normal; the covariance of its slopes is xx, xy, yy. Below a horizon the color is that of
/// the highest heights.";

/// The same, where it is one of percentiles.
const PERCENTILE: &str = "\
Positions of the map are shares of the surface that lie below a height, whatever mean and deviation the heights
/// have. Directions are unit vectors away from the surface, z along its normal; the covariance of its slopes is xx,
/// xy, yy. Below a horizon the color is that of the highest heights.";

/// What `NAME_height` says of the noise on the heights.
const PERTURBED: &str = "
///
/// `noise_mean` and `noise_deviation` are those of independent normal noise on the heights, in the same unit.";

/// What `NAME_height` says of its mean slope.
const TILTED: &str = "
///
/// `mean_slope` is that of the mean surface over the plane whose normal is z: a surface of the slope s has a normal
/// along (-s.x, -s.y, 1). The horizon is that of the mean surface.";

/// What `NAME_height` takes between mean and deviation and the tables, each parameter behind a comma.
pub(crate) fn given(surface: Microsurface) -> String {
    let noise = if surface.perturbed { ", noise_mean: f32, noise_deviation: f32" } else { "" };
    let light = if surface.shadowing { ", light: vec3f" } else { "" };
    format!("{noise}, {}, view: vec3f{light}", slopes(surface))
}

/// The parameters of the slopes' statistics.
pub(super) fn slopes(surface: Microsurface) -> &'static str {
    if surface.mean_slope {
        "mean_slope: vec2f, slope_covariance: vec3f"
    } else {
        "slope_covariance: vec3f"
    }
}
