//! The scenes of moss and of a sponge: heights that a curve makes of noise, on a log.

use super::frame::Shown;
use super::measured::{Measured, Method as Entry, Weight};
use super::progress::Progress;
use super::rays::{kept, Amount, Shots, Stage};
use super::shown;
use crate::imaging::camera::View;
use crate::imaging::look::Look;
use crate::imaging::taps::ALL_TAPS;
use crate::moss::known::Known;
use crate::moss::method::Method;
use crate::moss::scene::{materials, views};
use crate::moss::studio::{Noise, Studio};
use crate::report::document::Item;
use crate::report::timing;
use crate::report::{Bench, Error, Extent};

const FULL: Amount = Amount { size: [54, 36], moving: [24, 16], frames: 8, strata: 32, blocks: 4 };
const QUICK: Amount = Amount { size: [36, 30], moving: [12, 10], frames: 4, strata: 16, blocks: 2 };

/// The view that moves and that is timed: where pixels lose the waves.
const MIDDLE: usize = 1;

/// Steps of these scenes.
pub fn steps(extent: Extent) -> u64 {
    2 * of_each(extent)
}

fn of_each(extent: Extent) -> u64 {
    extent.pick(30, 450)
}

/// The views of the stills.
fn seen(amount: &Amount) -> [View; 3] {
    views(amount.size, [amount.strata; 3])
}

/// A surface over a noise.
struct Growth<'a> {
    bench: &'a Bench<'a>,
    noise: Noise<'a>,
    seed: u64,
    progress: &'a Progress<'a>,
}

/// All that the truth depends on.
const PROGRAM: &str = concat!(
    include_str!("moss.rs"),
    include_str!("../../moss/truth.rs"),
    include_str!("../../moss/log.rs"),
    include_str!("../../moss/scene.rs"),
    include_str!("../../imaging/relief.rs"),
    include_str!("../../imaging/waves.rs"),
    include_str!("../../imaging/camera.rs"),
    include_str!("../../imaging/pixel.rs"),
);

impl Stage for Growth<'_> {
    type View = View;

    fn sampled(&self, view: &View, strata: usize, seed: u64) -> Result<Vec<Look>, Error> {
        let inputs = format!("{:?}", (view, strata, seed, self.seed, &self.noise.studio.material));
        kept(self.bench.cache, &[PROGRAM, &inputs], view.width * view.height, || {
            Ok(self.noise.scenery().picture(view, strata, seed, &|rays| self.progress.add(rays)))
        })
    }

    fn shown(&self, view: &View) -> Result<Vec<Vec<Look>>, Error> {
        self.noise.shown(&self.noise.known(view))
    }
}

/// What the report shows of them.
///
/// # Errors
/// Those of scenes and of the device.
pub fn items(bench: &Bench<'_>) -> Result<Vec<Item>, Error> {
    let mut items = Vec::new();
    for material in materials()? {
        let studio = Studio::new(bench.timed, material, &Method::REPORTED)?;
        items.extend(scene(bench, &studio)?);
    }
    Ok(items)
}

fn scene(bench: &Bench<'_>, studio: &Studio) -> Result<Vec<Item>, Error> {
    let amount = bench.extent.pick(QUICK, FULL);
    let progress = Progress::new(
        bench.done,
        amount.rays(seen(&amount).iter().map(|view| view.width * view.height).sum()),
        of_each(bench.extent),
    );
    let (mut shots, mut times) = (Shots::default(), Vec::new());
    for seed in 0..amount.blocks {
        let stage = Growth { bench, noise: studio.noise(seed as u32 + 1), seed, progress: &progress };
        shots.still(&stage, &seen(&amount), amount.strata, seed)?;
        if seed == 0 {
            let moved = |pan, zoom| views(amount.moving, [amount.strata; 3])[MIDDLE].moved(pan, zoom);
            shots.moving(&stage, &moved, amount.strata.min(16), amount.frames)?;
            times = seconds(bench, studio, &stage.noise.known(&seen(&amount)[MIDDLE]))?;
        }
    }
    progress.end();
    let measured = measured(&amount, studio, &times, &shots);
    let name = studio.material.name;
    let title = format!("The {name} on a log, near and far, from overhead to a silhouette, in the light of a sun");
    Ok(shown(&format!("scenes_{name}"), &title, &measured, &pictures(&shots, &measured, &amount)))
}

/// Seconds a tap of each method: all its kernels.
fn seconds(bench: &Bench<'_>, studio: &Studio, known: &[[Option<Known>; ALL_TAPS]]) -> Result<Vec<f64>, Error> {
    let hits: Vec<Known> = known.iter().flatten().flatten().copied().collect();
    let color = |times: usize| Ok::<_, Error>(studio.renderers()[0].prepare(&hits.repeat(times))?.swap_remove(0));
    let hits = hits.repeat(timing::times_over(hits.len(), color)?);
    let kernels = studio.renderers().iter().map(|renderer| renderer.prepare(&hits));
    let kernels = kernels.collect::<Result<Vec<_>, Error>>()?;
    let times = timing::fastest(&kernels.concat(), bench.extent)?;
    let mut times = times.into_iter();
    let all = kernels.iter().map(|kernels| times.by_ref().take(kernels.len()).sum::<f64>() / hits.len() as f64);
    Ok(all.collect())
}

fn measured(amount: &Amount, studio: &Studio, seconds: &[f64], shots: &Shots) -> Measured {
    let entry = |(number, method): (usize, Method)| Entry {
        label: method.label().into(),
        seconds: seconds[number] * ALL_TAPS as f64,
        naive: Some(seconds[0] * ALL_TAPS as f64),
        weight: Weight::of(&studio.renderers()[number].modules.iter().collect::<Vec<_>>(), 0),
        shimmer: shots.methods[number],
    };
    Measured {
        methods: Method::REPORTED.into_iter().enumerate().map(entry).collect(),
        brute: shots.brute(amount.strata),
        stills: shots.stills.clone(),
        sample: seconds[0],
        over: format!(
            "Color times the cosine of the sun, what is in shadow being black. A pixel has {ALL_TAPS} taps, of \
             which each method runs the kernels of color, of the cosine and of visibility; the naive method's \
             curve is not timed. Standard errors: over {} fields of noise, of shimmer over parts of the view in \
             the middle. Brute force: the naive kernels as many times as it has samples, without its rays.",
            amount.blocks
        ),
    }
}

/// The light of the sky, which is everywhere, and of the sun; what is behind the log.
const SKY: [f64; 3] = [0.14, 0.18, 0.24];
const SUN: [f64; 3] = [1.30, 1.20, 1.02];
const BEHIND: [f64; 3] = [0.42, 0.56, 0.74];

fn pictures(shots: &Shots, measured: &Measured, amount: &Amount) -> Vec<super::View> {
    let labels: Vec<String> = measured.methods.iter().map(|method| method.label.clone()).collect();
    let shade = |look: &Look| [0, 1, 2].map(|at| SKY[at] * look.color[at] + SUN[at] * look.lit[at]);
    let views = seen(amount);
    let all = views.iter().zip(&shots.first).map(|(view, frame)| {
        let size = [view.width, view.height];
        frame.view(view.title.into(), &labels, &Shown { size, light: 0, shade: &shade, behind: BEHIND })
    });
    all.collect()
}
