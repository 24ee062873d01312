//! Scenes whose truth shoots rays: what stills and motions of them show, and how far that is from the truth.

use super::frame::Frame;
use super::measured::{Brute, Shimmer};
use crate::demo::motion::Motion;
use crate::gap::figure::Figure;
use crate::imaging::look::Look;
use crate::imaging::picture::Picture;
use crate::imaging::shimmer::shimmer;
use crate::imaging::tally::Errors;
use crate::report::cache::Cache;
use crate::report::Error;

/// Strata an axis at which brute force is measured, as far as they are fewer than the truth's; those of half the truth
/// follow.
const BRUTE: [usize; 6] = [1, 2, 4, 8, 16, 32];

/// Parts of a moving picture, over which its standard errors are.
const PARTS: usize = 4;

/// How much is done of a scene.
#[derive(Clone, Copy, Debug)]
pub struct Amount {
    /// Width and height of the stills.
    pub size: [usize; 2],
    /// Width and height of the moving pictures.
    pub moving: [usize; 2],
    /// Frames of each motion.
    pub frames: usize,
    /// Strata an axis of each half of the truth.
    pub strata: usize,
    /// Surfaces, or places on one, of which each has all stills.
    pub blocks: u64,
}

impl Amount {
    /// Rays of all that is seen, for a progress bar; `still` are the pixels of a block's stills.
    pub fn rays(&self, still: usize) -> u64 {
        let moving = 2 * self.frames * self.moving[0] * self.moving[1];
        (self.blocks * still as u64 + moving as u64) * rays(self.strata)
    }
}

/// A surface with all that looks at it.
pub trait Stage {
    /// From where it is seen.
    type View;

    /// What `strata`² rays a pixel see, under one light after the other.
    fn sampled(&self, view: &Self::View, strata: usize, seed: u64) -> Result<Vec<Look>, Error>;

    /// What every method shows likewise.
    fn shown(&self, view: &Self::View) -> Result<Vec<Vec<Look>>, Error>;
}

/// What is seen of a scene.
#[derive(Clone, Debug, Default)]
pub struct Shots {
    /// The errors of stills, block by block.
    pub stills: Vec<Errors>,
    /// The stills of the first block.
    pub first: Vec<Frame>,
    /// Of every method.
    pub methods: Vec<Shimmer>,
    /// By rising numbers of samples.
    pub brute: Vec<Brute>,
}

/// Rays that a pixel takes in a frame with so many strata an axis in each half of the truth.
pub fn rays(strata: usize) -> u64 {
    (2 * strata * strata + fewer(strata).map(|strata| strata * strata).sum::<usize>()) as u64
}

/// Strata an axis of the brute force that is measured by itself.
pub fn fewer(strata: usize) -> impl Iterator<Item = usize> {
    BRUTE.into_iter().filter(move |&fewer| fewer < strata)
}

/// Pictures that are kept under the text of what makes them.
pub fn kept(
    cache: &Cache,
    inputs: &[&str],
    pixels: usize,
    make: impl FnOnce() -> Result<Vec<Look>, Error>,
) -> Result<Vec<Look>, Error> {
    let numbers = cache.numbers(inputs, 7 * pixels, || {
        let looks = make()?.into_iter();
        Ok::<_, Error>(looks.flat_map(|look| numbers(&look)).map(|number| number as f32).collect())
    })?;
    let look = |pixel: &[f32]| {
        let at = |number: usize| f64::from(pixel[number]);
        Look { color: [at(0), at(1), at(2)], lit: [at(3), at(4), at(5)], share: at(6) }
    };
    Ok(numbers.chunks_exact(7).map(look).collect())
}

fn numbers(Look { color: [a, b, c], lit: [d, e, f], share }: &Look) -> [f64; 7] {
    [*a, *b, *c, *d, *e, *f, *share]
}

impl Shots {
    /// Adds a block: stills of a surface, `number` of which says what is drawn.
    ///
    /// # Errors
    /// Those of the stage.
    pub fn still<S: Stage>(&mut self, stage: &S, views: &[S::View], strata: usize, number: u64) -> Result<(), Error> {
        let looked =
            views.iter().zip(100 * number..).map(|(view, number)| Frame::new(stage, view, strata, number, number));
        let frames = looked.collect::<Result<Vec<_>, Error>>()?;
        let mut all = Errors::default();
        frames.iter().for_each(|frame| frame.enter(&mut all));
        self.stills.push(all);
        if self.first.is_empty() {
            self.first = frames;
        }
        Ok(())
    }

