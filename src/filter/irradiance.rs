//! Irradiance over the normals of a rough surface that a view sees: light from all around, and Lambert's cosine.
//!
//! Irradiance of order 2 is a polynomial of the normal n, so that its mean needs the means of n and n nᵀ only, whatever
//! the environment.
//!
//! Source: Heitz, Nowrouzezahrai, Poulin and Neyret 2014, "Filtering Non-Linear Transfer Functions on Surfaces",
//! section 5.3; Ramamoorthi and Hanrahan 2001, "An Efficient Representation for Irradiance Environment Maps".

use super::knots;
use super::texture::{number, Filter};
use crate::accuracy::{promise, Bound, Ranges};
use crate::table::Table;
use crate::transfer::color_map::Colors;
use crate::transfer::irradiance::Irradiance;
use crate::transfer::pieces::ROUNDING;

/// How the normals that a view sees are averaged: a ladder from the cheapest to the closest.
///
/// Errors are the largest ones of irradiance over its mean over all normals, for slope deviations up to 1 along any
/// axis and views from 5 degrees above the mean surface, as `irradiance_keeps_the_figures_of_its_tiers` in
/// `spirv-tests/tests/irradiance.rs` measures them on the device.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum IrradianceTier {
    /// The normal of the mean slope: no filtering at all, to compare with. More than the mean itself.
    Normal,
    /// Five slopes: 1.1e-2 for slope deviations up to 0.3.
    Points,
    /// Three Gaussians: 1e-2.
    ThreeGaussians,
    /// Four Gaussians: 2e-3.
    FourGaussians,
}

impl std::fmt::Display for IrradianceTier {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.write_str(match self {
            Self::Normal => "the normal of the mean slope",
            Self::Points => "five slopes",
            Self::ThreeGaussians => "three Gaussians",
            Self::FourGaussians => "four Gaussians",
        })
    }
}

impl IrradianceTier {
    /// The shelf function of the means; the normal of the mean slope has none.
    fn function(self) -> Option<&'static str> {
        match self {
            Self::Normal => None,
            Self::Points => Some("normals_visible_points"),
            Self::ThreeGaussians => Some("normals_visible_fast"),
            Self::FourGaussians => Some("normals_visible"),
        }
    }

    /// The expression of the means in the tangent frame.
    pub(crate) fn means(self) -> String {
        match self.function() {
            Some(function) => format!("{function}(view, mean_slope, slope_covariance)"),
            None => "normals_plus_one(normals_means(vec3f(), vec3f(), vec3f()), mean_slope, 1.0)".to_owned(),
        }
    }
}

/// The filter of a tier: its body knows the means in the frame x, y, z as `m`.
pub(crate) fn irradiance(light: &Irradiance, colors: Colors, tier: IrradianceTier) -> Filter {
    let mut body = String::new();
    let tables = match colors {
        Colors::Constant => {
            let terms = ["", "m.first.x", "m.first.y", "m.first.z", "m.level.x", "m.level.y", "m.level.z"];
            let terms = terms.into_iter().chain(["m.upright.x", "m.upright.y"]);
            for (term, color) in terms.zip(light.polynomial()) {
                let color = color.map(number).join(", ");
                body += &match term {
                    "" => format!("    var e = vec3f({color});\n"),
                    _ => format!("    e += {term} * vec3f({color});\n"),
                };
            }
            body += "    return max(e, vec3f());\n";
            Vec::new()
        }
        Colors::Dynamic => {
            body += "    return irradiance_read(m, environment);\n";
            vec![environment(light)]
        }
    };
    // Without a function no mean is beyond 1 on either side.
    let mean = tier.function().map_or(2.0, promise);
    let bound = Bound::Guaranteed((mean * most(light) + rounding(light)) as f32);
    Filter { body, tables, bound, trips: 1 }
}

/// What rounding adds: of each term its color, its product and the sums that it is in, up to eight.
fn rounding(light: &Irradiance) -> f64 {
    let sum = |channel: usize| light.polynomial().iter().map(|color| f64::from(color[channel].abs())).sum::<f64>();
    10.0 * ROUNDING * [0, 1, 2].map(sum).into_iter().fold(0.0, f64::max)
}

