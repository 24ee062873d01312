//! The tiers of irradiance that a scene tries.

use super::candidate::{parameters, Candidate};
use super::Scene;
use crate::filter::height::Microsurface;
use crate::filter::irradiance::{glue, irradiance, IrradianceTier};
use crate::transfer::irradiance::Irradiance;
use crate::Error;

/// Tiers from which an accuracy chooses: those that hold for any slopes.
const NORMALS: [IrradianceTier; 2] = [IrradianceTier::ThreeGaussians, IrradianceTier::FourGaussians];

impl Scene {
    pub(super) fn irradiances(&self, light: &Irradiance) -> Result<Vec<Candidate>, Error> {
        let named = [
            self.driver.map(|_| "a driver, which knows no slopes"),
            self.tier.map(|_| "a tier of values"),
            self.height_tier.map(|_| "a tier of heights"),
            self.slope_tier.map(|_| "a tier of slopes"),
            (self.microsurface != Microsurface::default()).then_some("what hides heights"),
        ];
        if let Some(named) = named.into_iter().flatten().next() {
            return Err(Error::Conflict(format!("`irradiance` goes without {named}")));
        }
        let candidate = |tier: IrradianceTier| {
            let filter = irradiance(light, self.colors, tier);
            let label = tier.to_string();
            let glue = glue(&self.name, tier, &label, &parameters(&filter.tables), &filter.body);
            let candidate = self.candidate(label, None, filter.bound.value(), filter, glue)?;
            Ok(Candidate { irradiance: Some(tier), ..candidate })
        };
        self.irradiance_tier.map_or(NORMALS.to_vec(), |tier| vec![tier]).into_iter().map(candidate).collect()
    }
}
