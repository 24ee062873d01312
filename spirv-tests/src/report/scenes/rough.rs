//! The scene of a rough surface, colored by height and lit by two suns.

use super::frame::Shown;
use super::measured::{Measured, Method as Entry, Weight};
use super::progress::Progress;
use super::rays::{kept, Amount, Shots, Stage};
use super::shown;
use crate::imaging::look::Look;
use crate::imaging::pixel::Pixel;
use crate::imaging::relief::Relief;
use crate::imaging::taps::ALL_TAPS;
use crate::imaging::view::View;
use crate::imaging::waves::Waves;
use crate::report::document::Item;
use crate::report::timing;
use crate::report::{Bench, Error, Extent};
use crate::rough::judge::Look as Seen;
use crate::rough::known;
use crate::rough::method::{Method, Renderer};
use crate::rough::relief::relief;
use crate::rough::scene::{lights, map, suns, views, LIGHTS};
use crate::rough::surface::surface;
use crate::rough::truth::Scenery;
use prefilter::reference::texture::PiecewiseLinear;
use std::cell::OnceCell;

const FULL: Amount = Amount { size: [54, 42], moving: [32, 20], frames: 8, strata: 32, blocks: 4 };
// Of fewer rows the first would see the sky in the grazing view.
const QUICK: Amount = Amount { size: [24, 42], moving: [16, 10], frames: 4, strata: 16, blocks: 2 };

/// The view that moves and that is timed.
const OBLIQUE: usize = 1;

/// Steps of this scene.
pub fn steps(extent: Extent) -> u64 {
    extent.pick(30, 600)
}

/// A surface and what colors it.
struct Surface<'a> {
    bench: &'a Bench<'a>,
    waves: Waves,
    relief: OnceCell<Relief>,
    map: &'a PiecewiseLinear,
    pixel: &'a Pixel,
    renderers: &'a [Renderer],
    progress: &'a Progress<'a>,
}

/// All that the truth depends on.
const PROGRAM: &str = concat!(
    include_str!("rough.rs"),
    include_str!("../../rough/truth.rs"),
    include_str!("../../rough/relief.rs"),
    include_str!("../../rough/surface.rs"),
    include_str!("../../rough/scene.rs"),
    include_str!("../../imaging/relief.rs"),
    include_str!("../../imaging/waves.rs"),
    include_str!("../../imaging/view.rs"),
    include_str!("../../imaging/pixel.rs"),
);

impl Stage for Surface<'_> {
    type View = View;

    fn sampled(&self, view: &View, strata: usize, seed: u64) -> Result<Vec<Look>, Error> {
        let inputs = format!("{:?}", (view, strata, seed, &self.waves));
        let pixels = view.width * view.height;
        kept(self.bench.cache, &[PROGRAM, &inputs], LIGHTS.len() * pixels, || {
            let relief = self.relief.get_or_init(|| relief(&self.waves));
            // As many samples of every pixel: brute force is judged, too.
            let scenery = Scenery { relief, map: self.map, pixel: self.pixel, wide: f64::INFINITY };
            let row = (view.width * strata * strata) as u64;
            let seen = scenery.picture(view, &lights(), strata, seed, &|| self.progress.add(row));
            let under = |light: usize| seen.iter().map(move |seen| look(&Seen::of(seen, light)));
            Ok((0..LIGHTS.len()).flat_map(under).collect())
        })
    }

    fn shown(&self, view: &View) -> Result<Vec<Vec<Look>>, Error> {
        let known = known::picture(&self.waves, view, &lights());
        let shown = self.renderers.iter().map(|renderer| {
            let mut looks = Vec::new();
            for (light, &toward) in lights().iter().enumerate() {
                let shown = renderer.shown(known.as_flattened(), light, toward)?;
                looks.extend(shown.chunks_exact(ALL_TAPS).map(|taps| look(&Seen::shown(taps))));
            }
            Ok(looks)
        });
        shown.collect()
    }
}

/// The light that reaches the eye of the sun's, and all that is seen.
fn look(seen: &Seen) -> Look {
    Look { color: seen.color, lit: seen.lighted(), share: 1.0 }
}

