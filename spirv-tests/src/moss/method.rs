//! The ways to color and light a transferred surface that are compared, each by exports of modules on the device.

use super::known::Known;
use super::scene::{Material, HEIGHT};
use super::Error;
use crate::exports::ExportKernel;
use crate::imaging::look::Look;
use crate::imaging::taps::ALL_TAPS;
use crate::imaging::vector::Vector;
use prefilter::gpu::{Device, Dispatch};
use prefilter::{
    ColorMap, Export, HeightTier, HeightTransfer, Irradiance, IrradianceTier, Microsurface, Module, Ranges, Scene,
    Tier, TransferTier,
};

/// A way to color and light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Over all heights, whichever are seen and lit; the sun on the mean normal.
    Texture,
    /// Heitz et al. 2014: one normal distribution of heights and one of slopes, and their fits of what is visible.
    Paper,
    /// Heights as the curve makes them, slopes as a mixture of three normal distributions.
    Ours,
    /// The color of the curve at the mean, and the sun on the mean normal; nothing is hidden.
    Naive,
    /// As ours with two normal distributions of slopes.
    TwoNodes,
    /// With four.
    FourNodes,
}

impl Method {
    /// Those that the demo shows.
    pub const ALL: [Self; 3] = [Self::Texture, Self::Paper, Self::Ours];

    /// All of them, for the report.
    pub const REPORTED: [Self; 6] =
        [Self::Naive, Self::Texture, Self::Paper, Self::TwoNodes, Self::Ours, Self::FourNodes];

    /// The name above pictures and in tables.
    pub fn label(self) -> &'static str {
        match self {
            Self::Texture => "texture filtering",
            Self::Paper => "paper",
            Self::Ours => "ours",
            Self::Naive => "naive",
            Self::TwoNodes => "ours, two nodes",
            Self::FourNodes => "ours, four nodes",
        }
    }
}

/// Heights that occur: all that a curve from 0 to [`HEIGHT`] can make.
const HEIGHTS: Ranges = Ranges { mean: (0.0, HEIGHT), deviation: 0.5 * HEIGHT };

/// Values of f that occur.
const VALUES: Ranges = Ranges { mean: (-5.0, 5.0), deviation: 1.0 };

/// Knots of the map of values: colors are looked up in it where the curve bends.
const KNOTS: usize = 1024;

/// The module of a surface's colors.
///
/// # Errors
/// Those of the scene.
pub fn module(material: &Material, tier: TransferTier) -> Result<Module, Error> {
    let paper = tier == TransferTier::Paper;
    let microsurface = Microsurface { hotspot: !paper, mean_slope: true, ..Microsurface::default() };
    let scene = Scene::new("surface").height(material.map.clone()).microsurface(microsurface);
    let scene = if paper { scene.height_tier(HeightTier::Paper).ranges(HEIGHTS) } else { scene };
    Ok(scene.transfer(material.curve.clone()).transfer_tier(tier).module()?)
}

/// Colors by values of f: the curve and then the map.
fn values(material: &Material) -> Result<ColorMap, Error> {
    let map = material.map.reference();
    let knot = |number: usize| {
        let value = VALUES.mean.0 / 2.0 * (1.0 - 2.0 * number as f32 / (KNOTS - 1) as f32);
        let [red, green, blue, _] = map.value(material.curve.height(value.into()));
        (value, [red, green, blue].map(|part| part as f32))
    };
    Ok(ColorMap::gradient((0..KNOTS).map(knot))?)
}

/// An export ready to run.
#[derive(Clone, Debug)]
struct Call {
    export: Export,
    kernel: ExportKernel,
}

impl Call {
    fn new(device: &Device, module: &Module, suffix: &str) -> Result<Self, Error> {
        let name = format!("{}_{suffix}", module.name());
        let export = module.exports().iter().find(|export| export.name == name);
        let Some(export) = export.cloned() else { return Err(Error::Map(format!("no export {name}"))) };
        Ok(Self { kernel: ExportKernel::new(device, module, &export)?, export })
    }

    /// The results of taps, whose light is given.
    fn run(&self, known: &[Known], light: impl Fn(&Known) -> Vector) -> Result<Vec<[f64; 3]>, Error> {
        let found = self.prepare(known, light)?.run()?;
        Ok(found.chunks_exact(4).map(|color| [0, 1, 2].map(|channel| f64::from(color[channel]))).collect())
    }

    /// The kernel with its inputs.
    fn prepare(&self, known: &[Known], light: impl Fn(&Known) -> Vector) -> Result<Dispatch, Error> {
        let parameters = self.export.parameters();
        let numbers = |known: &Known| {
            let light = light(known);
            let of = |name: &str| match name {
                "mean" => vec![known.mean],
                "deviation" => vec![known.deviation],
                "mean_slope" => known.slope.to_vec(),
                "slope_covariance" => known.slope_covariance.to_vec(),
                "view" => known.view.to_vec(),
                "light" => light.to_vec(),
                _ => Vec::new(),
            };
            parameters.iter().flat_map(|(name, _)| of(name)).map(|number| number as f32).collect::<Vec<_>>()
        };
        let points: Vec<f32> = known.iter().flat_map(numbers).collect();
        Ok(self.kernel.prepare(&points)?)
    }
}

