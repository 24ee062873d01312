//! The ways to color and light a transferred surface that are compared, each by exports of modules on the device.

use super::known::Known;
use super::scene::{Material, HEIGHT};
use super::Error;
use crate::exports::ExportKernel;
use crate::imaging::look::Look;
use crate::imaging::taps::ALL_TAPS;
use crate::imaging::vector::Vector;
use prefilter::gpu::Device;
use prefilter::{
    ColorMap, Export, HeightTier, Irradiance, IrradianceTier, Microsurface, Module, Ranges, Scene, TransferTier,
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
}

impl Method {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Texture, Self::Paper, Self::Ours];

    /// The name above pictures and in tables.
    pub fn label(self) -> &'static str {
        match self {
            Self::Texture => "texture filtering",
            Self::Paper => "paper",
            Self::Ours => "ours",
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
        let found = self.kernel.run(&points)?;
        Ok(found.iter().map(|color| [0, 1, 2].map(|channel| f64::from(color[channel]))).collect())
    }
}

/// A method ready to color on a device.
#[derive(Clone, Debug)]
pub struct Renderer {
    color: Call,
    /// The share that is lit of what faces the sun.
    visibility: Option<Call>,
    lambert: Call,
}

impl Renderer {
    /// Generates, compiles and uploads what the method needs.
    ///
    /// # Errors
    /// Those of the scenes and of the device.
    pub fn new(device: &Device, material: &Material, method: Method) -> Result<Self, Error> {
        let (slopes, tier) = match method {
            Method::Texture => (IrradianceTier::Normal, TransferTier::Paper),
            Method::Paper => (IrradianceTier::FourGaussians, TransferTier::Paper),
            Method::Ours => (IrradianceTier::FourGaussians, TransferTier::ThreeNodes),
        };
        let light = Irradiance::from_equirectangular(4, 2, &[[1.0; 3]; 8])?;
        let light = Scene::new("light").irradiance(light).irradiance_tier(slopes);
        let light = light.transfer(material.curve.clone()).transfer_tier(tier).module()?;
        let (color, visibility) = if method == Method::Texture {
            let colors = Scene::new("colors").texture(values(material)?).ranges(VALUES).module()?;
            (Call::new(device, &colors, "texture")?, None)
        } else {
            let surface = module(material, tier)?;
            (Call::new(device, &surface, "height")?, Some(Call::new(device, &surface, "visibility")?))
        };
        Ok(Self { color, visibility, lambert: Call::new(device, &light, "lambert")? })
    }

    /// What is shown of pixels, from what is known of their taps.
    ///
    /// # Errors
    /// Those of the device.
    pub fn shown(&self, known: &[[Option<Known>; ALL_TAPS]]) -> Result<Vec<Look>, Error> {
        let hits: Vec<Known> = known.iter().flatten().flatten().copied().collect();
        let sun = |known: &Known| known.sun;
        // From the zenith everything is lit.
        let seen = self.color.run(&hits, |_| [0.0, 0.0, 1.0])?;
        let lit = self.color.run(&hits, sun)?;
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
