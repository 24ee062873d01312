//! What a module says of itself: the tier, its bound, its cost, and what the bound does not cover.

use std::collections::BTreeSet;
use std::fmt::Write;

use super::candidate::{Candidate, Over};
use super::driven::Driven;
use super::layer::Layer;
use super::stage::Stage;
use super::Scene;
use crate::accuracy::{Bound, Ranges};
use crate::cost::Cost;
use crate::driver::Driver;
use crate::filter::combine::Reflectance;
use crate::filter::distribution::Distribution;
use crate::filter::envelope::varied;
use crate::filter::height::{self, surface, tier, HeightTier};
use crate::filter::height_transfer::TransferTier;
use crate::filter::slope::SlopeTier;
use crate::filter::{irradiance, slope, steepness};
use crate::table::transferred::COVERED;
use crate::table::Table;
use crate::transfer::color_map::ColorMap;

impl Scene {
    pub(super) fn explain(&self, chosen: &Candidate, passed: &[Candidate]) -> String {
        let what = what(chosen);
        let mut text = format!("{}: {what} by {}\n", self.name, chosen.label);
        let _ = writeln!(text, "  error   {}", described(chosen));
        if let Some(covered) = self.covers(chosen) {
            let _ = writeln!(text, "  covers  {covered}");
        }
        let _ = writeln!(text, "  cost    {} a call", chosen.cost);
        if let Some(ranges) = self.reaches() {
            let _ = writeln!(text, "  ranges  {ranges}");
        }
        let _ = writeln!(text, "  chosen  {}", self.reason(chosen));
        for other in passed {
            let _ = writeln!(text, "  passed  {}: error {}; {}", other.label, described(other), other.cost);
        }
        let gap = match (chosen.over, &self.driver) {
            (Over::Values, None) => format!("{UNDRIVEN} {} of that mean and deviation", self.distribution),
            (Over::Values, Some(driver)) if self.distribution == Distribution::Normal => driver.gap(false),
            (Over::Values, Some(driver)) => {
                format!("{UNDRIVEN} {}; with a normal one it is\n    {}", self.distribution, driver.gap(false))
            }
            (Over::Heights(_), driver) => driven(surface::gap(self.microsurface, self.percentile.is_some()), driver),
            (Over::Slopes(tier) | Over::SlopeMap(tier, _), driver) => driven(slope::gap(tier), driver),
            (Over::Steepness(_), driver) => driven(steepness::GAP.to_owned(), driver),
            (Over::Normals(_), driver) => driven(irradiance::GAP.to_owned(), driver),
        };
        let _ = writeln!(text, "  not in the error: {gap}");
        text
    }

    /// What the bound of a tier holds for besides its ranges.
    fn covers(&self, chosen: &Candidate) -> Option<String> {
        match (chosen.over, self.map()) {
            (Over::Heights(tier), Some(map)) => Some(self.covered(tier, map)),
            (Over::Slopes(tier), Some(map)) => Some(self.covered_slopes(tier, map)),
            (Over::Steepness(tier), Some(map)) => Some(self.covered_steepness(tier, map)),
            (Over::SlopeMap(tier, taps), _) => {
                self.slope_map.as_ref().map(|map| self.covered_slope_map(tier, taps, map))
            }
            (Over::Normals(tier), _) => Some(irradiance::covered(tier)),
            (Over::Values | Over::Heights(_) | Over::Slopes(_) | Over::Steepness(_), _) => None,
        }
    }

    /// The ranges, where the scene has some.
    fn reaches(&self) -> Option<String> {
        let Ranges { mean: (low, high), deviation } = self.chosen_ranges();
        let ranged = self.percentile.is_none() && (self.irradiance.is_none() || self.ranges.is_some());
        ranged.then(|| format!("means {low} to {high}, deviations to {deviation}"))
    }

