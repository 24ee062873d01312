//! What is looked at: moss and a sponge on a log, from where, and in what light.

use super::log::Log;
use crate::imaging::camera::View;
use crate::imaging::relief::Relief;
use crate::imaging::vector::{difference, length, scaled, sum, unit, Vector};
use crate::imaging::waves::{Spread, Waves};
use prefilter::{ColorMap, Error, HeightTransfer};
use std::f64::consts::TAU;

/// Lengths are in wavelengths of the middle of the waves, and so are heights: those of both surfaces are up to this.
pub const HEIGHT: f32 = 0.25;

/// After how much ground the waves repeat.
const PERIOD: f64 = 32.0;

/// Periods around the log.
const AROUND: f64 = 12.0;

/// Waves from 0.74 to 1.33 long, of equal amplitudes; as many as a driver of cosines takes, for values near normal.
const SPREAD: Spread = Spread { count: 64, periods: [24.0, 43.0], falling: 0.0 };

/// Means of f that tables reach: one in 400 places is beyond, where both curves are level.
const MEANS: (f32, f32) = (-3.0, 3.0);

/// Nodes a side of a period of the relief: 64 a wavelength.
const NODES: usize = 2048;

/// The log.
pub const LOG: Log = Log { radius: PERIOD * AROUND / TAU };

/// A surface: the curve g that makes heights of noise, and their colors.
#[derive(Clone, Debug)]
pub struct Material {
    /// One word, for tables.
    pub name: &'static str,
    /// The curve.
    pub curve: HeightTransfer,
    /// Colors by height.
    pub map: ColorMap,
}

/// Moss, cushions on dark ground, and a sponge, a level with dark pores.
///
/// # Errors
/// None: they are fixed.
pub fn materials() -> Result<[Material; 2], Error> {
    let moss = ColorMap::gradient([
        (0.000, [0.045, 0.026, 0.014]),
        (0.030, [0.070, 0.042, 0.020]),
        (0.030, [0.030, 0.075, 0.014]),
        (0.150, [0.120, 0.230, 0.030]),
        (0.200, [0.300, 0.420, 0.070]),
        (0.200, [0.560, 0.620, 0.200]),
        (0.250, [0.760, 0.780, 0.360]),
    ])?;
    let sponge = ColorMap::gradient([
        (0.000, [0.050, 0.012, 0.010]),
        (0.110, [0.190, 0.060, 0.020]),
        (0.190, [0.520, 0.280, 0.060]),
        (0.190, [0.800, 0.550, 0.160]),
        (0.250, [0.900, 0.700, 0.300]),
    ])?;
    let cushions = HeightTransfer::smoothstep(0.0, 1.2)?.scaled(HEIGHT, 0.0)?;
    let pores = HeightTransfer::smoothstep(0.3, 1.2)?.scaled(-HEIGHT, HEIGHT)?;
    Ok([
        Material { name: "moss", curve: cushions.over(MEANS, 1.0), map: moss },
        Material { name: "sponge", curve: pores.over(MEANS, 1.0), map: sponge },
    ])
}

/// The noise of a seed, of variance 1.
pub fn waves(seed: u32) -> Waves {
    Waves::new(SPREAD, PERIOD, seed)
}

/// All heights that a curve makes of noise.
pub fn relief(waves: &Waves, curve: &HeightTransfer) -> Relief {
    waves.relief(NODES, |value| curve.height(value))
}

/// A unit vector toward the sun: above the viewer, on the right.
pub fn sun() -> Vector {
    unit([0.45, -0.35, 0.75])
}

/// Part of the picture above the silhouette, by angles.
const SKY: f64 = 0.06;

/// The log near, where pixels lose some of the waves, and far away, of a size and with strata an axis of each half of
/// the truth.
pub fn views([width, height]: [usize; 2], strata: [usize; 3]) -> [View; 3] {
    let view = |name, title, above: f64, enlarged: usize, strata| {
        let eye = [0.0, -LOG.radius - above, 0.0];
        // From straight down on the log to above its silhouette.
        let half = 0.5 * (1.0 + SKY) * (LOG.radius / -eye[1]).asin();
        let target = sum(eye, [0.0, half.cos(), half.sin()]);
        let (width, height) = (width / enlarged, height / enlarged);
        let focal = 0.5 * height as f64 / half.tan();
        View { name, title, eye, target, focal, width, height, enlarged, strata, pan: [0.0; 2] }
    };
    [
        view("near", "near", 8.0, 1, strata[0]),
        view("middle", "where pixels lose the waves", 3.0 * LOG.radius, 1, strata[1]),
        view("far", "far away, 3 times enlarged", 11.0 * LOG.radius, 3, strata[2]),
    ]
}

/// Pixels that an object is wide in a zoom which is as wide as it is far.
const FOCAL: f64 = 200.0;

/// Wavelengths that a pixel in the middle of a frame is wide.
pub fn pixel(frame: &View) -> f64 {
    length(difference(frame.eye, frame.target)) / frame.focal
}

/// Frames of a camera that moves straight away from a place of the log, which it sees at 50 degrees from its normal:
/// pixels in the middle are from 0.15 to 2 wavelengths wide.
pub fn frames([width, height]: [usize; 2], strata: usize, count: usize) -> Vec<View> {
    const PIXELS: [f64; 2] = [0.15, 2.0];
    let target = LOG.point([0.0, LOG.radius * 50f64.to_radians(), 0.0]);
    let frame = |number: usize| {
        let pixel = PIXELS[0] * (PIXELS[1] / PIXELS[0]).powf(number as f64 / (count - 1) as f64);
        let eye = sum(target, scaled([0.0, -1.0, 0.0], FOCAL * pixel));
        View {
            name: "zoom",
            title: "zoom",
            eye,
            target,
            focal: FOCAL,
            width,
            height,
            enlarged: 1,
            strata,
            pan: [0.0; 2],
        }
    };
    (0..count).map(frame).collect()
}
