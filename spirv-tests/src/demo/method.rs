//! The ways to color a pixel that the demo compares, each as a kernel on the device.

use super::heights::Heights;
use super::input::Input;
use super::plane::Plane;
use super::{pyramid, Error};
use crate::imaging::picture::Picture;
use prefilter::driver::moment_mipmap::{Edge, MomentMipmap};
use prefilter::driver::moments::Moments;
use prefilter::driver::taps::Taps;
use prefilter::driver::Driver;
use prefilter::gpu::{Address, Device, Dispatch, Kernel, Texture, Work};
use prefilter::table::{Format, Table};
use prefilter::{Module, Scene, Tier};

/// Frames that are timed.
pub const TIMED: usize = 15;

/// A way to color a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// The color of the height at the pixel's center.
    Naive,
    /// The color of the trilinear mean of the heights.
    Mean,
    /// Trilinear mip levels of the colored heights.
    Colored,
    /// The same with up to 8 anisotropic taps.
    ColoredAlong,
    /// Heitz et al. 2014: trilinear (f, f²) and a table of filtered colors.
    Paper,
    /// A generated module with the moments driver and this many taps.
    Ours(Taps),
}

impl Method {
    /// All of them, in the order of the tables.
    pub fn all() -> Vec<Self> {
        let others = [Self::Naive, Self::Mean, Self::Colored, Self::ColoredAlong, Self::Paper];
        others.into_iter().chain([Taps::One, Taps::Two, Taps::Four, Taps::Eight].map(Self::Ours)).collect()
    }

    /// Those that the pictures show, besides the truth.
    pub const SHOWN: [Self; 5] =
        [Self::Naive, Self::Colored, Self::Paper, Self::Ours(Taps::One), Self::Ours(Taps::Eight)];

    /// The name in tables and above pictures.
    pub fn label(self) -> String {
        match self {
            Self::Naive => "naive".into(),
            Self::Mean => "color of the mean".into(),
            Self::Colored => "pre-colored mips".into(),
            Self::ColoredAlong => "pre-colored, aniso 8".into(),
            Self::Paper => "paper".into(),
            Self::Ours(Taps::One) => "ours, 1 tap".into(),
            Self::Ours(taps) => format!("ours, {} taps", taps.count()),
        }
    }

    /// The name in file names.
    pub fn stem(self) -> String {
        match self {
            Self::Naive => "naive".into(),
            Self::Mean => "mean".into(),
            Self::Colored => "colored".into(),
            Self::ColoredAlong => "colored_along".into(),
            Self::Paper => "paper".into(),
            Self::Ours(taps) => format!("ours_{}", taps.count()),
        }
    }

    /// The taps of a generated module.
    pub fn taps(self) -> Option<Taps> {
        match self {
            Self::Ours(taps) => Some(taps),
            _ => None,
        }
    }

    fn text(self) -> &'static str {
        match self {
            Self::Naive => include_str!("methods/naive.wgsl"),
            Self::Mean => include_str!("methods/mean.wgsl"),
            Self::Colored => include_str!("methods/colored.wgsl"),
            Self::ColoredAlong => include_str!("methods/colored_along.wgsl"),
            Self::Paper => include_str!("methods/paper.wgsl"),
            Self::Ours(_) => include_str!("methods/ours.wgsl"),
        }
    }

    /// The module that the kernel calls. The pre-colored methods call none: theirs is linked and dropped.
    ///
    /// # Errors
    /// Those of the scene.
    pub fn module(self, input: &Input) -> Result<Module, Error> {
        let scene = Scene::new("surface").texture(input.map.clone());
        let scene = match self {
            Self::Naive | Self::Mean | Self::Colored | Self::ColoredAlong => scene.tier(Tier::Naive),
            Self::Paper => scene.tier(Tier::Paper),
            Self::Ours(taps) => scene.driver(Driver::Moments(Moments { taps, ..Moments::default() })),
        };
        Ok(scene.module()?)
    }

    /// The image that the kernel reads; the module's tables follow it.
    ///
    /// # Errors
    /// Those of the pyramid.
    pub fn image(self, input: &Input) -> Result<Table, Error> {
        Ok(match self {
            Self::Naive | Self::Mean | Self::Paper => pyramid::raw_moments(&input.heights),
            Self::Colored | Self::ColoredAlong => pyramid::colored(&input.heights, &input.map.reference()),
            Self::Ours(_) => moments(&input.heights)?,
        })
    }
}

