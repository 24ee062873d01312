//! What a module says of itself: the tier, its bound, its cost, and what the bound does not cover.

use std::fmt::Write;

use super::candidate::Candidate;
use super::Scene;
use crate::accuracy::{Bound, Ranges};
use crate::filter::height::{self, surface, tier, HeightTier};
use crate::filter::{irradiance, slope};
use crate::transfer::color_map::ColorMap;

impl Scene {
    pub(super) fn explain(&self, chosen: &Candidate, passed: &[Candidate]) -> String {
        let Ranges { mean: (low, high), deviation } = self.chosen_ranges();
        let what = match (chosen.height, chosen.slope, chosen.irradiance) {
            (Some(_), ..) => "height (Ch)",
            (None, Some(_), _) => "slope (Cs)",
            (None, None, Some(_)) => "irradiance",
            (None, None, None) => "texture (C0)",
        };
        let mut text = format!("{}: {what} by {}\n", self.name, chosen.label);
        let _ = writeln!(text, "  error   {}", described(chosen));
        if let (Some(tier), Some(map)) = (chosen.height, self.map()) {
            let _ = writeln!(text, "  covers  {}", self.covered(tier, map));
        }
        if let (Some(tier), Some(map)) = (chosen.slope, self.map()) {
            let _ = writeln!(text, "  covers  {}", self.covered_slopes(tier, map));
        }
        if let Some(tier) = chosen.irradiance {
            let _ = writeln!(text, "  covers  {}", irradiance::covered(tier));
        }
        let _ = writeln!(text, "  cost    {} a call", chosen.cost);
        if self.percentile.is_none() && self.irradiance.is_none() {
            let _ = writeln!(text, "  ranges  means {low} to {high}, deviations to {deviation}");
        }
        let _ = writeln!(text, "  chosen  {}", self.reason(chosen));
        for other in passed {
            let _ = writeln!(text, "  passed  {}: error {}; {}", other.label, described(other), other.cost);
        }
        let gap = match (chosen.height, self.driver) {
            (Some(_), None) => surface::gap(self.microsurface, self.percentile.is_some()),
            (Some(_), Some(driver)) => format!("{};\n    {}", surface::gap(self.microsurface, false), driver.gap()),
            (None, Some(driver)) => driver.gap(),
            (None, None) if chosen.irradiance.is_some() => irradiance::GAP.to_owned(),
            (None, None) => chosen.slope.map_or_else(|| UNDRIVEN.to_owned(), slope::gap),
        };
        let _ = writeln!(text, "  not in the error: {gap}");
        text
    }

    /// What the bound of a tier of heights is made of, and the Λ and deviations that it holds for.
    fn covered(&self, tier: HeightTier, map: &ColorMap) -> String {
        let floor = tier::floor(tier, self.chosen_ranges());
        let (step, variation) = (surface::step_error(tier, self.microsurface), height::variation(map));
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
        format!(
            "{reach}, {deviations}{tilted}: {beyond}a step errs by {step:.1e}, times the total variation {variation:.3}"
        )
    }

    fn reason(&self, chosen: &Candidate) -> String {
        let named = "the scene names ";
        let over = match (chosen.height, chosen.slope) {
            (Some(_), _) => self.height_tier.map(|tier| (tier.stands_alone(), "heights")),
            (None, _) => self.slope_tier.map(|_| (false, "slopes")),
        };
        let free = match (stacked(chosen), self.tier, over) {
            _ if self.irradiance_tier.is_some() => return named.to_owned() + "this tier",
            (false, Some(_), _) | (true, Some(_), Some(_)) | (true, None, Some((true, _))) => {
                return named.to_owned() + "this tier";
            }
            (true, None, Some((false, what))) => format!("{named}the tier of {what}; that of the color map is "),
            _ => String::new(),
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

/// What the bound of a filter without a driver does not cover.
const UNDRIVEN: &str = "how far a pixel's values are from a normal distribution of that mean and deviation";

/// Whether the bound is that of a distribution and of a map over it.
fn stacked(candidate: &Candidate) -> bool {
    candidate.height.is_some() || candidate.slope.is_some()
}

fn described(candidate: &Candidate) -> String {
    let filter = &candidate.filter;
    match (stacked(candidate), filter.bound, filter.tables.first()) {
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
