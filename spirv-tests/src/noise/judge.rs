//! Every method on every input against the truth: stills and motions, from several parts of the noise.

use super::input::{Ground, Input};
use super::lens::Lens;
use super::method::{Method, Renderer};
use super::truth::{Look, Sampler, SAME};
use super::Error;
use crate::demo::motion::Motion;
use crate::gap::figure::Figure;
use crate::imaging::measure::{samples_for, worst};
use crate::imaging::picture::Picture;
use crate::imaging::region::Region;
use crate::imaging::shimmer::shimmer;
use crate::imaging::tally::{sizes, Errors, Of};
use crate::report::cache::Cache;
use prefilter::gpu::Device;

/// The share of the noise's variance from which a pixel that loses it is far.
const FAR: f64 = 0.9;

/// Strata an axis at which brute force is measured.
pub const BRUTE: [usize; 6] = [1, 2, 4, 8, 16, 32];

/// How much is done.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Extent {
    /// Width and height of the stills of a plane and of blocks.
    pub still: [[usize; 2]; 2],
    /// Width and height of their moving pictures.
    pub moving: [[usize; 2]; 2],
    /// Frames of each moving picture.
    pub frames: usize,
    /// Strata an axis of each of the two halves of the truth: of stills and of moving pictures.
    pub strata: [usize; 2],
    /// Parts of the noise.
    pub seeds: u32,
    /// How many of [`BRUTE`] are moved, too.
    pub moved: usize,
}

impl Extent {
    fn of(sizes: [[usize; 2]; 2], ground: Ground) -> [usize; 2] {
        sizes[usize::from(ground == Ground::Blocks)]
    }

    /// Strata an axis of brute force that is moved.
    fn moved(self) -> &'static [usize] {
        &BRUTE[..self.moved.min(BRUTE.len())]
    }

    /// Samples that [`judge`] takes of an input, for a progress bar.
    pub fn samples(self, input: &Input) -> u64 {
        let pixels = |sizes| Self::of(sizes, input.ground).iter().product::<usize>();
        let brute: usize = BRUTE.iter().map(|strata| strata * strata).sum();
        let [still, moving] = self.strata.map(|strata| 2 * strata * strata);
        let frames = Motion::ALL.len() * self.frames;
        let moved: usize = self.moved().iter().map(|strata| strata * strata).sum();
        let moving = pixels(self.moving) * (moving + moved) * frames;
        u64::from(self.seeds) * (pixels(self.still) * (still + brute) + moving) as u64
    }
}

/// What one part of the noise shows in motion.
#[derive(Clone, Debug)]
pub struct Shimmer {
    /// Of each method, in the order of [`Method::ALL`]; NaN where there is none for the input.
    pub methods: [f64; Method::ALL.len()],
    /// Of those of [`BRUTE`] that are moved: a pixel has the same samples in every frame.
    pub brute: Vec<f64>,
    /// How much of that is the truth's own.
    pub truth: f64,
}

/// All that is known of an input.
#[derive(Clone, Debug)]
pub struct Judged {
    /// The input.
    pub input: Input,
    /// Its stills' errors, one for each part of the noise.
    pub stills: Vec<Errors>,
    /// Milliseconds a still on the device, the fastest of several, by method; NaN where there is none.
    pub milliseconds: Vec<f64>,
    /// Shimmer of each part of the noise, by motion.
    pub motions: [Vec<Shimmer>; 2],
}

impl Judged {
    /// Root mean square error of a method in a region, or of all pixels, with its standard error.
    pub fn rms(&self, method: Method, region: Option<Region>) -> Figure {
        sizes(&self.stills, Of::Method(method.number()), region).rms
    }

    /// Stratified samples a pixel for the same root mean square error, or a bound.
    pub fn samples(&self, method: Method, region: Option<Region>) -> Result<f64, usize> {
        let brute = |(number, strata): (usize, usize)| {
            (strata * strata, sizes(&self.stills, Of::Brute(number), region).rms.value)
        };
        let measured: Vec<(usize, f64)> = BRUTE.into_iter().enumerate().map(brute).collect();
        samples_for(self.rms(method, region).value, &measured)
    }

    /// Shimmer of a method in a motion, over all parts of the noise, without the truth's own.
    pub fn shimmer(&self, method: Method, motion: Motion) -> Figure {
        self.unsteady(motion, &|seed| seed.methods.get(method.number()).copied())
    }

