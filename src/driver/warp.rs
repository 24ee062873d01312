//! Drivers whose positions a noise displaces.

use super::function::{Dimensions, Function};
use super::noise::{Noise, NoiseBasis, Shelf};
use super::octaves::{apart, OFFSET};
use super::{Called, Driver};
use crate::Error;

/// A driver of the plane whose positions noise displaces, f(p + g(p)): veins of marble from stripes, torn noise.
///
/// The footprint is carried along: by the derivatives of g where a footprint resolves its octaves, which turns,
/// stretches and squeezes it, and by the variance of those that it has lost, which widens it. Both components of g are
/// Perlin's noise of a gain of ½ and a lacunarity of 2.
///
/// What a footprint is displaced to is taken for normal, and to have one turn and size. Slopes are not known of it,
/// even of displaced [`Cosines`](crate::Cosines). Root mean square errors of the
/// largest channel on a plane to the horizon, in thousandths, by `spirv-tests/tests/noise/warp.rs`:
///
/// | warped, map | point | footprint as it was | carried | 4 taps | 8 taps |
/// |---|---|---|---|---|---|
/// | four octaves of noise, terrain | 171 | 74 | 62 | 32 | 22 |
/// | stripes, terrain | 108 | 45 | 24 | 13 | 8 |
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
        if let Driver::Noise(Noise { period: 1.., .. }) = *self.driver {
            return refused("do not repeat where they are displaced: give the noise a `period` of 0");
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
            "how far displaced footprints are from normal ones of one turn and size. Stripes of the width 0.3,\n    \
             displaced by 0.4, have an RMS of 0.024 by one tap, where a point has 0.108. Of the driver itself\n    \
             {}",
            inner.gap
        );
        let what = format!("{}, displaced by noise", inner.what);
        Some(Function { what, trips, gap, surface: false, body: self.body(&inner.body), ..inner })
    }

    /// That function, and `NAME_color`, which calls a filter with the statistics.
    pub(crate) fn glue(&self, called: &Called<'_>) -> String {
        match (self.function(), self.driver.pattern()) {
            (None, _) => String::new(),
            (Some(function), Some(pattern)) => pattern.glue(called, &function),
            (Some(function), None) => function.glue(called),
        }
    }

    /// How many warps are within.
    fn depth(&self) -> u32 {
        match &*self.driver {
            Driver::Warp(within) => 1 + within.depth(),
            _ => 0,
        }
    }

    fn body(&self, inner: &str) -> String {
        let power: f64 = (0..self.octaves).map(|octave| 0.25f64.powi(octave as i32)).sum();
        let Shelf { variance, .. } = NoiseBasis::Perlin.shelf();
        // Of octaves, in cells: the size cancels in derivatives.
        let scale = (f64::from(self.deviation) / (power * variance).sqrt()) as f32;
        // Seeds of neither component, nor of a warp within, are those of a noise.
        let own = apart(self.seed).wrapping_add(self.depth().wrapping_mul(0xc2b2_ae35));
        let (octaves, size, seed, other) = (self.octaves, self.size, own ^ 0x27d4_eb2f, own ^ 0x1656_67b1);
        let inner = inner.replace('\n', "\n    ");
        format!(
            "    // What displaces positions, by its two components, in cells of an octave.
    var warp_across = across / {size:?};
    var warp_along = along / {size:?};
    var warp_at = clamp(position / {size:?}, vec2f(-1e9), vec2f(1e9));
    var warp_deviations = fractal_deviations(warp_across, warp_along);
    var warp_x = fractal_sum(0.0, 0.0, vec2f());
    var warp_y = warp_x;
    var warp_share = {scale:?};
    for (var octave = 0u; octave < {octaves}u; octave++) {{
        let weights = perlin_filter(warp_deviations);
        let n = perlin_noise(warp_at, vec2f(), {seed}u + octave);
        let m = perlin_noise(warp_at, vec2f(), {other}u + octave);
        let slope_x = vec2f(dot(warp_across, n.yz), dot(warp_along, n.yz));
        let slope_y = vec2f(dot(warp_across, m.yz), dot(warp_along, m.yz));
        warp_x = fractal_add(warp_x, warp_share, weights, n.x, slope_x);
        warp_y = fractal_add(warp_y, warp_share, weights, m.x, slope_y);
        warp_share *= 0.5;
        warp_deviations *= 2.0;
        warp_at = 2.0 * warp_at + {OFFSET};
        warp_across *= 2.0;
        warp_along *= 2.0;
    }}
    let warp_footprint = warp_vectors(across, along, warp_x.slope, warp_y.slope, {variance:?} * warp_x.rest);
    let warp_position = position + vec2f(warp_x.mean, warp_y.mean);
    {{
        let position = warp_position;
        let across = warp_footprint.xy;
        let along = warp_footprint.zw;
    {}    }}
",
            inner.strip_suffix("    ").unwrap_or(&inner)
        )
    }
}