/// How many times the error of a mean that of irradiance may be, over all frames.
///
/// Of the components of n irradiance has a product with a vector, which a frame only turns: the sum of its components
/// is at most √3 times its length. Of n nᵀ it has the product with a symmetric matrix M, of which the trace does not
/// count, as that of an error of n nᵀ is 0: M without it, turned, has the norm F = |M|. The error of zz being minus
/// those of xx and yy, the product with an error is at most its largest part times |N.xx − N.zz| + |N.yy − N.zz| +
/// 2 |N.xy| + 2 |N.xz| + 2 |N.yz|; the first two are at most √6 times the norm of the diagonal, the others √6 times
/// that of the rest, together √12 F.
fn most(light: &Irradiance) -> f64 {
    let of = |channel: usize| {
        let [_, x, y, z, xx, xy, yy, xz, yz] = light.polynomial().map(|color| f64::from(color[channel]));
        let trace = (xx + yy) / 3.0;
        let squares = [xx - trace, yy - trace, -trace].map(|part| part * part).iter().sum::<f64>();
        let length = (x * x + y * y + z * z).sqrt();
        let norm = (squares + 0.5 * (xy * xy + xz * xz + yz * yz)).sqrt();
        3f64.sqrt() * length + 12f64.sqrt() * norm
    };
    [0, 1, 2].map(of).into_iter().fold(0.0, f64::max)
}

/// The polynomial's colors as one row of texels.
fn environment(light: &Irradiance) -> Table {
    let texels = light.polynomial().iter().flat_map(|&[red, green, blue]| [red, green, blue, 0.0]).collect();
    knots::row("environment", 9, 1, texels)
}

/// What `NAME_irradiance` takes between the slopes' statistics and the tables, each behind a comma.
pub(crate) const GIVEN: &str = ", view: vec3f, x: vec3f, y: vec3f, z: vec3f";

/// `NAME_irradiance` with a body, and `NAME_lambert`.
pub(crate) fn glue(name: &str, tier: IrradianceTier, label: &str, parameters: &str, body: &str) -> String {
    let means = tier.means();
    format!(
        "/// Mean irradiance on `{name}` over the normals that are seen,
/// by {label}.
///
/// `view` is a unit vector away from the surface in its tangent frame, z along the normal, in which slopes have a mean
/// and a covariance, xx, xy, yy: a slope s has a normal along (-s.x, -s.y, 1). `x`, `y` and `z` are that frame's axes
/// in the space of the environment. Times albedo over pi it is the radiance; what hides the environment is not in it.
fn {name}_irradiance(mean_slope: vec2f, slope_covariance: vec3f{GIVEN}{parameters}) -> vec3f {{
    let m = irradiance_turned({means}, x, y, z);
{body}}}

/// Mean of Lambert's cosine of a directional light over the normals of `{name}` that are seen, in the tangent frame.
fn {name}_lambert(mean_slope: vec2f, slope_covariance: vec3f, view: vec3f, light: vec3f) -> f32 {{
    return irradiance_lambert({means}, light);
}}
"
    )
}

/// The largest slope deviation that [`IrradianceTier::Points`] keeps its promise for.
pub(crate) const NARROW: f32 = 0.3;

/// What bounds hold for where no ranges are given: components of the mean slope, slope deviations.
pub(crate) const RANGES: Ranges = Ranges { mean: (-0.3, 0.3), deviation: 1.0 };

/// What the bound of a tier holds for.
pub(crate) fn covered(tier: IrradianceTier) -> String {
    let deviations = match tier {
        IrradianceTier::Normal => return "any slopes and views".to_owned(),
        IrradianceTier::Points => "0.3",
        IrradianceTier::ThreeGaussians | IrradianceTier::FourGaussians => "1",
    };
    format!(
        "slope deviations to {deviations} along any axis, correlations to 0.9, mean slopes to 0.3 on each axis, views \
         from 5 degrees above the mean surface"
    )
}

/// What no bound covers.
pub(crate) const GAP: &str =
    "how far slopes are from a normal distribution of that mean and covariance, what of the\n    \
    environment is beyond order 2, about 1 % of its irradiance, and what hides the environment from facets";
