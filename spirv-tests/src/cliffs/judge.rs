//! Every method on every view under every sky against the truth, from over several places.

use super::ground::Ground;
use super::known::{Known, Tracer};
use super::method::{Method, Renderer};
use super::model::{self, Taps};
use super::scene::{self, Materials, LIGHTS, PLACES};
use super::truth::Scenery;
use super::Error;
use crate::imaging::measure::errors;
use crate::imaging::picture::Picture;
use crate::imaging::pixel::Pixel;
use crate::imaging::region::Region;
use crate::imaging::tally::Errors;
use crate::imaging::taps::ALL_TAPS;
use crate::imaging::view::View;
use prefilter::gpu::Device;

/// The share of the variance of slopes from which a pixel that loses it is far.
const FAR: f64 = 0.9;

/// Strata an axis at which brute force is measured.
pub const BRUTE: [usize; 4] = [1, 2, 4, 8];

/// How much is done.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Extent {
    /// Width and height of the pictures.
    pub size: [usize; 2],
    /// Strata an axis of each of the two halves of the truth.
    pub strata: usize,
    /// Places, of [`PLACES`].
    pub places: usize,
    /// Every how many taps of a picture from over a place are modeled.
    pub modeled: usize,
}

impl Extent {
    /// Rows of pixels that [`judge`] finds the truth of, for a progress bar.
    pub fn rows(self) -> u64 {
        (2 * self.size[1] * scene::views(self.size).len() * self.places) as u64
    }
}

/// A view under a sky, from over the first place.
#[derive(Clone, Debug)]
pub struct Panel {
    /// The view.
    pub view: View,
    /// The sky.
    pub light: usize,
    /// The truth.
    pub truth: Picture,
    /// What each method shows, in the order of [`Method::ALL`].
    pub shown: Vec<Picture>,
    /// What each pixel resolves.
    pub regions: Vec<Region>,
}

/// The errors of a view under a sky, place by place.
#[derive(Clone, Debug)]
pub struct Row {
    /// The view.
    pub view: View,
    /// The sky.
    pub light: usize,
    /// From over each place.
    pub places: Vec<Errors>,
    /// Some taps from over each place, against the model.
    pub taps: Vec<Taps>,
}

/// Everything that is known.
#[derive(Clone, Debug)]
pub struct Judged {
    /// Strata an axis of each of the two halves of the truth.
    pub strata: usize,
    /// The pictures from over the first place.
    pub panels: Vec<Panel>,
    /// The errors from over all places.
    pub rows: Vec<Row>,
}

/// The ground with all that looks at it.
struct Studio<'a> {
    scenery: Scenery,
    tracer: Tracer,
    /// Of each sky, in the order of [`Method::ALL`].
    renderers: Vec<Vec<Renderer>>,
    /// Variances of slopes along both axes over the ground.
    slopes: [f64; 2],
    extent: Extent,
    done: &'a (dyn Fn() + Sync),
}

/// Judges every method. `done` is called after every row of pixels of the truth, from several threads.
///
/// # Errors
/// Those of scenes and of the device.
pub fn judge(device: &Device, extent: Extent, done: &(dyn Fn() + Sync)) -> Result<Judged, Error> {
    let studio = Studio::new(device, extent, done)?;
    let mut judged = Judged { strata: extent.strata, panels: Vec::new(), rows: Vec::new() };
    for (number, view) in scene::views(extent.size).iter().enumerate() {
        let row = |light| Row { view: *view, light, places: Vec::new(), taps: Vec::new() };
        let mut rows: Vec<Row> = (0..LIGHTS.len()).map(row).collect();
        for (at, &place) in PLACES.iter().take(extent.places).enumerate() {
            let panels = studio.look(&mut rows, place, (100 * (number * PLACES.len() + at)) as u64)?;
            if at == 0 {
                judged.panels.extend(panels);
            }
        }
        judged.rows.extend(rows);
    }
    Ok(judged)
}

impl<'a> Studio<'a> {
    fn new(device: &Device, extent: Extent, done: &'a (dyn Fn() + Sync)) -> Result<Self, Error> {
        let (ground, materials, skies) = (Ground::new()?, Materials::new()?, scene::skies()?);
        let renderers = skies.map(|sky| Method::ALL.map(|method| Renderer::new(device, &materials, sky, method)));
        let renderers = renderers.into_iter().map(|some| some.into_iter().collect());
        Ok(Self {
            scenery: Scenery { relief: ground.relief(), palette: materials.palette(), skies, pixel: Pixel::default() },
            tracer: Tracer::new(device, &ground)?,
            renderers: renderers.collect::<Result<_, _>>()?,
            slopes: ground.whole()?.1,
            extent,
            done,
        })
    }

    /// Adds what is seen of a view from over a place to its rows, and returns it.
    fn look(&self, rows: &mut [Row], place: [f64; 2], seed: u64) -> Result<Vec<Panel>, Error> {
        let Some(view) = rows.first().map(|row| row.view) else { return Ok(Vec::new()) };
        let scenery = &self.scenery;
        let half = |half: u64| scenery.pictures(&view, place, self.extent.strata, seed + half, self.done);
        let halves = [half(1), half(2)];
        let brute = BRUTE.map(|strata| scenery.pictures(&view, place, strata, seed + 10 + strata as u64, &|| ()));
        let known = self.tracer.picture(&view, place)?;
        let regions = regions(&known, self.slopes);
        let some: Vec<Known> = known.iter().step_by(self.extent.modeled).copied().collect();
        let models = model::all(&some, &scenery.palette, &scenery.skies);
        let panel = |row: &mut Row| {
            let (light, renderers) = (row.light, &self.renderers[row.light]);
            let truth = halves[0][light].mean(&halves[1][light]);
            let shown = renderers.iter().map(|renderer| renderer.picture(&known, view.width));
            let shown = shown.collect::<Result<Vec<_>, Error>>()?;
            let apart = errors(&halves[0][light], &halves[1][light]);
            row.places.push(Errors {
                regions: regions.clone(),
                methods: shown.iter().map(|shown| errors(shown, &truth)).collect(),
                brute: brute.iter().map(|pictures| errors(&pictures[light], &truth)).collect(),
                // The mean of two has half the deviation of their difference.
                truth: apart.iter().map(|error| 0.5 * error).collect(),
            });
            let colors = renderers.iter().map(|renderer| renderer.colors(&some));
            row.taps.push(Taps::new(&models, light, &colors.collect::<Result<Vec<_>, Error>>()?));
            Ok(Panel { view, light, truth, shown, regions: regions.clone() })
        };
        rows.iter_mut().map(panel).collect()
    }
}

/// What each pixel resolves, by the variance of slopes over the ground.
fn regions(known: &[Known], slopes: [f64; 2]) -> Vec<Region> {
    let lost = |tap: &Known| f64::from(tap.covariance[0] + tap.covariance[2]) / (slopes[0] + slopes[1]);
    let mean = |taps: &[Known]| taps.iter().map(lost).sum::<f64>() / taps.len() as f64;
    known.chunks_exact(ALL_TAPS).map(|taps| Region::of(mean(taps), FAR)).collect()
}
