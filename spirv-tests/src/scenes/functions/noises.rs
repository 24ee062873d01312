//! Scenes that are driven by octaves of noise.

use prefilter::{Driver, HeightTier, Microsurface, Noise, NoiseBasis, NoiseFold, NoiseMethod, Scene, SlopeTier, Taps};

use crate::maps::named;
use crate::scenes::{Result, FAST};

/// By default, by the curvature, ridged, tiles under several taps, on triangles by the paper's way; heights of a plane
/// and of a tilted surface, slopes, and tiles of them.
///
/// # Errors
/// As [`crate::scenes::all`].
pub(in crate::scenes) fn all() -> Result<Vec<(&'static str, Scene)>> {
    let rock = |noise| Scene::new("rock").tier(FAST).driver(Driver::Noise(noise));
    let tiles = Noise { basis: NoiseBasis::Value, period: 8, rotation: 0.0, taps: Taps::Two, ..Noise::default() };
    let paper = Noise { basis: NoiseBasis::Simplex, method: NoiseMethod::Stationary, ..Noise::default() };
    let tilted = Microsurface { mean_slope: true, ..Microsurface::default() };
    let flat = Noise { rotation: 0.0, deviation: 0.05, ..Noise::default() };
    let low = Noise { basis: NoiseBasis::Simplex, deviation: 0.05, taps: Taps::Two, ..Noise::default() };
    let curved = |noise| rock(Noise { method: NoiseMethod::Curvature, ..noise });
    let triangles = Noise { basis: NoiseBasis::Simplex, ..Noise::default() };
    Ok(vec![
        ("noise_curvature", curved(Noise::default()).texture(named("terrain")?)),
        ("noise_curvature_simplex", curved(triangles).texture(named("terrain")?)),
        ("noise_curvature_tiles", curved(tiles).texture(named("steps6")?)),
        ("noise_default", rock(Noise::default()).texture(named("terrain")?)),
        ("noise_height", rock(Noise::default()).height(named("terrain")?).height_tier(HeightTier::Gaussian)),
        ("noise_ridged", rock(Noise { fold: NoiseFold::Ridged, ..Noise::default() }).texture(named("terrain")?)),
        ("noise_slope", rock(low).slope(named("terrain")?).slope_tier(SlopeTier::Gaussian)),
        (
            "noise_slope_tiles",
            rock(Noise { period: 4, ..flat }).slope(named("terrain")?).slope_tier(SlopeTier::Gaussian),
        ),
        ("noise_stationary", rock(paper).texture(named("steps6")?)),
        ("noise_solid", rock(Noise { basis: NoiseBasis::PerlinSolid, ..Noise::default() }).texture(named("terrain")?)),
        ("noise_tilted", rock(flat).height(named("terrain")?).height_tier(HeightTier::Gaussian).microsurface(tilted)),
        ("noise_tiles", rock(tiles).texture(named("steps6")?)),
    ])
}
