//! Scenes that are driven by octaves of noise.

use prefilter::{Driver, HeightTier, Noise, NoiseBasis, NoiseFold, NoiseMethod, Scene, Taps};

use crate::maps::named;
use crate::scenes::{Result, FAST};

/// By default, ridged, tiles under several taps, on triangles by the paper's way, and heights.
///
/// # Errors
/// As [`crate::scenes::all`].
pub(in crate::scenes) fn all() -> Result<Vec<(&'static str, Scene)>> {
    let rock = |noise| Scene::new("rock").tier(FAST).driver(Driver::Noise(noise));
    let tiles = Noise { basis: NoiseBasis::Value, period: 8, rotation: 0.0, taps: Taps::Two, ..Noise::default() };
    let paper = Noise { basis: NoiseBasis::Simplex, method: NoiseMethod::Stationary, ..Noise::default() };
    Ok(vec![
        ("noise_default", rock(Noise::default()).texture(named("terrain")?)),
        ("noise_height", rock(Noise::default()).height(named("terrain")?).height_tier(HeightTier::Gaussian)),
        ("noise_ridged", rock(Noise { fold: NoiseFold::Ridged, ..Noise::default() }).texture(named("terrain")?)),
        ("noise_stationary", rock(paper).texture(named("steps6")?)),
        ("noise_solid", rock(Noise { basis: NoiseBasis::PerlinSolid, ..Noise::default() }).texture(named("terrain")?)),
        ("noise_tiles", rock(tiles).texture(named("steps6")?)),
    ])
}
