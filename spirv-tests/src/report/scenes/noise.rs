//! The scenes of noise: a plane under two color maps, and blocks.

use super::measured::{Brute, Measured, Method as Entry, Weight};
use super::progress::Progress;
use super::sheet::{Panel, View};
use super::shown;
use crate::demo::motion::Motion;
use crate::noise::input::{Ground, Input};
use crate::noise::judge::{judge, Extent as Amount, Judged, BRUTE};
use crate::noise::method::{Method, Renderer};
use crate::noise::sheet::Shown;
use crate::noise::truth::{Sampler, SAME};
use crate::report::document::Item;
use crate::report::timing;
use crate::report::{Bench, Error, Extent};

const FULL: Amount = Amount {
    still: [[48, 36], [108, 46]],
    moving: [[48, 36], [72, 30]],
    frames: 8,
    strata: [32, 16],
    seeds: 4,
    moved: BRUTE.len(),
};
const QUICK: Amount = Amount {
    still: [[32, 24], [36, 15]],
    moving: [[24, 18], [36, 15]],
    frames: 6,
    strata: [16, 8],
    seeds: 2,
    moved: 4,
};

/// Strata an axis of the brute force that is timed.
const TIMED: usize = 4;

/// Steps of these scenes.
pub fn steps(extent: Extent) -> u64 {
    3 * of_each(extent)
}

fn of_each(extent: Extent) -> u64 {
    extent.pick(20, 300)
}

/// Size of the pictures of the sheet, and how many times they are enlarged.
fn picture(input: &Input, extent: Extent) -> ([usize; 2], usize) {
    let [width, height] = match input.ground {
        Ground::Plane => [216, 108],
        Ground::Blocks => [216, 92],
    };
    let times = extent.pick(3, 1);
    ([width / times, height / times], times)
}

/// Size of the pictures that are timed, at least.
fn timed(input: &Input) -> [usize; 2] {
    match input.ground {
        Ground::Plane => [96, 72],
        Ground::Blocks => [72, 30],
    }
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
    let (size, enlarged) = picture(input, bench.extent);
    let progress = Progress::new(bench.done, amount.samples(input) + Shown::samples(size), of_each(bench.extent));
    let done = |samples| progress.add(samples);
    let judged = judge(bench.device, input, amount, bench.cache, &done)?;
    let pictures = Shown::new(bench.device, input, size, bench.cache, &done)?;
    let measured = measured(bench, &judged, amount.seeds)?;
    progress.end();
    let stem = format!("scenes_noise_{}", input.name);
    Ok(shown(&stem, input.title, &measured, &[view(&pictures, input, enlarged)]))
}

fn view(pictures: &Shown, input: &Input, enlarged: usize) -> View {
    let panel = |(method, looks)| match method {
        None => Panel::truth(pictures.picture(looks)),
        Some(method) => {
            let label = Method::label(method);
            Panel::new(&label, pictures.rms(looks), pictures.picture(looks), pictures.errors(looks))
        }
    };
    View { title: input.title.into(), enlarged, panels: pictures.looks().map(panel).collect() }
}

fn measured(bench: &Bench<'_>, judged: &Judged, seeds: u32) -> Result<Measured, Error> {
    let input = &judged.input;
    let all: Vec<Method> = input.methods().filter(|method| !matches!(method, Method::Stratified(_))).collect();
    let times = times(bench, input, &all)?;
    let shimmer = |method: Method| Motion::ALL.map(|motion| Some(judged.shimmer(method, motion)));
    let entry = |(&method, &[seconds, naive]): (&Method, &[f64; 2])| {
        let weight = weight(method, input)?;
        Ok(Entry { label: method.label(), seconds, naive: Some(naive), weight, shimmer: shimmer(method) })
    };
    let moved = judged.motions[0].first().map_or(0, |shimmer| shimmer.brute.len());
    let brute = BRUTE.into_iter().enumerate().map(|(number, strata)| Brute {
        samples: strata * strata,
        shimmer: Motion::ALL.map(|motion| (number < moved).then(|| judged.brute_shimmer(number, motion))),
    });
    let mut stills = judged.stills.clone();
    for still in &mut stills {
        still.methods = all.iter().map(|method| std::mem::take(&mut still.methods[method.number()])).collect();
    }
    Ok(Measured {
        over: format!(
            "Standard errors: over {seeds} parts of the noise. Brute force: a kernel, timed with {} samples.",
            TIMED * TIMED
        ),
        methods: all.iter().zip(&times.methods).map(entry).collect::<Result<_, Error>>()?,
        brute: brute.collect(),
        stills,
        sample: times.sample,
    })
}

fn weight(method: Method, input: &Input) -> Result<Weight, Error> {
    let weight = Weight::of(&[&method.module(input)?], 0);
    // The others call a part of their module only: none of its tables.
    let is_whole = method.is_driven() && method != Method::Mean;
    Ok(if is_whole { weight } else { Weight { bytes: Some(0), operations: None } })
}

/// Seconds a pixel.
struct Times {
    /// Of each method, and of the naive kernel with its driver.
    methods: Vec<[f64; 2]>,
    /// Of a stratified sample.
    sample: f64,
}

/// All kernels take turns.
fn times(bench: &Bench<'_>, input: &Input, methods: &[Method]) -> Result<Times, Error> {
    let device = bench.timed;
    let sampler = Sampler::new(device, input, bench.cache)?;
    let first = Renderer::new(device, &sampler, methods[0])?;
    let lens = input.lens(timing::enlarged(timed(input), |size| first.prepare(&input.lens(size), 1))?);
    let mut kernels = vec![sampler.prepare(&lens, 1, TIMED, SAME, 0..TIMED * TIMED)?];
    for &method in methods {
        kernels.push(Renderer::new(device, &sampler, method)?.prepare(&lens, 1)?);
        // Methods that ask no driver are compared with the naive method itself.
        if method.is_driven() {
            kernels.push(Renderer::naive(device, &sampler, method)?.prepare(&lens, 1)?);
        }
    }
    let seconds = timing::fastest(&kernels, bench.extent)?;
    let mut seconds = seconds.into_iter().map(|seconds| seconds / lens.pixels() as f64);
    let mut next = || seconds.next().unwrap_or(f64::NAN);
    let sample = next() / (TIMED * TIMED) as f64;
    let (mut found, mut first) = (Vec::new(), None);
    for method in methods {
        let own = next();
        let first = *first.get_or_insert(own);
        found.push([own, if method.is_driven() { next() } else { first }]);
    }
    Ok(Times { methods: found, sample })
}
