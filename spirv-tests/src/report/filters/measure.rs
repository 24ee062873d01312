//! How far each row of a case is from the truth, and how long it takes.

use super::brute::{Brute, SIDES};
use super::case::Case;
use super::driver::{driven, takes_slopes};
use super::pixel::Pixel;
use crate::exports::ExportKernel;
use crate::gap::figure::{over_seeds, Figure};
use crate::imaging::measure::{sizes, worst};
use crate::random::Random;
use crate::report::timing::{fastest, filling, repeated, WAVES};
use crate::report::{Bench, Error};
use prefilter::gpu::Dispatch;

/// Seeds that standard errors are from.
pub const SEEDS: usize = 4;

/// Pixels whose time is taken, or samples of them.
const TIMED: usize = 1 << 15;

/// Of samples at least so many pixels are timed.
const LEAST: usize = 64;

/// The sizes of a row's errors, and its time.
#[derive(Clone, Copy, Debug)]
pub struct Sizes {
    /// Root of the mean square of the worst channel's error.
    pub rms: Figure,
    /// The error that 99 pixels in 100 stay below.
    pub percentile: Figure,
    /// The largest error.
    pub maximum: Figure,
    /// Milliseconds a megapixel.
    pub time: f64,
}

/// What was measured of a case.
#[derive(Clone, Debug)]
pub struct Measured {
    /// As many as the case has rows, in their order.
    pub rows: Vec<Sizes>,
    /// Samples a pixel, and what they do.
    pub brute: Vec<(usize, Sizes)>,
    /// Milliseconds a megapixel of the naive map and of what a scene without settings chooses, both behind a driver.
    pub driven: [f64; 2],
}

impl Measured {
    /// Samples and RMS errors.
    pub fn samples(&self) -> Vec<(usize, f64)> {
        self.brute.iter().map(|(count, sizes)| (*count, sizes.rms.value)).collect()
    }

    /// The time of what is chosen over that of the naive map, both behind the driver.
    pub fn driven_ratio(&self) -> f64 {
        self.driven[1] / self.driven[0]
    }

    /// The time of so many samples: linear between the logarithms of those measured.
    pub fn time_of(&self, samples: f64) -> f64 {
        let known: Vec<(f64, f64)> = self.brute.iter().map(|(count, sizes)| (*count as f64, sizes.time)).collect();
        let pair = known.windows(2).find(|pair| samples <= pair[1].0).or(known.windows(2).last());
        pair.map_or(f64::NAN, |pair| {
            let [(few, quick), (many, slow)] = [pair[0], pair[1]];
            quick * (slow / quick).powf((samples / few).ln() / (many / few).ln())
        })
    }
}

/// Measures every row of a case.
///
/// # Errors
/// What scenes and the device refuse.
pub fn measure(bench: &Bench<'_>, case: &Case) -> Result<Measured, Error> {
    let count = (bench.extent.pick(256, 4096) / case.share).max(32);
    let pixels = pixels(case, count);
    let all: Vec<Pixel> = pixels.concat();
    let truth = truth(bench, case, &pixels, count)?;
    (bench.done)(1);
    let runs = runs(bench, case, &all)?;
    (bench.done)(1);
    let dispatches: Vec<Dispatch> = runs.iter().map(|run| run.timed.clone()).collect();
    let seconds = fastest(&dispatches, bench.extent)?;
    (bench.done)(1);
    let times = seconds.iter().zip(&runs).map(|(seconds, run)| 1e9 * seconds / run.pixels as f64);
    let times: Vec<f64> = times.collect();
    let (rows, samples) = (case.rows.len(), SIDES.len());
    let sizes = |at: usize| figures(&differences(&runs[at].colors, &truth), count, times[at]);
    Ok(Measured {
        rows: (0..rows).map(sizes).collect(),
        brute: SIDES.iter().enumerate().map(|(at, side)| (side * side, sizes(rows + at))).collect(),
        driven: [times[rows + samples], times[rows + samples + 1]],
    })
}