/// The moments of a height image as a texture.
fn moments(heights: &Heights) -> Result<Table, Error> {
    let edge = if heights.address == Address::Repeat { Edge::Repeat } else { Edge::Clamp };
    let mipmap = MomentMipmap::new(heights.width as u32, heights.height as u32, &heights.texels, edge)?;
    Ok(mipmap.table("moments", Format::Rg32Float)?)
}

/// A method ready to color planes of one input on a device.
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
    pub fn new(device: &Device, input: &Input, method: Method) -> Result<Self, Error> {
        Self::of(device, input, method, &method.module(input)?)
    }

    /// The naive tier with the driver of a generated module.
    ///
    /// # Errors
    /// Those of the scene and of the device.
    pub fn naive(device: &Device, input: &Input, taps: Taps) -> Result<Self, Error> {
        let driver = Driver::Moments(Moments { taps, ..Moments::default() });
        let scene = Scene::new("surface").texture(input.map.clone()).driver(driver).tier(Tier::Naive);
        Self::of(device, input, Method::Ours(taps), &scene.module()?)
    }

    fn of(device: &Device, input: &Input, method: Method, module: &Module) -> Result<Self, Error> {
        let shader = module.link(&format!("{}\n{}", include_str!("ground.wgsl"), method.text()))?;
        let kernel = Kernel::new(device, shader.wgsl(), "main")?;
        let mut textures = vec![device.upload(&method.image(input)?, input.heights.address)?];
        for table in module.tables() {
            textures.push(device.upload(table, Address::Clamp)?);
        }
        Ok(Self { kernel, textures })
    }

    /// The picture of a plane.
    ///
    /// # Errors
    /// Those of the device.
    pub fn picture(&self, plane: &Plane) -> Result<Picture, Error> {
        let channels = self.prepare(plane)?.run()?;
        let pixels = channels.chunks_exact(4).map(|color| [color[0], color[1], color[2]]).collect();
        Ok(Picture { width: plane.width, height: plane.height, pixels })
    }

    /// Milliseconds that a frame takes on the device: the fastest of [`TIMED`] after 2 that are not counted.
    ///
    /// What else the machine does only adds to a time; on a software device it adds the most.
    ///
    /// # Errors
    /// Those of the device.
    pub fn milliseconds(&self, plane: &Plane) -> Result<f64, Error> {
        let dispatch = self.prepare(plane)?;
        let times = (0..2 + TIMED).map(|_| dispatch.time()).skip(2).collect::<Result<Vec<f64>, _>>()?;
        Ok(1e3 * times.into_iter().fold(f64::INFINITY, f64::min))
    }

    /// The kernel with its inputs, to run or to time.
    ///
    /// # Errors
    /// Those of the device.
    pub fn prepare(&self, plane: &Plane) -> Result<Dispatch, Error> {
        let first = plane.pixel(0, 0);
        let numbers =
            [[plane.width as f64, plane.height as f64], first, [plane.focal, plane.turn], plane.periods, plane.origin];
        let numbers: Vec<f32> = numbers.iter().flatten().map(|&number| number as f32).collect();
        let textures: Vec<&Texture> = self.textures.iter().collect();
        let pixels = plane.width * plane.height;
        let work = Work { inputs: &[&numbers], textures: &textures, invocations: pixels, output: 4 * pixels };
        Ok(self.kernel.prepare(&work)?)
    }
}
