//! Scenes that are driven by images.

use prefilter::{Colors, Distribution, Driver, Indicators, Moments, Pixel, Scene, Taps, Tier};

use super::{Result, EXACT, FAST};
use crate::maps::named;

/// The scenes of images in bands, and of four moments.
///
/// # Errors
/// As [`super::all`].
pub(super) fn all() -> Result<Vec<(&'static str, Scene)>> {
    let shares = |taps| Driver::Indicators(Indicators { taps, ..Indicators::default() });
    let strata = || Ok::<_, Box<dyn std::error::Error + Send + Sync>>(Scene::new("strata").texture(named("steps6")?));
    let threshold = prefilter::ColorMap::bands([0.02; 3], [(0.5, [0.9, 0.85, 0.8])])?;
    let moments = Driver::Moments(Moments { taps: Taps::Two, ..Moments::default() });
    let bricks = Scene::new("bricks").texture(named("terrain")?).distribution(Distribution::Pair).driver(moments);
    Ok(vec![
        ("driven_by_shares", Scene::new("cutout").texture(threshold).tier(FAST).driver(shares(Taps::One))),
        ("driven_by_shares_of_six", strata()?.colors(Colors::Dynamic).tier(EXACT).driver(shares(Taps::Four))),
        ("driven_in_two", bricks.tier(FAST)),
    ])
}

/// Scenes of images by one normal distribution a tap.
///
/// # Errors
/// As [`super::all`].
pub(super) fn driven() -> Result<Vec<(&'static str, Scene)>> {
    let moments = |taps| Driver::Moments(Moments { taps, ..Moments::default() });
    let oblong = Moments { taps: Taps::Two, pixel: Pixel::Covariance([0.25, 0.05, 0.1]), slopes: false };
    let terrain = || Ok::<_, Box<dyn std::error::Error + Send + Sync>>(Scene::new("relief").texture(named("terrain")?));
    Ok(vec![
        ("driven", terrain()?.driver(moments(Taps::One))),
        ("driven_by_eight_taps", terrain()?.driver(moments(Taps::Eight))),
        ("driven_by_oblong_pixels", terrain()?.driver(Driver::Moments(oblong))),
        ("driven_table", terrain()?.tier(Tier::Table).driver(moments(Taps::Four))),
        ("driven_dynamic", terrain()?.colors(Colors::Dynamic).tier(EXACT).driver(moments(Taps::Eight))),
    ])
}
