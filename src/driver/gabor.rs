//! Solid random-phase Gabor noise.

use super::function::{Dimensions, Function};
use super::gabor_spectrum::{Polar, Spectrum, NODES};
use super::taps::{Pixel, Taps};
use crate::Error;

/// Solid random-phase Gabor noise: waves under Gaussians at random places in space, filtered over the footprint of a
/// pixel on whatever surface cuts the solid. Neither a normal nor a tangent frame is involved: where two faces meet at
/// a sharp edge the noise is the same on both.
///
/// The noise has the given mean and deviation over all places. What a footprint hides of its variance is known in
/// closed form, and told apart from place to place by the gradient of the filtered noise.
///
/// ```
/// use prefilter::{ColorMap, Driver, Gabor, Scene, Spectrum};
/// let map = ColorMap::gradient([(0.2, [0.3, 0.2, 0.1]), (0.8, [0.8, 0.7, 0.5])])?;
/// let grains = Gabor { spectrum: Spectrum::Isotropic { frequency: 3.0 }, bandwidth: 2.0, ..Gabor::default() };
/// let module = Scene::new("granite").texture(map).driver(Driver::Gabor(grains)).module()?;
/// let color = module.exports().iter().find(|export| export.name == "granite_color");
/// let signature = "fn granite_color(position: vec3f, dpdx: vec3f, dpdy: vec3f) -> vec3f";
/// assert!(color.is_some_and(|color| color.signature == signature));
/// # Ok::<(), prefilter::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Gabor {
    /// The frequencies of the waves.
    pub spectrum: Spectrum,
    /// The bandwidth a of a kernel exp(−π a² r²) cos(2π ω·r + φ), 1e-6 to 1e6 a unit of the position: about the width
    /// of the spectrum. Kernels reach 1.2/a.
    pub bandwidth: f32,
    /// Kernels in each cell of side 0.8/a, 1 to 16: more make the noise more alike everywhere, and cost in proportion.
    pub kernels: u32,
    /// Noise of another seed is independent.
    pub seed: u32,
    /// The mean, up to 1e15 either way.
    pub mean: f32,
    /// The deviation, 0 to 1e15.
    pub deviation: f32,
    /// How it is filtered.
    pub method: GaborMethod,
    /// Evaluations of the color a pixel.
    pub taps: Taps,
    /// The filter that turns samples into a pixel.
    pub pixel: Pixel,
}

/// How Gabor noise is filtered.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum GaborMethod {
    /// Every kernel by its integral over the footprint, and the variance by the gradient, too.
    #[default]
    Exact,
    /// Envelopes that stay round, and the variance that is lost on average: Lagae and Drettakis 2011, "Filtering Solid
    /// Gabor Noise". Kept to compare: it is neither nearer nor faster.
    Paper,
}

impl Default for Gabor {
    /// Isotropic noise of frequency and bandwidth 1 about 0.5, two kernels a cell, by one tap.
    fn default() -> Self {
        Self {
            spectrum: Spectrum::Isotropic { frequency: 1.0 },
            bandwidth: 1.0,
            kernels: 2,
            seed: 0,
            mean: 0.5,
            deviation: 0.18,
            method: GaborMethod::Exact,
            taps: Taps::One,
            pixel: Pixel::default(),
        }
    }
}

/// The bandwidth in cells, as on the shelf: a cell's side is so many of 1/a.
const SIDE: f64 = 0.8;

impl Gabor {
    /// Whether the description can be used.
    ///
    /// # Errors
    /// [`Error::Value`] or [`Error::Size`] for a number outside its range.
    pub(crate) fn check(&self) -> Result<(), Error> {
        self.pixel.check()?;
        let within = |what: &str, value: f32, range: std::ops::RangeInclusive<f32>| {
            // Written so that NaN is refused.
            if range.contains(&value) {
                return Ok(());
            }
            let allowed = format!("{:e} to {:e}", range.start(), range.end());
            Err(Error::value(format!("the noise's {what}"), value, allowed))
        };
        within("bandwidth", self.bandwidth, 1e-6..=1e6)?;
        within("mean", self.mean, -1e15..=1e15)?;
        within("deviation", self.deviation, 0.0..=1e15)?;
        if !(1..=16).contains(&self.kernels) {
            let (what, allowed) = ("the noise's number of kernels a cell".into(), "1 to 16".into());
            return Err(Error::Size { what, count: self.kernels as usize, allowed });
        }
        self.spectrum.check(self.bandwidth)
    }

    /// Turns of the loops on the shelf.
    pub(crate) fn trips(&self) -> Vec<(&'static str, usize)> {
        let kernels = self.kernels as usize;
        vec![("gabor_noise", 64), ("gabor_cell", kernels), ("gabor_paper_noise", 64), ("gabor_paper_cell", kernels)]
    }

