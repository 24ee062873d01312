//! The shelf: plain WGSL functions that filter, one concept a file, and the linker that takes what a text mentions.
//!
//! The shelf holds functions, structs and constants only. They are pure (no bindings, no derivatives, no implicit level
//! of detail), so that any stage can use every one of them and a compute shader can test every one of them. A file's
//! stem prefixes every name in it: mentioning a name is enough to [`link`] it.
//!
//! ```
//! let text = "fn coverage(height: f32) -> f32 { return normal_cdf(height); }";
//! let linked = prefilter_wgsl::link(text)?;
//! assert!(linked.starts_with(text) && linked.contains("fn normal_cdf("));
//! # Ok::<(), prefilter_wgsl::Collision>(())
//! ```
#![deny(missing_docs)]

mod linker;
mod scan;
mod token;

pub use linker::{collisions, link, mentioned, nearest, Collision};
pub use scan::{declarations, Declaration, Kind};

/// One WGSL file of the shelf.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct File {
    /// The path below the crate's folder, with forward slashes: `math/normal.wgsl`.
    pub path: &'static str,
    /// The whole text.
    pub text: &'static str,
}

macro_rules! shelf {
    ($($path:literal),* $(,)?) => {
        &[$(File { path: $path, text: include_str!(concat!("../", $path)) }),*]
    };
}

/// Every file of the shelf, rooms in the order of their dependencies, files by name.
pub const FILES: &[File] = shelf![
    "math/cubic.wgsl",
    "math/grid.wgsl",
    "math/mixture.wgsl",
    "math/hash.wgsl",
    "math/lattice.wgsl",
    "math/lattice_solid.wgsl",
    "math/normal.wgsl",
    "math/piece.wgsl",
    "math/pulse.wgsl",
    "footprint/crossing.wgsl",
    "footprint/curvature.wgsl",
    "footprint/footprint.wgsl",
    "footprint/taps.wgsl",
    "visibility/heights.wgsl",
    "visibility/normals.wgsl",
    "visibility/roughness.wgsl",
    "visibility/slope_nodes.wgsl",
    "visibility/slopes.wgsl",
    "visibility/smith.wgsl",
    "visibility/steepness.wgsl",
    "visibility/visibility.wgsl",
    "driver/bend.wgsl",
    "driver/bent_noise.wgsl",
    "driver/cosines.wgsl",
    "driver/four_moments.wgsl",
    "driver/gabor.wgsl",
    "driver/gabor_kernel.wgsl",
    "driver/gabor_paper.wgsl",
    "driver/gabor_spectrum.wgsl",
    "driver/fold.wgsl",
    "driver/fractal.wgsl",
    "driver/indicators.wgsl",
    "driver/moments.wgsl",
    "driver/pattern.wgsl",
    "driver/perlin.wgsl",
    "driver/perlin_solid.wgsl",
    "driver/simplex.wgsl",
    "driver/slope_moments.wgsl",
    "driver/statistics.wgsl",
    "driver/transfer.wgsl",
    "driver/value.wgsl",
    "driver/value_solid.wgsl",
    "driver/warp.wgsl",
    "filter/combine.wgsl",
    "filter/height.wgsl",
    "filter/irradiance.wgsl",
    "filter/perturbed.wgsl",
    "filter/percentile.wgsl",
    "filter/rice.wgsl",
    "filter/rounds.wgsl",
    "filter/slope_map.wgsl",
    "filter/split.wgsl",
    "filter/tails.wgsl",
    "filter/texture.wgsl",
    "pass/moment_pyramid.wgsl",
];
