//! Every method on one input against the truth: a still, a pan and a zoom.

use super::input::Input;
use super::method::{Method, Renderer};
use super::motion::Motion;
use super::plane::Plane;
use super::truth::Sampler;
use super::Error;
use crate::imaging::measure::{deviation, errors, root_mean_square, samples_for, Deviation};
use crate::imaging::picture::Picture;
use crate::imaging::shimmer::shimmer;
use prefilter::gpu::Device;

/// Strata an axis of the truth, which is the mean of two such pictures.
pub const TRUTH: usize = 32;

/// Strata an axis at which brute force is measured.
pub const BRUTE: [usize; 5] = [1, 2, 4, 8, 16];

/// Sizes of the pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sizes {
    /// Width and height of the stills.
    pub still: [usize; 2],
    /// Width and height of the moving pictures.
    pub moving: [usize; 2],
    /// Frames of each moving picture.
    pub frames: usize,
}

/// What is known of one method on one input.
#[derive(Clone, Debug)]
pub struct Row {
    /// The method.
    pub method: Method,
    /// Its still.
    pub picture: Picture,
    /// The still's errors.
    pub deviation: Deviation,
    /// Milliseconds a still on the device, the fastest of several.
    pub milliseconds: f64,
    /// Stratified samples a pixel for the same RMS, or the most measured if that is too few.
    pub samples: Result<f64, usize>,
    /// Temporal deviation in each motion.
    pub shimmer: Vec<f64>,
    /// Frames of each motion.
    pub frames: Vec<Vec<Picture>>,
}

/// All methods on one input.
#[derive(Clone, Debug)]
pub struct Judged {
    /// The input's name.
    pub name: &'static str,
    /// The input's title.
    pub title: &'static str,
    /// The true still.
    pub truth: Picture,
    /// Standard error of the true still, from two seeds.
    pub truth_error: f64,
    /// The methods.
    pub rows: Vec<Row>,
    /// RMS errors of brute force by samples a pixel.
    pub brute: Vec<(usize, f64)>,
    /// The true moving pictures.
    pub motions: Vec<Moving>,
}

/// A moving picture as it should be.
#[derive(Clone, Debug)]
pub struct Moving {
    /// How it moves.
    pub motion: Motion,
    /// The planes that the frames show.
    pub planes: Vec<Plane>,
    /// The true frames.
    pub frames: Vec<Picture>,
    /// Standard error of the worst frame, from two seeds.
    pub truth_error: f64,
}

impl Judged {
    /// The row of a method.
    pub fn row(&self, method: Method) -> Option<&Row> {
        self.rows.iter().find(|row| row.method == method)
    }
}

/// Samples that [`judge`] takes of one input, for a progress bar.
pub fn samples(sizes: Sizes) -> u64 {
    let pixels = |[width, height]: [usize; 2]| (width * height) as u64;
    let truth = (TRUTH * TRUTH) as u64;
    let brute: u64 = BRUTE.iter().map(|strata| (strata * strata) as u64).sum();
    let frames = (Motion::ALL.len() * sizes.frames) as u64;
    pixels(sizes.still) * (2 * truth + brute) + pixels(sizes.moving) * 2 * truth * frames
}

/// Judges every method on one input. `done` is told how many samples have been taken, from several threads.
///
/// # Errors
/// Those of scenes and of the device.
pub fn judge(device: &Device, input: &Input, sizes: Sizes, done: &(dyn Fn(u64) + Sync)) -> Result<Judged, Error> {
    let map = input.map.reference();
    let sampler = Sampler::new(&input.heights, &map);
    let sampled = |plane: &Plane, strata: usize, seed: u64| {
        let row = (plane.width * strata * strata) as u64;
        sampler.picture(plane, strata, seed, &|| done(row))
    };
    let plane = input.plane(sizes.still[0], sizes.still[1]);
    let (truth, truth_error) = truth(&plane, 0, &sampled);
    let brute = (3..).zip(BRUTE).map(|(seed, strata)| {
        let far = deviation(&sampled(&plane, strata, seed), &truth).rms;
        // The truth's own error is independent of the samples' and no fault of theirs.
        (strata * strata, (far * far - truth_error * truth_error).max(0.0).sqrt())
    });
    let brute: Vec<(usize, f64)> = brute.collect();
    let motions = motions(input, sizes, &sampled);
    let row = |method| row(device, input, method, &plane, &truth, &brute, &motions);
    let rows = Method::all().into_iter().map(row).collect::<Result<Vec<_>, Error>>()?;
    Ok(Judged { name: input.name, title: input.title, truth, truth_error, rows, brute, motions })
}

/// Samples of a plane, strata an axis and a seed.
type Sampled<'a> = dyn Fn(&Plane, usize, u64) -> Picture + 'a;

/// The mean of two true pictures from the seeds `2 number + 1` and `2 number + 2`, and its standard error.
fn truth(plane: &Plane, number: u64, sampled: &Sampled<'_>) -> (Picture, f64) {
    let pair = [1, 2].map(|seed| sampled(plane, TRUTH, 2 * number + seed));
    // The mean of two has half the deviation of their difference.
    (pair[0].mean(&pair[1]), 0.5 * root_mean_square(&errors(&pair[0], &pair[1])))
}

/// The true moving pictures; none where there are no frames.
fn motions(input: &Input, sizes: Sizes, sampled: &Sampled<'_>) -> Vec<Moving> {
    let plane = input.plane(sizes.moving[0], sizes.moving[1]);
    let moving = (1..).zip(Motion::ALL).map(|(number, motion)| {
        let planes = motion.planes(plane, sizes.frames);
        let truths = (1000 * number..).zip(&planes).map(|(number, plane)| truth(plane, number, sampled));
        let (frames, truth_errors): (Vec<Picture>, Vec<f64>) = truths.unzip();
        let truth_error = truth_errors.into_iter().fold(0.0, f64::max);
        Moving { motion, planes, frames, truth_error }
    });
    moving.filter(|moving| !moving.frames.is_empty()).collect()
}

fn row(
    device: &Device,
    input: &Input,
    method: Method,
    plane: &Plane,
    truth: &Picture,
    brute: &[(usize, f64)],
    motions: &[Moving],
) -> Result<Row, Error> {
    let renderer = Renderer::new(device, input, method)?;
    let picture = renderer.picture(plane)?;
    let deviation = deviation(&picture, truth);
    let shown = |moving: &Moving| moving.planes.iter().map(|plane| renderer.picture(plane)).collect();
    let frames = motions.iter().map(shown).collect::<Result<Vec<Vec<Picture>>, Error>>()?;
    Ok(Row {
        method,
        picture,
        deviation,
        milliseconds: renderer.milliseconds(plane)?,
        samples: samples_for(deviation.rms, brute),
        shimmer: frames.iter().zip(motions).map(|(shown, moving)| shimmer(shown, &moving.frames)).collect(),
        frames,
    })
}
