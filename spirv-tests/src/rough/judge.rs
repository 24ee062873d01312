//! Every method on every view under every light against the truth, over several surfaces.

use super::known::{self, Known};
use super::method::{Method, Renderer, Shown};
use super::relief::relief;
use super::scene::{self, LIGHTS};
use super::surface::surface;
use super::tally::{Quantity, Tally};
use super::truth::{Scenery, Seen, WIDE};
use super::Error;
use crate::gap::figure::Figure;
use crate::imaging::pixel::Pixel;
use crate::imaging::region::Region;
use crate::imaging::taps::ALL_TAPS;
use crate::imaging::view::View;
use prefilter::gpu::Device;

/// The share of the variance of heights from which a pixel that loses it is far.
const FAR: f64 = 0.99;

/// Lights.
const COUNT: usize = LIGHTS.len();

/// How much is done.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Extent {
    /// Width and height of the pictures.
    pub size: [usize; 2],
    /// Strata an axis of each of the two halves of the truth.
    pub strata: usize,
    /// Surfaces.
    pub seeds: usize,
}

impl Extent {
    /// Rows of pixels that [`judge`] finds the truth of, for a progress bar.
    pub fn rows(self) -> u64 {
        (2 * self.size[1] * scene::views(self.size).len() * self.seeds) as u64
    }
}

/// A pixel's colors: of what is seen, of what is lit of it, and the share that is lit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Look {
    /// Mean color of all that is seen.
    pub color: [f64; 3],
    /// Mean color of what is seen and lit.
    pub lit: [f64; 3],
    /// The share of what is seen that is lit.
    pub share: f64,
}

impl Look {
    /// What is seen, under a light.
    pub fn of(seen: &Seen<COUNT>, light: usize) -> Self {
        let share = seen.share[light];
        Self { color: seen.color, lit: seen.lit[light].map(|channel| channel / share), share }
    }

    /// The mean of taps: of what is lit by how much that is.
    pub fn shown(taps: &[Shown]) -> Self {
        let count = taps.len() as f64;
        let share = taps.iter().map(|tap| tap.share).sum::<f64>();
        let mean = |of: &dyn Fn(&Shown, usize) -> f64, weight: f64| {
            std::array::from_fn(|channel| taps.iter().map(|tap| of(tap, channel)).sum::<f64>() / weight)
        };
        let color = mean(&|tap, channel| tap.color[channel], count);
        // Where nothing is lit it makes no difference what would be.
        let lit = match share {
            0.0 => mean(&|tap, channel| tap.lit[channel], count),
            _ => mean(&|tap, channel| tap.share * tap.lit[channel], share),
        };
        Self { color, lit, share: share / count }
    }

    /// What reaches the eye of the light's: the colors that are lit, the others being black.
    pub fn lighted(&self) -> [f64; 3] {
        self.lit.map(|channel| if self.share == 0.0 { 0.0 } else { self.share * channel })
    }
}

/// A view under a light, on the first surface.
#[derive(Clone, Debug)]
pub struct Panel {
    /// The view.
    pub view: View,
    /// The light.
    pub light: usize,
    /// The truth.
    pub truth: Vec<Look>,
    /// What each method shows, in the order of [`Method::ALL`].
    pub shown: Vec<Vec<Look>>,
}

/// The errors of a view under a light, surface by surface.
#[derive(Clone, Debug)]
pub struct Row {
    /// The view.
    pub view: View,
    /// The light.
    pub light: usize,
    /// Of each method, in the order of [`Method::ALL`], over the surfaces.
    pub methods: Vec<Vec<Tally>>,
    /// The standard errors of the truth, over the surfaces.
    pub truth: Vec<Tally>,
}

impl Row {
    /// Root mean square error of a method over all surfaces, without the variance of the truth; in a region, or of all
    /// pixels. NaN where there is none.
    pub fn rms(&self, method: Method, quantity: Quantity, region: Option<Region>) -> f64 {
        self.figure(method, quantity, region).value
    }

    /// The same with its standard error over surfaces.
    pub fn figure(&self, method: Method, quantity: Quantity, region: Option<Region>) -> Figure {
        let surfaces: Vec<(&Tally, &Tally)> = self.methods[method.number()].iter().zip(&self.truth).collect();
        let [figure] = Figure::jackknife(&surfaces, |some| {
            let [shown, truth] = [0, 1].map(|which| {
                let tallies = some.iter().map(|pair| if which == 0 { pair.0 } else { pair.1 });
                Tally::rms(tallies, quantity, region)
            });
            let left = shown * shown - truth * truth;
            // The truth's error is independent of the method's and no fault of it.
            [if left < 0.0 { 0.0 } else { left.sqrt() }]
        });
        figure
    }

