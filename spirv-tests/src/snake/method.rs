//! The ways to color a snake that are compared, each as a kernel on the device.

use super::known::Known;
use super::scene::{Material, DIRECTION};
use super::skin::{Skin, SIDE};
use super::Error;
use crate::imaging::look::Look;
use crate::imaging::taps::{ALL_TAPS, TAP_DEVIATION};
use prefilter::gpu::{Address, Device, Dispatch, Kernel, Texture, Work};
use prefilter::table::{Format, Table};
use prefilter::Kernel::Fast;
use prefilter::{Accuracy, Edge, IrradianceTier, Module, MomentMipmap, Ranges, Scene, SlopeMipmap, SlopeTier, Tier};

/// A way to color.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// The maps at mean value and mean slope.
    Naive,
    /// Over all slopes, whichever are seen.
    All,
    /// Over the slopes that are seen, by one normal distribution as in the paper; the light on them apart.
    Single,
    /// By two normal distributions, the light apart.
    Apart,
    /// The same as one combination, color and light averaged together.
    Ours,
}

impl Method {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::Naive, Self::All, Self::Single, Self::Apart, Self::Ours];

    /// Those that the pictures show, besides the truth.
    pub const SHOWN: [Self; 3] = [Self::Naive, Self::All, Self::Ours];

    /// The name above pictures.
    pub fn label(self) -> &'static str {
        match self {
            Self::Naive => "naive",
            Self::All => "view-independent",
            Self::Single => "one distribution",
            Self::Apart => "light apart",
            Self::Ours => "ours",
        }
    }

    fn text(self) -> &'static str {
        match self {
            Self::Naive => include_str!("methods/naive.wgsl"),
            Self::All => include_str!("methods/all.wgsl"),
            Self::Single | Self::Apart => include_str!("methods/visible.wgsl"),
            Self::Ours => include_str!("methods/combined.wgsl"),
        }
    }

    /// The modules that the kernel calls.
    ///
    /// # Errors
    /// Those of the scenes.
    pub fn modules(self, material: &Material) -> Result<Vec<Module>, Error> {
        let accuracy = Accuracy::default().without_tables();
        let skin = Scene::new("skin").texture(material.green.clone());
        let (values, slopes, light) = match self {
            Self::Naive => (Tier::Naive, SlopeTier::Unweighted, IrradianceTier::Normal),
            Self::All => (Tier::ClosedForm(Fast), SlopeTier::Unweighted, IrradianceTier::FourGaussians),
            Self::Single => (Tier::ClosedForm(Fast), SlopeTier::Gaussian, IrradianceTier::FourGaussians),
            Self::Apart | Self::Ours => (Tier::ClosedForm(Fast), SlopeTier::Pair, IrradianceTier::FourGaussians),
        };
        let layer = |scene: Scene| scene.slope_tier(slopes).ranges(SLOPES).accuracy(accuracy);
        let skin = skin.tier(values);
        let lit = |scene: Scene| scene.irradiance(material.light).irradiance_tier(light);
        let day = lit(Scene::new("day"));
        let scenes = match self {
            Self::Ours => vec![lit(Scene::new("snake").combination(material.layers(&skin, layer)?)), day],
            _ => vec![skin, layer(Scene::new("blush").slope(material.red.clone())), day],
        };
        scenes.iter().map(|scene| Ok(scene.module()?)).collect()
    }
}

/// Slopes that occur.
const SLOPES: Ranges = Ranges { mean: (-2.0, 2.0), deviation: 1.0 };

/// The maps of a skin on a device: the pattern's moments, and slopes with their second table.
#[derive(Clone, Debug)]
pub struct Maps {
    textures: [Texture; 3],
    /// Bytes of all of them.
    pub bytes: usize,
}

impl Maps {
    /// Makes and uploads the pyramids.
    ///
    /// # Errors
    /// Those of the device.
    pub fn new(device: &Device, skin: &Skin) -> Result<Self, Error> {
        let side = SIDE as u32;
        let texel = std::f32::consts::TAU / SIDE as f32;
        let moments = MomentMipmap::new(side, side, &skin.pattern.texels, Edge::Repeat)?;
        let slopes = SlopeMipmap::from_heights(side, side, &skin.heights, texel, Edge::Repeat)?;
        let [slopes, cross] = slopes.tables("slopes", Format::Rgba16Float)?;
        let upload = |table: &Table| device.upload(table, Address::Repeat);
        let moments = moments.table("moments", Format::Rg16Float)?;
        let bytes = [&moments, &slopes, &cross].map(Table::bytes).iter().sum();
        Ok(Self { textures: [upload(&moments)?, upload(&slopes)?, upload(&cross)?], bytes })
    }
}

/// A method ready to color on a device.
#[derive(Clone, Debug)]
pub struct Renderer {
    kernel: Kernel,
}

impl Renderer {
    /// Generates and compiles what the method needs.
    ///
    /// # Errors
    /// Those of the scenes and of the device.
    pub fn new(device: &Device, material: &Material, method: Method) -> Result<Self, Error> {
        let modules = method.modules(material)?;
        let host =
            format!("const tap_deviation = {TAP_DEVIATION:?};\n{}\n{}", include_str!("shade.wgsl"), method.text());
        let shader = prefilter::link(&modules.iter().collect::<Vec<_>>(), &host)?;
        Ok(Self { kernel: Kernel::new(device, shader.wgsl(), "main")? })
    }

    /// What is shown of pixels, from what is known of their taps.
    ///
    /// # Errors
    /// Those of the device.
    pub fn shown(&self, maps: &Maps, known: &[[Option<Known>; ALL_TAPS]]) -> Result<Vec<Look>, Error> {
        let colors = self.prepare(maps, known)?.run()?;
        let mut shown = colors.chunks_exact(8).map(|numbers| {
            let color = std::array::from_fn(|channel| f64::from(numbers[channel]));
            let lit = std::array::from_fn(|channel| f64::from(numbers[4 + channel]) / std::f64::consts::PI);
            Look { color, lit, share: 1.0 }
        });
        let missed = Look { color: [0.0; 3], lit: [0.0; 3], share: 0.0 };
        let looks = known.iter().map(|taps| {
            let looks = taps.map(|tap| tap.map_or(missed, |_| shown.next().unwrap_or(Look::UNKNOWN)));
            Look::mean(&looks)
        });
        Ok(looks.collect())
    }

    /// The kernel with its inputs, of all taps that see something, to run or to time.
    ///
    /// # Errors
    /// Those of the device.
    pub fn prepare(&self, maps: &Maps, known: &[[Option<Known>; ALL_TAPS]]) -> Result<Dispatch, Error> {
        let hits = || known.iter().flatten().flatten();
        let numbers: Vec<f32> = hits().flat_map(numbers).map(|number| number as f32).collect();
        let textures: Vec<&Texture> = maps.textures.iter().collect();
        let invocations = hits().count();
        let work = Work { inputs: &[&numbers], textures: &textures, invocations, output: 8 * invocations };
        Ok(self.kernel.prepare(&work)?)
    }
}

/// What a kernel reads of a tap.
fn numbers(known: &Known) -> Vec<f64> {
    let Known { position, changes: [right, down], stretch, turns: [dndx, dndy], view, frame: [x, y, z] } = known;
    let parts: [&[f64]; 11] = [position, right, down, &[*stretch], dndx, dndy, view, x, y, z, &DIRECTION];
    parts.concat()
}
