//! The ways to color a rough surface that are compared, each as a kernel on the device.

use super::known::Known;
use super::Error;
use prefilter::gpu::{Address, Device, Kernel, Texture, Work};
use prefilter::{Accuracy, ColorMap, HeightTier, Microsurface, Module, Scene};

/// A way to color.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Over all heights, whichever are seen and lit.
    Texture,
    /// Heitz et al. 2014: their fits of the visible heights, and the sum of the Λ of view and light.
    Paper,
    /// The distribution of the heights seen and lit in closed form, and the correlation of view and light.
    Ours,
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
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Texture, Self::Paper, Self::Ours];

    /// The name above pictures.
    pub fn label(self) -> &'static str {
        match self {
            Self::Texture => "view-independent",
            Self::Paper => "paper",
            Self::Ours => "ours",
        }
    }

    fn text(self) -> &'static str {
        match self {
            Self::Texture => include_str!("methods/texture.wgsl"),
            Self::Paper | Self::Ours => include_str!("methods/height.wgsl"),
        }
    }

    fn module(self, map: ColorMap) -> Result<Module, Error> {
        // The color map in closed form for everyone: what differs is the heights.
        let scene = Scene::new("surface").height(map).accuracy(Accuracy::default().without_tables());
        let (tier, hotspot) = match self {
            // For its color over all heights and its shadows.
            Self::Texture => (HeightTier::Gaussian, true),
            Self::Paper => (HeightTier::Paper, false),
            Self::Ours => (HeightTier::ClosedForm, true),
        };
        let microsurface = Microsurface { hotspot, mean_slope: true, ..Microsurface::default() };
        Ok(scene.height_tier(tier).microsurface(microsurface).module()?)
    }
}

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
        let numbers = known.iter().flat_map(|known| {
            let Known { mean, deviation, slope, slope_covariance, view, facing } = known;
            let parts: [&[f64]; 6] = [&[*mean, *deviation], slope, slope_covariance, view, &toward, &[facing[light]]];
            parts.concat()
        });
        let numbers: Vec<f32> = numbers.map(|number| number as f32).collect();
        let textures: Vec<&Texture> = self.textures.iter().collect();
        let (invocations, output) = (known.len(), 8 * known.len());
        let colors = self.kernel.run(&Work { inputs: &[&numbers], textures: &textures, invocations, output })?;
        let shown = colors.chunks_exact(8).map(|numbers| {
            let color = |first: usize| std::array::from_fn(|channel| f64::from(numbers[first + channel]));
            Shown { color: color(0), lit: color(4), share: f64::from(numbers[3]) }
        });
        Ok(shown.collect())
    }
}
