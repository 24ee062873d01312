//! Every method on every view against the truth, over several skins.

use super::body::Body;
use super::known;
use super::mesh::Mesh;
use super::method::{Maps, Method, Renderer};
use super::scene::{self, Material, LEVELS};
use super::skin::{Skin, SIDE};
use super::stage::{stage, Stage};
use super::truth::Scenery;
use super::Error;
use crate::gap::figure::Figure;
use crate::imaging::camera::View;
use crate::imaging::look::{Look, Quantity};
use crate::imaging::measure::{root_mean_square, samples_for, sizes, Deviation};
use crate::imaging::pixel::Pixel;
use prefilter::gpu::Device;
use prefilter::{Edge, MomentMipmap};

/// Strata an axis at which brute force is measured, as far as the truth has as many.
const BRUTE: [usize; 5] = [1, 2, 4, 8, 16];

/// Texels a side of the level that casts shadows in pictures.
const COARSE: usize = 64;

/// How much is done.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Extent {
    /// Width and height of the pictures.
    pub size: [usize; 2],
    /// Strata an axis of each of the two halves of the truth, view by view.
    pub strata: [usize; 3],
    /// Skins.
    pub seeds: usize,
}

impl Extent {
    fn views(self) -> [View; 3] {
        scene::views(self.size, self.strata)
    }

    /// Rays that [`judge`] shoots, for a progress bar.
    pub fn rays(self) -> u64 {
        let rays = |view: &View| {
            let strata = [view.strata; 2].into_iter().chain(brute(view));
            (view.width * view.height) as u64 * strata.map(|strata| (strata * strata) as u64).sum::<u64>()
        };
        self.seeds as u64 * self.views().iter().map(rays).sum::<u64>()
    }
}

fn brute(view: &View) -> impl Iterator<Item = usize> + '_ {
    BRUTE.into_iter().filter(|&strata| strata <= view.strata)
}

/// Errors of a picture's pixels, skin by skin: of the worst channel, times the share of the pixel that the snake
/// covers.
pub type Errors = Vec<Vec<f32>>;

/// The errors of those pixels of a picture in which the snake is seen by both.
fn errors(quantity: Quantity, shown: &[Look], truth: &[Look]) -> Vec<f32> {
    shown.iter().zip(truth).filter_map(|(shown, truth)| quantity.error(shown, truth)).collect()
}

/// What is known of a view.
#[derive(Clone, Debug)]
pub struct Row {
    /// The view.
    pub view: View,
    /// The true picture of the first skin.
    pub truth: Vec<Look>,
    /// What its pictures show besides.
    pub stage: Vec<Stage>,
    /// What each method shows of it, in the order of [`Method::ALL`].
    pub shown: Vec<Vec<Look>>,
    /// Errors of the methods, by quantity.
    pub errors: Vec<[Errors; 2]>,
    /// Standard errors of the truth.
    pub truth_errors: [Errors; 2],
    /// Errors of brute force by strata an axis.
    pub brute: Vec<(usize, [Errors; 2])>,
}

impl Row {
    fn new(view: View) -> Self {
        let brute = brute(&view).map(|strata| (strata, Default::default())).collect();
        let errors = vec![Default::default(); Method::ALL.len()];
        Self {
            view,
            truth: Vec::new(),
            stage: Vec::new(),
            shown: Vec::new(),
            errors,
            truth_errors: Default::default(),
            brute,
        }
    }

    /// Root mean square error of a method over all skins, without the variance of the truth, and its standard error
    /// over skins.
    pub fn rms(&self, method: Method, quantity: Quantity) -> Figure {
        self.figure(&self.errors[method as usize][quantity as usize], quantity)
    }

    /// The error that 99 pixels in 100 stay below, and the largest.
    pub fn sizes(&self, method: Method, quantity: Quantity) -> Deviation {
        sizes(self.errors[method as usize][quantity as usize].concat())
    }

    /// The standard error of the truth.
    pub fn truth_error(&self, quantity: Quantity) -> f64 {
        root_mean_square(&self.truth_errors[quantity as usize].concat())
    }

    /// Stratified samples a pixel at which brute force is as far from the truth.
    pub fn samples(&self, method: Method, quantity: Quantity) -> Result<f64, usize> {
        samples_for(self.rms(method, quantity).value, &self.brute(quantity))
    }

    /// Root mean square errors of brute force by samples a pixel.
    pub fn brute(&self, quantity: Quantity) -> Vec<(usize, f64)> {
        let of = |(strata, errors): &(usize, [Errors; 2])| {
            (strata * strata, self.figure(&errors[quantity as usize], quantity).value)
        };
        self.brute.iter().map(of).collect()
    }

