//! The maps that filters are measured with.

use crate::maps;
use crate::report::Error;
use prefilter::{ColorMap, Module, Scene, Tier};

/// The map at a value, as a scene without a filter.
///
/// # Errors
/// None for maps that are maps.
pub fn naive(name: &str, map: &ColorMap) -> Result<Module, prefilter::Error> {
    Scene::new(name).texture(map.clone()).tier(Tier::Naive).module()
}

/// A map by its name.
///
/// # Errors
/// Damaged data.
pub fn named(name: &str) -> Result<ColorMap, Error> {
    maps::named(name).map_err(|error| Error::Map(error.to_string()))
}

/// A map over [0, 1] spread over other positions.
///
/// # Errors
/// Positions that no map may have.
pub fn spread(map: &ColorMap, low: f32, high: f32) -> Result<ColorMap, prefilter::Error> {
    let mut stops: Vec<(f32, [f32; 3])> = Vec::new();
    for knot in map.knots() {
        let position = low + (high - low) * knot.position;
        let [left, right] = [knot.left, knot.right].map(|color| [color[0], color[1], color[2]]);
        stops.push((position, left));
        if left != right {
            stops.push((position, right));
        }
    }
    ColorMap::gradient(stops)
}
