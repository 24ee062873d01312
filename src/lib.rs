//! Filtered color maps for shaders: no shimmer, no supersampling, one evaluation a pixel.
//!
//! A pixel covers many values of a noise or of a height field, and a color map bends them: the color of the mean is not
//! the mean of the colors. Where a driver knows the mean and the deviation of what the pixel covers, the mean color is
//! an integral over a normal distribution, and this crate writes the WGSL that evaluates it.
//!
//! # From a description to a shader
//!
//! A [`Scene`] names what is filtered: a [`ColorMap`], perhaps a [`Driver`], the [`Ranges`] of the values and the
//! [`Accuracy`] wanted. It becomes a [`Module`]: a text of pure functions that naga has validated, the [`Table`]s that
//! they read, and what is known of their error and cost.
//!
//! ```
//! use prefilter::{Accuracy, ColorMap, Scene};
//!
//! let lichen = ColorMap::gradient([
//!     (0.00, [0.05, 0.09, 0.03]),
//!     (0.45, [0.21, 0.24, 0.10]),
//!     (0.45, [0.42, 0.40, 0.37]), // the same position twice: a hard edge
//!     (1.00, [0.71, 0.69, 0.66]),
//! ])?;
//! let module = Scene::new("lichen").texture(lichen).accuracy(Accuracy::max_filter_error(1.0 / 255.0)).module()?;
//! println!("{}", module.wgsl()); // pure functions, ready to paste, include or concatenate
//! println!("{}", module.explain()); // which tier, its bound, its cost, and why
//!
//! // Your entry points first, the functions behind, all validated:
//! let shader = module.link(
//!     "@fragment fn main(@location(0) height: vec2f) -> @location(0) vec4f {
//!         return vec4f(lichen_texture(height.x, height.y), 1.0);
//!     }",
//! )?;
//! let spirv: Vec<u32> = shader.spirv()?;
//! # assert!(!spirv.is_empty());
//! # Ok::<(), prefilter::Error>(())
//! ```
//!
//! # Three ways in
//!
//! - *A generator*, at run time or in a build script: [`Scene::module`], as above.
//! - *An include library*: the shelf, plain WGSL functions in the crate [`prefilter_wgsl`]. Mention one in a shader of
//!   yours, and `include_wgsl!` (feature `macros`) links it and validates the whole while `cargo build` runs.
//! - *A module for an engine*: [`Module::wgsl`] has no bindings and no entry points. The host wires, with the
//!   signatures of [`Module::exports`] and the textures of [`Module::tables`].
//!
//! # Tiers
//!
//! | [`Tier`] | cost | error |
//! |---|---|---|
//! | [`ClosedForm`](Tier::ClosedForm), fast | some 33 operations a stop | 2e-5 for six stops, 5e-5 for six hard edges |
//! | [`ClosedForm`](Tier::ClosedForm), exact | some 37 operations a stop | 1e-5 for six stops: f32 rounding |
//! | [`Table`](Tier::Table) | one fetch, 64 KiB | a few thousandths for gradients; not for hard edges |
//! | [`Paper`](Tier::Paper) | one fetch, 512 KiB | as the paper's, to compare with |
//! | [`Naive`](Tier::Naive) | a few operations | everything that this crate is about |
//!
//! A scene that names no tier gets the lightest whose bound keeps its accuracy. A [`Bound`] is against the integral;
//! how far the covered values are from a normal distribution is the driver's matter, and `cargo xtask demo` measures
//! it.
//!
//! # Drivers
//!
//! A [`Driver`] finds the statistics of a pixel's footprint, so that a module exports `NAME_color(position, dpdx, dpdy,
//! …)`. Some read an image's pyramid: [`Moments`] and [`Indicators`] that of values, [`SlopeMoments`] that of slopes.
//! The others are functions of the position, of which nothing is stored:
//!
//! - in the plane: [`Noise`], [`Pattern`], [`Cosines`], which knows slopes, and [`Warp`], another function of the plane
//!   at positions that noise displaces;
//! - in a solid that a surface cuts: [`Gabor`], and [`Noise`] of a solid [`NoiseBasis`];
//! - in either: [`Custom`], a function of yours in WGSL, with slopes where it has them.
//!
//! All evaluate one to eight points of a footprint, [`Taps`]. A scene without a driver takes the statistics as
//! arguments. What values of that mean and deviation are taken for is their [`Distribution`], by default a normal one.
//!
//! # Color by height
//!
//! Heights of a rough surface hide each other at grazing angles, and what is seen and lit are rather the high ones.
//! [`Scene::height`] averages the map over those: `NAME_height` takes the mean and deviation of the heights, the
//! covariance of the slopes, and the directions of view and light. `NAME_visibility` is the share of the seen that is
//! lit, for those who have no shadows yet. [`HeightTier`]s differ in how they represent the visible heights,
//! [`Microsurface`] says what hides them, and [`Module::explain`] what Smith's model itself is off by.
//!
//! A [`Microsurface`] may also tilt the mean surface and put noise on the heights: exports take what that needs, and
//! nothing where it is off. [`Scene::height_percentile`] takes a map over the share of the surface that lies below a
//! height instead: the heights' mean and deviation cancel, and any map is exact.
//!
//! # Heights by a curve
//!
//! [`Scene::transfer`] makes what is filtered the heights h = g(f) of a curve, a [`HeightTransfer`]: exports take the
//! statistics of f. The slopes of h are a mixture, narrow where the curve is flat; [`TransferTier`]s differ in what
//! stands for it. `NAME_transferred` has the mean height, by which vertices are displaced.
//!
//! # Color by slope
//!
//! Facets count by their area in the picture: at grazing angles those that face the view. [`Scene::slope`] averages the
//! map over one component of the slopes that are seen, along any horizontal vector: `NAME_slope` takes the mean and the
//! covariance of the slopes, the direction of the view and that vector. [`SlopeTier`]s differ in how they represent the
//! visible slopes; [`SlopeTier::Unweighted`] is for flat meshes whose normals come from a map. [`Scene::steepness`]
//! averages a map over the length of the slopes that are seen: rock on cliffs, with one fetch. [`Scene::slope_map`]
//! averages a [`SlopeMap`], colors by the whole slope, with a few reads from a table.
//!
//! # Light by slope
//!
//! Diffuse light depends on the slopes that are seen, too. [`Scene::irradiance`] averages an environment's irradiance
//! of order 2 and Lambert's cosine over their normals; [`IrradianceTier`]s differ in how they average.
//!
//! # Layers together
//!
//! Layers are scenes, and add and multiply: [`Scene::combination`] takes an expression of them, a [`Combination`], and
//! evaluates what they share once. With [`Scene::irradiance`] or a [`Reflectance`] color and light are averaged
//! together where both depend on the slopes.
//!
//! # Conventions
//!
//! - `mean` and `deviation` (σ, never the variance σ²) share the unit of the color map's positions. Deviations below
//!   1e-6 count as 1e-6.
//! - Colors are linear, three channels or four: premultiplied alpha, or a material value. The `_srgb` constructors
//!   decode.
//! - Covariances are (xx, xy, yy). Positions of an image are texture coordinates in [0, 1], its top left texel's corner
//!   at the origin.
//! - Results stay in the map's hull of colors, those of tables to the rounding of halves, and are never NaN for finite
//!   numbers.
//!
//! # Features
//!
//! None by default: a dependent then builds little more than naga. `macros`: `include_wgsl!`. `gpu`: compute on wgpu
//! without ceremony. `joint`: maps of height and steepness together. `image`, `colorgrad`: color maps from those
//! crates. `serde`: scenes, maps and tables to files. `glsl`, `hlsl`, `msl`: naga's other writers. `naga`: the
//! validated module itself, tied to naga's version.
//!
//! # Source
//!
//! Heitz, Nowrouzezahrai, Poulin and Neyret 2014, "Filtering Non-Linear Transfer Functions on Surfaces", IEEE
//! Transactions on Visualization and Computer Graphics 20(7).
#![deny(missing_docs)]

