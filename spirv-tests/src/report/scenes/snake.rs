//! The scene of a snake, colored by a pattern and by the slopes of its scales.

use super::frame::Shown;
use super::measured::{Measured, Method as Entry, Weight};
use super::progress::Progress;
use super::rays::{kept, Amount, Shots, Stage};
use super::shown;
use crate::imaging::camera::View;
use crate::imaging::look::Look;
use crate::imaging::pixel::Pixel;
use crate::imaging::taps::ALL_TAPS;
use crate::report::document::Item;
use crate::report::timing;
use crate::report::{Bench, Error, Extent};
use crate::snake::body::Body;
use crate::snake::judge::displaced;
use crate::snake::known::{self, Known};
use crate::snake::mesh::Mesh;
use crate::snake::method::{Maps, Method, Renderer};
use crate::snake::scene::{views, Material, LEVELS};
use crate::snake::skin::{Skin, SIDE};
use crate::snake::truth::Scenery;
use prefilter::reference::texture::PiecewiseLinear;
use prefilter::{Edge, MomentMipmap};

const FULL: Amount = Amount { size: [72, 48], moving: [36, 24], frames: 8, strata: 32, blocks: 4 };
const QUICK: Amount = Amount { size: [48, 32], moving: [18, 12], frames: 4, strata: 16, blocks: 2 };

/// The view that moves and that is timed.
const WHOLE: usize = 1;

/// Steps of this scene.
pub fn steps(extent: Extent) -> u64 {
    extent.pick(30, 600)
}

/// The views of the stills.
fn seen(amount: &Amount) -> Vec<(View, usize)> {
    views(amount.size, [amount.strata; 3]).into_iter().zip(LEVELS).collect()
}

/// A skin and what colors it.
struct Snake<'a> {
    bench: &'a Bench<'a>,
    body: &'a Body,
    skin: Skin,
    seed: u64,
    mesh: Mesh,
    heights: MomentMipmap,
    maps: Maps,
    material: &'a Material,
    maps_of_colors: &'a [PiecewiseLinear; 2],
    pixel: &'a Pixel,
    renderers: &'a [Renderer],
    progress: &'a Progress<'a>,
}

/// All that the truth depends on.
const PROGRAM: &str = concat!(
    include_str!("snake.rs"),
    include_str!("../../snake/truth.rs"),
    include_str!("../../snake/body.rs"),
    include_str!("../../snake/mesh.rs"),
    include_str!("../../snake/skin.rs"),
    include_str!("../../snake/scene.rs"),
    include_str!("../../imaging/camera.rs"),
    include_str!("../../imaging/pixel.rs"),
);

impl Stage for Snake<'_> {
    /// With the level of the heights that methods see displaced.
    type View = (View, usize);

    fn sampled(&self, (view, _): &Self::View, strata: usize, seed: u64) -> Result<Vec<Look>, Error> {
        let inputs = format!("{:?}", (view, strata, seed, self.seed, self.material));
        kept(self.bench.cache, &[PROGRAM, &inputs], view.width * view.height, || {
            let [green, red] = self.maps_of_colors;
            let (body, skin, mesh, light) = (self.body, &self.skin, &self.mesh, &self.material.light);
            let scenery = Scenery { body, skin, mesh, green, red, light, pixel: self.pixel };
            let row = (view.width * strata * strata) as u64;
            Ok(scenery.picture(view, strata, seed, &|| self.progress.add(row)))
        })
    }

    fn shown(&self, view: &Self::View) -> Result<Vec<Vec<Look>>, Error> {
        let known = self.known(view);
        self.renderers.iter().map(|renderer| renderer.shown(&self.maps, &known)).collect()
    }
}

impl<'a> Snake<'a> {
    /// What filters know of a view.
    fn known(&self, (view, level): &(View, usize)) -> Vec<[Option<Known>; ALL_TAPS]> {
        let resolved = displaced(self.body, &self.heights, *level);
        known::picture(self.body, resolved.as_ref().unwrap_or(&self.mesh), *level, view)
    }
}

