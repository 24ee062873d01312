//! The ways to color a pixel that the demo compares, each as a kernel on the device.

use super::input::Input;
use super::lens::Lens;
use super::truth::{numbers, Look, Sampler, SAME};
use super::Error;
use prefilter::driver::taps::Taps;
use prefilter::gpu::{Address, Device, Dispatch, Kernel, Texture, Work};
use prefilter::{Module, Scene, Tier};

/// Frames that are timed.
pub const TIMED: usize = 7;

/// A way to color a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// The color of the noise at the pixel's center.
    Naive,
    /// The color of the filtered noise.
    Mean,
    /// Fading to the average color.
    Fading,
    /// Dropping what is too fine.
    Clamping,
    /// Hart et al. 1999: the mean of the map over the values of linear noise.
    Hart,
    /// Heitz et al. 2014: filtered noise, and its deviation by the pixel's size alone.
    Paper,
    /// A generated module with this many taps.
    Ours(Taps),
    /// A generated module with one tap, which knows second derivatives of the noise; of lattices only.
    Curvature,
    /// Stratified samples, so many an axis: in every frame at the same places of a pixel, for drawn anew they would
    /// shimmer more.
    Stratified(usize),
}

impl Method {
    /// All of them, in the order of the tables.
    pub const ALL: [Self; 11] = [
        Self::Naive,
        Self::Mean,
        Self::Fading,
        Self::Clamping,
        Self::Hart,
        Self::Paper,
        Self::Ours(Taps::One),
        Self::Curvature,
        Self::Ours(Taps::Four),
        Self::Ours(Taps::Eight),
        Self::Stratified(4),
    ];

    /// The number in [`Self::ALL`].
    pub fn number(self) -> usize {
        Self::ALL.iter().position(|&method| method == self).unwrap_or(usize::MAX)
    }

    /// The name in tables and above pictures, without a comma.
    pub fn label(self) -> String {
        match self {
            Self::Naive => "naive".into(),
            Self::Mean => "color of the mean".into(),
            Self::Fading => "global fading".into(),
            Self::Clamping => "frequency clamping".into(),
            Self::Hart => "Hart et al. 1999".into(),
            Self::Paper => "paper".into(),
            Self::Ours(Taps::One) => "ours with 1 tap".into(),
            Self::Curvature => "ours by curvature".into(),
            Self::Ours(taps) => format!("ours with {} taps", taps.count()),
            Self::Stratified(strata) => format!("{} stratified samples", strata * strata),
        }
    }

    fn text(self) -> &'static str {
        match self {
            Self::Naive => include_str!("methods/naive.wgsl"),
            Self::Mean => include_str!("methods/mean.wgsl"),
            Self::Fading => include_str!("methods/fading.wgsl"),
            Self::Clamping => include_str!("methods/clamping.wgsl"),
            Self::Hart => include_str!("methods/hart.wgsl"),
            Self::Paper => include_str!("methods/paper.wgsl"),
            Self::Ours(_) | Self::Curvature | Self::Stratified(_) => include_str!("methods/ours.wgsl"),
        }
    }

    /// Whether it asks the driver.
    pub fn is_driven(self) -> bool {
        matches!(self, Self::Mean | Self::Paper | Self::Ours(_) | Self::Curvature)
    }

    /// The module that the kernel calls; what it does not call is linked and dropped.
    ///
    /// # Errors
    /// Those of the scene.
    pub fn module(self, input: &Input) -> Result<Module, Error> {
        let scene = Scene::new("surface").texture(input.map.clone()).driver(input.driver(self));
        let scene = if self == Self::Paper { scene.tier(Tier::Paper) } else { scene };
        Ok(scene.module()?)
    }
}

/// A method ready to color pictures of one input on a device.
#[derive(Clone, Debug)]
pub struct Renderer<'a> {
    input: &'a Input,
    sampler: &'a Sampler<'a>,
    /// Strata of brute force, else a kernel with its textures.
    strata: Option<usize>,
    kernel: Kernel,
    textures: Vec<Texture>,
}

impl<'a> Renderer<'a> {
    /// Generates, compiles and uploads what the method needs.
    ///
    /// # Errors
    /// Those of the scene and of the device.
    pub fn new(device: &Device, sampler: &'a Sampler<'a>, method: Method) -> Result<Self, Error> {
        let strata = if let Method::Stratified(strata) = method { Some(strata) } else { None };
        let module = method.module(sampler.input())?;
        Ok(Self { strata, ..Self::of(device, sampler, &module, method.text())? })
    }

    /// The naive tier with the same driver as a method's.
    ///
    /// # Errors
    /// Those of the scene and of the device.
    pub fn naive(device: &Device, sampler: &'a Sampler<'a>, method: Method) -> Result<Self, Error> {
        let input = sampler.input();
        let scene = Scene::new("surface").texture(input.map.clone()).driver(input.driver(method));
        Self::of(device, sampler, &scene.tier(Tier::Naive).module()?, include_str!("methods/ours.wgsl"))
    }

    fn of(device: &Device, sampler: &'a Sampler<'a>, module: &Module, text: &str) -> Result<Self, Error> {
        let input = sampler.input();
        let text = [input.world(), include_str!("shade.wgsl").to_owned(), text.to_owned()].concat();
        let kernel = Kernel::new(device, module.link(&text)?.wgsl(), "main")?;
        let textures = module.tables().iter().map(|table| device.upload(table, Address::Clamp));
        Ok(Self { input, sampler, strata: None, kernel, textures: textures.collect::<Result<_, _>>()? })
    }

    /// What every pixel shows; `seed` says from where, and what brute force draws.
    ///
    /// # Errors
    /// Those of the device.
    pub fn picture(&self, lens: &Lens, seed: u32) -> Result<Vec<Look>, Error> {
        if let Some(strata) = self.strata {
            return self.sampler.picture(lens, seed, strata, SAME, &|_| ());
        }
        let channels = self.prepare(lens, seed)?.run()?;
        let look = |pixel: &[f32]| Look {
            color: [pixel[0], pixel[1], pixel[2]],
            // A NaN that nobody wrote is something that is seen.
            share: if pixel[3] == 0.0 { 0.0 } else { 1.0 },
            light: 0.0,
            length: pixel[3],
        };
        Ok(channels.chunks_exact(4).map(look).collect())
    }

    /// Milliseconds that a frame takes on the device: the fastest of [`TIMED`] after 2 that are not counted.
    ///
    /// # Errors
    /// Those of the device.
    pub fn milliseconds(&self, lens: &Lens) -> Result<f64, Error> {
        let dispatch = match self.strata {
            Some(strata) => self.sampler.prepare(lens, 1, strata, SAME, 0..strata * strata)?,
            None => self.prepare(lens, 1)?,
        };
        let times = (0..2 + TIMED).map(|_| dispatch.time()).skip(2).collect::<Result<Vec<f64>, _>>()?;
        Ok(1e3 * times.into_iter().fold(f64::INFINITY, f64::min))
    }

    /// The kernel with its inputs; not that of brute force.
    ///
    /// # Errors
    /// Those of the device.
    pub fn prepare(&self, lens: &Lens, seed: u32) -> Result<Dispatch, Error> {
        let (shot, knots) = (numbers(self.input, lens, seed), self.sampler.knots());
        let textures: Vec<&Texture> = self.textures.iter().collect();
        let (invocations, output) = (lens.pixels(), 4 * lens.pixels());
        let work = Work { inputs: &[&shot, knots], textures: &textures, invocations, output };
        Ok(self.kernel.prepare(&work)?)
    }
}
