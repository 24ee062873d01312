//! A pyramid of moments on the device, with the work that fills it.

use crate::driver::moment_mipmap::{check_size, Edge};
use crate::table::Format;
use crate::Error;

use super::{Device, MomentPass, Texture};

/// A pyramid on the device and the passes that fill it from its image.
#[derive(Clone, Debug)]
pub struct MomentPyramid {
    pub(super) device: Device,
    pub(super) steps: Vec<Step>,
    pub(super) texture: Texture,
}

/// One dispatch.
#[derive(Clone, Debug)]
pub(super) struct Step {
    pub pipeline: wgpu::ComputePipeline,
    pub bound: wgpu::BindGroup,
    pub groups: [u32; 2],
}

/// One level of a texture.
pub(super) struct View {
    pub view: wgpu::TextureView,
    pub size: [u32; 2],
}

impl MomentPyramid {
    /// The pyramid, with a sampler that continues it as its image.
    pub fn texture(&self) -> &Texture {
        &self.texture
    }

    /// Records the passes that fill the pyramid from what the image holds when they run.
    pub fn encode(&self, encoder: &mut wgpu::CommandEncoder) {
        let mut pass =
            encoder.begin_compute_pass(&wgpu::ComputePassDescriptor { label: Some("moments"), timestamp_writes: None });
        for Step { pipeline, bound, groups: [across, down] } in &self.steps {
            pass.set_pipeline(pipeline);
            pass.set_bind_group(0, bound, &[]);
            pass.dispatch_workgroups(*across, *down, 1);
        }
    }

    /// Fills the pyramid and waits for that.
    ///
    /// # Errors
    /// [`Error::Device`] where the device refuses the work or is lost.
    pub fn run(&self) -> Result<(), Error> {
        self.device.checked("building a pyramid of moments", || {
            let mut encoder = self.device.wgpu().create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
            self.encode(&mut encoder);
            self.device.queue().submit([encoder.finish()]);
        })?;
        self.device.wait()
    }
}

impl Device {
    /// The pyramid of moments of an image given row by row, built on the device: that of
    /// [`MomentMipmap`](crate::MomentMipmap), or of [`FourMomentMipmap`](crate::FourMomentMipmap) in a format of four
    /// channels.
    ///
    /// # Errors
    /// As [`MomentMipmap::new`](crate::MomentMipmap::new) for the sizes, and those of [`MomentPass`].
    pub fn moments(
        &self,
        width: u32,
        height: u32,
        values: &[f32],
        edge: Edge,
        format: Format,
    ) -> Result<Texture, Error> {
        check_size(width, height, values.len())?;
        let image = self.checked("uploading an image", || {
            let size = wgpu::Extent3d { width, height, depth_or_array_layers: 1 };
            let image = self.wgpu().create_texture(&wgpu::TextureDescriptor {
                label: Some("image"),
                size,
                mip_level_count: 1,
                sample_count: 1,
                dimension: wgpu::TextureDimension::D2,
                format: wgpu::TextureFormat::R32Float,
                usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
                view_formats: &[],
            });
            let layout =
                wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(4 * width), rows_per_image: None };
            self.queue().write_texture(image.as_image_copy(), bytemuck::cast_slice(values), layout, size);
            image
        })?;
        let pyramid = MomentPass::new(self, edge, format)?.prepare(&image)?;
        pyramid.run()?;
        Ok(pyramid.texture)
    }
}

/// A level of a texture, as the only one.
pub(super) fn mip(texture: &wgpu::Texture, number: u32) -> View {
    let view = texture.create_view(&wgpu::TextureViewDescriptor {
        dimension: Some(wgpu::TextureViewDimension::D2),
        base_mip_level: number,
        mip_level_count: Some(1),
        ..Default::default()
    });
    View { view, size: [texture.width(), texture.height()].map(|side| (side >> number).max(1)) }
}