/// What the report shows of it.
///
/// # Errors
/// Those of scenes and of the device.
pub fn items(bench: &Bench<'_>) -> Result<Vec<Item>, Error> {
    let amount = bench.extent.pick(QUICK, FULL);
    let progress = Progress::new(
        bench.done,
        amount.rays(seen(&amount).iter().map(|(view, _)| view.width * view.height).sum()),
        steps(bench.extent),
    );
    let (body, material, pixel) = (Body::new(), Material::new()?, Pixel::default());
    let renderers = Method::ALL.map(|method| Renderer::new(bench.timed, &material, method));
    let renderers = renderers.into_iter().collect::<Result<Vec<_>, Error>>()?;
    let (colors, mut shots, mut found) =
        ([&material.green, &material.red].map(|map| map.reference()), Shots::default(), None);
    for seed in 0..amount.blocks {
        let skin = Skin::new(seed as u32 + 1);
        let stage = Snake {
            bench,
            body: &body,
            mesh: body.mesh(&skin.heights, 0),
            heights: MomentMipmap::new(SIDE as u32, SIDE as u32, &skin.heights, Edge::Repeat)?,
            maps: Maps::new(bench.timed, &skin)?,
            skin,
            seed,
            material: &material,
            maps_of_colors: &colors,
            pixel: &pixel,
            renderers: &renderers,
            progress: &progress,
        };
        shots.still(&stage, &seen(&amount), amount.strata, seed)?;
        if seed == 0 {
            let moved = |pan, zoom| (views(amount.moving, [amount.strata; 3])[WHOLE].moved(pan, zoom), LEVELS[WHOLE]);
            shots.moving(&stage, &moved, amount.strata.min(16), amount.frames)?;
            found = Some(measured(&amount, &stage)?);
        }
    }
    progress.end();
    let Some(mut measured) = found else { return Ok(Vec::new()) };
    measured.methods.iter_mut().zip(&shots.methods).for_each(|(method, shimmer)| method.shimmer = *shimmer);
    (measured.brute, measured.stills) = (shots.brute(amount.strata), shots.stills.clone());
    Ok(shown("scenes_snake", TITLE, &measured, &pictures(&shots, &measured, &amount)))
}

const TITLE: &str = "A snake colored by a pattern and by the slopes of its scales, lit from all around, near and far";

/// Times and weights.
fn measured(amount: &Amount, stage: &Snake<'_>) -> Result<Measured, Error> {
    let known = stage.known(&seen(amount)[WHOLE]);
    let hits = known.iter().flatten().flatten().count();
    let once = |times: usize| stage.renderers[0].prepare(&stage.maps, &known.repeat(times));
    let known = known.repeat(timing::times_over(hits, once)?);
    let taps = known.iter().flatten().flatten().count() as f64;
    let kernels = stage.renderers.iter().map(|renderer| renderer.prepare(&stage.maps, &known));
    let seconds = timing::fastest(&kernels.collect::<Result<Vec<_>, Error>>()?, stage.bench.extent)?;
    let entry = |(number, method): (usize, Method)| {
        let modules = method.modules(stage.material)?;
        Ok(Entry {
            label: method.label().into(),
            seconds: seconds[number] / taps * ALL_TAPS as f64,
            naive: Some(seconds[0] / taps * ALL_TAPS as f64),
            weight: Weight::of(&modules.iter().collect::<Vec<_>>(), stage.maps.bytes),
            shimmer: [None; 2],
        })
    };
    Ok(Measured {
        methods: Method::ALL.into_iter().enumerate().map(entry).collect::<Result<_, Error>>()?,
        brute: Vec::new(),
        stills: Vec::new(),
        sample: seconds[0] / taps,
        over: format!(
            "Color times irradiance. A pixel has {ALL_TAPS} taps; one distribution: the paper's. Standard \
             errors: over {} skins, of shimmer over parts of the view of the whole snake. Brute force: the \
             naive kernel as many times as it has samples, without its rays. Bytes: with the pyramids of values \
             and slopes.",
            amount.blocks
        ),
    })
}

/// The color of what is behind.
const SAND: [f64; 3] = [0.50, 0.42, 0.31];

fn pictures(shots: &Shots, measured: &Measured, amount: &Amount) -> Vec<super::View> {
    let labels: Vec<String> = measured.methods.iter().map(|method| method.label.clone()).collect();
    let views = seen(amount);
    let all = views.iter().zip(&shots.first).map(|((view, _), frame)| {
        let size = [view.width, view.height];
        frame.view(view.title.into(), &labels, &Shown { size, light: 0, shade: &|look| look.lit, behind: SAND })
    });
    all.collect()
}
