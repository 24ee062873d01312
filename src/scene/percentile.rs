//! The candidate of a scene of percentiles: there is only one.

use super::candidate::{parameters, Candidate};
use super::Scene;
use crate::filter::height::glue::Glue;
use crate::filter::height::HeightTier;
use crate::filter::percentile::filter;
use crate::transfer::color_map::ColorMap;
use crate::Error;

impl Scene {
    pub(super) fn percentiles(&self, map: &ColorMap) -> Result<Candidate, Error> {
        let tier = HeightTier::Exact;
        let named = [
            self.driver.map(|_| "a driver, whose mean and deviation they do not take".to_owned()),
            self.tier.map(|tier| format!("a color map's tier, {tier}")),
            self.height_tier.filter(|named| *named != tier).map(|tier| format!("a tier of heights, {tier}")),
            self.microsurface.perturbed.then(|| "noise on the heights, of which they know nothing".to_owned()),
        ];
        if let Some(named) = named.into_iter().flatten().next() {
            return Err(Error::Conflict(format!("percentiles of heights are exact and stand alone, without {named}")));
        }
        let (name, surface, label) = (&self.name, self.microsurface, "percentiles in closed form");
        let filter = filter(map, self.colors, surface)?;
        let parameters = parameters(&filter.tables);
        let glue = Glue { name, map, tier, label, surface, percentile: true, parameters: &parameters }.text(&filter);
        self.candidate(label.to_owned(), Some(tier), filter.bound.value(), filter, glue)
    }
}
