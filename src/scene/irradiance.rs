//! The tiers of irradiance that a scene tries.

use super::candidate::{parameters, Candidate, Over, Text};
use super::Scene;
use crate::accuracy::Ranges;
use crate::filter::irradiance::{glue, irradiance, IrradianceTier, GIVEN, NARROW, RANGES};
use crate::transfer::irradiance::Irradiance;
use crate::Error;

/// Tiers from which an accuracy chooses; the first holds for narrow slopes only.
const NORMALS: [IrradianceTier; 3] =
    [IrradianceTier::Points, IrradianceTier::ThreeGaussians, IrradianceTier::FourGaussians];

impl Scene {
    /// Light from all around on the slopes of a rough surface that a view sees, and Lambert's cosine of one light.
    ///
    /// Exports `NAME_irradiance(mean_slope, slope_covariance, view, x, y, z, …)`, the mean irradiance over the normals
    /// that are seen, x, y and z being the axes of the tangent frame in the environment's space, and
    /// `NAME_lambert(mean_slope, slope_covariance, view, light)`, the mean of max(n · l, 0). With
    /// [`Colors::Dynamic`](crate::Colors::Dynamic) the environment is a texture of nine texels.
    ///
    /// Bounds are for views from 5 degrees above the plane and the mean surface, mean slopes to 0.3 on each axis and
    /// slope deviations up to 1 along any axis (of [`IrradianceTier::Points`] 0.3) with correlations up to 0.9; that of
    /// Lambert's cosine is 0.03 besides. Of flatter views, or where slopes vary by more along a diagonal, they do not
    /// hold.
    /// [`Self::ranges`], of components of the mean slope and of slope deviations, are within these: where deviations
    /// are up to 0.3, an accuracy may choose the points, which cost a third.
    ///
    /// ```
    /// use prefilter::{Irradiance, Scene};
    /// let sky = Irradiance::from_equirectangular(64, 32, &[[0.4, 0.6, 1.0]; 64 * 32])?;
    /// let module = Scene::new("dune").irradiance(sky).module()?;
    /// let names: Vec<_> = module.exports().iter().map(|export| export.name.as_str()).collect();
    /// assert_eq!(names, ["dune_irradiance", "dune_lambert"]);
    /// # Ok::<(), prefilter::Error>(())
    /// ```
    #[must_use]
    pub fn irradiance(self, light: Irradiance) -> Self {
        Self { irradiance: Some(light), ..self }
    }

    pub(super) fn irradiances(&self, light: &Irradiance) -> Result<Vec<Candidate>, Error> {
        let candidate = |tier: IrradianceTier| {
            let filter = irradiance(light, self.colors, tier);
            let label = tier.to_string();
            let glue = glue(&self.name, tier, &label, &parameters(&filter.tables), &filter.body)
                + &self.driven("irradiance", "vec3f", GIVEN, &filter.tables);
            self.candidate(label, Over::Normals(tier), filter.bound.value(), filter, Text { glue, ..Text::default() })
        };
        let Ranges { mean: (low, high), deviation } = self.chosen_ranges();
        if low < RANGES.mean.0 || high > RANGES.mean.1 || deviation > RANGES.deviation {
            let what = format!(
                "the scene `{}` filters `irradiance`, whose bounds hold for components of mean slopes from -0.3 to \
                 0.3 and deviations to 1: its `ranges` are wider",
                self.name
            );
            return Err(Error::Conflict(what));
        }
        let fits = |tier: &IrradianceTier| *tier != IrradianceTier::Points || deviation <= NARROW;
        let tiers = || NORMALS.into_iter().filter(fits).collect();
        self.irradiance_tier.map_or_else(tiers, |tier| vec![tier]).into_iter().map(candidate).collect()
    }
}
