//! Scenes of values that are not normal.

use prefilter::{Custom, Distribution, Driver, Learned, Scene, Taps};

use super::{Result, FAST};
use crate::maps::named;

/// The scenes of values whose distribution is named.
///
/// # Errors
/// As [`super::all`].
pub(super) fn all() -> Result<Vec<(&'static str, Scene)>> {
    let coins = "fn coins(position: vec2f, across: vec2f, along: vec2f) -> vec4f {
    let share = 0.5 + 0.3 * sin(position.x);
    let variance = share * (1.0 - share);
    return vec4f(share, variance, (1.0 - 2.0 * share) * inverseSqrt(variance), 1.0 / variance - 6.0);
}";
    let coins = Custom { taps: Taps::Two, ..Custom::new(coins, "coins") };
    let hill = || Ok::<_, Box<dyn std::error::Error + Send + Sync>>(Scene::new("hill").texture(named("terrain")?));
    let plateaus: Vec<f32> = (0..256).map(|at| if (at / 4 + at / 64) % 2 == 0 { 0.3 } else { 0.7 }).collect();
    Ok(vec![
        ("values_bounded", hill()?.distribution(Distribution::Beta { low: 0.0, high: 1.0 })),
        ("values_learned", hill()?.distribution(Distribution::Learned(Learned::from_image(16, 16, &plateaus)?))),
        ("values_in_two", hill()?.tier(FAST).distribution(Distribution::Pair).driver(Driver::Custom(coins))),
    ])
}
