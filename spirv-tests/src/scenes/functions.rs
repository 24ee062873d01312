//! Scenes that are driven by functions of the position.

use prefilter::{Custom, Driver, Scene, Taps};

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
    Ok(vec![("custom_solid", Scene::new("wood").texture(named("terrain")?).tier(FAST).driver(Driver::Custom(rings)))])
}