/// What the report shows of it.
///
/// # Errors
/// Those of scenes and of the device.
pub fn items(bench: &Bench<'_>) -> Result<Vec<Item>, Error> {
    let amount = bench.extent.pick(QUICK, FULL);
    let progress = Progress::new(bench.done, amount.rays(3 * amount.size[0] * amount.size[1]), steps(bench.extent));
    let (map, pixel) = (map()?, Pixel::default());
    let renderers = Method::REPORTED.map(|method| Renderer::new(bench.timed, map.clone(), method));
    let renderers = renderers.into_iter().collect::<Result<Vec<_>, Error>>()?;
    let (reference, mut shots) = (map.reference(), Shots::default());
    for seed in 0..amount.blocks {
        let stage = Surface {
            bench,
            waves: surface(seed as u32 + 1),
            relief: OnceCell::new(),
            map: &reference,
            pixel: &pixel,
            renderers: &renderers,
            progress: &progress,
        };
        shots.still(&stage, &views(amount.size), amount.strata, seed)?;
        if seed == 0 {
            let moved = |pan, zoom| views(amount.moving)[OBLIQUE].moved(pan, zoom);
            shots.moving(&stage, &moved, amount.strata.min(16), amount.frames)?;
        }
    }
    let measured = measured(bench, &amount, &renderers, &shots)?;
    progress.end();
    Ok(shown("scenes_rough", TITLE, &measured, &pictures(&shots, &measured, amount.size)))
}

const TITLE: &str = "A rough surface colored by height, from overhead to grazing, lit by a sun behind and a sun ahead";

fn measured(bench: &Bench<'_>, amount: &Amount, renderers: &[Renderer], shots: &Shots) -> Result<Measured, Error> {
    let view = views(amount.size)[OBLIQUE];
    let known = known::picture(&surface(1), &view, &lights());
    let known = known.as_flattened();
    let times = timing::times_over(known.len(), |times| renderers[0].prepare(&known.repeat(times), 0, lights()[0]))?;
    let known = known.repeat(times);
    let kernels = renderers.iter().map(|renderer| renderer.prepare(&known, 0, lights()[0]));
    let seconds = timing::fastest(&kernels.collect::<Result<Vec<_>, Error>>()?, bench.extent)?;
    let taps = known.len() as f64;
    let entry = |(number, method): (usize, Method)| {
        let weight = Weight::of(&[&method.module(map()?)?], 0);
        // It calls the color of values alone, not the heaviest function of its module.
        let operations = weight.operations.filter(|_| method != Method::Texture);
        Ok(Entry {
            label: method.label().into(),
            seconds: seconds[number] / taps * ALL_TAPS as f64,
            naive: Some(seconds[0] / taps * ALL_TAPS as f64),
            weight: Weight { operations, ..weight },
            shimmer: shots.methods[number],
        })
    };
    Ok(Measured {
        methods: Method::REPORTED.into_iter().enumerate().map(entry).collect::<Result<_, Error>>()?,
        brute: shots.brute(amount.strata),
        stills: shots.stills.clone(),
        sample: seconds[0] / taps,
        over: format!(
            "The light of the sun that reaches the eye. A pixel has {ALL_TAPS} taps. Standard errors: over {} \
             surfaces, of shimmer over parts of the oblique view. Brute force: the naive kernel as many times \
             as it has samples, without its rays.",
            amount.blocks
        ),
    })
}

/// The light of the sky, which is everywhere, and of the sun.
const SKY: [f64; 3] = [0.14, 0.18, 0.24];
const SUN: [f64; 3] = [0.88, 0.81, 0.69];

fn pictures(shots: &Shots, measured: &Measured, size: [usize; 2]) -> Vec<super::View> {
    let labels: Vec<String> = measured.methods.iter().map(|method| method.label.clone()).collect();
    let shade =
        |look: &Look| [0, 1, 2].map(|channel| SKY[channel] * look.color[channel] + SUN[channel] * look.lit[channel]);
    let all = views(size).into_iter().zip(&shots.first).flat_map(|(view, frame)| {
        let (labels, shade) = (&labels, &shade);
        (0..LIGHTS.len()).map(move |light| {
            let title = format!("{}, {}", view.title, suns(&view)[light]);
            frame.view(title, labels, &Shown { size, light, shade, behind: [0.0; 3] })
        })
    });
    all.collect()
}
