//! The tiers of heights that a scene tries.

use super::candidate::{arguments, parameters, Candidate, Over, Text};
use super::sizes::of_texels;
use super::Scene;
use crate::filter::height::glue::{given, Glue};
use crate::filter::height::skewed::{skewed, COLUMNS, SIZES};
use crate::filter::height::tails::{short_tails, tails};
use crate::filter::height::tier::texture_ranges;
use crate::filter::height::{self, HeightTier};
use crate::filter::texture::{color_type, filter, NODES};
use crate::filter::Tier;
use crate::transfer::color_map::{ColorMap, Colors};
use crate::Error;

/// Tiers of heights over C0 from which an accuracy chooses.
const HEIGHTS: [HeightTier; 1] = [HeightTier::Gaussian];

impl Scene {
    pub(super) fn heights(&self, map: &ColorMap) -> Result<Vec<Candidate>, Error> {
        let mut candidates = Vec::new();
        for tier in self.standing_alone(map) {
            let sizes = if tier == HeightTier::Skewed && self.height_tier.is_none() {
                self.sizes(&SIZES, COLUMNS)
            } else {
                vec![COLUMNS]
            };
            let attempt = |columns, worth| Ok(vec![self.alone(map, tier, columns, worth)?]);
            self.beside(&mut candidates, &sizes, attempt)?;
        }
        if self.height_tier.is_some_and(HeightTier::stands_alone) {
            return Ok(candidates);
        }
        let named = self.height_tier.map_or(HEIGHTS.to_vec(), |tier| vec![tier]);
        let (name, surface, ranges) = (&self.name, self.microsurface, self.chosen_ranges());
        let below = texture_ranges(ranges);
        let attempt = |texture_tier: Tier, nodes: [usize; 2], worth: f32| {
            let model = named.iter().map(|&tier| height::model_error(map, tier, surface, ranges) as f32);
            let model = if self.height_tier.is_some() { 0.0 } else { model.fold(f32::INFINITY, f32::min) };
            let texture = filter(map, self.colors, texture_tier, nodes, below, worth - model)?;
            let own = self.texture_glue(map, texture_tier, below, &texture);
            let candidate = |&tier: &HeightTier| {
                let filter = height::over(&texture, map, tier, surface, ranges, name, &arguments(&texture.tables));
                let label = format!("{tier} over {texture_tier}{}", of_texels(nodes, NODES));
                let extra = parameters(&filter.tables);
                let glue = Glue { name, map, tier, label: &label, surface, percentile: false, parameters: &extra }
                    .text(&filter);
                let driven = self.driven("height", color_type(map.channels()), &given(surface), &filter.tables);
                let glue = glue + &driven + "\n" + &own;
                let text = Text { glue, beneath: own.clone(), ..Text::default() };
                let judged = if self.height_tier.is_some() { texture.bound } else { filter.bound };
                self.candidate(label, Over::Heights(tier), judged.value(), filter, text)
            };
            named.iter().map(candidate).collect()
        };
        self.by_tiers(&mut candidates, self.tiers(), attempt)?;
        Ok(candidates)
    }

    /// The tiers of heights that need no C0 and that the scene names or allows.
    fn standing_alone(&self, map: &ColorMap) -> Vec<HeightTier> {
        match (self.height_tier, self.tier) {
            (Some(tier), _) if tier.stands_alone() => vec![tier],
            (Some(_), _) | (None, Some(_)) => Vec::new(),
            (None, None) => {
                let constant = self.colors == Colors::Constant && !self.microsurface.perturbed;
                let bands = (constant && height::banded(map)).then_some(HeightTier::Exact);
                let table = self.accuracy.unwrap_or_default().tables.then_some(HeightTier::Skewed);
                let short = (self.colors == Colors::Constant).then_some(HeightTier::ClosedFormFast);
                bands.into_iter().chain(short).chain([HeightTier::ClosedForm]).chain(table).collect()
            }
        }
    }

    /// The candidate of a tier of heights that needs no C0, its table having so many columns, where its bound may be at
    /// most `worth`.
    fn alone(&self, map: &ColorMap, tier: HeightTier, columns: usize, worth: f32) -> Result<Candidate, Error> {
        if let Some(named) = self.tier {
            return Err(Error::Conflict(format!("{named} does not go with {tier}: leave out the tier of values")));
        }
        let (name, surface, label) = (&self.name, self.microsurface, tier.to_string());
        let label = label + &of_texels([columns], [COLUMNS]);
        let filter = match tier {
            HeightTier::Skewed => skewed(map, self.colors, surface, columns, self.chosen_ranges(), worth),
            HeightTier::ClosedFormFast => short_tails(map, self.colors, surface, self.chosen_ranges())?,
            HeightTier::ClosedForm => tails(map, self.colors, surface, self.chosen_ranges())?,
            _ => height::bands(map, self.colors, surface, self.chosen_ranges())?,
        };
        let parameters = parameters(&filter.tables);
        let glue =
            Glue { name, map, tier, label: &label, surface, percentile: false, parameters: &parameters }.text(&filter);
        let glue = glue + &self.driven("height", color_type(map.channels()), &given(surface), &filter.tables);
        let text = Text { glue, ..Text::default() };
        self.candidate(label, Over::Heights(tier), filter.bound.value(), filter, text)
    }
}
