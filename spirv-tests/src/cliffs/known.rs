//! What filters know of a pixel: a few rays to the filtered ground, and the statistics of what the filter lost there.
//!
//! The geometry that an engine would displace is the ground as filtered over a pixel's footprint. Its silhouettes are
//! smoothed by several taps a pixel, whose colors are averaged. All of it is the same for every method.

use super::ground::{Ground, SPACING};
use super::Error;
use crate::imaging::taps::{places, ALL_TAPS, TAP_DEVIATION};
use crate::imaging::view::View;
use prefilter::gpu::{Device, Kernel, Texture, Work};

/// What is known of a tap.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Known {
    /// Mean of the heights over the footprint.
    pub mean: f32,
    /// Their deviation.
    pub deviation: f32,
    /// Mean of the slopes.
    pub slope: [f32; 2],
    /// Their covariance.
    pub covariance: [f32; 3],
    /// A unit vector to the eye.
    pub view: [f32; 3],
}

/// Rays on the device.
#[derive(Clone, Debug)]
pub struct Tracer {
    kernel: Kernel,
    textures: [Texture; 3],
    ground: [f32; 4],
    top: f64,
}

impl Tracer {
    /// Compiles the kernel and uploads the ground's pyramids.
    ///
    /// # Errors
    /// Those of the device.
    pub fn new(device: &Device, ground: &Ground) -> Result<Self, Error> {
        let shader = prefilter::link(&[], include_str!("known.wgsl"))?;
        let (deviation, [xx, yy]) = ground.whole()?;
        // Faces are as wide as it takes a slope's deviation to rise by the heights'.
        let face = deviation / (0.5 * (xx + yy)).sqrt();
        let numbers = [SPACING[0], SPACING[1], face, TAP_DEVIATION];
        Ok(Self {
            kernel: Kernel::new(device, shader.wgsl(), "main")?,
            textures: ground.textures(device)?,
            ground: numbers.map(|number| number as f32),
            top: ground.relief().top(),
        })
    }

    /// What is known of every pixel of a view from over a place, tap by tap.
    ///
    /// # Errors
    /// Those of the device.
    pub fn picture(&self, view: &View, place: [f64; 2]) -> Result<Vec<Known>, Error> {
        let taps = |pixel: usize| (0..ALL_TAPS).map(move |tap| (pixel, tap));
        let taps: Vec<(usize, usize)> = (0..view.width * view.height).flat_map(taps).collect();
        let rays: Vec<([f32; 8], [f32; 3])> =
            taps.iter().map(|&(pixel, tap)| self.ray(view, place, pixel, tap)).collect();
        let numbers: Vec<f32> = rays.iter().flat_map(|(ray, _)| *ray).collect();
        let textures: Vec<&Texture> = self.textures.iter().collect();
        let work = Work {
            inputs: &[&numbers, &self.ground],
            textures: &textures,
            invocations: taps.len(),
            output: 8 * taps.len(),
        };
        let found = self.kernel.run(&work)?;
        let known = found.chunks_exact(8).zip(&rays).map(|(found, &(_, view))| Known {
            mean: found[0],
            deviation: found[1],
            slope: [found[2], found[3]],
            covariance: [found[4], found[5], found[6]],
            view,
        });
        Ok(known.collect())
    }

    /// The numbers of a tap's ray, and the unit vector to the eye.
    fn ray(&self, view: &View, place: [f64; 2], pixel: usize, tap: usize) -> ([f32; 8], [f32; 3]) {
        let ray = view.ray(places(view.middle(pixel % view.width, pixel / view.width))[tap]);
        let start = ray.crossing(self.top);
        let [x, y, z] = ray.at(start);
        let back = ray.back();
        let length = ray.way.iter().map(|part| part * part).sum::<f64>().sqrt();
        let width = ray.width(start);
        let growth = ray.width(start + 1.0 / length) - width;
        let numbers = [x + place[0], y + place[1], z, -back[0], -back[1], -back[2], width, growth];
        (numbers.map(|number| number as f32), back.map(|part| part as f32))
    }
}