/// A kernel's colors, and the kernel over pixels to be timed.
struct Run {
    colors: Vec<[f32; 4]>,
    timed: Dispatch,
    pixels: usize,
}

/// All rows, all counts of samples, and the naive and the default row behind a driver.
fn runs(bench: &Bench<'_>, case: &Case, all: &[Pixel]) -> Result<Vec<Run>, Error> {
    let run = |kernel: &ExportKernel, numbers: &[f32], pixels: usize| -> Result<Run, Error> {
        let (timed, pixels) = filling(pixels, WAVES, |count| kernel.prepare(&repeated(numbers, all.len(), count)))?;
        Ok(Run { colors: kernel.run(numbers)?, timed, pixels })
    };
    let mut runs = Vec::new();
    for row in &case.rows {
        let kernel = row.kernel(bench.timed)?;
        runs.push(run(&kernel, &row.points(&kernel, all), TIMED)?);
    }
    let kernel = case.brute.kernel(bench.timed)?;
    for side in SIDES {
        let few = (TIMED / (side * side)).max(LEAST);
        runs.push(run(&kernel, &Brute::points(&kernel, all, side, 1), few)?);
    }
    let chosen = case.rows.iter().find(|row| row.default);
    let slopes = chosen.map_or(Ok(false), |row| row.kernel(bench.timed).map(|kernel| takes_slopes(&kernel)))?;
    for row in case.rows.first().into_iter().chain(chosen) {
        let kernel = driven(bench.timed, row, slopes)?;
        runs.push(run(&kernel, &row.points(&kernel, all), TIMED)?);
    }
    Ok(runs)
}

/// Random pixels, seed by seed.
pub fn pixels(case: &Case, count: usize) -> Vec<Vec<Pixel>> {
    let of = |seed: usize| {
        let mut random = Random::new(0x5eed + seed as u32);
        (0..count).map(|_| case.drawn.pixel(&mut random)).collect()
    };
    (0..SEEDS).map(of).collect()
}

/// The integral at every pixel.
fn truth(bench: &Bench<'_>, case: &Case, pixels: &[Vec<Pixel>], count: usize) -> Result<Vec<[f32; 3]>, Error> {
    let drawn = format!("{} {:?} {count}", case.stem, case.drawn);
    let common = [drawn.as_str(), include_str!("pixel.rs")];
    let inputs: Vec<&str> = common.into_iter().chain(case.sources.iter().copied()).collect();
    let kept = bench.cache.numbers(&inputs, 3 * SEEDS * count, || {
        let of = |seed: u64| -> Vec<f32> {
            let colors = pixels[seed as usize].iter().map(|pixel| (case.truth)(pixel));
            colors.flat_map(|color| [0, 1, 2].map(|channel| color[channel] as f32)).collect()
        };
        Ok::<_, Error>(over_seeds(SEEDS, of).concat())
    })?;
    Ok(kept.chunks_exact(3).map(|color| [color[0], color[1], color[2]]).collect())
}

fn differences(colors: &[[f32; 4]], truth: &[[f32; 3]]) -> Vec<f32> {
    let apart = |(color, truth): (&[f32; 4], &[f32; 3])| worst(&[color[0], color[1], color[2]], truth);
    colors.iter().zip(truth).map(apart).collect()
}

/// Figures of the errors of all seeds, `count` of each.
fn figures(errors: &[f32], count: usize, time: f64) -> Sizes {
    let seeds: Vec<&[f32]> = errors.chunks_exact(count).collect();
    let [rms, percentile, maximum] = Figure::jackknife(&seeds, |seeds| {
        let all = sizes(seeds.iter().flat_map(|errors| errors.iter().copied()).collect());
        [all.rms, all.percentile, all.maximum]
    });
    Sizes { rms, percentile, maximum, time }
}