    /// Finds the shimmer on pan and on zoom; `moved` gives the view of a motion's frame.
    ///
    /// # Errors
    /// Those of the stage.
    pub fn moving<S: Stage>(
        &mut self,
        stage: &S,
        moved: &dyn Fn([f64; 2], f64) -> S::View,
        strata: usize,
        frames: usize,
    ) -> Result<(), Error> {
        let [pan, zoom] = Motion::ALL.map(|motion| {
            let frame = |number: usize| {
                let (pan, zoom) = motion.at(number);
                // Brute force has the same samples in every frame.
                Frame::new(stage, &moved(pan, zoom), strata, 10_000 + number as u64, 10_000)
            };
            Ok::<_, Error>(unsteady(&(0..frames).map(frame).collect::<Result<Vec<_>, Error>>()?))
        });
        let ([methods, brute], [methods_zoom, brute_zoom]) = (pan?, zoom?);
        let both = |pan: Vec<Figure>, zoom: Vec<Figure>| {
            pan.into_iter().zip(zoom).map(|(pan, zoom)| [Some(pan), Some(zoom)]).collect::<Vec<Shimmer>>()
        };
        self.methods = both(methods, methods_zoom);
        let brute = both(brute, brute_zoom).into_iter().zip(fewer(strata));
        self.brute = brute.map(|(shimmer, strata)| Brute { samples: strata * strata, shimmer }).collect();
        Ok(())
    }

    /// Brute force of the stills, with the shimmer that is known, by rising numbers of samples.
    pub fn brute(&self, strata: usize) -> Vec<Brute> {
        let all = fewer(strata).chain([strata]).map(|strata| {
            let samples = strata * strata;
            let known = self.brute.iter().find(|brute| brute.samples == samples);
            known.copied().unwrap_or(Brute { samples, shimmer: [None; 2] })
        });
        all.collect()
    }
}

/// Shimmer of methods and of brute force, without the truth's own, over the pixels that see nothing else in any frame.
fn unsteady(frames: &[Frame]) -> [Vec<Figure>; 2] {
    let Some(first) = frames.first() else { return Default::default() };
    let is_whole = |pixel: usize| {
        frames
            .iter()
            .all(|frame| frame.truth[pixel].share == 1.0 && frame.shown.iter().all(|shown| shown[pixel].share == 1.0))
    };
    let whole: Vec<usize> = (0..first.truth.len()).filter(|&pixel| is_whole(pixel)).collect();
    let parts: Vec<&[usize]> = whole.chunks(whole.len().div_ceil(PARTS).max(1)).collect();
    let figure = |of: &dyn Fn(&Frame) -> &[Look]| {
        let squares = parts.iter().map(|pixels| {
            let series = |of: &dyn Fn(&Frame) -> &[Look]| -> Vec<Picture> {
                frames.iter().map(|frame| some(of(frame), pixels)).collect()
            };
            let truth = series(&|frame| &frame.truth);
            // The mean of two halves has half the deviation of their difference.
            let own = 0.5 * shimmer(&series(&|frame| &frame.halves[0]), &series(&|frame| &frame.halves[1]));
            shimmer(&series(of), &truth).powi(2) - own.powi(2)
        });
        let [figure] = Figure::jackknife(&squares.collect::<Vec<_>>(), |some| {
            let left = some.iter().copied().sum::<f64>() / some.len() as f64;
            [if left < 0.0 { 0.0 } else { left.sqrt() }]
        });
        figure
    };
    let methods = (0..first.shown.len()).map(|number| figure(&|frame| &frame.shown[number]));
    let brute = (0..first.brute.len()).map(|number| figure(&|frame| &frame.brute[number]));
    [methods.collect(), brute.collect()]
}

fn some(looks: &[Look], pixels: &[usize]) -> Picture {
    let pixels: Vec<[f32; 3]> = pixels.iter().map(|&pixel| looks[pixel].lit.map(|part| part as f32)).collect();
    Picture { width: pixels.len(), height: 1, pixels }
}
