//! What hides parts of a rough surface, and what is known of how well Smith's model describes it.

use super::tier::{self, HeightTier};
use crate::accuracy::Ranges;
use crate::filter::shared::Shared;
use crate::filter::texture::number;

/// What hides parts of a rough surface, and what the module says of it; what is off leaves no trace in the text.
///
/// Write what differs and `..Microsurface::default()`: more switches will come.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default))]
pub struct Microsurface {
    /// The light casts shadows: `NAME_height` takes it, and `NAME_visibility` is exported. Default: yes.
    pub shadowing: bool,
    /// View and light from similar azimuths see the same heights: along the light everything is lit. The paper takes
    /// them for independent. Matters with `shadowing` only. Default: no.
    pub hotspot: bool,
    /// `NAME_masking`, the share of the surface that the view sees, is exported. Default: no, because engines have such
    /// a term.
    pub masking: bool,
    /// The mean surface is tilted: exports take `mean_slope: vec2f` before `slope_covariance`. Slopes and directions
    /// are over the plane whose normal is z; below the horizon of the mean surface nothing is seen. Default: no.
    pub mean_slope: bool,
    /// Independent normal noise lies on the heights: `NAME_height` takes its mean and deviation, `noise_mean` and
    /// `noise_deviation`, behind those of the heights. The scene's ranges are then those of the sum, too: its mean is
    /// the sum of both, its deviation the square root of the sum of both variances. Default: no.
    pub perturbed: bool,
}

impl Default for Microsurface {
    fn default() -> Self {
        Self { shadowing: true, hotspot: false, masking: false, mean_slope: false, perturbed: false }
    }
}

/// `seen` and `lit`, the Λ of the view and what the light adds to it, by Smith's model of normal slopes.
pub(crate) fn shared(tier: HeightTier, surface: Microsurface) -> Vec<Shared> {
    let function = if tier == HeightTier::Exact { "smith_lambda" } else { "smith_lambda_fast" };
    shared_by(surface, &|direction| {
        if surface.mean_slope {
            format!("{function}(smith_parameter({direction}, slope_covariance, mean_slope))")
        } else {
            format!("{function}(smith_parameter_level({direction}, slope_covariance))")
        }
    })
}

/// The same by the expression of a direction's Λ.
pub(crate) fn shared_by(surface: Microsurface, of: &dyn Fn(&str) -> String) -> Vec<Shared> {
    let mut shared = vec![Shared::new("seen", "f32", of("view"))];
    if surface.shadowing && surface.hotspot {
        shared.push(Shared::new("apart", "f32", "visibility_independence(view, light)"));
        shared.push(Shared::new("lit", "f32", format!("visibility_correlated(seen, {}, apart)", of("light"))));
    } else if surface.shadowing {
        shared.push(Shared::new("lit", "f32", of("light")));
    }
    shared
}

/// The expression of what hides heights: the Λ of the view and, where it casts shadows, that of the light.
pub(crate) fn lambda(surface: Microsurface) -> &'static str {
    if surface.shadowing {
        "seen + lit"
    } else {
        "seen"
    }
}

