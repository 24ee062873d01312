//! Scenes of transferred heights.

use prefilter::{
    ColorMap, Cosines, Driver, HeightTransfer, Irradiance, Microsurface, Noise, Scene, SlopeTier, Taps, TransferTier,
    Wave,
};

use super::{Result, FAST};

/// The scenes of transferred heights, by every tier and of every filter that goes with one.
///
/// # Errors
/// As [`super::all`].
pub(super) fn all() -> Result<Vec<(&'static str, Scene)>> {
    let map = ColorMap::gradient([(0.0, [0.05, 0.1, 0.02]), (1.0, [0.4, 0.5, 0.1])])?;
    let moss = || -> Result<Scene> {
        Ok(Scene::new("moss").height(map.clone()).transfer(HeightTransfer::smoothstep(0.0, 1.2)?))
    };
    let wave = |frequency, amplitude, phase| Wave { frequency, amplitude, phase };
    let waves = vec![wave([1.0, 0.3], 0.4, 0.1), wave([-0.5, 1.1], 0.3, 2.0)];
    let waves = Driver::Cosines(Cosines { waves, taps: Taps::Two, ..Cosines::default() });
    let tilted = Microsurface { mean_slope: true, ..Microsurface::default() };
    let noise = Driver::Noise(Noise { octaves: 3, ..Noise::default() });
    let sand = ColorMap::gradient([(-0.5, [0.31, 0.22, 0.12]), (0.5, [0.93, 0.84, 0.68])])?;
    let dune = Scene::new("dune").slope(sand).slope_tier(SlopeTier::Gaussian).tier(FAST);
    let sky = Irradiance::from_harmonics([[0.9, 1.1, 1.4]; 9])?;
    let steep = Scene::new("steep").steepness(map.clone());
    let high = Scene::new("high").height(map.clone());
    let stairs = HeightTransfer::terraces(3, 0.4)?;
    Ok(vec![
        ("transfer_height", moss()?),
        ("transfer_height_paper", moss()?.transfer_tier(TransferTier::Paper).driver(noise)),
        ("transfer_height_tilted", moss()?.microsurface(tilted).driver(waves)),
        ("transfer_slope", dune.transfer(HeightTransfer::absolute().scaled(0.4, 0.1)?)),
        ("transfer_irradiance", Scene::new("hill").irradiance(sky).transfer(stairs.clone())),
        ("transfer_combination", Scene::new("hills").combination(&high * &steep).transfer(stairs)),
    ])
}
