//! What a pixel should be, by rays to the whole ground: no footprint, pyramid or filter is involved.

use super::scene::{Palette, LIGHTS};
use crate::imaging::picture::Picture;
use crate::imaging::pixel::{fill, Pixel};
use crate::imaging::relief::Relief;
use crate::imaging::view::View;
use prefilter::Irradiance;
use std::f64::consts::PI;

/// The ground as it is.
#[derive(Clone, Debug)]
pub struct Scenery {
    /// Its heights.
    pub relief: Relief,
    /// Its colors.
    pub palette: Palette,
    /// Its lights.
    pub skies: [Irradiance; LIGHTS.len()],
    /// How pixels are sampled.
    pub pixel: Pixel,
}

impl Scenery {
    /// Pictures under each sky by `strata`² rays a pixel from a camera over a place. `done` is called after every row,
    /// from several threads.
    pub fn pictures(
        &self,
        view: &View,
        place: [f64; 2],
        strata: usize,
        seed: u64,
        done: &(dyn Fn() + Sync),
    ) -> [Picture; LIGHTS.len()] {
        let mut pixels = vec![[[f32::NAN; 3]; LIGHTS.len()]; view.width * view.height];
        let look = |column: usize, row: usize| {
            let middle = view.middle(column, row);
            let samples = self.pixel.samples(strata, seed, (row * view.width + column) as u64);
            let mut sums = [[0.0; 3]; LIGHTS.len()];
            for [right, down] in samples {
                let light = self.light(view, place, [middle[0] + right, middle[1] + down]);
                for (total, channel) in sums.as_flattened_mut().iter_mut().zip(light.as_flattened()) {
                    *total += channel;
                }
            }
            sums.map(|sum| sum.map(|total| (total / (strata * strata) as f64) as f32))
        };
        fill(&mut pixels, view.width, &look, done);
        std::array::from_fn(|light| Picture {
            width: view.width,
            height: view.height,
            pixels: pixels.iter().map(|pixel| pixel[light]).collect(),
        })
    }

    /// What the ray of a place in the picture sees under each sky. Views stay below the horizon; a ray that sees no
    /// ground would spoil the pixel.
    fn light(&self, view: &View, place: [f64; 2], at: [f64; 2]) -> [[f64; 3]; LIGHTS.len()] {
        let ray = view.ray(at);
        let from = [ray.from[0] + place[0], ray.from[1] + place[1], ray.from[2]];
        let Some(along) = self.relief.hit(from, ray.way) else { return [[f64::NAN; 3]; LIGHTS.len()] };
        let [x, y, height] = std::array::from_fn(|axis| from[axis] + along * ray.way[axis]);
        let [across, down] = self.relief.slope([x, y]);
        let color = self.palette.color(height, across.hypot(down));
        let length = (1.0 + across * across + down * down).sqrt();
        let normal = [-across / length, -down / length, 1.0 / length].map(|part| part as f32);
        self.skies.map(|sky| {
            let light = sky.value(normal);
            [0, 1, 2].map(|channel| color[channel] * f64::from(light[channel]) / PI)
        })
    }
}
