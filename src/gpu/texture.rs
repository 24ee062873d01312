//! Tables as textures.

use crate::table::{Format, Level, Sampling, Table};
use crate::Error;

use super::Device;

/// What a sampler reads beyond a texture's edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Address {
    /// The texel at the edge.
    Clamp,
    /// The texture again.
    Repeat,
    /// The texture mirrored.
    Mirror,
}

/// A table on a device, with the sampler that reads it.
#[derive(Clone, Debug)]
pub struct Texture {
    texture: wgpu::Texture,
    view: wgpu::TextureView,
    sampler: wgpu::Sampler,
}

impl Texture {
    /// A texture that the device fills, read texel by texel.
    pub(super) fn loaded(device: &Device, texture: wgpu::Texture, address: Address) -> Self {
        let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
        let sampler = device.wgpu().create_sampler(&sampler("", Sampling::Loaded, address));
        Self { texture, view, sampler }
    }

    /// The texture, for hosts that bind it themselves.
    pub fn wgpu(&self) -> &wgpu::Texture {
        &self.texture
    }

    /// The view of all levels.
    pub fn view(&self) -> &wgpu::TextureView {
        &self.view
    }

    /// The sampler: linear within and between levels for a filtered table, nearest for a loaded one.
    pub fn sampler(&self) -> &wgpu::Sampler {
        &self.sampler
    }
}

impl Device {
    /// All levels of a table, and its sampler.
    ///
    /// # Errors
    /// [`Error::Size`] where a level has the wrong size or number of texels or the device's limits are exceeded,
    /// [`Error::Device`] where the device does not filter the table's format or refuses the texture.
    pub fn upload(&self, table: &Table, address: Address) -> Result<Texture, Error> {
        self.check(table)?;
        let Some(first) = table.levels.first() else { return Err(no_level(table)) };
        let (size, format) = (extent(first), format(table.format));
        let dimension = if table.is_volume() { wgpu::TextureDimension::D3 } else { wgpu::TextureDimension::D2 };
        self.checked(&format!("uploading the table `{}`", table.name), || {
            let texture = self.wgpu().create_texture(&wgpu::TextureDescriptor {
                label: Some(&table.name),
                size,
                mip_level_count: table.levels.len() as u32,
                sample_count: 1,
                dimension,
                format,
                usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
                view_formats: &[],
            });
            for (number, level) in table.levels.iter().enumerate() {
                let target = wgpu::TexelCopyTextureInfo { mip_level: number as u32, ..texture.as_image_copy() };
                let layout = wgpu::TexelCopyBufferLayout {
                    offset: 0,
                    bytes_per_row: Some(level.width * table.format.bytes_per_texel() as u32),
                    rows_per_image: Some(level.height),
                };
                let bytes = table.format.encode(&level.texels);
                self.queue().write_texture(target, &bytes, layout, extent(level));
            }
            let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
            let sampler = self.wgpu().create_sampler(&sampler(&table.name, table.sampling, address));
            Texture { texture, view, sampler }
        })
    }

    fn check(&self, table: &Table) -> Result<(), Error> {
        let Some(first) = table.levels.first() else { return Err(no_level(table)) };
        let limits = self.wgpu().limits();
        let limit = if table.is_volume() { limits.max_texture_dimension_3d } else { limits.max_texture_dimension_2d };
        let size = |what: String, count: usize, allowed: String| Err(Error::Size { what, count, allowed });
        for (number, level) in table.levels.iter().enumerate() {
            let sides = |level: &Level| [level.width, level.height, level.depth];
            let expected = sides(first).map(|side| side.checked_shr(number as u32).unwrap_or(0).max(1));
            for (side, (given, expected)) in sides(level).into_iter().zip(expected).enumerate() {
                let side = ["width", "height", "depth"][side];
                let what = format!("the {side} of level {number} of table `{}`", table.name);
                if given == 0 || given > limit {
                    return size(what, given as usize, format!("1 to {limit}"));
                }
                if given != expected {
                    return size(what, given as usize, format!("{expected}, half of the level above"));
                }
            }
            let texels = level.count() * table.format.channels();
            if level.texels.len() != texels {
                let what = format!("the number of values in level {number} of table `{}`", table.name);
                return size(
                    what,
                    level.texels.len(),
                    format!("{texels}, width times height times depth times channels"),
                );
            }
        }
        let levels = 32 - first.width.max(first.height).max(first.depth).leading_zeros() as usize;
        if table.levels.len() > levels {
            let what = format!("the number of levels of table `{}`", table.name);
            return size(what, table.levels.len(), format!("1 to {levels}"));
        }
        let wide = matches!(table.format, Format::Rgba32Float | Format::Rg32Float);
        if table.sampling == Sampling::Filtered && wide && !self.has(wgpu::Features::FLOAT32_FILTERABLE) {
            let message = format!(
                "{} does not filter 32-bit floats; store the table `{}` in 16-bit floats or load single texels",
                self.label(),
                table.name
            );
            return Err(Error::Device { message });
        }
        Ok(())
    }
}

fn no_level(table: &Table) -> Error {
    let what = format!("the number of levels of table `{}`", table.name);
    Error::Size { what, count: 0, allowed: "1 or more".into() }
}

fn extent(level: &Level) -> wgpu::Extent3d {
    wgpu::Extent3d { width: level.width, height: level.height, depth_or_array_layers: level.depth }
}

pub(super) fn format(format: Format) -> wgpu::TextureFormat {
    match format {
        Format::Rgba32Float => wgpu::TextureFormat::Rgba32Float,
        Format::Rgba16Float => wgpu::TextureFormat::Rgba16Float,
        Format::Rg32Float => wgpu::TextureFormat::Rg32Float,
        Format::Rg16Float => wgpu::TextureFormat::Rg16Float,
        Format::Rgb10a2Unorm => wgpu::TextureFormat::Rgb10a2Unorm,
    }
}

fn sampler(name: &str, sampling: Sampling, address: Address) -> wgpu::SamplerDescriptor<'_> {
    let mode = match address {
        Address::Clamp => wgpu::AddressMode::ClampToEdge,
        Address::Repeat => wgpu::AddressMode::Repeat,
        Address::Mirror => wgpu::AddressMode::MirrorRepeat,
    };
    let (filter, mipmap_filter) = match sampling {
        Sampling::Filtered => (wgpu::FilterMode::Linear, wgpu::MipmapFilterMode::Linear),
        Sampling::Loaded => (wgpu::FilterMode::Nearest, wgpu::MipmapFilterMode::Nearest),
    };
    wgpu::SamplerDescriptor {
        label: Some(name),
        address_mode_u: mode,
        address_mode_v: mode,
        address_mode_w: mode,
        mag_filter: filter,
        min_filter: filter,
        mipmap_filter,
        ..Default::default()
    }
}
