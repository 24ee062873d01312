//! The tiers of slopes that a scene tries, and what their bounds hold for.

use super::candidate::{arguments, parameters, Candidate, Over};
use super::Scene;
use crate::filter::height::variation;
use crate::filter::slope::{floor, given, glue, over, steepest, step_error, texture_ranges, SlopeTier};
use crate::filter::texture::{color_type, filter};
use crate::transfer::color_map::ColorMap;
use crate::Error;

/// Tiers of slopes from which an accuracy chooses.
const SLOPES: [SlopeTier; 2] = [SlopeTier::Gaussian, SlopeTier::Pair];

impl Scene {
    pub(super) fn slopes(&self, map: &ColorMap) -> Result<Vec<Candidate>, Error> {
        let (name, ranges) = (&self.name, self.chosen_ranges());
        let tiers = self.slope_tier.map_or(SLOPES.to_vec(), |tier| vec![tier]);
        let mut candidates = Vec::new();
        for texture_tier in self.tiers() {
            for &tier in &tiers {
                let below = texture_ranges(tier, ranges);
                let texture = filter(map, self.colors, texture_tier, below)?;
                let own = self.texture_glue(map, texture_tier, below, &texture);
                let filter = over(&texture, map, tier, ranges, name, &arguments(&texture.tables));
                let label = format!("{tier} over {texture_tier}");
                let glue = glue(name, map, tier, &label, &parameters(&filter.tables), &filter.body)
                    + &self.driven("slope", color_type(map), given(tier), &filter.tables)
                    + "\n"
                    + &own;
                let judged = if self.slope_tier.is_some() { texture.bound } else { filter.bound };
                candidates.push(self.candidate(label, Over::Slopes(tier), judged.value(), filter, glue)?);
            }
        }
        Ok(candidates)
    }

    /// What the bound of a tier of slopes is made of, and what it holds for.
    pub(super) fn covered_slopes(&self, tier: SlopeTier, map: &ColorMap) -> String {
        let ranges = self.chosen_ranges();
        let views = match tier {
            SlopeTier::Unweighted => "views above the horizon of the mean surface, or none for a flat mesh",
            SlopeTier::Gaussian | SlopeTier::Pair => "views above the horizon of the mean surface",
        };
        format!(
            "{views}, deviations of the component from {:.1e}, slope correlations to 0.9, mean slopes to {}: a step \
             errs by {:.1e}, times the total variation {:.3}",
            floor(ranges),
            steepest(ranges),
            step_error(tier, ranges),
            variation(map)
        )
    }
}