/// A method ready to color on a device.
#[derive(Clone, Debug)]
pub struct Renderer {
    color: Call,
    /// Colors are those of this curve at the mean, which looks the map up.
    curve: Option<HeightTransfer>,
    /// The share that is lit of what faces the sun.
    visibility: Option<Call>,
    lambert: Call,
    /// The modules of both.
    pub modules: [Module; 2],
}

impl Renderer {
    /// Generates, compiles and uploads what the method needs.
    ///
    /// # Errors
    /// Those of the scenes and of the device.
    pub fn new(device: &Device, material: &Material, method: Method) -> Result<Self, Error> {
        let (slopes, tier) = match method {
            Method::Naive | Method::Texture => (IrradianceTier::Normal, TransferTier::Paper),
            Method::Paper => (IrradianceTier::FourGaussians, TransferTier::Paper),
            Method::TwoNodes => (IrradianceTier::FourGaussians, TransferTier::TwoNodes),
            Method::Ours => (IrradianceTier::FourGaussians, TransferTier::ThreeNodes),
            Method::FourNodes => (IrradianceTier::FourGaussians, TransferTier::FourNodes),
        };
        let light = Irradiance::from_equirectangular(4, 2, &[[1.0; 3]; 8])?;
        let light = Scene::new("light").irradiance(light).irradiance_tier(slopes);
        let light = light.transfer(material.curve.clone()).transfer_tier(tier).module()?;
        let colors = match method {
            Method::Naive => Scene::new("colors").texture(material.map.clone()).tier(Tier::Naive).module()?,
            Method::Texture => Scene::new("colors").texture(values(material)?).ranges(VALUES).module()?,
            _ => module(material, tier)?,
        };
        let (color, visibility) = match method {
            Method::Naive | Method::Texture => (Call::new(device, &colors, "texture")?, None),
            _ => (Call::new(device, &colors, "height")?, Some(Call::new(device, &colors, "visibility")?)),
        };
        let curve = (method == Method::Naive).then(|| material.curve.clone());
        let lambert = Call::new(device, &light, "lambert")?;
        Ok(Self { color, curve, visibility, lambert, modules: [colors, light] })
    }

    /// The kernels that a picture takes, with their inputs: of colors seen and lit, of the sun's cosine, and of what
    /// is lit.
    ///
    /// # Errors
    /// Those of the device.
    pub fn prepare(&self, hits: &[Known]) -> Result<Vec<Dispatch>, Error> {
        let sun = |known: &Known| known.sun;
        let calls = [Some(&self.color), Some(&self.color), Some(&self.lambert), self.visibility.as_ref()];
        calls.into_iter().flatten().map(|call| call.prepare(hits, sun)).collect()
    }

    /// What a map is looked up at: the curve at the mean, or the mean for a filter.
    fn colored(&self, hits: &[Known]) -> Vec<Known> {
        let mean = |known: &Known| self.curve.as_ref().map_or(known.mean, |curve| curve.height(known.mean));
        hits.iter().map(|known| Known { mean: mean(known), ..*known }).collect()
    }

    /// What is shown of pixels, from what is known of their taps.
    ///
    /// # Errors
    /// Those of the device.
    pub fn shown(&self, known: &[[Option<Known>; ALL_TAPS]]) -> Result<Vec<Look>, Error> {
        let hits: Vec<Known> = known.iter().flatten().flatten().copied().collect();
        let sun = |known: &Known| known.sun;
        // From the zenith everything is lit.
        let colored = self.colored(&hits);
        let seen = self.color.run(&colored, |_| [0.0, 0.0, 1.0])?;
        let lit = self.color.run(&colored, sun)?;
        let lambert = self.lambert.run(&hits, sun)?;
        let visible = match &self.visibility {
            Some(visibility) => visibility.run(&hits, sun)?,
            None => vec![[1.0; 3]; hits.len()],
        };
        let tap = |number: usize, known: &Known| {
            let light = if known.sunlit { lambert[number][0] * visible[number][0] } else { 0.0 };
            Look { color: seen[number], lit: lit[number].map(|part| light * part), share: 1.0 }
        };
        let mut taps = hits.iter().enumerate().map(|(number, known)| tap(number, known));
        let missed = Look { color: [0.0; 3], lit: [0.0; 3], share: 0.0 };
        let looks = known.iter().map(|pixel| {
            Look::mean(&pixel.map(|known| known.map_or(missed, |_| taps.next().unwrap_or(Look::UNKNOWN))))
        });
        Ok(looks.collect())
    }
}
