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
use std::cell::OnceCell;

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
    /// Made when rays are shot at it.
    relief: OnceCell<Relief>,
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
    /// Generates and compiles some methods.
    ///
    /// # Errors
    /// Those of scenes and of the device.
    pub fn new(device: &Device, material: Material, methods: &[Method]) -> Result<Self, Error> {
        let displacement = Displacement::new(device, &module(&material, TransferTier::Paper)?)?;
        let renderers = methods.iter().map(|&method| Renderer::new(device, &material, method));
        let renderers = renderers.collect::<Result<Vec<_>, Error>>()?;
        let map = material.map.reference();
        Ok(Self { material, map, displacement, renderers, pixel: Pixel::default() })
    }

    /// The methods.
    pub fn renderers(&self) -> &[Renderer] {
        &self.renderers
    }

    /// How many methods there are.
    pub fn methods(&self) -> usize {
        self.renderers.len()
    }

    /// The surface over the noise of a seed.
    pub fn noise(&self, seed: u32) -> Noise<'_> {
        Noise { studio: self, waves: scene::waves(seed), relief: OnceCell::new() }
    }
}

impl Noise<'_> {
    /// Looks at a view. `done` is told how many rays have been shot, from several threads.
    ///
    /// # Errors
    /// Those of the device.
    pub fn look(&self, view: &View, seed: u64, done: &(dyn Fn(u64) + Sync)) -> Result<Seen, Error> {
        let halves = self.scenery().halves(view, seed, done);
        let known = self.known(view);
        Ok(Seen { truth: Scenery::mean(&halves), shown: self.shown(&known)?, known, halves })
    }

    /// What the truth shoots rays at.
    pub fn scenery(&self) -> Scenery<'_> {
        let Studio { map, pixel, material, .. } = self.studio;
        let relief = self.relief.get_or_init(|| scene::relief(&self.waves, &material.curve));
        Scenery { log: LOG, relief, range: self.range(), map, sun: scene::sun(), pixel }
    }

    /// What is known of every pixel of a view.
    pub fn known(&self, view: &View) -> Vec<[Option<Known>; ALL_TAPS]> {
        let (displacement, range, face) = (&self.studio.displacement, self.range(), self.face());
        let displaced = Displaced { log: LOG, waves: &self.waves, displacement, range, face, sun: scene::sun() };
        displaced.picture(view)
    }

    /// What each method shows of that.
    ///
    /// # Errors
    /// Those of the device.
    pub fn shown(&self, known: &[[Option<Known>; ALL_TAPS]]) -> Result<Vec<Vec<Look>>, Error> {
        self.studio.renderers.iter().map(|renderer| renderer.shown(known)).collect()
    }

    /// The lowest and the highest height.
    fn range(&self) -> [f64; 2] {
        let (low, high) = self.studio.material.curve.range(f64::NEG_INFINITY, f64::INFINITY);
        [low, high]
    }

    /// How wide faces are: as it takes a slope's deviation to rise by that of f.
    fn face(&self) -> f64 {
        1.0 / self.waves.slope_variance().sqrt()
    }
}
