//! What the demo filters: a plane and blocks, each with a noise and a color map.

use super::lens::Lens;
use super::method::Method;
use super::Error;
use crate::imaging::pixel::PIXEL_DEVIATION;
use crate::maps;
use crate::random::Random;
use prefilter::{ColorMap, Driver, Gabor, GaborMethod, Noise, NoiseMethod, Spectrum, Taps};
use std::f64::consts::TAU;

/// What is seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ground {
    /// A plane to the horizon with six octaves of Perlin's noise.
    Plane,
    /// Blocks with solid noise, near and far.
    Blocks,
}

/// A ground with its color map.
#[derive(Clone, Debug)]
pub struct Input {
    /// A few letters, for files and tables.
    pub name: &'static str,
    /// What it is, for people.
    pub title: &'static str,
    /// What is seen.
    pub ground: Ground,
    /// The colors of the noise.
    pub map: ColorMap,
}

impl Input {
    /// All of them.
    ///
    /// # Errors
    /// Damaged data.
    pub fn all() -> Result<[Self; 3], Error> {
        Ok([Self::terrain()?, Self::steps()?, Self::blocks()?])
    }

    /// The plane under matplotlib's `terrain` colors.
    ///
    /// # Errors
    /// Damaged data.
    pub fn terrain() -> Result<Self, Error> {
        let title = "a plane of Perlin's noise, six octaves, under a terrain map";
        Ok(Self { name: "terrain", title, ground: Ground::Plane, map: named("terrain")? })
    }

    /// The plane in six steps with hard edges.
    ///
    /// # Errors
    /// Damaged data.
    pub fn steps() -> Result<Self, Error> {
        let title = "a plane of Perlin's noise, six octaves, in six steps";
        Ok(Self { name: "steps6", title, ground: Ground::Plane, map: named("steps6")? })
    }

    /// Blocks of green stone with light veins, whose edges are hard.
    ///
    /// # Errors
    /// None.
    pub fn blocks() -> Result<Self, Error> {
        let map = ColorMap::gradient([
            (0.20, [0.010, 0.035, 0.030]),
            (0.42, [0.030, 0.180, 0.130]),
            (0.47, [0.120, 0.420, 0.280]),
            (0.47, [0.900, 0.720, 0.330]),
            (0.53, [0.960, 0.850, 0.550]),
            (0.53, [0.080, 0.330, 0.230]),
            (0.80, [0.450, 0.680, 0.480]),
        ])?;
        let title = "blocks of one stone, 10, 50 and 250 units away and as many times as large";
        Ok(Self { name: "blocks", title, ground: Ground::Blocks, map })
    }

    /// A picture of it with so many pixels; `plane_scene` of `colormaps.json` where they are 48 × 36.
    pub fn lens(&self, [width, height]: [usize; 2]) -> Lens {
        let first_row = match self.ground {
            Ground::Plane => 2.5,
            Ground::Blocks => -0.5 * (height as f64 - 1.0),
        };
        Lens { width, height, first_row, focal: 1.25 * width as f64, pan: [0.0; 2] }
    }

    /// Units of the noise a unit of the world: pixels, on a plane those of the lowest row, cover as much noise in
    /// pictures of all sizes.
    pub fn density(&self, lens: &Lens) -> f64 {
        match self.ground {
            Ground::Plane => (lens.first_row + lens.height as f64 - 1.0) / 37.5,
            Ground::Blocks => lens.width as f64 / 216.0,
        }
    }

    /// Where the eye is in the noise; seeds look at other parts of it.
    pub fn origin(&self, seed: u32) -> [f64; 3] {
        let mut random = Random::new(seed);
        [0; 3].map(|_| 100.0 * random.unit() - 50.0)
    }

    /// Whether there is such a method for it.
    pub fn has(&self, method: Method) -> bool {
        method != Method::Curvature || self.ground == Ground::Plane
    }

    /// The methods that there are for it, in the order of the tables.
    pub fn methods(&self) -> impl Iterator<Item = Method> + '_ {
        Method::ALL.into_iter().filter(|&method| self.has(method))
    }

    /// The driver of the noise, which filters it by a method.
    pub fn driver(&self, method: Method) -> Driver {
        let taps = if let Method::Ours(taps) = method { taps } else { Taps::One };
        match self.ground {
            Ground::Plane => Driver::Noise(Noise {
                method: match method {
                    Method::Paper => NoiseMethod::Stationary,
                    Method::Curvature => NoiseMethod::Curvature,
                    _ => NoiseMethod::Gradient,
                },
                taps,
                ..Noise::default()
            }),
            Ground::Blocks => Driver::Gabor(Gabor {
                spectrum: Spectrum::Isotropic { frequency: FREQUENCY },
                bandwidth: 1.2,
                method: if method == Method::Paper { GaborMethod::Paper } else { GaborMethod::Exact },
                taps,
                ..Gabor::default()
            }),
        }
    }

    /// The text before every kernel: what a ray sees, the noise by its definition and the map.
    pub fn world(&self) -> String {
        let (ground, noise) = match self.ground {
            Ground::Plane => (include_str!("plane.wgsl"), include_str!("fbm.wgsl")),
            Ground::Blocks => (include_str!("blocks.wgsl"), include_str!("gabor.wgsl")),
        };
        [include_str!("shot.wgsl"), ground, noise, include_str!("map.wgsl")].concat()
    }

    /// The share of the noise's variance that a pixel loses whose longer side has a length, as if every octave were one
    /// wave along it.
    pub fn lost(&self, length: f64) -> f64 {
        let deviation = PIXEL_DEVIATION * length;
        let retained = |frequency: f64| (-(TAU * frequency * deviation).powi(2)).exp();
        match self.ground {
            Ground::Plane => {
                // Gradients of an octave have 8.38395 times its variance along either axis.
                let octaves = (0..6).map(|octave| (0.25f64.powi(octave), PERLIN * 2f64.powi(octave)));
                let total: f64 = octaves.clone().map(|(share, _)| share).sum();
                octaves.map(|(share, frequency)| share * (1.0 - retained(frequency))).sum::<f64>() / total
            }
            Ground::Blocks => 1.0 - retained(f64::from(FREQUENCY)),
        }
    }
}

/// Waves of the blocks a unit.
const FREQUENCY: f32 = 1.6;

/// Waves of an octave a cell, by the variance of its gradient: √8.38395/τ.
const PERLIN: f64 = 0.460836;

fn named(name: &str) -> Result<ColorMap, Error> {
    maps::named(name).map_err(|error| Error::Map(error.to_string()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pixels_lose_more_the_longer_they_are() -> Result<(), Error> {
        for input in Input::all()? {
            let lost = [0.0, 0.01, 0.1, 0.3, 1.0, 30.0].map(|length| input.lost(length));
            assert!(lost.windows(2).all(|pair| pair[0] <= pair[1]), "{}: {lost:?}", input.name);
            assert!(lost[0] == 0.0 && lost[5] > 0.999 && lost[5] <= 1.0, "{}: {lost:?}", input.name);
        }
        Ok(())
    }

    #[test]
    fn the_plane_is_that_of_the_data() -> Result<(), Error> {
        let input = Input::terrain()?;
        let lens = input.lens([48, 36]);
        assert_eq!((lens.corner(), lens.focal, input.density(&lens)), ([-23.5, 2.5], 60.0, 1.0));
        Ok(())
    }
}
