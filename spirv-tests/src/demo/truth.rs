//! What a pixel should be: the mean color of everything that it sees, by brute force in f64.
//!
//! Every sample goes its own way through the exact perspective to a bilinear height of the base image and to the map's
//! color there. No footprint, no pyramid and no table is involved. The pixel filter is a Gaussian; a pixel's samples
//! are stratified, one in each cell of a grid of equally probable cells.

use super::heights::Heights;
use super::plane::Plane;
use crate::imaging::picture::Picture;
use crate::imaging::pixel::{fill, Pixel};
use prefilter::reference::texture::PiecewiseLinear;

/// Colors of a scene by supersampling.
#[derive(Clone, Debug)]
pub struct Sampler<'a> {
    heights: &'a Heights,
    map: &'a PiecewiseLinear,
    pixel: Pixel,
}

impl<'a> Sampler<'a> {
    /// Samples of `map` over `heights`.
    pub fn new(heights: &'a Heights, map: &'a PiecewiseLinear) -> Self {
        Self { heights, map, pixel: Pixel::default() }
    }

    /// The picture of a plane with `strata`² samples a pixel; `strata` is a power of two up to 64. The same seed draws
    /// the same samples. `done` is called after every row, from several threads.
    pub fn picture(&self, plane: &Plane, strata: usize, seed: u64, done: &(dyn Fn() + Sync)) -> Picture {
        let mut picture = Picture::new(plane.width, plane.height);
        let pixel = |column: usize, row: usize| {
            let number = (row * plane.width + column) as u64;
            self.color(plane, plane.pixel(column, row), self.pixel.samples(strata, seed, number))
        };
        fill(&mut picture.pixels, plane.width, &pixel, done);
        picture
    }

    /// The mean color at some places about the middle of a pixel.
    fn color(&self, plane: &Plane, center: [f64; 2], samples: impl Iterator<Item = [f64; 2]>) -> [f32; 3] {
        let (mut sum, mut count) = ([0.0; 3], 0.0);
        for [across, down] in samples {
            let place = [center[0] + across, center[1] + down];
            let color = self.map.value(self.heights.bilinear(plane.position(place)));
            for (total, channel) in sum.iter_mut().zip(color) {
                *total += channel;
            }
            count += 1.0;
        }
        sum.map(|total| (total / count) as f32)
    }
}

#[cfg(test)]
mod tests {
    use super::super::heights::Address;
    use super::*;
    use crate::imaging::pixel::PIXEL_DEVIATION;
    use prefilter::reference::normal::cumulative;

    /// Where the heights are a ramp and the map is a step, a pixel's mean is the normal distribution function.
    #[test]
    fn a_step_over_a_ramp_is_the_normal_distribution() {
        let heights = Heights {
            width: 256,
            height: 2,
            texels: (0..512).map(|number| (number % 256) as f32 / 256.0).collect(),
            address: Address::Mirror,
        };
        let map = PiecewiseLinear { knots: vec![(0.5, [0.0; 4], [1.0; 4])] };
        // Far below the horizon the perspective is nearly affine: 1/py changes by 1e-4 over a pixel.
        let plane = Plane {
            width: 8,
            height: 1,
            first_row: 1e4,
            focal: 1.0,
            pan: [0.37, 0.0],
            periods: [40.0, 40.0],
            turn: 0.0,
            origin: [0.501953125, 0.0],
        };
        let sampler = Sampler::new(&heights, &map);
        let picture = sampler.picture(&plane, 32, 7, &|| ());
        for column in 0..plane.width {
            let at = plane.position(plane.pixel(column, 0))[0];
            // Heights rise by 1 a period: the texel i/256 has its center at (i + ½)/256.
            let distance =
                (at - 0.5 / 256.0 - 0.5) / (PIXEL_DEVIATION * plane.derivatives(plane.pixel(column, 0))[0][0]);
            let expected = cumulative(distance);
            assert!((f64::from(picture.pixels[column][1]) - expected).abs() < 0.01, "{column}: {expected} {picture:?}");
        }
    }
}
