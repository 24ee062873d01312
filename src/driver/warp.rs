//! Drivers whose positions a noise displaces.

use super::function::{Dimensions, Function};
use super::{Called, Driver};
use crate::Error;

/// A driver of the plane whose positions noise displaces, f(p + g(p)): veins of marble from stripes, torn noise.
///
/// The footprint is carried along: by the derivatives of g where a footprint resolves its octaves, which turns,
/// stretches and squeezes it, and by the variance of those that it has lost, which widens it. Both components of g are
/// Perlin's noise of a gain of ½ and a lacunarity of 2.
///
/// What a footprint is displaced to is taken for normal, and to have one turn and size. Root mean square errors of the
/// largest channel on a plane to the horizon, in thousandths, by `spirv-tests/tests/noise/warp.rs`:
///
/// | warped, map | point | footprint as it was | carried | 4 taps | 8 taps |
/// |---|---|---|---|---|---|
/// | four octaves of noise, terrain | 165 | 75 | 64 | 33 | 21 |
/// | stripes, terrain | 108 | 42 | 24 | 12 | 8 |
///
/// ```
/// use prefilter::{ColorMap, Driver, Noise, Scene, Warp};
/// let rock = ColorMap::gradient([(0.2, [0.2, 0.15, 0.1]), (0.8, [0.7, 0.65, 0.6])])?;
/// let warp = Warp { size: 2.0, deviation: 0.4, ..Warp::of(Driver::Noise(Noise::default())) };
/// let module = Scene::new("rock").texture(rock).driver(Driver::Warp(warp)).module()?;
/// assert_eq!(module.exports()[2].signature, "fn rock_color(position: vec2f, dpdx: vec2f, dpdy: vec2f) -> vec3f");
/// # Ok::<(), prefilter::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Warp {
    /// The driver at the displaced positions, a function of the plane; its taps and its pixel's filter are the whole's.
    pub driver: Box<Driver>,
    /// Size of the cells of the displacement's first octave, in units of the position, 1e-6 to 1e6.
    pub size: f32,
    /// Deviation of the displacement along either axis, in units of the position, 0 to 1e6.
    pub deviation: f32,
    /// Octaves of the displacement, 1 to 16.
    pub octaves: u32,
    /// Seeds have displacements of their own.
    pub seed: u32,
}

impl Warp {
    /// The driver displaced by two octaves of the size 1 with a deviation of 0.2.
    pub fn of(driver: Driver) -> Self {
        Self { driver: Box::new(driver), size: 1.0, deviation: 0.2, octaves: 2, seed: 0 }
    }

    /// Whether the description can be used.
    ///
    /// # Errors
    /// [`Error::Conflict`] for a driver that is no function of the plane, [`Error::Value`] and [`Error::Size`] for
    /// numbers outside their ranges, and what the driver refuses.
    pub(crate) fn check(&self) -> Result<(), Error> {
        self.driver.check()?;
        let refused = |what: &str| Err(Error::Conflict(format!("positions of {} {what}", self.driver.gives())));
        match self.driver.function(false).map(|function| function.dimensions) {
            None => return refused("are not displaced: warp a function of the position"),
            Some(Dimensions::Solid) => return refused("are not displaced: warp a function of the plane"),
            Some(Dimensions::Plane) => {}
        }
        if !(1..=16).contains(&self.octaves) {
            let (what, count) = ("the warp's number of octaves".into(), self.octaves as usize);
            return Err(Error::Size { what, count, allowed: "1 to 16".into() });
        }
        // Written so that NaN is refused.
        let numbers = [("size", self.size, 1e-6, 1e6), ("deviation", self.deviation, 0.0, 1e6)];
        match numbers.into_iter().find(|(_, value, low, high)| !(low..=high).contains(&value)) {
            Some((name, value, low, high)) => {
                Err(Error::value(format!("the warp's {name}"), value, format!("{low:e} to {high:e}")))
            }
            None => Ok(()),
        }
    }

    /// What it says of a footprint: what the driver says of the displaced one.
    pub(crate) fn function(&self) -> Option<Function> {
        let inner = self.driver.function(false)?;
        let trips = inner.trips.max(self.octaves as usize);
        let gap = format!(
            "how far displaced footprints are from normal ones of one turn and size, and of the driver that is\n    \
             displaced {}",
            inner.gap
        );
        let what = format!("{}, displaced by noise", inner.what);
        Some(Function { what, trips, gap, surface: false, body: self.body(&inner.body), ..inner })
    }

    /// That function, and `NAME_color`, which calls a filter with the statistics.
    pub(crate) fn glue(&self, called: &Called<'_>) -> String {
        match (self.function(), &*self.driver) {
            (None, _) => String::new(),
            (Some(function), Driver::Pattern(pattern)) => pattern.glue(called, &function),
            (Some(function), _) => function.glue(called),
        }
    }

    fn body(&self, inner: &str) -> String {
        let power: f64 = (0..self.octaves).map(|octave| 0.25f64.powi(octave as i32)).sum();
        // Of octaves, in cells: the size cancels in derivatives.
        let scale = (f64::from(self.deviation) / (power * VARIANCE).sqrt()) as f32;
        let (octaves, seed) = (self.octaves, self.seed.wrapping_mul(0x9e37_79b1));
        let (size, other) = (self.size, seed ^ 0x55_5555);
        let variance = VARIANCE as f32;
        let inner = inner.replace('\n', "\n    ");
        format!(
            "    // What displaces positions, by its two components, in cells of an octave.
    var cell_across = across / {size:?};
    var cell_along = along / {size:?};
    var cell = position / {size:?};
    let products = vec3f(dot(cell_across, cell_across), dot(cell_across, cell_along), dot(cell_along, cell_along));
    var cell_deviations = footprint_deviations(products);
    var x = fractal_sum(0.0, 0.0, vec2f());
    var y = x;
    var share = {scale:?};
    for (var octave = 0u; octave < {octaves}u; octave++) {{
        let weights = perlin_filter(cell_deviations);
        let n = perlin_noise(cell, vec2f(), {seed}u + octave);
        let m = perlin_noise(cell, vec2f(), {other}u + octave);
        x = fractal_add(x, share, weights, n.x, vec2f(dot(cell_across, n.yz), dot(cell_along, n.yz)));
        y = fractal_add(y, share, weights, m.x, vec2f(dot(cell_across, m.yz), dot(cell_along, m.yz)));
        share *= 0.5;
        cell_deviations *= 2.0;
        cell = 2.0 * cell + vec2f(0.618033989, 0.414213562); // no lattice point on one of the octave before
        cell_across *= 2.0;
        cell_along *= 2.0;
    }}
    let displaced = warp_vectors(across, along, x.slope, y.slope, {variance:?} * x.rest);
    let displaced_position = position + vec2f(x.mean, y.mean);
    {{
        let position = displaced_position;
        let across = displaced.xy;
        let along = displaced.zw;
    {}    }}
",
            inner.strip_suffix("    ").unwrap_or(&inner)
        )
    }
}

/// The variance of Perlin's noise, as on the shelf.
const VARIANCE: f64 = 0.0465311504;
