//! Scenes that are driven by patterns of two values and by waves.

use prefilter::driver::cosines::Wave;
use prefilter::driver::pattern::Motif;
use prefilter::{Cosines, Driver, Pattern, Pixel, Scene, SlopeTier, Taps, Tier, Warp};

use super::{Result, FAST};
use crate::maps::named;

/// The scenes that are driven by patterns and by waves.
///
/// # Errors
/// As [`super::all`].
pub(super) fn all() -> Result<Vec<(&'static str, Scene)>> {
    let checker = Pattern::default();
    let grid = Pattern { motif: Motif::Grid { widths: [0.1, 0.05] }, values: [0.9, 0.2], ..checker };
    let tiles = Scene::new("tiles").texture(named("terrain")?);
    let wave = |x: f32, y: f32, amplitude: f32, phase: f32| Wave { frequency: [x, y], amplitude, phase };
    let waves = vec![wave(0.8, 0.1, 0.1, 0.3), wave(1.7, -0.6, -0.04, 12.9), wave(3.1, 1.2, 0.02, 0.0)];
    let one = Cosines { waves: vec![waves[0]], mean: 0.5, taps: Taps::Four, pixel: Pixel::Round(0.4) };
    let sea = Driver::Cosines(Cosines { waves, ..Cosines::default() });
    let steepness = Scene::new("sea").steepness(named("terrain")?).slope_tier(SlopeTier::Gaussian);
    let marble = Pattern { motif: Motif::Stripes { duty: 0.3 }, taps: Taps::Two, ..checker };
    let marble = Driver::Warp(Warp { size: 2.0, ..Warp::of(Driver::Pattern(marble)) });
    Ok(vec![
        ("pattern_warped", Scene::new("marble").texture(named("terrain")?).tier(FAST).driver(marble)),
        ("cosines_one", Scene::new("ripple").texture(named("steps6")?).tier(FAST).driver(Driver::Cosines(one))),
        ("cosines_steepness", steepness.driver(sea)),
        ("pattern_checker", tiles.clone().tier(FAST).driver(Driver::Pattern(checker))),
        ("pattern_grid", tiles.tier(Tier::Table).driver(Driver::Pattern(grid))),
    ])
}
