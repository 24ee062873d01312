//! A camera that moves away: over the hand-over from displaced geometry to the filter, what shimmers and jumps.

use super::scene;
use super::studio::{Noise, Seen};
use super::Error;
use crate::imaging::camera::View;
use crate::imaging::look::{Look, Quantity};
use crate::imaging::picture::Picture;
use crate::imaging::shimmer::{largest_jump, shimmer};

/// How much is done.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Extent {
    /// Width and height of the frames.
    pub size: [usize; 2],
    /// Strata an axis of each of the two halves of the truth.
    pub strata: usize,
    /// Frames.
    pub count: usize,
}

impl Extent {
    /// The frames.
    pub fn frames(self) -> Vec<View> {
        scene::frames(self.size, self.strata, self.count)
    }
}

/// How unsteady frames are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unsteady {
    /// Deviation over the frames of (result − truth), root mean square over the pixels.
    pub shimmer: f64,
    /// The largest change of that from a frame to the next, root mean square over the pixels.
    pub jump: f64,
    /// Wavelengths that a pixel is wide where it is.
    pub at: f64,
}

/// The zoom on a surface.
#[derive(Clone, Debug)]
pub struct Zoomed {
    /// The surface.
    pub material: &'static str,
    /// Of the methods in the order of [`Method::ALL`](super::method::Method::ALL), by quantity.
    pub methods: Vec<[Unsteady; 2]>,
    /// What of that the truth's own errors make.
    pub truth: [Unsteady; 2],
}

/// Zooms on a surface over a noise.
///
/// # Errors
/// Those of the device.
pub fn zoom(noise: &Noise<'_>, extent: Extent, done: &(dyn Fn(u64) + Sync)) -> Result<Zoomed, Error> {
    let views = extent.frames();
    let looked = views.iter().zip(1000..).map(|(view, seed)| noise.look(view, seed, done));
    let seen = looked.collect::<Result<Vec<_>, Error>>()?;
    let width = |frame: usize| views.get(frame).map_or(f64::NAN, scene::pixel);
    let unsteady = |of: &dyn Fn(&Seen) -> &[Look], other: &dyn Fn(&Seen) -> &[Look]| {
        Quantity::ALL.map(|quantity| {
            let [shown, truth] = [of, other]
                .map(|of| seen.iter().map(|seen| picture(of(seen), quantity, extent.size)).collect::<Vec<_>>());
            let (jump, frame) = largest_jump(&shown, &truth);
            Unsteady { shimmer: shimmer(&shown, &truth), jump, at: width(frame) }
        })
    };
    let methods = 0..noise.studio.methods();
    // The mean of two halves has half the deviation of their difference.
    let half = |of: Unsteady| Unsteady { shimmer: 0.5 * of.shimmer, jump: 0.5 * of.jump, ..of };
    Ok(Zoomed {
        material: noise.studio.material.name,
        methods: methods.map(|method| unsteady(&|seen| &seen.shown[method], &|seen| &seen.truth)).collect(),
        truth: unsteady(&|seen| &seen.halves[0], &|seen| &seen.halves[1]).map(half),
    })
}

fn picture(looks: &[Look], quantity: Quantity, [width, height]: [usize; 2]) -> Picture {
    let pixels = looks.iter().map(|look| quantity.of(look).map(|part| part as f32)).collect();
    Picture { width, height, pixels }
}