mod accuracy;
mod cost;
pub mod driver;
mod error;
pub mod filter;
#[cfg(feature = "gpu")]
pub mod gpu;
mod join;
mod linkage;
mod module;
mod name;
mod probe;
pub mod reference;
mod reserved;
mod scene;
mod shader;
pub mod table;
pub mod transfer;

pub use accuracy::{Accuracy, Bound, Ranges};
pub use cost::Cost;
pub use driver::cosines::{Cosines, Wave};
pub use driver::custom::Custom;
pub use driver::fold::NoiseFold;
pub use driver::four_moments::FourMomentMipmap;
pub use driver::gabor::{Gabor, GaborMethod};
pub use driver::gabor_spectrum::Spectrum;
pub use driver::indicator_mipmap::IndicatorMipmap;
pub use driver::indicators::Indicators;
pub use driver::moment_mipmap::{Edge, MomentMipmap};
pub use driver::moments::Moments;
pub use driver::noise::{Noise, NoiseBasis, NoiseMethod};
pub use driver::pattern::{Motif, Pattern};
pub use driver::slope_mipmap::SlopeMipmap;
pub use driver::slope_moments::SlopeMoments;
pub use driver::taps::{Pixel, Taps};
pub use driver::warp::Warp;
pub use driver::Driver;
pub use error::Error;
pub use filter::combine::Reflectance;
pub use filter::distribution::Distribution;
pub use filter::height::{HeightTier, Microsurface};
pub use filter::height_transfer::TransferTier;
pub use filter::irradiance::IrradianceTier;
pub use filter::slope::SlopeTier;
pub use filter::slope_map::SlopeTaps;
pub use filter::{Kernel, Tier};
pub use module::{Export, Module, Stage};
#[cfg(feature = "macros")]
#[doc(inline)]
pub use prefilter_macros::include_wgsl;
#[cfg(feature = "joint")]
pub use scene::JointMap;
pub use scene::{Combination, Scene};
pub use shader::{link, Shader};
pub use table::learned::Learned;
pub use table::Table;
pub use transfer::color_map::{ColorMap, Colors};
pub use transfer::height_transfer::HeightTransfer;
pub use transfer::irradiance::Irradiance;
pub use transfer::slope_map::{SlopeDomain, SlopeMap};

/// The README's code blocks are tests, too.
#[cfg(all(doctest, feature = "macros"))]
#[doc = include_str!("../README.md")]
struct Readme;