    /// What a combination says of its layers and of itself.
    pub(super) fn explain_combined(
        &self,
        layers: &[Layer<'_>],
        drivers: &[Driven<'_>],
        bound: Bound,
        cost: Cost,
    ) -> String {
        let mut text =
            format!("{}: a combination of {} layers\n  error   {bound}, of the color\n", self.name, layers.len());
        let _ = writeln!(text, "  cost    {cost} a call");
        for Layer { scene, chosen, .. } in layers {
            let (name, what) = (&scene.name, what(chosen));
            let _ = writeln!(text, "  layer   {name}: {what} by {}: error {}", chosen.label, described(chosen));
            // As the layer was chosen: over what hides the whole.
            let layer = Scene { microsurface: self.microsurface, ..(*scene).clone() };
            if let Some(covered) = layer.covers(chosen) {
                let _ = writeln!(text, "    covers  {covered}");
            }
            if let Some(ranges) = layer.reaches() {
                let _ = writeln!(text, "    ranges  {ranges}");
            }
        }
        let lit = self.irradiance.is_some() || self.reflectance == Some(Reflectance::Lambert);
        if lit && layers.iter().any(Layer::slopes) {
            let _ = writeln!(text, "  light   {TOGETHER}");
        }
        let gaps: BTreeSet<String> = drivers.iter().map(|driven| format!(";\n    {}", driven.gap())).collect();
        let _ = writeln!(text, "  not in the error: {INDEPENDENT}{}", gaps.into_iter().collect::<String>());
        text
    }

    /// What a scene of transferred heights says of itself, before what that of the heights says.
    pub(super) fn explain_transferred(
        &self,
        stage: &Stage,
        (narrow, moved): (f32, Option<f32>),
        [bound, cost]: [&str; 2],
        heights: &str,
    ) -> String {
        let Stage { tier, nodes, ranges: Ranges { mean: (low, high), deviation }, .. } = stage;
        let mut text = format!("{}: heights h = g(f) by {tier}\n  error   {bound}\n", self.name);
        if let Some(nodes) = nodes {
            let error = nodes.table.error;
            let hidden = if self.height.is_some() {
                format!(", Λ of view and light that add up to {COVERED:e} at most")
            } else {
                String::new()
            };
            let _ = writeln!(
                text,
                "  covers  f of means {low} to {high} and deviations from {narrow:.1e} to {deviation}{hidden}"
            );
            let what = match moved {
                Some(moved) => {
                    let hiding = nodes.lambda_error;
                    format!("Λ errs by {hiding:.1e} of 1 + Λ, which moves a color by up to {moved:.1e}")
                }
                None => format!("a step of slopes errs by {error:.1e} of the mixture's"),
            };
            let _ = writeln!(text, "  nodes   read between texels, {what}");
        }
        for Table { name, error, .. } in &stage.moments.tables {
            let _ = writeln!(text, "  moments of h from the table `{name}`, within {error:.1e} of half their ranges");
        }
        let _ = writeln!(text, "  cost    {cost} a call");
        let tilted = moved.is_some() && self.microsurface.mean_slope;
        let tier = if *tier == TransferTier::Paper {
            PAPER
        } else if tilted {
            LEANING
        } else {
            ""
        };
        let gap = self.driver.as_ref().map_or(String::new(), |driver| format!(";\n    {}", driver.gap(true)));
        let _ = writeln!(text, "  not in the error: {NORMAL}{tier}{gap}");
        text + heights
    }

    /// What the bound of a tier of heights is made of, and the Λ and deviations that it holds for.
    fn covered(&self, tier: HeightTier, map: &ColorMap) -> String {
        let floor = tier::floor(tier, self.chosen_ranges());
        let step = surface::step_error(tier, self.microsurface, tier::rounded(tier, self.chosen_ranges()));
        let varied = varied(map, height::model_error(map, tier, self.microsurface, self.chosen_ranges()) / step);
        let reach = if tier == HeightTier::Exact {
            "Λ of a direction to 5.2e5"
        } else {
            "Λ of view and light that add up to 1e4 at most"
        };
        let tilted = if self.microsurface.mean_slope {
            format!(", mean slopes to 1 with directions that win {} over the mean surface", surface::RISE)
        } else {
            String::new()
        };
        let sum = if self.microsurface.perturbed { " with noise" } else { "" };
        let deviations = if self.percentile.is_some() {
            "any heights".to_owned()
        } else {
            format!("deviations{sum} from {floor:.1e}")
        };
        let beyond = if tier == HeightTier::Skewed { "beyond the table " } else { "" };
        format!("{reach}, {deviations}{tilted}: {beyond}a step errs by {step:.1e}, times {varied}")
    }

    fn reason(&self, chosen: &Candidate) -> String {
        // Whether the scene names what the map is averaged over, and whether a tier of the map's own is left to choose.
        let (named, stacked) = match chosen.over {
            Over::Values => (None, true),
            Over::Heights(tier) => (self.height_tier.map(|_| "heights"), !tier.stands_alone()),
            Over::Slopes(tier) => (self.slope_tier.map(|_| "slopes"), tier != SlopeTier::Naive),
            Over::SlopeMap(SlopeTier::Naive, _) => (self.slope_tier.map(|_| "slopes"), false),
            Over::SlopeMap(..) => (self.slope_tier.and(self.slope_taps).map(|_| "slopes"), false),
            Over::Steepness(_) => (self.slope_tier.map(|_| "slopes").or(self.slope_taps.map(|_| "slopes")), false),
            Over::Normals(_) => (self.irradiance_tier.map(|_| "normals"), false),
        };
        let free = match (named, stacked && self.tier.is_none()) {
            (Some(_), false) => return NAMED.to_owned(),
            (None, false) if matches!(chosen.over, Over::Values) => return NAMED.to_owned(),
            (Some(what), true) => format!("the scene names the tier of {what}; that of the color map is "),
            (None, _) => String::new(),
        };
        let budget = self.accuracy.unwrap_or_default().max_filter_error;
        if chosen.judged <= budget {
            format!("{free}the lightest within {budget:.1e}")
        } else {
            format!(
                "{free}the lightest near the closest; none is within {budget:.1e}, and the scene asks for no accuracy"
            )
        }
    }
}

/// What is filtered.
fn what(chosen: &Candidate) -> &'static str {
    match chosen.over {
        Over::Values => "texture (C0)",
        Over::Heights(_) => "height (Ch)",
        Over::Slopes(_) => "slope (Cs)",
        Over::SlopeMap(..) => "slope map (Cs)",
        Over::Steepness(_) => "steepness (Cs)",
        Over::Normals(_) => "irradiance",
    }
}

/// Why a tier is taken that was not chosen.
const NAMED: &str = "the scene names this tier";

/// How a color and light that both depend on slopes are averaged; `spirv-tests/tests/combine/light.rs` measures it.
const TOGETHER: &str =
    "averaged with the color over five nodes of the visible slopes: 4 to 7 times as near, root mean\n    \
                        square, as the product of both means";

/// What the bound of a combination does not cover.
const INDEPENDENT: &str =
    "what that of each layer alone does not cover, and how far heights, slopes and values of\n    \
                           different layers are from independent";

/// What the bound of a scene of transferred heights does not cover.
const NORMAL: &str = "how far f and its slopes are from normal and from independent at a point";

/// What the paper's tier leaves out besides; `spirv-tests/tests/slope_nodes` measures it.
const PAPER: &str = ";
    how far h and its slopes are from normal: steps of slopes err by up to 0.2 where the curve is a smooth
    step over two deviations of f, and by 0.4 where f rises into it";

/// What a mean slope leaves out besides.
const LEANING: &str = ";\n    how much more Λ errs over a tilted surface than over a level one";

/// What the bound of a filter without a driver does not cover.
const UNDRIVEN: &str = "how far a pixel's values are from";

/// A filter's gap, and its driver's behind it.
fn driven(gap: String, driver: &Option<Driver>) -> String {
    driver.as_ref().map_or(gap.clone(), |driver| format!("{gap};\n    {}", driver.gap(true)))
}

/// Whether the bound is that of a distribution and of a map over it.
fn stacked(candidate: &Candidate) -> bool {
    matches!(candidate.over, Over::Heights(_) | Over::Slopes(_) | Over::SlopeMap(..) | Over::Steepness(_))
}

fn described(candidate: &Candidate) -> String {
    let filter = &candidate.filter;
    match (stacked(candidate), filter.bound, filter.tables.first()) {
        (_, bound, Some(table)) if !candidate.is_baked() => {
            format!("at least {:.1e}, by {:.1e} between its narrowest rows: not baked", bound.value(), table.error)
        }
        (false, Bound::Estimated(bound), Some(table)) => {
            format!("{bound:.1e}, estimated: twice the {:.1e} measured between texels", table.error)
        }
        (true, Bound::Estimated(bound), Some(table)) => {
            format!("{bound:.1e}, estimated: with twice the {:.1e} measured between texels", table.error)
        }
        (false, bound, _) => format!("{:.1e}, guaranteed by the shelf's contracts", bound.value()),
        (true, bound, _) => format!("{:.1e}, guaranteed by the shelf's contracts and step errors", bound.value()),
    }
}
