//! Scenes that are driven by functions of the position.

use prefilter::{ColorMap, Custom, Driver, Gabor, GaborMethod, Reflectance, Scene, SlopeTier, Spectrum, Taps};

mod noises;

use super::{Result, FAST};
use crate::maps::named;

/// The scenes that are driven by functions.
///
/// # Errors
/// As [`super::all`].
pub(super) fn all() -> Result<Vec<(&'static str, Scene)>> {
    let rings = "fn rings(position: vec3f, across: vec3f, along: vec3f) -> vec4f {
    return vec4f(length(position.xy), dot(across.xy, across.xy) + dot(along.xy, along.xy), 0.0, 0.0);
}";
    let rings = Custom { taps: Taps::Four, ..Custom::new(rings, "rings") };
    let waves = "fn waves(position: vec2f, across: vec2f, along: vec2f) -> vec4f {
    let fade = exp(-0.5 * (across.x * across.x + along.x * along.x));
    return vec4f(0.5 + 0.4 * fade * sin(position.x), 0.08 * (1.0 - fade * fade), 0.0, 0.0);
}
fn waves_slope(position: vec2f, across: vec2f, along: vec2f) -> vec2f {
    return vec2f(0.4 * exp(-0.5 * (across.x * across.x + along.x * along.x)) * cos(position.x), 0.0);
}
fn waves_slope_covariance(position: vec2f, across: vec2f, along: vec2f) -> vec3f {
    return vec3f(0.08 * (1.0 - exp(-across.x * across.x - along.x * along.x)), 0.0, 0.0);
}";
    let driver = || Driver::Custom(Custom { taps: Taps::Two, ..Custom::new(waves, "waves") });
    let grain = ColorMap::gradient([(0.1, [0.5; 3]), (0.9, [1.0, 0.95, 0.9])])?;
    let grain = Scene::new("grain").texture(grain).tier(FAST).driver(driver());
    let sand = ColorMap::gradient([(-0.3, [0.7, 0.6, 0.4]), (0.3, [0.9, 0.8, 0.6])])?;
    let sand = Scene::new("sand").slope(sand).slope_tier(SlopeTier::Gaussian).tier(FAST);
    let dunes = Scene::new("dunes").combination(grain * sand).driver(driver()).reflectance(Reflectance::Given);
    let own = vec![
        ("combination_driven", dunes),
        ("custom_solid", Scene::new("wood").texture(named("terrain")?).tier(FAST).driver(Driver::Custom(rings))),
    ];
    Ok([own, gabors()?, noises::all()?].concat())
}

/// Solid Gabor noise: every spectrum and both methods.
fn gabors() -> Result<Vec<(&'static str, Scene)>> {
    let map = named("terrain")?;
    let scene = |gabor| Scene::new("granite").texture(map.clone()).tier(FAST).driver(Driver::Gabor(gabor));
    let grain = Spectrum::Anisotropic { frequency: [0.3, 2.0, -0.4] };
    let rings = Spectrum::Hybrid { frequency: (1.0, 2.5), azimuth: (-0.5, 0.5), height: (-0.2, 0.3) };
    let long = Gabor { spectrum: grain, bandwidth: 0.7, kernels: 3, seed: 9, ..Gabor::default() };
    Ok(vec![
        ("gabor_default", scene(Gabor::default())),
        ("gabor_anisotropic", scene(Gabor { taps: Taps::Four, ..long })),
        ("gabor_hybrid", scene(Gabor { spectrum: rings, ..Gabor::default() })),
        ("gabor_paper", scene(Gabor { method: GaborMethod::Paper, ..Gabor::default() })),
    ])
}
