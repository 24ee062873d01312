//! The color maps of `examples/data/colormaps.json`, and random ones for hard cases.

use prefilter::ColorMap;
use serde_json::Value;

use crate::random::Random;

/// The names of the maps in the file.
pub const NAMES: [&str; 6] = ["terrain", "gist_earth", "viridis", "steps6", "stripe1_lin", "stripe1_hard"];

const FILE: &str = include_str!("../../examples/data/colormaps.json");

/// A map of the file by its name.
///
/// # Errors
/// A name that the file lacks, or numbers that no map may have.
pub fn named(name: &str) -> Result<ColorMap, Box<dyn std::error::Error + Send + Sync>> {
    let file: Value = serde_json::from_str(FILE)?;
    let knots = file["maps"][name].as_array().ok_or_else(|| format!("colormaps.json has no map `{name}`"))?;
    let mut stops = Vec::new();
    for knot in knots {
        let position = knot[0].as_f64().ok_or("a knot begins with its position")? as f32;
        let (left, right) = (color(&knot[1])?, color(&knot[2])?);
        stops.push((position, left));
        if right != left {
            stops.push((position, right));
        }
    }
    Ok(ColorMap::gradient(stops)?)
}

/// Three numbers, or one for a gray.
fn color(value: &Value) -> Result<[f32; 3], &'static str> {
    let channel = |index: usize| value[index].as_f64().or(value[0].as_f64()).map(|number| number as f32);
    match (channel(0), channel(1), channel(2)) {
        (Some(red), Some(green), Some(blue)) => Ok([red, green, blue]),
        _ => Err("a color is one or three numbers"),
    }
}

/// A gradient of `count` stops at uneven positions in [0, 1] with colors over the whole range, hard where `hard`: every
/// third position twice. The same seed gives the same map.
///
/// # Errors
/// A count that no map may have.
pub fn random(count: usize, hard: bool, seed: u32) -> Result<ColorMap, prefilter::Error> {
    let mut random = Random::new(seed);
    let mut unit = || random.unit() as f32;
    let mut positions: Vec<f32> = (0..count).map(|_| unit()).collect();
    positions.sort_by(f32::total_cmp);
    positions.dedup();
    let mut stops: Vec<(f32, [f32; 3])> = Vec::new();
    for (index, position) in positions.into_iter().enumerate() {
        stops.push((position, [unit(), unit(), unit()]));
        if hard && index % 3 == 1 {
            stops.push((position, [unit(), unit(), unit()]));
        }
    }
    ColorMap::gradient(stops)
}
