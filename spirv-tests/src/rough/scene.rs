//! What is looked at: the colors of heights, the views and the lights.

use crate::imaging::view::{azimuth, Lens, View};
use prefilter::ColorMap;

/// Elevation of both suns, in degrees.
const SUN: f64 = 18.0;

/// Degrees between the azimuth of a sun and the line of sight.
const ASIDE: f64 = 20.0;

/// A light's name.
pub const LIGHTS: [&str; 2] = ["behind", "ahead"];

/// Unit vectors toward the suns: behind the viewer and ahead.
pub fn lights() -> [[f64; 3]; 2] {
    let (sine, cosine) = SUN.to_radians().sin_cos();
    [180.0 - ASIDE, ASIDE].map(|degrees| {
        let [x, y] = azimuth(degrees.to_radians());
        [cosine * x, cosine * y, sine]
    })
}

/// What the suns are called in a view.
pub fn suns(view: &View) -> [&'static str; 2] {
    match view.lens {
        Lens::Pinhole { .. } => ["sun behind the viewer", "sun ahead"],
        Lens::Satellite { .. } => ["sun on one side", "sun on the other side"],
    }
}

/// From grazing to overhead, from near to far.
pub fn views([width, height]: [usize; 2]) -> [View; 3] {
    let tangents = |degrees: [f64; 2]| degrees.map(|degrees| degrees.to_radians().tan());
    let satellite = Lens::Satellite { first: 0.3, farther: 100.0 };
    let pinhole = |degrees, last| Lens::Pinhole { tangents: tangents(degrees), last };
    let view = |name, title, lens| View { name, title, lens, width, height, pan: [0.0; 2] };
    [
        view("grazing", "grazing: the ground from 0.5 to 10 degrees below the horizon", pinhole([0.5, 10.0], 0.7)),
        view("oblique", "oblique: the ground from 12 to 40 degrees below the horizon", pinhole([12.0, 40.0], 0.45)),
        view("overhead", "from overhead, 100 times farther at the right", satellite),
    ]
}

/// Wet moss in the hollows, dry moss and rock between, pale lichen on the tops; positions in deviations of heights.
///
/// # Errors
/// None: the map is fixed.
pub fn map() -> Result<ColorMap, prefilter::Error> {
    ColorMap::gradient([
        (-2.4, [0.012, 0.035, 0.030]),
        (-0.9, [0.030, 0.110, 0.030]),
        (0.0, [0.150, 0.230, 0.035]),
        (0.0, [0.260, 0.170, 0.100]),
        (0.9, [0.480, 0.370, 0.260]),
        (0.9, [0.700, 0.360, 0.070]),
        (1.25, [0.820, 0.500, 0.110]),
        (1.25, [0.860, 0.820, 0.720]),
        (2.4, [0.960, 0.950, 0.900]),
    ])
}