    /// What it says of a footprint.
    pub(crate) fn function(&self) -> Function {
        let polar = self.spectrum.polar(SIDE / f64::from(self.bandwidth));
        let body = format!(
            "    // In cells, whose side is {SIDE} of one over the bandwidth.
    let scale = {:?};
    let footprint = gabor_covered(across * scale, along * scale);
    let spectrum = gabor_spectrum_of({}, {}, {});
{}{}",
            (f64::from(self.bandwidth) / SIDE) as f32,
            pair(polar.frequency),
            pair(polar.azimuth),
            pair(polar.height),
            self.retained(&polar),
            self.moments(),
        );
        Function {
            what: "solid Gabor noise".to_owned(),
            dimensions: Dimensions::Solid,
            body,
            surface: false,
            trips: NODES,
            taps: self.taps,
            pixel: self.pixel,
            gap: gap(self.method, self.taps),
        }
    }

    /// Statements that find what is left of the variance.
    fn retained(&self, polar: &Polar) -> String {
        let numbers = |numbers: &[f64]| {
            let numbers: Vec<String> = numbers.iter().map(|&number| format!("{:?}", number as f32)).collect();
            format!("vec{}f({})", numbers.len(), numbers.join(", "))
        };
        let nodes = polar.nodes();
        match (self.spectrum, nodes.as_slice()) {
            (Spectrum::Isotropic { .. }, _) => {
                let length = polar.frequency[0] as f32;
                format!("    let retained = gabor_spectrum_retained_evenly({length:?}, footprint);\n")
            }
            (_, [(frequency, _)]) => {
                let frequency = numbers(frequency);
                format!("    let retained = gabor_spectrum_retained({frequency}, footprint);\n")
            }
            _ => {
                let node = |([x, y, z], weight): &([f64; 3], f64)| numbers(&[*x, *y, *z, *weight]);
                let listed = nodes.iter().map(node).collect::<Vec<_>>().join(",\n        ");
                format!(
                    "    // Frequencies that stand for the ranges, with their weights.
    var frequencies = array<vec4f, {0}>(
        {listed},
    );
    var retained = vec2f();
    for (var node = 0u; node < {0}u; node++) {{
        retained += frequencies[node].w * gabor_spectrum_retained(frequencies[node].xyz, footprint);
    }}
",
                    nodes.len()
                )
            }
        }
    }

    /// Statements that return the moments.
    fn moments(&self) -> String {
        let Self { kernels, seed, mean, deviation, .. } = self;
        let variance = deviation * deviation;
        match self.method {
            GaborMethod::Exact => format!(
                "    let noise = gabor_noise(position * scale, {kernels}u, {seed}u, spectrum, footprint);
    let variance = {variance:?} * gabor_spectrum_variance(retained, noise.yz);
    return vec4f({mean:?} + {deviation:?} * noise.x, variance, 0.0, 0.0);
"
            ),
            GaborMethod::Paper => format!(
                "    let noise = gabor_paper_noise(position * scale, {kernels}u, {seed}u, spectrum, footprint);
    return vec4f({mean:?} + {deviation:?} * noise, {variance:?} * (1.0 - retained.x), 0.0, 0.0);
"
            ),
        }
    }
}

/// Two numbers in WGSL.
fn pair([start, extent]: [f64; 2]) -> String {
    format!("vec2f({:?}, {:?})", start as f32, extent as f32)
}

/// What no bound of a filter covers; `spirv-tests/tests/gabor/plane.rs` measures it.
fn gap(method: GaborMethod, taps: Taps) -> String {
    let (terrain, steps) = match (method, taps) {
        (GaborMethod::Paper, Taps::One) => (0.061, 0.086),
        (GaborMethod::Exact, Taps::One) => (0.042, 0.058),
        (GaborMethod::Exact, Taps::Two) => (0.032, 0.042),
        (GaborMethod::Exact, Taps::Four) => (0.021, 0.027),
        (GaborMethod::Exact, Taps::Eight) => (0.015, 0.019),
        (GaborMethod::Paper, _) => return NORMAL.to_owned(),
    };
    let (naive_terrain, naive_steps) = NAIVE;
    format!(
        "{NORMAL}: on a plane\n    to the horizon an RMS of {terrain:.3} on a terrain and {steps:.3} with hard edges; \
         the naive map has\n    {naive_terrain:.2} and {naive_steps:.2}"
    )
}

/// What the gap is.
const NORMAL: &str = "how far footprints are from normal distributions of their mean and variance";

/// The gap of a map at the noise of the pixel's center, on a terrain and with hard edges.
const NAIVE: (f64, f64) = (0.19, 0.24);