    fn figure(&self, errors: &Errors, quantity: Quantity) -> Figure {
        let skins: Vec<(&Vec<f32>, &Vec<f32>)> = errors.iter().zip(&self.truth_errors[quantity as usize]).collect();
        let [figure] = Figure::jackknife(&skins, |some| {
            let square = |errors: &[f32]| root_mean_square(errors).powi(2);
            // The truth's error is independent of the method's and no fault of it.
            let left: f64 = some.iter().map(|skin| square(skin.0) - square(skin.1)).sum::<f64>() / some.len() as f64;
            [if left < 0.0 { 0.0 } else { left.sqrt() }]
        });
        figure
    }
}

/// Everything that is known.
#[derive(Clone, Debug)]
pub struct Judged {
    /// The views.
    pub rows: Vec<Row>,
}

/// Judges every method. `done` is told how many rays have been shot, from several threads.
///
/// # Errors
/// Those of scenes and of the device.
pub fn judge(device: &Device, extent: Extent, done: &(dyn Fn(u64) + Sync)) -> Result<Judged, Error> {
    let (body, material, pixel) = (Body::new(), Material::new()?, Pixel::default());
    let renderers = Method::ALL.map(|method| Renderer::new(device, &material, method));
    let renderers = renderers.into_iter().collect::<Result<Vec<_>, Error>>()?;
    let (green, red) = (material.green.reference(), material.red.reference());
    let mut rows = extent.views().map(Row::new);
    let coarse = body.mesh(&[0.0; COARSE * COARSE], (SIDE / COARSE).ilog2() as usize);
    for seed in 0..extent.seeds {
        let skin = Skin::new(seed as u32 + 1);
        let (maps, mesh) = (Maps::new(device, &skin)?, body.mesh(&skin.heights, 0));
        let heights = MomentMipmap::new(SIDE as u32, SIDE as u32, &skin.heights, Edge::Repeat)?;
        let scenery = Scenery {
            body: &body,
            skin: &skin,
            mesh: &mesh,
            green: &green,
            red: &red,
            light: &material.light,
            pixel: &pixel,
        };
        for (row, level) in rows.iter_mut().zip(LEVELS) {
            let view = row.view;
            let sampled = |strata: usize, number: usize| {
                let rays = (view.width * strata * strata) as u64;
                scenery.picture(&view, strata, (16 * seed + number) as u64, &|| done(rays))
            };
            let resolved = displaced(&body, &heights, level);
            let known = known::picture(&body, resolved.as_ref().unwrap_or(&mesh), level, &view);
            let shown = renderers.iter().map(|renderer| renderer.shown(&maps, &known));
            if seed == 0 {
                row.stage = stage(&body, &coarse, &view);
            }
            enter(row, shown.collect::<Result<Vec<_>, Error>>()?, &sampled);
        }
    }
    Ok(Judged { rows: rows.into() })
}

/// The body with the means of the heights over the texels of a level; None for the level of all heights.
pub fn displaced(body: &Body, heights: &MomentMipmap, level: usize) -> Option<Mesh> {
    let means: Vec<f32> = heights.levels().get(level)?.texels.iter().step_by(2).copied().collect();
    (level > 0).then(|| body.mesh(&means, level))
}

/// Adds what methods show of a skin, and how far it is from the truth: strata and a number to pictures.
fn enter(row: &mut Row, shown: Vec<Vec<Look>>, sampled: &dyn Fn(usize, usize) -> Vec<Look>) {
    let halves = [sampled(row.view.strata, 0), sampled(row.view.strata, 1)];
    let truth: Vec<Look> = halves[0].iter().zip(&halves[1]).map(|(one, other)| Look::mean(&[*one, *other])).collect();
    let brute: Vec<Vec<Look>> = (2..).zip(&row.brute).map(|(number, brute)| sampled(brute.0, number)).collect();
    for quantity in Quantity::ALL {
        for (series, shown) in row.errors.iter_mut().zip(&shown) {
            series[quantity as usize].push(errors(quantity, shown, &truth));
        }
        for ((_, series), shown) in row.brute.iter_mut().zip(&brute) {
            series[quantity as usize].push(errors(quantity, shown, &truth));
        }
        // The mean of two has half the deviation of their difference.
        let apart = errors(quantity, &halves[0], &halves[1]);
        row.truth_errors[quantity as usize].push(apart.iter().map(|error| 0.5 * error).collect());
    }
    if row.shown.is_empty() {
        (row.truth, row.shown) = (truth, shown);
    }
}
