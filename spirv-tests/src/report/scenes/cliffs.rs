//! The scene of mountains, colored by height and steepness in the light of two skies.

use super::frame::Shown;
use super::measured::{Measured, Method as Entry, Weight};
use super::progress::Progress;
use super::rays::{kept, Amount, Shots, Stage};
use super::shown;
use crate::cliffs::ground::Ground;
use crate::cliffs::known::Tracer;
use crate::cliffs::method::{modules, plain, Method, Renderer};
use crate::cliffs::scene::{skies, suns, views, Materials, LIGHTS, PLACES};
use crate::cliffs::truth::Scenery;
use crate::imaging::look::Look;
use crate::imaging::picture::Picture;
use crate::imaging::pixel::Pixel;
use crate::imaging::taps::ALL_TAPS;
use crate::imaging::view::View;
use crate::report::document::Item;
use crate::report::timing;
use crate::report::{Bench, Error, Extent};
use prefilter::Module;

const FULL: Amount = Amount { size: [72, 36], moving: [36, 18], frames: 8, strata: 32, blocks: 4 };
const QUICK: Amount = Amount { size: [42, 21], moving: [18, 10], frames: 4, strata: 16, blocks: 2 };

/// The view that moves and that is timed.
const OBLIQUE: usize = 1;

/// Steps of this scene.
pub fn steps(extent: Extent) -> u64 {
    extent.pick(30, 600)
}

/// The ground and what colors it.
struct Mountains<'a> {
    bench: &'a Bench<'a>,
    scenery: &'a Scenery,
    tracer: &'a Tracer,
    place: [f64; 2],
    /// Of each sky.
    renderers: &'a [Vec<Renderer>],
    progress: &'a Progress<'a>,
}

/// All that the truth depends on.
const PROGRAM: &str = concat!(
    include_str!("cliffs.rs"),
    include_str!("../../cliffs/truth.rs"),
    include_str!("../../cliffs/ground.rs"),
    include_str!("../../cliffs/scene.rs"),
    include_str!("../../imaging/relief.rs"),
    include_str!("../../imaging/view.rs"),
    include_str!("../../imaging/pixel.rs"),
);

impl Stage for Mountains<'_> {
    type View = View;

    fn sampled(&self, view: &View, strata: usize, seed: u64) -> Result<Vec<Look>, Error> {
        let inputs = format!("{:?}", (view, strata, seed, self.place, self.scenery.skies));
        kept(self.bench.cache, &[PROGRAM, &inputs], LIGHTS.len() * view.width * view.height, || {
            let row = (view.width * strata * strata) as u64;
            let pictures = self.scenery.pictures(view, self.place, strata, seed, &|| self.progress.add(row));
            Ok(pictures.iter().flat_map(looks).collect())
        })
    }

    fn shown(&self, view: &View) -> Result<Vec<Vec<Look>>, Error> {
        let known = self.tracer.picture(view, self.place)?;
        let mut shown = vec![Vec::new(); Method::REPORTED.len()];
        for renderers in self.renderers {
            for (shown, renderer) in shown.iter_mut().zip(renderers) {
                shown.extend(looks(&renderer.picture(&known, view.width)?));
            }
        }
        Ok(shown)
    }
}

fn looks(picture: &Picture) -> Vec<Look> {
    let look = |pixel: &[f32; 3]| Look { color: pixel.map(f64::from), lit: pixel.map(f64::from), share: 1.0 };
    picture.pixels.iter().map(look).collect()
}

