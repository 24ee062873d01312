//! The scenes of height images: terrain and gravel, on a plane to the horizon.

use super::frame::Shown;
use super::measured::{Measured, Method as Entry, Weight};
use super::progress::Progress;
use super::rays::{kept, rays, Shots, Stage};
use super::shown;
use crate::demo::input::Input;
use crate::demo::method::{Method, Renderer};
use crate::demo::plane::Plane;
use crate::demo::truth::Sampler;
use crate::imaging::look::Look;
use crate::imaging::picture::Picture;
use crate::random::Random;
use crate::report::cache;
use crate::report::document::Item;
use crate::report::timing;
use crate::report::{Bench, Error, Extent};
use prefilter::Taps;

/// How much is done.
struct Amount {
    size: [usize; 2],
    moving: [usize; 2],
    frames: usize,
    places: u32,
}

const FULL: Amount = Amount { size: [160, 120], moving: [64, 48], frames: 12, places: 4 };
const QUICK: Amount = Amount { size: [48, 36], moving: [24, 18], frames: 4, places: 2 };

/// Strata an axis of each half of the truth.
const STRATA: usize = 32;

/// Size of the pictures that are timed, at least.
const TIMED: [usize; 2] = [128, 128];

/// Steps of these scenes.
pub fn steps(extent: Extent) -> u64 {
    2 * of_each(extent)
}

fn of_each(extent: Extent) -> u64 {
    extent.pick(8, 200)
}

impl Amount {
    fn rays(&self) -> u64 {
        let pixels = |[width, height]: [usize; 2]| (width * height) as u64;
        let (still, moving) =
            (u64::from(self.places) * pixels(self.size), 2 * self.frames as u64 * pixels(self.moving));
        (still + moving) * rays(STRATA)
    }
}

/// An image and what colors it.
struct Images<'a> {
    bench: &'a Bench<'a>,
    sampler: Sampler<'a>,
    /// All that the truth depends on, but for views and samples.
    program: String,
    renderers: Vec<Renderer>,
    progress: Progress<'a>,
}

impl Stage for Images<'_> {
    type View = Plane;

    fn sampled(&self, plane: &Plane, strata: usize, seed: u64) -> Result<Vec<Look>, Error> {
        let inputs = format!("{:?}", (plane, strata, seed));
        kept(self.bench.cache, &[&self.program, &inputs], plane.width * plane.height, || {
            let row = (plane.width * strata * strata) as u64;
            Ok(looks(&self.sampler.picture(plane, strata, seed, &|| self.progress.add(row))))
        })
    }

    fn shown(&self, plane: &Plane) -> Result<Vec<Vec<Look>>, Error> {
        self.renderers.iter().map(|renderer| Ok(looks(&renderer.picture(plane)?))).collect()
    }
}

fn looks(picture: &Picture) -> Vec<Look> {
    let look = |pixel: &[f32; 3]| Look { color: pixel.map(f64::from), lit: pixel.map(f64::from), share: 1.0 };
    picture.pixels.iter().map(look).collect()
}

/// What the report shows of them.
///
/// # Errors
/// Those of scenes and of the device.
pub fn items(bench: &Bench<'_>) -> Result<Vec<Item>, Error> {
    let mut items = Vec::new();
    for input in Input::all()? {
        items.extend(scene(bench, &input)?);
    }
    Ok(items)
}

fn scene(bench: &Bench<'_>, input: &Input) -> Result<Vec<Item>, Error> {
    let amount = bench.extent.pick(QUICK, FULL);
    let map = input.map.reference();
    let renderers = Method::all().into_iter().map(|method| Renderer::new(bench.timed, input, method));
    let stage = Images {
        bench,
        sampler: Sampler::new(&input.heights, &map),
        program: [
            include_str!("demo.rs"),
            include_str!("../../demo/truth.rs"),
            include_str!("../../demo/heights.rs"),
            include_str!("../../demo/plane.rs"),
            include_str!("../../imaging/pixel.rs"),
            &cache::name(&[&format!("{:?}", (&input.heights, &map))]),
        ]
        .concat(),
        renderers: renderers.collect::<Result<_, _>>()?,
        progress: Progress::new(bench.done, amount.rays(), of_each(bench.extent)),
    };
    let mut shots = Shots::default();
    for place in 0..amount.places {
        shots.still(&stage, &[seen(input, amount.size, place)], STRATA, u64::from(place))?;
    }
    let moved = |pan, zoom| seen(input, amount.moving, 0).panned(pan).zoomed(zoom);
    shots.moving(&stage, &moved, STRATA, amount.frames)?;
    let measured = measured(bench, input, &amount, &stage, &shots)?;
    stage.progress.end();
    let labels: Vec<String> = measured.methods.iter().map(|method| method.label.clone()).collect();
    let picture = Shown { size: amount.size, light: 0, shade: &|look| look.color, behind: [0.0; 3] };
    let views: Vec<super::View> =
        shots.first.iter().map(|frame| frame.view(input.title.into(), &labels, &picture)).collect();
    Ok(shown(&format!("scenes_demo_{}", input.name), input.title, &measured, &views))
}

/// The plane over one of several places of the image.
fn seen(input: &Input, [width, height]: [usize; 2], place: u32) -> Plane {
    let plane = input.plane(width, height);
    let mut random = Random::new(place);
    match place {
        0 => plane,
        _ => Plane { origin: [random.unit(), random.unit()], ..plane },
    }
}

fn measured(
    bench: &Bench<'_>,
    input: &Input,
    amount: &Amount,
    stage: &Images<'_>,
    shots: &Shots,
) -> Result<Measured, Error> {
    let size = timing::enlarged(TIMED, |size| stage.renderers[0].prepare(&seen(input, size, 0)))?;
    let (plane, methods) = (seen(input, size, 0), Method::all());
    let mut kernels = stage.renderers.iter().map(|it| it.prepare(&plane)).collect::<Result<Vec<_>, Error>>()?;
    let taps: Vec<Taps> = methods.iter().filter_map(|method| method.taps()).collect();
    for &taps in &taps {
        kernels.push(Renderer::naive(bench.timed, input, taps)?.prepare(&plane)?);
    }
    let seconds = timing::fastest(&kernels, bench.extent)?;
    let seconds: Vec<f64> = seconds.iter().map(|seconds| seconds / (size[0] * size[1]) as f64).collect();
    let naive = |method: Method| match method {
        Method::Naive | Method::Colored | Method::ColoredAlong => seconds[0],
        // The mean of the heights in the same pyramid, and the map there.
        Method::Mean | Method::Paper => seconds[1],
        Method::Ours(own) => seconds[methods.len() + taps.iter().position(|&taps| taps == own).unwrap_or(0)],
    };
    let entry = |(number, &method): (usize, &Method)| {
        let (image, module) = (method.image(input)?.bytes(), method.module(input)?);
        let weight = match method {
            Method::Colored | Method::ColoredAlong => Weight { bytes: Some(image), operations: None },
            _ => Weight::of(&[&module], image),
        };
        let (label, shimmer) = (method.label(), shots.methods[number]);
        Ok(Entry { label, seconds: seconds[number], naive: Some(naive(method)), weight, shimmer })
    };
    Ok(Measured {
        methods: methods.iter().enumerate().map(entry).collect::<Result<_, Error>>()?,
        brute: shots.brute(STRATA),
        stills: shots.stills.clone(),
        sample: seconds[0],
        over: format!(
            "Standard errors: over {} places of the image, of shimmer over parts of the picture. Brute force: \
             the naive kernel as many times as it has samples. Bytes: with the image's pyramid.",
            amount.places
        ),
    })
}