    /// The standard error of the truth.
    pub fn truth_error(&self, quantity: Quantity, region: Option<Region>) -> f64 {
        Tally::rms(&self.truth, quantity, region)
    }
}

/// Everything that is known.
#[derive(Clone, Debug)]
pub struct Judged {
    /// Strata an axis of each of the two halves of the truth.
    pub strata: usize,
    /// The pictures of the first surface.
    pub panels: Vec<Panel>,
    /// The errors over all surfaces.
    pub rows: Vec<Row>,
}

/// Judges every method. `done` is called after every row of pixels of the truth, from several threads.
///
/// # Errors
/// Those of scenes and of the device.
pub fn judge(device: &Device, extent: Extent, done: &(dyn Fn() + Sync)) -> Result<Judged, Error> {
    let (views, map) = (scene::views(extent.size), scene::map()?);
    let renderers = Method::ALL.map(|method| Renderer::new(device, map.clone(), method));
    let renderers = renderers.into_iter().collect::<Result<Vec<_>, Error>>()?;
    let mut judged = Judged { strata: extent.strata, panels: Vec::new(), rows: Vec::new() };
    let row = |view: View, light| Row { view, light, methods: vec![Vec::new(); renderers.len()], truth: Vec::new() };
    judged.rows.extend(views.iter().flat_map(|&view| (0..COUNT).map(move |light| row(view, light))));
    let (reference, pixel) = (map.reference(), Pixel::default());
    for seed in 0..extent.seeds {
        let surface = surface(seed as u32 + 1);
        let relief = relief(&surface);
        let scenery = Scenery { relief: &relief, map: &reference, pixel: &pixel, wide: WIDE };
        for (number, view) in views.iter().enumerate() {
            let half = |half: u64| {
                let seed = 2 * (seed * views.len() + number) as u64 + half;
                scenery.picture(view, &scene::lights(), extent.strata, seed, done)
            };
            let halves = [half(1), half(2)];
            let known = known::picture(&surface, view, &scene::lights());
            for light in 0..COUNT {
                let panel = panel(&renderers, *view, light, &halves, &known)?;
                let row = &mut judged.rows[number * COUNT + light];
                enter(row, &panel, &halves, &known);
                if seed == 0 {
                    judged.panels.push(panel);
                }
            }
        }
    }
    Ok(judged)
}

/// The mean of both halves, and what the methods show.
fn panel(
    renderers: &[Renderer],
    view: View,
    light: usize,
    halves: &[Vec<Seen<COUNT>>; 2],
    known: &[[Known<COUNT>; ALL_TAPS]],
) -> Result<Panel, Error> {
    let truth = halves[0].iter().zip(&halves[1]).map(|(one, other)| Look::of(&one.mean(other), light)).collect();
    let shown = renderers.iter().map(|renderer| {
        let shown = renderer.shown(known.as_flattened(), light, scene::lights()[light])?;
        Ok(shown.chunks_exact(ALL_TAPS).map(Look::shown).collect())
    });
    Ok(Panel { view, light, truth, shown: shown.collect::<Result<_, Error>>()? })
}

/// Adds up the errors of a panel.
fn enter(row: &mut Row, panel: &Panel, halves: &[Vec<Seen<COUNT>>; 2], known: &[[Known<COUNT>; ALL_TAPS]]) {
    let regions: Vec<Region> = known.iter().map(|known| Region::of(known[0].deviation.powi(2), FAR)).collect();
    for (tallies, shown) in row.methods.iter_mut().zip(&panel.shown) {
        let mut tally = Tally::default();
        for ((shown, truth), region) in shown.iter().zip(&panel.truth).zip(&regions) {
            tally.add(shown, truth, truth.share, *region);
        }
        tallies.push(tally);
    }
    let mut tally = Tally::default();
    let looks = halves.each_ref().map(|half| half.iter().map(|seen| Look::of(seen, panel.light)));
    let [first, second] = looks;
    for (((one, other), truth), region) in first.zip(second).zip(&panel.truth).zip(&regions) {
        tally.add(&one, &other, truth.share, *region);
    }
    // The mean of two has half the deviation of their difference.
    row.truth.push(tally.scaled(0.25));
}
