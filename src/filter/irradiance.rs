//! Irradiance over the normals of a rough surface that a view sees: light from all around, and Lambert's cosine.
//!
//! Irradiance of order 2 is a polynomial of the normal n, so that its mean needs the means of n and n nᵀ only, whatever
//! the environment.
//!
//! Source: Heitz, Nowrouzezahrai, Poulin and Neyret 2014, "Filtering Non-Linear Transfer Functions on Surfaces",
//! section 5.3; Ramamoorthi and Hanrahan 2001, "An Efficient Representation for Irradiance Environment Maps".

use super::knots;
use super::texture::{number, Filter};
use crate::accuracy::{Bound, Ranges};
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
    /// Three Gaussians: 9.1e-3.
    ThreeGaussians,
    /// Four Gaussians: 1.1e-3.
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
    let bound = Bound::Guaranteed((tier.misses().most(light) + rounding(light)) as f32);
    Filter { body, tables, bound, trips: 1 }
}

/// What rounding adds: of each term its color, its product and the sums that it is in, up to eight.
fn rounding(light: &Irradiance) -> f64 {
    let sum = |channel: usize| light.polynomial().iter().map(|color| f64::from(color[channel].abs())).sum::<f64>();
    10.0 * ROUNDING * [0, 1, 2].map(sum).into_iter().fold(0.0, f64::max)
}

/// The largest errors of the means of a tier, of which none depends on the frame.
struct Misses {
    /// The length of that of E[n].
    first: f64,
    /// The norm of that of E[n nᵀ], the root of the sum of its squares, without the part that its trace is of.
    square: f64,
    /// Its trace: sums of Gaussians do not add up to the 1 that squares of a unit vector do.
    trace: f64,
}

impl IrradianceTier {
    /// A tenth above the worst of all that [`covered`] names, as searches found it. A short one on the device is
    /// `means_keep_the_figures_of_irradiance` in `spirv-tests/tests/slopes/normals.rs`; it fails where the figures are
    /// exceeded, and where they are more than 1.3 times what it finds.
    fn misses(self) -> Misses {
        match self {
            // No two unit vectors are farther apart, nor are their squares.
            Self::Normal => Misses { first: 2.0, square: std::f64::consts::SQRT_2, trace: 0.0 },
            Self::Points => Misses { first: 3e-3, square: 1.03e-2, trace: 1e-6 },
            Self::ThreeGaussians => Misses { first: 4.2e-3, square: 5.3e-3, trace: 9e-3 },
            Self::FourGaussians => Misses { first: 7.2e-4, square: 7e-4, trace: 1.15e-3 },
        }
    }
}

impl Misses {
    /// The largest error of irradiance, over all frames.
    ///
    /// Of the components of n irradiance has a product with a vector, of those of n nᵀ one with a symmetric matrix M:
    /// products with an error are at most those of lengths and norms, which a frame leaves. M and the error are each
    /// their trace's part, trace/3 times the identity, and a rest whose product with the other's part is 0.
    fn most(&self, light: &Irradiance) -> f64 {
        let of = |channel: usize| {
            let [_, x, y, z, xx, xy, yy, xz, yz] = light.polynomial().map(|color| f64::from(color[channel]));
            let part = (xx + yy) / 3.0;
            let squares = [xx - part, yy - part, -part].map(|rest| rest * rest).iter().sum::<f64>();
            let length = (x * x + y * y + z * z).sqrt();
            let norm = (squares + 0.5 * (xy * xy + xz * xz + yz * yz)).sqrt();
            self.first * length + self.square * norm + self.trace * part.abs()
        };
        [0, 1, 2].map(of).into_iter().fold(0.0, f64::max)
    }
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
         from 5 degrees above the plane and the mean surface"
    )
}

/// What no bound covers.
pub(crate) const GAP: &str =
    "how far slopes are from a normal distribution of that mean and covariance, what of the\n    \
    environment is beyond order 2, about 1 % of its irradiance, and what hides the environment from facets";
