//! The ways to color a rough surface that are compared, each as a kernel on the device.

use super::known::Known;
use super::Error;
use prefilter::gpu::{Address, Device, Dispatch, Kernel, Texture, Work};
use prefilter::{Accuracy, ColorMap, HeightTier, Microsurface, Module, Ranges, Scene, Tier};

/// A way to color.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// The color of the mean height, and no masking or shadowing.
    Naive,
    /// Over all heights, whichever are seen and lit.
    Texture,
    /// Heitz et al. 2014: their fits of the visible heights, and the sum of the Λ of view and light.
    Paper,
    /// The distribution of the heights seen and lit as one normal distribution, and the correlation.
    Gaussian,
    /// The distribution of the heights seen and lit in closed form, and the correlation of view and light.
    Ours,
    /// The same by a table over mean, deviation and skewness.
    Table,
}

/// What a method says of a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shown {
    /// Mean color of what is seen.
    pub color: [f64; 3],
    /// Mean color of what is seen and lit.
    pub lit: [f64; 3],
    /// The share of what is seen that is lit.
    pub share: f64,
}

impl Method {
    /// Those that the demo shows.
    pub const ALL: [Self; 3] = [Self::Texture, Self::Paper, Self::Ours];

    /// All of them, for the report.
    pub const REPORTED: [Self; 6] = [Self::Naive, Self::Texture, Self::Paper, Self::Gaussian, Self::Ours, Self::Table];

    /// The number in [`Self::ALL`].
    pub fn number(self) -> usize {
        Self::ALL.iter().position(|&method| method == self).unwrap_or(usize::MAX)
    }

    /// The name above pictures.
    pub fn label(self) -> &'static str {
        match self {
            Self::Naive => "naive",
            Self::Texture => "view-independent",
            Self::Paper => "paper",
            Self::Gaussian => "ours, one Gaussian",
            Self::Ours => "ours",
            Self::Table => "ours, by a table",
        }
    }

    fn text(self) -> &'static str {
        match self {
            Self::Naive => include_str!("methods/naive.wgsl"),
            Self::Texture => include_str!("methods/texture.wgsl"),
            Self::Paper | Self::Gaussian | Self::Ours => include_str!("methods/height.wgsl"),
            Self::Table => include_str!("methods/tabled.wgsl"),
        }
    }

    /// The module that the kernel calls; what it does not call is linked and dropped.
    ///
    /// # Errors
    /// Those of the scene.
    pub fn module(self, map: ColorMap) -> Result<Module, Error> {
        // The color map in closed form for everyone: what differs is the heights.
        let scene = match self {
            Self::Naive => return Ok(Scene::new("surface").texture(map).tier(Tier::Naive).module()?),
            // Heights are in deviations, and slopes tilt what is seen.
            Self::Table => Scene::new("surface").height(map).ranges(HEIGHTS),
            _ => Scene::new("surface").height(map).accuracy(Accuracy::default().without_tables()),
        };
        let (tier, hotspot) = match self {
            // For its color over all heights and its shadows.
            Self::Naive | Self::Texture | Self::Gaussian => (HeightTier::Gaussian, true),
            Self::Paper => (HeightTier::Paper, false),
            Self::Ours => (HeightTier::ClosedForm, true),
            Self::Table => (HeightTier::Skewed, true),
        };
        let microsurface = Microsurface { hotspot, mean_slope: true, ..Microsurface::default() };
        Ok(scene.height_tier(tier).microsurface(microsurface).module()?)
    }
}

/// Heights that occur, in deviations of all.
const HEIGHTS: Ranges = Ranges { mean: (-5.0, 5.0), deviation: 1.0 };

/// A method ready to color on a device.
#[derive(Clone, Debug)]
pub struct Renderer {
    kernel: Kernel,
    textures: Vec<Texture>,
}

impl Renderer {
    /// Generates, compiles and uploads what the method needs.
    ///
    /// # Errors
    /// Those of the scene and of the device.
    pub fn new(device: &Device, map: ColorMap, method: Method) -> Result<Self, Error> {
        let module = method.module(map)?;
        let shader = module.link(&format!("{}\n{}", include_str!("shade.wgsl"), method.text()))?;
        let kernel = Kernel::new(device, shader.wgsl(), "main")?;
        let tables = module.tables().iter().map(|table| device.upload(table, Address::Clamp));
        Ok(Self { kernel, textures: tables.collect::<Result<_, _>>()? })
    }

    /// Colors pixels under one of the lights, toward which `toward` is a unit vector.
    ///
    /// # Errors
    /// Those of the device.
    pub fn shown<const LIGHTS: usize>(
        &self,
        known: &[Known<LIGHTS>],
        light: usize,
        toward: [f64; 3],
    ) -> Result<Vec<Shown>, Error> {
        let colors = self.prepare(known, light, toward)?.run()?;
        let shown = colors.chunks_exact(8).map(|numbers| {
            let color = |first: usize| std::array::from_fn(|channel| f64::from(numbers[first + channel]));
            Shown { color: color(0), lit: color(4), share: f64::from(numbers[3]) }
        });
        Ok(shown.collect())
    }

    /// The same, to run or to time.
    ///
    /// # Errors
    /// Those of the device.
    pub fn prepare<const LIGHTS: usize>(
        &self,
        known: &[Known<LIGHTS>],
        light: usize,
        toward: [f64; 3],
    ) -> Result<Dispatch, Error> {
        let numbers = known.iter().flat_map(|known| {
            let Known { mean, deviation, slope, slope_covariance, view, facing } = known;
            let parts: [&[f64]; 6] = [&[*mean, *deviation], slope, slope_covariance, view, &toward, &[facing[light]]];
            parts.concat()
        });
        let numbers: Vec<f32> = numbers.map(|number| number as f32).collect();
        let textures: Vec<&Texture> = self.textures.iter().collect();
        let (invocations, output) = (known.len(), 8 * known.len());
        Ok(self.kernel.prepare(&Work { inputs: &[&numbers], textures: &textures, invocations, output })?)
    }
}