/// What the report shows of it.
///
/// # Errors
/// Those of scenes and of the device.
pub fn items(bench: &Bench<'_>) -> Result<Vec<Item>, Error> {
    let amount = bench.extent.pick(QUICK, FULL);
    let progress = Progress::new(bench.done, amount.rays(3 * amount.size[0] * amount.size[1]), steps(bench.extent));
    let (ground, materials, skies) = (Ground::new()?, Materials::new()?, skies()?);
    let renderers = skies.map(|sky| {
        let of_sky = Method::REPORTED.map(|method| Renderer::new(bench.timed, &materials, sky, method));
        of_sky.into_iter().collect::<Result<Vec<_>, Error>>()
    });
    let renderers = renderers.into_iter().collect::<Result<Vec<_>, Error>>()?;
    let scenery = Scenery { relief: ground.relief(), palette: materials.palette(), skies, pixel: Pixel::default() };
    let (tracer, mut shots) = (Tracer::new(bench.timed, &ground)?, Shots::default());
    let stage = |place| Mountains {
        bench,
        scenery: &scenery,
        tracer: &tracer,
        place,
        renderers: &renderers,
        progress: &progress,
    };
    for (place, number) in PLACES.into_iter().zip(0..amount.blocks) {
        shots.still(&stage(place), &views(amount.size), amount.strata, number)?;
    }
    let moved = |pan, zoom| views(amount.moving)[OBLIQUE].moved(pan, zoom);
    shots.moving(&stage(PLACES[0]), &moved, amount.strata.min(16), amount.frames)?;
    let measured = measured(&amount, &stage(PLACES[0]), &materials, &shots)?;
    progress.end();
    Ok(shown("scenes_cliffs", TITLE, &measured, &pictures(&shots, &measured, amount.size)))
}

const TITLE: &str =
    "Mountains, colored by height and steepness in the light of skies with a sun behind and a sun ahead";

fn measured(amount: &Amount, stage: &Mountains<'_>, materials: &Materials, shots: &Shots) -> Result<Measured, Error> {
    let known = stage.tracer.picture(&views(amount.size)[OBLIQUE], stage.place)?;
    let first = &stage.renderers[0][0];
    let times = timing::times_over(known.len(), |times| first.prepare(&known.repeat(times)))?;
    let known = known.repeat(times);
    let kernels = stage.renderers[0].iter().map(|renderer| renderer.prepare(&known));
    let seconds = timing::fastest(&kernels.collect::<Result<Vec<_>, Error>>()?, stage.bench.extent)?;
    let (taps, sky) = (known.len() as f64, stage.scenery.skies[0]);
    let ([colors, light], plain) = (modules(materials, sky)?, plain(materials, sky)?);
    let entry = |(number, method): (usize, Method)| {
        let called: Vec<&Module> = match method {
            Method::Plain => plain.iter().collect(),
            // Of its exports, the one of color times light is the most expensive.
            Method::Joint => vec![&colors],
            _ => vec![&colors, &light],
        };
        let weight = Weight::of(&called, 0);
        // The export of color alone is not the most expensive of its module: nothing is known of its operations.
        let weight = match method {
            Method::Plain | Method::Joint => weight,
            _ => Weight { operations: None, ..weight },
        };
        Entry {
            label: method.label().into(),
            seconds: seconds[number] / taps * ALL_TAPS as f64,
            naive: Some(seconds[0] / taps * ALL_TAPS as f64),
            weight,
            shimmer: shots.methods[number],
        }
    };
    Ok(Measured {
        methods: Method::REPORTED.into_iter().enumerate().map(entry).collect(),
        brute: shots.brute(amount.strata),
        stills: shots.stills.clone(),
        sample: seconds[0] / taps,
        over: format!(
            "Light that reaches the eye. A pixel has {ALL_TAPS} taps. Standard errors: over {} places, of \
             shimmer over parts of the oblique view. Brute force: the naive kernel as many times as it has \
             samples, without its rays.",
            amount.blocks
        ),
    })
}

fn pictures(shots: &Shots, measured: &Measured, size: [usize; 2]) -> Vec<super::View> {
    let labels: Vec<String> = measured.methods.iter().map(|method| method.label.clone()).collect();
    let all = views(size).into_iter().zip(&shots.first).flat_map(|(view, frame)| {
        let labels = &labels;
        (0..LIGHTS.len()).map(move |light| {
            let title = format!("{}, {}", view.title, suns(&view)[light]);
            frame.view(title, labels, &Shown { size, light, shade: &|look| look.lit, behind: [0.0; 3] })
        })
    });
    all.collect()
}