    /// The same of brute force, by its number in [`BRUTE`]; NaN where it was not moved.
    pub fn brute_shimmer(&self, number: usize, motion: Motion) -> Figure {
        self.unsteady(motion, &|seed| seed.brute.get(number).copied())
    }

    fn unsteady(&self, motion: Motion, shown: &dyn Fn(&Shimmer) -> Option<f64>) -> Figure {
        let series = &self.motions[usize::from(motion == Motion::Zoom)];
        let [figure] = Figure::jackknife(series, |some| {
            let square = |seed: &&Shimmer| shown(seed).unwrap_or(f64::NAN).powi(2) - seed.truth.powi(2);
            let left = some.iter().map(square).sum::<f64>() / some.len() as f64;
            [if left < 0.0 { 0.0 } else { left.sqrt() }]
        });
        figure
    }
}

/// An input with all that looks at it.
struct Studio<'a> {
    sampler: &'a Sampler<'a>,
    /// In the order of [`Method::ALL`].
    renderers: Vec<Option<Renderer<'a>>>,
    extent: Extent,
    done: &'a dyn Fn(u64),
}

/// Judges every method on an input. What is sampled is kept in `cache`; `done` is told how many samples have been
/// taken.
///
/// # Errors
/// Those of scenes and of the device.
pub fn judge(
    device: &Device,
    input: &Input,
    extent: Extent,
    cache: &Cache,
    done: &dyn Fn(u64),
) -> Result<Judged, Error> {
    let sampler = Sampler::new(device, input, cache)?;
    let renderer = |method| input.has(method).then(|| Renderer::new(device, &sampler, method)).transpose();
    let renderers = Method::ALL.into_iter().map(renderer);
    let studio = Studio { sampler: &sampler, renderers: renderers.collect::<Result<_, _>>()?, extent, done };
    let still = input.lens(Extent::of(extent.still, input.ground));
    let time = |renderer: &Option<Renderer<'_>>| renderer.as_ref().map_or(Ok(f64::NAN), |it| it.milliseconds(&still));
    let milliseconds = studio.renderers.iter().map(time);
    let mut judged = Judged {
        input: input.clone(),
        stills: Vec::new(),
        milliseconds: milliseconds.collect::<Result<_, _>>()?,
        motions: [Vec::new(), Vec::new()],
    };
    for seed in 1..=extent.seeds {
        judged.stills.push(studio.still(&still, seed)?);
        for (motion, series) in Motion::ALL.into_iter().zip(&mut judged.motions) {
            series.extend(studio.moving(motion, seed)?);
        }
    }
    Ok(judged)
}

