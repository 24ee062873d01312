//! The tiers of irradiance that a scene tries.

use super::candidate::{parameters, Candidate, Over};
use super::Scene;
use crate::filter::irradiance::{glue, irradiance, IrradianceTier, GIVEN};
use crate::transfer::irradiance::Irradiance;
use crate::Error;

/// Tiers from which an accuracy chooses: those that hold for any slopes.
const NORMALS: [IrradianceTier; 2] = [IrradianceTier::ThreeGaussians, IrradianceTier::FourGaussians];

impl Scene {
    pub(super) fn irradiances(&self, light: &Irradiance) -> Result<Vec<Candidate>, Error> {
        let candidate = |tier: IrradianceTier| {
            let filter = irradiance(light, self.colors, tier);
            let label = tier.to_string();
            let glue = glue(&self.name, tier, &label, &parameters(&filter.tables), &filter.body)
                + &self.driven("irradiance", "vec3f", GIVEN, &filter.tables);
            self.candidate(label, Over::Normals(tier), filter.bound.value(), filter, glue)
        };
        self.irradiance_tier.map_or(NORMALS.to_vec(), |tier| vec![tier]).into_iter().map(candidate).collect()
    }
}
