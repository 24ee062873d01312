//! The candidate of a scene of percentiles: there is only one.

use super::candidate::{parameters, Candidate, Over, Text};
use super::Scene;
use crate::filter::height::glue::Glue;
use crate::filter::height::HeightTier;
use crate::filter::percentile::filter;
use crate::transfer::color_map::ColorMap;
use crate::Error;

impl Scene {
    /// Ch of a map over percentiles: positions are shares, from 0 to 1, of the surface that lie below a height.
    ///
    /// Exports what [`Self::height`] does, without mean and deviation: `NAME_height(slope_covariance, view, light, …)`.
    /// Whatever distribution the heights have cancels, and the color is exact. Equation 3 of Heitz et al. 2014 is that
    /// of the map from black at 0 to white at 1.
    ///
    /// ```
    /// use prefilter::{ColorMap, Scene};
    /// let rust = ColorMap::gradient([(0.0, [0.1, 0.04, 0.02]), (0.7, [0.5, 0.2, 0.1]), (1.0, [0.6, 0.6, 0.6])])?;
    /// let module = Scene::new("iron").height_percentile(rust).module()?;
    /// let height = "fn iron_height(slope_covariance: vec3f, view: vec3f, light: vec3f) -> vec3f";
    /// assert_eq!(module.exports()[0].signature, height);
    /// # Ok::<(), prefilter::Error>(())
    /// ```
    #[must_use]
    pub fn height_percentile(self, map: ColorMap) -> Self {
        Self { percentile: Some(map), ..self }
    }

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
