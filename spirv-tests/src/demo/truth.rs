//! What a pixel should be: the mean color of everything that it sees, by brute force in f64.
//!
//! Every sample goes its own way through the exact perspective to a bilinear height of the base image and to the map's
//! color there. No footprint, no pyramid and no table is involved. The pixel filter is a Gaussian; a pixel's samples
//! are stratified, one in each cell of a grid of equally probable cells.

use super::heights::Heights;
use super::picture::Picture;
use super::plane::Plane;
use prefilter::reference::normal::cumulative;
use prefilter::reference::texture::PiecewiseLinear;

/// Deviation of the Gaussian pixel filter, in pixels.
pub const PIXEL_DEVIATION: f64 = 0.5;

/// Equally probable offsets that stand for the Gaussian; a multiple of every number of strata in use.
const OFFSETS: usize = 8192;

/// Colors of a scene by supersampling.
#[derive(Clone, Debug)]
pub struct Sampler<'a> {
    heights: &'a Heights,
    map: &'a PiecewiseLinear,
    offsets: Vec<f64>,
}

impl<'a> Sampler<'a> {
    /// Samples of `map` over `heights`.
    pub fn new(heights: &'a Heights, map: &'a PiecewiseLinear) -> Self {
        Self { heights, map, offsets: offsets() }
    }

    /// The picture of a plane with `strata`² samples a pixel; `strata` is a power of two up to 64. The same seed draws
    /// the same samples. `done` is called after every row, from several threads.
    pub fn picture(&self, plane: &Plane, strata: usize, seed: u64, done: &(dyn Fn() + Sync)) -> Picture {
        let mut picture = Picture::new(plane.width, plane.height);
        let threads = std::thread::available_parallelism().map_or(1, usize::from);
        let rows: Vec<(usize, &mut [[f32; 3]])> = picture.pixels.chunks_mut(plane.width.max(1)).enumerate().collect();
        let rows = std::sync::Mutex::new(rows.into_iter());
        std::thread::scope(|scope| {
            for _ in 0..threads {
                scope.spawn(|| loop {
                    // A poisoned lock means that another row panicked, which the scope reports.
                    let Some((row, pixels)) = rows.lock().ok().and_then(|mut rows| rows.next()) else { return };
                    for (column, pixel) in pixels.iter_mut().enumerate() {
                        let number = (row * plane.width + column) as u64;
                        let mut random = Random::new(seed, number);
                        *pixel = self.pixel(plane, plane.pixel(column, row), strata, &mut random);
                    }
                    done();
                });
            }
        });
        picture
    }

    fn pixel(&self, plane: &Plane, center: [f64; 2], strata: usize, random: &mut Random) -> [f32; 3] {
        let cell = OFFSETS / strata;
        let mut sum = [0.0; 3];
        for sample in 0..strata * strata {
            let drawn = random.next();
            let across = self.offsets[sample % strata * cell + (drawn >> 32) as usize % cell];
            let down = self.offsets[sample / strata * cell + drawn as u32 as usize % cell];
            let place = [center[0] + PIXEL_DEVIATION * across, center[1] + PIXEL_DEVIATION * down];
            let color = self.map.value(self.heights.bilinear(plane.position(place)));
            for (total, channel) in sum.iter_mut().zip(color) {
                *total += channel;
            }
        }
        sum.map(|total| (total / (strata * strata) as f64) as f32)
    }
}

/// Quantiles of the normal distribution at the middles of equally probable intervals.
fn offsets() -> Vec<f64> {
    let quantile = |probability: f64| {
        let (mut low, mut high) = (-8.0, 8.0);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if cumulative(middle) < probability {
                low = middle;
            } else {
                high = middle;
            }
        }
        0.5 * (low + high)
    };
    (0..OFFSETS).map(|number| quantile((number as f64 + 0.5) / OFFSETS as f64)).collect()
}

/// SplitMix64 (Steele, Lea and Flood 2014), started from a seed and a pixel.
struct Random(u64);

impl Random {
    fn new(seed: u64, pixel: u64) -> Self {
        let mut random = Self(seed);
        let start = random.next();
        Self(start ^ pixel.wrapping_mul(0xd134_2543_de82_ef95))
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut mixed = self.0;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }
}

#[cfg(test)]
mod tests {
    use super::super::heights::Address;
    use super::*;

    #[test]
    fn offsets_have_the_moments_of_a_normal_variable() {
        let offsets = offsets();
        let moment = |power: i32| offsets.iter().map(|offset| offset.powi(power)).sum::<f64>() / OFFSETS as f64;
        // The outermost intervals stand at their middles: their tails are the whole difference.
        assert!(moment(1).abs() < 1e-12 && moment(3).abs() < 1e-10);
        assert!((moment(2) - 1.0).abs() < 1e-3, "{}", moment(2));
        assert!((moment(4) - 3.0).abs() < 2e-2, "{}", moment(4));
    }

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

    #[test]
    fn seeds_differ_and_repeat() {
        let mut first = Random::new(1, 5);
        let (drawn, other) = (first.next(), Random::new(2, 5).next());
        assert_eq!(drawn, Random::new(1, 5).next());
        assert_ne!(drawn, other);
        assert_ne!(drawn, Random::new(1, 6).next());
    }
}
