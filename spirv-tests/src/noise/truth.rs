//! What a pixel should be: the mean color of everything that it sees, by brute force on the device.
//!
//! Every sample goes its own way to the noise's value, by its definition, and to the map's color there. The pixel
//! filter is a Gaussian; a pixel's samples are stratified, one in each cell of a grid of equally probable cells. Passes
//! are short, and their sums are added in f64.

use super::input::Input;
use super::lens::Lens;
use super::Error;
use crate::imaging::pixel::{Pixel, PIXEL_DEVIATION};
use crate::report::cache::Cache;
use prefilter::gpu::{Device, Dispatch, Kernel, Work};
use std::ops::Range;

/// What a pixel shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Look {
    /// The mean color of what is seen.
    pub color: [f32; 3],
    /// The share of the pixel that sees something.
    pub share: f32,
    /// The mean light on it; only the truth knows.
    pub light: f32,
    /// Length of the pixel's longer side on the noise; only methods know.
    pub length: f32,
}

impl Look {
    /// The mean of two looks at the same pixel.
    pub fn mean(&self, other: &Self) -> Self {
        let share = self.share + other.share;
        // One that sees nothing has no color.
        let part = if share == 0.0 { 0.5 } else { self.share / share };
        let mix = |one: f32, other: f32| part * one + (1.0 - part) * other;
        Self {
            color: std::array::from_fn(|channel| mix(self.color[channel], other.color[channel])),
            share: 0.5 * share,
            light: mix(self.light, other.light),
            length: self.length,
        }
    }
}

/// The number of samples that are the same in every frame: drawn anew they would shimmer more.
pub const SAME: u32 = 77;

/// Samples a pass takes at most, all pixels together: some tenths of a second on two cores.
const PASS: usize = 1 << 21;

/// Samples a pass takes at most of a pixel. Mesa's llvmpipe ends all loops of an invocation after 65535 iterations,
/// counted over all of them, and says nothing; a sample of blocks takes up to 223.
const DEEP: usize = 256;

/// Colors of an input by supersampling.
#[derive(Clone, Debug)]
pub struct Sampler<'a> {
    input: &'a Input,
    kernel: Kernel,
    knots: Vec<f32>,
    offsets: Vec<f32>,
    cache: &'a Cache,
    /// What all pictures depend on, for the cache: the program and the device.
    program: String,
}

impl<'a> Sampler<'a> {
    /// Compiles the kernel; pictures are kept in `cache`.
    ///
    /// # Errors
    /// Those of the device.
    pub fn new(device: &Device, input: &'a Input, cache: &'a Cache) -> Result<Self, Error> {
        let text = [input.world(), include_str!("truth.wgsl").to_owned()].concat();
        let linked = prefilter::link(&[], &text)?;
        let kernel = Kernel::new(device, linked.wgsl(), "main")?;
        let program = [include_str!("truth.rs"), linked.wgsl(), device.label()].join("\n");
        let knots = input.map.reference().knots.into_iter().flat_map(|(position, left, right)| {
            let [left, right] = [left, right].map(|color| [color[0], color[1], color[2], position]);
            [left, right].concat()
        });
        let offsets = Pixel::default().offsets().iter().map(|offset| (PIXEL_DEVIATION * offset) as f32).collect();
        let knots = knots.map(|number| number as f32).collect();
        Ok(Self { input, kernel, knots, offsets, cache, program })
    }

    /// What is sampled.
    pub fn input(&self) -> &'a Input {
        self.input
    }

    /// The knots of the color map, as kernels read them.
    pub fn knots(&self) -> &[f32] {
        &self.knots
    }

    /// What every pixel sees by `strata`² samples; `strata` is a power of two up to 64. `seed` says from where,
    /// `number` which samples are drawn. `done` is told how many samples a pass took.
    ///
    /// # Errors
    /// Those of the device.
    pub fn picture(
        &self,
        lens: &Lens,
        seed: u32,
        strata: usize,
        number: u32,
        done: &dyn Fn(u64),
    ) -> Result<Vec<Look>, Error> {
        let numbers = self.cache.numbers(
            &[
                &self.program,
                &format!("{:?}", (numbers(self.input, lens, seed), &self.knots, &self.offsets, strata, number)),
            ],
            5 * lens.pixels(),
            || self.sampled(lens, seed, strata, number, done),
        )?;
        let look = |pixel: &[f32]| Look {
            color: [pixel[0], pixel[1], pixel[2]],
            share: pixel[3],
            light: pixel[4],
            length: 0.0,
        };
        Ok(numbers.chunks_exact(5).map(look).collect())
    }

    /// Color, share and light of every pixel.
    fn sampled(
        &self,
        lens: &Lens,
        seed: u32,
        strata: usize,
        number: u32,
        done: &dyn Fn(u64),
    ) -> Result<Vec<f32>, Error> {
        let (all, step) = (strata * strata, (PASS / lens.pixels()).clamp(1, DEEP));
        let mut sums = vec![[0.0f64; 5]; lens.pixels()];
        for start in (0..all).step_by(step) {
            let strata = self.prepare(lens, seed, strata, number, start..all.min(start + step))?.run()?;
            for (sum, pixel) in sums.iter_mut().zip(strata.chunks_exact(8)) {
                for (total, part) in sum.iter_mut().zip(pixel) {
                    *total += f64::from(*part);
                }
            }
            done((lens.pixels() * step.min(all - start)) as u64);
        }
        let look = |[red, green, blue, count, light]: [f64; 5]| {
            let mean = |total: f64| if count == 0.0 { 0.0 } else { total / count };
            [mean(red), mean(green), mean(blue), count / all as f64, mean(light)].map(|number| number as f32)
        };
        Ok(sums.into_iter().flat_map(look).collect())
    }

    /// One pass over some strata.
    ///
    /// # Errors
    /// Those of the device.
    pub fn prepare(
        &self,
        lens: &Lens,
        seed: u32,
        strata: usize,
        number: u32,
        some: Range<usize>,
    ) -> Result<Dispatch, Error> {
        let shot = numbers(self.input, lens, seed);
        let pass = [strata.ilog2(), some.start as u32, some.end as u32, number].map(f32::from_bits);
        let (invocations, output) = (lens.pixels(), 8 * lens.pixels());
        let inputs: [&[f32]; 4] = [&shot, &self.knots, &self.offsets, &pass];
        Ok(self.kernel.prepare(&Work { inputs: &inputs, textures: &[], invocations, output })?)
    }
}

/// The frame of a picture as kernels read it.
pub fn numbers(input: &Input, lens: &Lens, seed: u32) -> [f32; 12] {
    let ([left, top], [x, y, z]) = (lens.corner(), input.origin(seed));
    let size = [lens.width as f64, lens.height as f64];
    let numbers = [size[0], size[1], left, top, lens.focal, input.density(lens), 0.0, 0.0, x, y, z, 0.0];
    numbers.map(|number| number as f32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn means_weigh_by_what_is_seen() {
        let look = |color: f32, share: f32| Look { color: [color; 3], share, light: color, length: 0.0 };
        let mean = look(0.8, 0.75).mean(&look(0.4, 0.25));
        assert!((mean.color[1] - 0.7).abs() < 1e-6 && mean.share == 0.5 && (mean.light - 0.7).abs() < 1e-6);
        let mean = look(0.8, 0.5).mean(&look(0.0, 0.0));
        assert!(mean.color[0] == 0.8 && mean.share == 0.25);
        assert_eq!(look(0.0, 0.0).mean(&look(0.0, 0.0)).share, 0.0);
    }
}