impl Studio<'_> {
    /// Two independent halves of the truth.
    fn halves(&self, lens: &Lens, seed: u32, strata: usize, number: u32) -> Result<[Vec<Look>; 2], Error> {
        let half = |half: u32| self.sampler.picture(lens, seed, strata, 2 * number + half, self.done);
        Ok([half(0)?, half(1)?])
    }

    /// What every method shows, in the order of [`Method::ALL`]: no pixels where there is none.
    fn shown(&self, lens: &Lens, seed: u32) -> Result<Vec<Vec<Look>>, Error> {
        let picture = |renderer: &Option<Renderer<'_>>| {
            renderer.as_ref().map_or(Ok(Vec::new()), |renderer| renderer.picture(lens, seed))
        };
        self.renderers.iter().map(picture).collect()
    }

    fn still(&self, lens: &Lens, seed: u32) -> Result<Errors, Error> {
        let halves = self.halves(lens, seed, self.extent.strata[0], 0)?;
        let truth = mean(&halves);
        let shown = self.shown(lens, seed)?;
        let brute = (10..).zip(BRUTE).map(|(number, strata)| {
            let brute = self.sampler.picture(lens, seed, strata, number, self.done)?;
            Ok(errors(&brute, &truth, &shown[0]))
        });
        let lost = |look: &Look| Region::of(self.sampler.input().lost(f64::from(look.length)), FAR);
        let judged = shown[0].iter().zip(&truth).filter(|(look, truth)| is_judged(look, truth));
        Ok(Errors {
            regions: judged.map(|(look, _)| lost(look)).collect(),
            brute: brute.collect::<Result<_, Error>>()?,
            // The mean of two has half the deviation of their difference.
            truth: errors(&halves[0], &halves[1], &shown[0]).into_iter().map(|error| 0.5 * error).collect(),
            // None of a method that there is not: figures of no pixels are NaN.
            methods: shown.iter().map(|looks| errors(looks, &truth, &shown[0])).collect(),
        })
    }

    /// Shimmer in a motion; none where there are no frames.
    fn moving(&self, motion: Motion, seed: u32) -> Result<Option<Shimmer>, Error> {
        let lens = self.sampler.input().lens(Extent::of(self.extent.moving, self.sampler.input().ground));
        let lenses = lens.moving(motion, self.extent.frames);
        let halves = (100..).zip(&lenses).map(|(number, lens)| self.halves(lens, seed, self.extent.strata[1], number));
        let halves = halves.collect::<Result<Vec<_>, Error>>()?;
        let truth: Vec<Vec<Look>> = halves.iter().map(mean).collect();
        let frames = |renderer: &Option<Renderer<'_>>| {
            let frames = renderer.iter().flat_map(|it| lenses.iter().map(|lens| it.picture(lens, seed)));
            frames.collect::<Result<Vec<Vec<Look>>, Error>>()
        };
        let shown = self.renderers.iter().map(frames).collect::<Result<Vec<Vec<Vec<Look>>>, Error>>()?;
        let Some(whole) = shown.first().map(|naive| whole(naive, &truth)) else { return Ok(None) };
        if lenses.is_empty() {
            return Ok(None);
        }
        let of = |frames: &[Vec<Look>]| frames.iter().map(|frame| some(frame, &whole)).collect::<Vec<Picture>>();
        let half = |half: usize| of(&halves.iter().map(|halves| halves[half].clone()).collect::<Vec<_>>());
        let true_frames = of(&truth);
        let mut methods = [f64::NAN; Method::ALL.len()];
        for (figure, frames) in methods.iter_mut().zip(&shown).filter(|(_, frames)| !frames.is_empty()) {
            *figure = shimmer(&of(frames), &true_frames);
        }
        let brute = self.extent.moved().iter().map(|&strata| {
            let frames = lenses.iter().map(|lens| self.sampler.picture(lens, seed, strata, SAME, self.done));
            Ok(shimmer(&of(&frames.collect::<Result<Vec<_>, Error>>()?), &true_frames))
        });
        let brute = brute.collect::<Result<_, Error>>()?;
        Ok(Some(Shimmer { methods, brute, truth: 0.5 * shimmer(&half(0), &half(1)) }))
    }
}

/// The mean of two halves.
fn mean(halves: &[Vec<Look>; 2]) -> Vec<Look> {
    halves[0].iter().zip(&halves[1]).map(|(one, other)| one.mean(other)).collect()
}

/// Whether methods see something where there is something: elsewhere there is no color to judge.
pub fn is_judged(look: &Look, truth: &Look) -> bool {
    look.share != 0.0 && truth.share > 0.0
}

/// The errors of the judged pixels: of the worst channel, times the share of the pixel that sees something. `naive`
/// knows where methods see something.
fn errors(shown: &[Look], truth: &[Look], naive: &[Look]) -> Vec<f32> {
    let pixels = shown.iter().zip(truth).zip(naive).filter(|((_, truth), naive)| is_judged(naive, truth));
    pixels.map(|((shown, truth), _)| error(shown, truth)).collect()
}

/// The error of a pixel.
pub fn error(shown: &Look, truth: &Look) -> f32 {
    // Brute force with few samples may see nothing of what is little of the pixel.
    let color = if shown.share == 0.0 { [0.0; 3] } else { shown.color };
    truth.share * worst(&color, &truth.color)
}

/// The pixels that see nothing but the ground in every frame.
fn whole(naive: &[Vec<Look>], truth: &[Vec<Look>]) -> Vec<usize> {
    let pixels = naive.first().map_or(0, Vec::len);
    let covered = |pixel: usize| {
        naive.iter().all(|frame| frame[pixel].share != 0.0) && truth.iter().all(|frame| frame[pixel].share == 1.0)
    };
    (0..pixels).filter(|&pixel| covered(pixel)).collect()
}

/// Some pixels of a frame in a row.
fn some(frame: &[Look], pixels: &[usize]) -> Picture {
    Picture { width: pixels.len(), height: 1, pixels: pixels.iter().map(|&pixel| frame[pixel].color).collect() }
}
