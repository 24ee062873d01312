//! Textures that a module reads: their texels, formats and measured errors.

pub(crate) mod bake;
mod balanced;
pub mod grid;
mod hats;
mod hiding;
mod lattice;
mod layers;
pub(crate) mod learned;
mod normal;
pub(crate) mod power;
pub(crate) mod rice;
mod rule;
mod slope_hiding;
pub(crate) mod slope_map;
pub mod slope_nodes;
mod slope_steps;
pub(crate) mod steep_nodes;
pub(crate) mod strip;
mod threads;
pub(crate) mod transfer;
pub(crate) mod transferred;

/// How a table's texels are stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Format {
    /// Four 32-bit floats; core WebGPU and WebGL2 load it but do not filter it.
    Rgba32Float,
    /// Four 16-bit floats; filterable everywhere.
    Rgba16Float,
    /// Two 32-bit floats; loaded, not filtered.
    Rg32Float,
    /// Two 16-bit floats; filterable everywhere.
    Rg16Float,
    /// Three numbers from 0 to 1 in ten bits and one in two; filterable everywhere.
    Rgb10a2Unorm,
}

impl Format {
    /// Channels a texel.
    pub fn channels(self) -> usize {
        match self {
            Self::Rgba32Float | Self::Rgba16Float | Self::Rgb10a2Unorm => 4,
            Self::Rg32Float | Self::Rg16Float => 2,
        }
    }

    /// Bytes a texel.
    pub fn bytes_per_texel(self) -> usize {
        match self {
            Self::Rgba32Float => 16,
            Self::Rgba16Float | Self::Rg32Float => 8,
            Self::Rg16Float | Self::Rgb10a2Unorm => 4,
        }
    }

    /// The bytes that a texture of this format is filled with, little-endian: rounded to the nearest of those that it
    /// holds.
    pub fn encode(self, values: &[f32]) -> Vec<u8> {
        match self {
            Self::Rgba32Float | Self::Rg32Float => values.iter().flat_map(|value| value.to_le_bytes()).collect(),
            Self::Rgba16Float | Self::Rg16Float => {
                values.iter().flat_map(|&value| half::f16::from_f32(value).to_le_bytes()).collect()
            }
            Self::Rgb10a2Unorm => values.chunks_exact(4).flat_map(|texel| packed(texel).to_le_bytes()).collect(),
        }
    }
}

/// Three numbers of ten bits and one of two, from the lowest bits up.
fn packed(texel: &[f32]) -> u32 {
    let bits =
        |(&value, [most, shift]): (&f32, [u32; 2])| ((value.clamp(0.0, 1.0) * most as f32).round() as u32) << shift;
    texel.iter().zip([[1023, 0], [1023, 10], [1023, 20], [3, 30]]).map(bits).sum()
}

/// How a module reads a table, and so what its exports take.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Sampling {
    /// Single texels: nothing is interpolated. An export that takes a sampler too reads at texel centers: by a nearest
    /// one that does not filter, or of 16-bit formats by any, with the address mode of what the levels continue as.
    Loaded,
    /// Interpolated by a linear sampler that clamps at the edges; the export takes it behind the texture.
    Filtered,
}

/// One mip level.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Level {
    /// Texels a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Slices: 1 in a flat texture.
    #[cfg_attr(feature = "serde", serde(default = "flat"))]
    pub depth: u32,
    /// The channels of the texels, row by row from the top, slice by slice.
    pub texels: Vec<f32>,
}

/// The depth of levels stored before there were volumes.
#[cfg(feature = "serde")]
fn flat() -> u32 {
    1
}

/// A texture to bind to a parameter of an export.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Table {
    /// The parameter's name; a filtered table's sampler is named `NAME_sampler`.
    pub name: String,
    /// How its texels are stored.
    pub format: Format,
    /// How it is read.
    pub sampling: Sampling,
    /// The mip levels, the largest first.
    pub levels: Vec<Level>,
    /// The largest error that reading between texels was measured to add to a result, in its units.
    pub error: f32,
}

impl Level {
    /// Texels of all slices.
    pub fn count(&self) -> usize {
        self.width as usize * self.height as usize * self.depth as usize
    }
}

impl Table {
    /// Bytes of all levels.
    pub fn bytes(&self) -> usize {
        self.levels.iter().map(Level::count).sum::<usize>() * self.format.bytes_per_texel()
    }

    /// Whether it has its texels: one that errs by too much in a part of it has none, and that part's error.
    pub(crate) fn is_baked(&self) -> bool {
        self.levels.iter().all(|level| level.texels.len() == level.count() * self.format.channels())
    }

    /// Its part in a bound: twice the error.
    pub(crate) fn part(&self) -> f32 {
        2.0 * self.error
    }

    /// Whether it is a three-dimensional texture: one of several slices.
    pub fn is_volume(&self) -> bool {
        self.levels.iter().any(|level| level.depth > 1)
    }

    /// The WGSL type of its parameter: `texture_2d<f32>`, or `texture_3d<f32>` of a volume.
    pub fn wgsl_type(&self) -> &'static str {
        if self.is_volume() {
            "texture_3d<f32>"
        } else {
            "texture_2d<f32>"
        }
    }
}
