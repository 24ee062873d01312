//! A surface with all that looks at it.

use super::displacement::Displacement;
use super::known::{Displaced, Known};
use super::method::{module, Method, Renderer};
use super::scene::{self, Material, LOG};
use super::truth::Scenery;
use super::Error;
use crate::imaging::camera::View;
use crate::imaging::look::Look;
use crate::imaging::pixel::Pixel;
use crate::imaging::relief::Relief;
use crate::imaging::taps::ALL_TAPS;
use crate::imaging::waves::Waves;
use prefilter::gpu::Device;
use prefilter::reference::texture::PiecewiseLinear;
use prefilter::TransferTier;

/// A surface, and the methods that color it.
#[derive(Clone, Debug)]
pub struct Studio {
    /// The surface.
    pub material: Material,
    map: PiecewiseLinear,
    displacement: Displacement,
    renderers: Vec<Renderer>,
    pixel: Pixel,
}

/// The surface over one noise.
#[derive(Clone, Debug)]
pub struct Noise<'a> {
    /// The surface over any noise.
    pub studio: &'a Studio,
    waves: Waves,
    relief: Relief,
}

/// What is seen of a view.
#[derive(Clone, Debug)]
pub struct Seen {
    /// What is known of each pixel's taps.
    pub known: Vec<[Option<Known>; ALL_TAPS]>,
    /// Both halves of the truth.
    pub halves: [Vec<Look>; 2],
    /// Their mean.
    pub truth: Vec<Look>,
    /// What each method shows, in the order of [`Method::ALL`].
    pub shown: Vec<Vec<Look>>,
}

impl Studio {
    /// Generates and compiles all methods.
    ///
    /// # Errors
    /// Those of scenes and of the device.
    pub fn new(device: &Device, material: Material) -> Result<Self, Error> {
        let displacement = Displacement::new(device, &module(&material, TransferTier::Paper)?)?;
        let renderers = Method::ALL.map(|method| Renderer::new(device, &material, method));
        let renderers = renderers.into_iter().collect::<Result<Vec<_>, Error>>()?;
        let map = material.map.reference();
        Ok(Self { material, map, displacement, renderers, pixel: Pixel::default() })
    }

    /// How many methods there are.
    pub fn methods(&self) -> usize {
        self.renderers.len()
    }

    /// The surface over the noise of a seed.
    pub fn noise(&self, seed: u32) -> Noise<'_> {
        let waves = scene::waves(seed);
        let relief = scene::relief(&waves, &self.material.curve);
        Noise { studio: self, waves, relief }
    }
}

impl Noise<'_> {
    /// Looks at a view. `done` is told how many rays have been shot, from several threads.
    ///
    /// # Errors
    /// Those of the device.
    pub fn look(&self, view: &View, seed: u64, done: &(dyn Fn(u64) + Sync)) -> Result<Seen, Error> {
        let Studio { material, map, displacement, renderers, pixel } = self.studio;
        let (low, high) = material.curve.range(f64::NEG_INFINITY, f64::INFINITY);
        let (range, sun, log) = ([low, high], scene::sun(), LOG);
        let scenery = Scenery { log, relief: &self.relief, range, map, sun, pixel };
        let halves = scenery.halves(view, seed, done);
        let face = self.face();
        let displaced = Displaced { log, waves: &self.waves, displacement, range, face, sun };
        let known = displaced.picture(view);
        let shown = renderers.iter().map(|renderer| renderer.shown(&known)).collect::<Result<_, Error>>()?;
        Ok(Seen { truth: Scenery::mean(&halves), known, halves, shown })
    }

    /// How wide faces are: as it takes a slope's deviation to rise by that of f.
    fn face(&self) -> f64 {
        1.0 / self.waves.slope_variance().sqrt()
    }
}
