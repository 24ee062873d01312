//! What a pixel is: a Gaussian over the picture, sampled one place in each of a grid of equally probable cells.

use prefilter::reference::normal::cumulative;
use std::sync::Mutex;

/// Deviation of the Gaussian pixel filter, in pixels.
pub const PIXEL_DEVIATION: f64 = 0.5;

/// Equally probable offsets that stand for the Gaussian; a multiple of every number of strata in use.
const OFFSETS: usize = 8192;

/// Samples of pixels.
#[derive(Clone, Debug)]
pub struct Pixel {
    offsets: Vec<f64>,
}

impl Default for Pixel {
    fn default() -> Self {
        Self { offsets: offsets() }
    }
}

impl Pixel {
    /// Equally probable offsets from the middle along one axis, in deviations, from the lowest up.
    pub fn offsets(&self) -> &[f64] {
        &self.offsets
    }

    /// `strata`² places about the middle of a pixel, in pixels; `strata` is a power of two up to 64. A seed draws
    /// the same places for a pixel of the same number every time.
    pub fn samples(&self, strata: usize, seed: u64, number: u64) -> impl Iterator<Item = [f64; 2]> + '_ {
        let cell = OFFSETS / strata;
        let mut random = Random::new(seed, number);
        (0..strata * strata).map(move |sample| {
            let drawn = random.next();
            let across = self.offsets[sample % strata * cell + (drawn >> 32) as usize % cell];
            let down = self.offsets[sample / strata * cell + drawn as u32 as usize % cell];
            [PIXEL_DEVIATION * across, PIXEL_DEVIATION * down]
        })
    }
}

/// Fills a picture by as many threads as there are processors: `work` is given a column and a row. `done` is called
/// after every row, from several threads.
pub fn fill<T: Send>(
    pixels: &mut [T],
    width: usize,
    work: &(dyn Fn(usize, usize) -> T + Sync),
    done: &(dyn Fn() + Sync),
) {
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let rows: Vec<(usize, &mut [T])> = pixels.chunks_mut(width.max(1)).enumerate().collect();
    let rows = Mutex::new(rows.into_iter());
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| loop {
                // A poisoned lock means that another row panicked, which the scope reports.
                let Some((row, pixels)) = rows.lock().ok().and_then(|mut rows| rows.next()) else { return };
                for (column, pixel) in pixels.iter_mut().enumerate() {
                    *pixel = work(column, row);
                }
                done();
            });
        }
    });
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

    #[test]
    fn seeds_differ_and_repeat() {
        let mut first = Random::new(1, 5);
        let (drawn, other) = (first.next(), Random::new(2, 5).next());
        assert_eq!(drawn, Random::new(1, 5).next());
        assert_ne!(drawn, other);
        assert_ne!(drawn, Random::new(1, 6).next());
    }
}
