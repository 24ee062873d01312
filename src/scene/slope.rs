//! The tiers of slopes that a scene tries, and what their bounds hold for.

use super::candidate::{arguments, parameters, Candidate, Over, Text};
use super::sizes::of_texels;
use super::Scene;
use crate::filter::envelope::varied;
use crate::filter::slope::{floor, given, glue, model_error, over, steepest, step_error, texture_ranges, SlopeTier};
use crate::filter::texture::{color_type, filter, NODES};
use crate::filter::{Kernel, Tier};
use crate::transfer::color_map::{ColorMap, Colors};
use crate::Error;

/// Tiers of slopes from which an accuracy chooses.
const SLOPES: [SlopeTier; 2] = [SlopeTier::Gaussian, SlopeTier::Pair];

impl Scene {
    /// Cs: color by one component of the slope, of those slopes of a rough surface that a view sees: cliffs that face a
    /// direction, snow and rain from one side.
    ///
    /// Exports `NAME_slope(mean_slope, slope_covariance, view, direction, …)`, the mean color over the slopes'
    /// components along a horizontal vector of length 1 at most. A facet of the slope s has a normal along
    /// (−s.x, −s.y, 1), and counts by its area in the picture.
    ///
    /// The ranges are those of the component's mean and deviation over all slopes. Bounds are for views above the
    /// horizon of the mean surface, for mean slopes up to 1 or the largest mean, and for deviations of the component
    /// from a thousandth of that, or from a tenth of the largest deviation where that is less. What deviates more than
    /// the ranges say is drawn together, as [`Ranges`](crate::Ranges) tells.
    ///
    /// ```
    /// use prefilter::{Accuracy, ColorMap, Scene};
    /// let dune = ColorMap::gradient([(-0.6, [0.3, 0.2, 0.1]), (0.1, [0.8, 0.6, 0.4]), (0.6, [0.9, 0.8, 0.7])])?;
    /// let accuracy = Accuracy::max_filter_error(0.02).without_tables();
    /// let module = Scene::new("dune").slope(dune).accuracy(accuracy).module()?;
    /// assert_eq!(
    ///     module.exports()[0].signature,
    ///     "fn dune_slope(mean_slope: vec2f, slope_covariance: vec3f, view: vec3f, direction: vec2f) -> vec3f"
    /// );
    /// # Ok::<(), prefilter::Error>(())
    /// ```
    #[must_use]
    pub fn slope(self, map: ColorMap) -> Self {
        Self { slope: Some(map), ..self }
    }

    pub(super) fn slopes(&self, map: &ColorMap) -> Result<Vec<Candidate>, Error> {
        let (name, ranges) = (&self.name, self.chosen_ranges());
        let tiers = self.slope_tier.map_or(SLOPES.to_vec(), |tier| vec![tier]);
        let attempt = |texture_tier: Tier, nodes: [usize; 2], worth: f32| {
            // One and two normal distributions ask C0 for the same.
            let below = texture_ranges(tiers[0], ranges);
            let model = tiers.iter().map(|&tier| model_error(map, tier, ranges) as f32);
            let model = if self.slope_tier.is_some() { 0.0 } else { model.fold(f32::INFINITY, f32::min) };
            let texture = filter(map, self.colors, texture_tier, nodes, below, worth - model)?;
            let candidate = |&tier: &SlopeTier| {
                let own = self.texture_glue(map, texture_tier, below, &texture);
                let on = |tier| over(&texture, map, tier, ranges, name, &arguments(&texture.tables));
                let (filter, alike) = (on(tier), on(SlopeTier::Unweighted).body);
                let label = format!("{tier} over {texture_tier}{}", of_texels(nodes, NODES));
                let glue = glue(name, map, tier, &label, &parameters(&filter.tables), &filter.body)
                    + &self.driven("slope", color_type(map.channels()), given(tier), &filter.tables)
                    + "\n"
                    + &own;
                let text = Text { glue, beneath: own.clone(), alike };
                let judged = if self.slope_tier.is_some() { texture.bound } else { filter.bound };
                self.candidate(label, Over::Slopes(tier), judged.value(), filter, text)
            };
            tiers.iter().map(candidate).collect()
        };
        let mut candidates = Vec::new();
        self.by_tiers(&mut candidates, self.tiers_below_slopes(), attempt)?;
        Ok(candidates)
    }

    /// The tiers of C0 that the scene names or allows; a single one for a map at a single slope.
    fn tiers_below_slopes(&self) -> Vec<Tier> {
        match (self.slope_tier, self.tier, self.colors) {
            (Some(SlopeTier::Naive), None, Colors::Constant) => vec![Tier::Naive],
            (Some(SlopeTier::Naive), None, Colors::Dynamic) => vec![Tier::ClosedForm(Kernel::Exact)],
            _ => self.tiers(),
        }
    }

    /// What the bound of a tier of slopes is made of, and what it holds for.
    pub(super) fn covered_slopes(&self, tier: SlopeTier, map: &ColorMap) -> String {
        let ranges = self.chosen_ranges();
        let views = match tier {
            SlopeTier::Unweighted => "views above the horizon of the mean surface, or none for a flat mesh",
            SlopeTier::Naive | SlopeTier::Gaussian | SlopeTier::Pair => "views above the horizon of the mean surface",
        };
        format!(
            "{views}, deviations of the component from {:.1e}, slope correlations to 0.9, mean slopes to {}: a step \
             errs by {:.1e}, times {}",
            floor(ranges),
            steepest(ranges),
            step_error(tier, ranges),
            varied(map, model_error(map, tier, ranges) / step_error(tier, ranges))
        )
    }
}
