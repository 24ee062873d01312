//! The ways to color and light the ground that are compared, each as a kernel on the device.

use super::known::Known;
use super::scene::{Materials, PRODUCTS};
use super::Error;
use crate::imaging::picture::Picture;
use crate::imaging::taps::ALL_TAPS;
use prefilter::gpu::{Address, Device, Dispatch, Kernel, Texture, Work};
use prefilter::{Accuracy, ColorMap, Irradiance, IrradianceTier, Microsurface, Module, Scene, Tier};

/// A way to color and light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Of the mean height and the mean slope.
    Naive,
    /// Over all heights and slopes, whichever are seen.
    Alike,
    /// The mean color of what is seen times the mean irradiance on it.
    Factored,
    /// The mean of color times irradiance over what is seen.
    Joint,
    /// As the naive method, without a filter's machinery: maps and light are looked up once each.
    Plain,
}

/// The largest error of the mean color that is asked for: lengths of slopes are ten distributions where one errs by
/// more.
const ERROR: f32 = 0.06;

impl Method {
    /// Those that the demo shows.
    pub const ALL: [Self; 4] = [Self::Naive, Self::Alike, Self::Factored, Self::Joint];

    /// Those of the report.
    pub const REPORTED: [Self; 4] = [Self::Plain, Self::Alike, Self::Factored, Self::Joint];

    /// The name above pictures and in tables for people.
    pub fn label(self) -> &'static str {
        match self {
            Self::Plain | Self::Naive => "naive",
            Self::Alike => "view-independent",
            Self::Factored => "ours, factored",
            Self::Joint => "ours, joint",
        }
    }

    /// Those that filter what is seen.
    pub const FILTERED: [Self; 2] = [Self::Factored, Self::Joint];

    /// The name in tables for other programs.
    pub fn stem(self) -> &'static str {
        match self {
            Self::Plain | Self::Naive => "naive",
            Self::Alike => "view-independent",
            Self::Factored => "factored",
            Self::Joint => "joint",
        }
    }

    fn text(self) -> &'static str {
        match self {
            Self::Plain => include_str!("methods/plain.wgsl"),
            Self::Naive => include_str!("methods/naive.wgsl"),
            Self::Alike => include_str!("methods/alike.wgsl"),
            Self::Factored => include_str!("methods/factored.wgsl"),
            Self::Joint => include_str!("methods/joint.wgsl"),
        }
    }
}

/// The modules of colors and of light over what is seen.
///
/// # Errors
/// Those of the scenes.
pub fn modules(materials: &Materials, sky: Irradiance) -> Result<[Module; 2], Error> {
    let seen = Microsurface { shadowing: false, mean_slope: true, ..Microsurface::default() };
    let colors = Scene::new("cliffs").combination(materials.map()?.combination("ground", PRODUCTS)?);
    let colors = colors.microsurface(seen).irradiance(sky).accuracy(Accuracy::max_filter_error(ERROR)).module()?;
    let light = Scene::new("sky").irradiance(sky).irradiance_tier(IrradianceTier::FourGaussians).module()?;
    Ok([colors, light])
}

/// The modules that filter nothing: of the three colors and of the light.
///
/// # Errors
/// Those of the scenes.
pub fn plain(materials: &Materials, sky: Irradiance) -> Result<Vec<Module>, Error> {
    let color = |name, map: &ColorMap| Scene::new(name).texture(map.clone()).tier(Tier::Naive);
    let light = Scene::new("day").irradiance(sky).irradiance_tier(IrradianceTier::Normal);
    let scenes =
        [color("woods", &materials.ground), color("bare", &materials.flat), color("rock", &materials.rock), light];
    scenes.iter().map(|scene| Ok(scene.module()?)).collect()
}

/// A method ready to color on a device under one sky.
#[derive(Clone, Debug)]
pub struct Renderer {
    kernel: Kernel,
    textures: Vec<Texture>,
}

impl Renderer {
    /// Generates, compiles and uploads what the method needs.
    ///
    /// # Errors
    /// Those of the scenes and of the device.
    pub fn new(device: &Device, materials: &Materials, sky: Irradiance, method: Method) -> Result<Self, Error> {
        let [colors, light] = modules(materials, sky)?;
        let text = [include_str!("shade.wgsl"), method.text()].join("\n");
        let plain = if method == Method::Plain { plain(materials, sky)? } else { Vec::new() };
        let modules: Vec<&Module> = [&colors, &light].into_iter().chain(&plain).collect();
        let kernel = Kernel::new(device, prefilter::link(&modules, &text)?.wgsl(), "main")?;
        let textures = colors.tables().iter().map(|table| device.upload(table, Address::Clamp));
        Ok(Self { kernel, textures: textures.collect::<Result<_, _>>()? })
    }

    /// The picture of what is known, `width` pixels wide.
    ///
    /// # Errors
    /// Those of the device.
    pub fn picture(&self, known: &[Known], width: usize) -> Result<Picture, Error> {
        let colors = self.colors(known)?;
        let mean = |taps: &[[f32; 3]]| {
            let sum = |channel: usize| taps.iter().map(|tap| tap[channel]).sum::<f32>();
            [0, 1, 2].map(|channel| sum(channel) / taps.len() as f32)
        };
        let pixels: Vec<[f32; 3]> = colors.chunks_exact(ALL_TAPS).map(mean).collect();
        Ok(Picture { width, height: pixels.len() / width.max(1), pixels })
    }

    /// The light of every tap.
    ///
    /// # Errors
    /// Those of the device.
    pub fn colors(&self, known: &[Known]) -> Result<Vec<[f32; 3]>, Error> {
        let colors = self.prepare(known)?.run()?;
        Ok(colors.chunks_exact(4).map(|color| [color[0], color[1], color[2]]).collect())
    }

    /// The kernel with its inputs, to run or to time.
    ///
    /// # Errors
    /// Those of the device.
    pub fn prepare(&self, known: &[Known]) -> Result<Dispatch, Error> {
        let numbers = known.iter().flat_map(|known| {
            let Known { mean, deviation, slope, covariance, view } = known;
            let parts: [&[f32]; 4] = [&[*mean, *deviation], slope, covariance, view];
            parts.concat()
        });
        let numbers: Vec<f32> = numbers.collect();
        let textures: Vec<&Texture> = self.textures.iter().collect();
        let (invocations, output) = (known.len(), 4 * known.len());
        Ok(self.kernel.prepare(&Work { inputs: &[&numbers], textures: &textures, invocations, output })?)
    }
}
