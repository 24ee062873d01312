//! The candidate of a scene of percentiles: there is only one.

use super::candidate::{parameters, Candidate, Over, Text};
use super::Scene;
use crate::filter::height::glue::Glue;
use crate::filter::height::HeightTier;
use crate::filter::percentile::filter;
use crate::transfer::color_map::ColorMap;
use crate::Error;

impl Scene {
    pub(super) fn percentiles(&self, map: &ColorMap) -> Result<Candidate, Error> {
        let tier = HeightTier::Exact;
        let (name, surface, label) = (&self.name, self.microsurface, "percentiles in closed form");
        let filter = filter(map, self.colors, surface)?;
        let parameters = parameters(&filter.tables);
        let glue = Glue { name, map, tier, label, surface, percentile: true, parameters: &parameters }.text(&filter);
        self.candidate(
            label.to_owned(),
            Over::Heights(tier),
            filter.bound.value(),
            filter,
            Text { glue, ..Text::default() },
        )
    }
}