/// The statement that names `visible`: mean, deviation and maybe skewness of the visible heights, from an expression of
/// those in the heights' own deviations; and the mean and the deviation of what is colored.
///
/// With noise all three are those of the sum, in the unit of the map. `s` and `n` are the deviations of the heights and
/// of the noise.
pub(crate) fn visible(moments: &str, surface: Microsurface) -> (String, [&'static str; 2]) {
    if surface.perturbed {
        let sum = format!("heights_perturbed({moments}, mean, s, noise_mean, n)");
        return (format!("    let visible = {sum};\n"), ["visible.x", "visible.y"]);
    }
    (format!("    let visible = {moments};\n"), ["mean + s * visible.x", "s * visible.y"])
}

/// The statements that name the deviations of the heights, and of their noise, as the ranges hold them.
pub(crate) fn clamped(surface: Microsurface, ranges: Ranges) -> String {
    let reach = number(ranges.deviation);
    let noise = format!("    let n = clamp(noise_deviation, 0.0, {reach});\n");
    format!("    let s = clamp(deviation, 0.0, {reach});\n{}", if surface.perturbed { &noise } else { "" })
}

/// What a step error gains over a tilted surface, for directions that win [`RISE`] over it and mean slopes up to 1:
/// at most 1/e of the 1e-7/rise that the rounding of the rise costs each Λ, relative to 1 + Λ.
const TILTED: f64 = 7.5e-6;

/// What the correlation of view and light adds to a step error: at most 1/e of the 6e-6 that the shelf promises of the
/// independence of their azimuths.
const HOTSPOT: f64 = 2.3e-6;

/// How far the sum with noise is from visible heights of the same mean, deviation and skewness, as a step error for Λ
/// up to 1e4: `noise_leaves_the_family_by_little` in `spirv-tests/tests/height/skewed.rs` measures it.
const NOISE: f64 = 4.3e-3;

/// What noise adds to the step error of tails, which are moved for it: with noise they err by up to 8.7e-4, as
/// `steps_keep_their_figures_with_noise` in `spirv-tests/tests/heights/steps.rs` measures for Λ up to 1e4.
const MOVED: f64 = 5.5e-4;

/// The same of shorter tails, which are not moved: with noise they err by up to 5.2e-3, as
/// `steps_of_shorter_tails_keep_their_figures` in the same file measures.
const UNMOVED: f64 = 3.55e-3;

/// The smallest ω.z − s̄·ω.xy that bounds over tilted surfaces hold from.
pub(crate) const RISE: f64 = 0.01;

/// The step error of shares of the surface, which hang on nothing but the directions' Λ.
pub(crate) fn share_error(surface: Microsurface) -> f64 {
    tier::HIDING + tilted(surface) + correlated(surface)
}

/// What a mean slope adds to a step error.
fn tilted(surface: Microsurface) -> f64 {
    if surface.mean_slope {
        TILTED
    } else {
        0.0
    }
}

/// What the correlation of view and light adds.
fn correlated(surface: Microsurface) -> f64 {
    if surface.hotspot && surface.shadowing {
        HOTSPOT
    } else {
        0.0
    }
}

/// The step error of a tier over a surface, of whose heights each mean rounds by as much as `rounded`, a step error.
pub(crate) fn step_error(tier: HeightTier, surface: Microsurface, rounded: f64) -> f64 {
    // Of what stands for the heights themselves noise enlarges no step error: the difference of the cumulative
    // functions of both sums, ∫ (F − G)(h − r) N(r) dr, is a mean of the difference without noise. One more mean is
    // added, which rounds.
    let perturbed = match (surface.perturbed, tier) {
        (false, _) => 0.0,
        (true, HeightTier::Skewed) => NOISE + rounded,
        (true, HeightTier::ClosedFormFast) => UNMOVED + rounded,
        (true, HeightTier::ClosedForm) => MOVED + rounded,
        (true, _) => rounded,
    };
    tier::step_error(tier) + rounded + tilted(surface) + correlated(surface) + perturbed
}

/// What no bound of the heights covers, and how much that was measured to be.
///
/// Source: `docs/visibility_gap.csv` and `docs/shadowing_gap.csv`, by lines of sight over height fields of four
/// spectra; a test of `spirv-tests` compares.
pub(crate) fn gap(surface: Microsurface, percentile: bool) -> String {
    let light = match (surface.shadowing, surface.hotspot) {
        (false, _) => String::new(),
        (true, false) => lit(["0.09", "0.22", "0.23", "0.42"]),
        (true, true) => lit(["0.10", "0.06", "0.24", "0.04"]),
    };
    let heights = if percentile { "" } else { "how far heights are from normal, " };
    let who = if surface.shadowing { "view and light together have within 8e-5" } else { "a view has within 4e-5" };
    format!(
        "{heights}slope correlations beyond 0.98, and Λ beyond 1e4, which\n    \
         {who} slope deviations of the horizon. Smith's model itself was measured against\n    \
         lines of sight over rough surfaces: for one direction steps err by up to 0.04 with a Gaussian\n    \
         autocorrelation, 0.06 with others{light}"
    )
}

/// The gap with a light, away from the view and near it.
fn lit([step, step_near, share, share_near]: [&str; 4]) -> String {
    format!(
        "; with a light by up to {step}, near the view {step_near}, and\n    \
         the share that is lit by {share}, near the view {share_near}"
    )
}
