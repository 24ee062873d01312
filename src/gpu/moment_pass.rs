//! Pyramids of moments, built on the device from a texture.

use crate::driver::moment_mipmap::Edge;
use crate::shader::Shader;
use crate::table::Format;
use crate::Error;

use super::moment_pyramid::{mip, MomentPyramid, Step, View};
use super::texture::format as of_wgpu;
use super::{Address, Device, Texture};

/// The passes that build a pyramid of moments from an image on the device, compiled once for many images.
///
/// The pyramid is that of [`MomentMipmap`](crate::MomentMipmap) in a format of two channels and that of
/// [`FourMomentMipmap`](crate::FourMomentMipmap) in one of four, for images of any size, odd ones too: parts of texels
/// count by their area. Sums are in f32: values up to 1e7 and deviations from 1e-9. Stored as [`Format::Rgba16Float`]
/// they may be rounded towards 0 where the processor's are to nearest, and values beyond 65504 are infinite.
///
/// A level that nests in the level above takes twice the time of reading that once; any other is made of the whole
/// image again. While it is built the pyramid takes two more textures of the image's size, of 8 bytes a texel for two
/// moments and 16 for four.
///
/// ```no_run
/// use prefilter::gpu::{Device, MomentPass};
/// use prefilter::{table::Format, Edge};
///
/// // The image is bound as a texture; its first channel counts.
/// fn moments(device: wgpu::Device, queue: wgpu::Queue, image: &wgpu::Texture) -> Result<(), prefilter::Error> {
///     let pass = MomentPass::new(&Device::from_wgpu(device, queue), Edge::Repeat, Format::Rg32Float)?;
///     let pyramid = pass.prepare(image)?;
///     pyramid.run()?; // or, where the image changes, `encode` in an encoder of your own every frame
///     let moments = pyramid.texture(); // for `NAME_color`
///     Ok(())
/// }
/// ```
#[derive(Clone, Debug)]
pub struct MomentPass {
    device: Device,
    format: Format,
    edge: Edge,
    points: wgpu::ComputePipeline,
    texels: wgpu::ComputePipeline,
    columns: wgpu::ComputePipeline,
    rows: wgpu::ComputePipeline,
    copies: wgpu::ComputePipeline,
}

/// Texels of a workgroup, a side.
const SIDE: u32 = 8;

/// The entry points; `EDGE` and the two formats are written in.
const ENTRIES: &str = "
@group(0) @binding(0) var source: texture_2d<f32>;
@group(0) @binding(1) var level: texture_storage_2d<LEVEL, write>;
@group(0) @binding(2) var exact: texture_storage_2d<EXACT, write>;

@compute @workgroup_size(8, 8)
fn points(@builtin(global_invocation_id) id: vec3u) {
    if any(id.xy >= textureDimensions(level)) { return; }
    textureStore(level, id.xy, vec4f(textureLoad(source, id.xy, 0).x, 0.0, 0.0, 0.0));
}

@compute @workgroup_size(8, 8)
fn texels(@builtin(global_invocation_id) id: vec3u) {
    if any(id.xy >= textureDimensions(exact)) { return; }
    let moments = moment_pyramid_texel(source, i32(id.x), i32(id.y), EDGE);
    textureStore(exact, id.xy, moment_pyramid_stored(moments));
}

@compute @workgroup_size(8, 8)
fn columns(@builtin(global_invocation_id) id: vec3u) {
    if any(id.xy >= textureDimensions(exact)) { return; }
    let count = i32(textureDimensions(exact).x);
    let moments = moment_pyramid_part(source, true, i32(id.y), i32(id.x), count);
    textureStore(exact, id.xy, moment_pyramid_stored(moments));
}

@compute @workgroup_size(8, 8)
fn rows(@builtin(global_invocation_id) id: vec3u) {
    if any(id.xy >= textureDimensions(exact)) { return; }
    let count = i32(textureDimensions(exact).y);
    let moments = moment_pyramid_part(source, false, i32(id.x), i32(id.y), count);
    textureStore(exact, id.xy, moment_pyramid_stored(moments));
}

@compute @workgroup_size(8, 8)
fn copies(@builtin(global_invocation_id) id: vec3u) {
    if any(id.xy >= textureDimensions(level)) { return; }
    textureStore(level, id.xy, textureLoad(source, id.xy, 0));
}
";

impl MomentPass {
    /// Compiles the passes for images that `edge` continues and pyramids of a format.
    ///
    /// # Errors
    /// [`Error::Conflict`] for [`Format::Rg16Float`], which WebGPU does not store to, [`Error::Device`] where the
    /// device refuses a pipeline.
    pub fn new(device: &Device, edge: Edge, format: Format) -> Result<Self, Error> {
        let shader = Self::shader(edge, format)?;
        device.checked("compiling the passes of moments", || {
            let module = device.wgpu().create_shader_module(wgpu::ShaderModuleDescriptor {
                label: Some("moments"),
                source: wgpu::ShaderSource::Wgsl(shader.wgsl().into()),
            });
            let pipeline = |entry: &str| {
                device.wgpu().create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
                    label: Some(entry),
                    layout: None,
                    module: &module,
                    entry_point: Some(entry),
                    compilation_options: wgpu::PipelineCompilationOptions::default(),
                    cache: None,
                })
            };
            let [points, texels, columns, rows, copies] =
                ["points", "texels", "columns", "rows", "copies"].map(pipeline);
            Self { device: device.clone(), format, edge, points, texels, columns, rows, copies }
        })
    }

    /// The passes as one shader, for hosts that run them in another way: compute entry points `points`, `texels`,
    /// `columns`, `rows` and `copies` of 8 × 8 texels, whose bindings of group 0 are a texture that is read, 0, and one
    /// that is stored to: 1 of `points` and `copies`, 2 of the others.
    ///
    /// WebGL2 has no such shaders: render passes there may call `moment_pyramid_texel` and `moment_pyramid_part` of the
    /// shelf.
    ///
    /// # Errors
    /// [`Error::Conflict`] for [`Format::Rg16Float`] and [`Format::Rgb10a2Unorm`].
    pub fn shader(edge: Edge, format: Format) -> Result<Shader, Error> {
        let (level, exact) = match format {
            Format::Rg32Float => ("rg32float", "rg32float"),
            Format::Rgba32Float => ("rgba32float", "rgba32float"),
            Format::Rgba16Float => ("rgba16float", "rgba32float"),
            Format::Rg16Float | Format::Rgb10a2Unorm => {
                let message = "a pass stores moments as Rg32Float, Rgba32Float or Rgba16Float, not as";
                return Err(Error::Conflict(format!("{message} {format:?}")));
            }
        };
        let repeats = if edge == Edge::Repeat { "true" } else { "false" };
        let text = ENTRIES.replace("LEVEL", level).replace("EXACT", exact).replace("EDGE", repeats);
        let path = "moment_pass.wgsl".to_owned();
        let linked = prefilter_wgsl::link(&text).map_err(|collision| Error::Collision { path, collision })?;
        Shader::new("moment_pass.wgsl", linked)
    }

    /// The pyramid of an image, still to be filled: of the first channel of its largest level, which the device's
    /// shaders read as floats.
    ///
    /// # Errors
    /// [`Error::Device`] where the image is not one that a shader reads so, or the device has no room.
    pub fn prepare(&self, image: &wgpu::Texture) -> Result<MomentPyramid, Error> {
        self.device.checked("preparing a pyramid of moments", || {
            let pyramid = self.texture("moments", image.width(), image.height(), self.format, true);
            let narrow = self.format == Format::Rgba16Float;
            let exact = if narrow { self.exact(image, true) } else { pyramid.clone() };
            let mut steps = vec![self.step(&self.points, &mip(image, 0), 1, &mip(&pyramid, 0))];
            if pyramid.mip_level_count() > 1 {
                let base = self.exact(image, false);
                steps.push(self.step(&self.texels, &mip(image, 0), 2, &mip(&base, 0)));
                for number in 1..pyramid.mip_level_count() {
                    steps.extend(self.halved(&base, &exact, number));
                    if narrow {
                        let (from, to) = (mip(&exact, number), mip(&pyramid, number));
                        steps.push(self.step(&self.copies, &from, 1, &to));
                    }
                }
            }
            let address = if self.edge == Edge::Repeat { Address::Repeat } else { Address::Clamp };
            let texture = Texture::loaded(&self.device, pyramid, address);
            MomentPyramid { device: self.device.clone(), steps, texture }
        })
    }

    /// The two steps to a level: from the level above where its texels nest in this one's, or from the image's.
    fn halved(&self, base: &wgpu::Texture, exact: &wgpu::Texture, number: u32) -> [Step; 2] {
        let size = |level: u32| [exact.width(), exact.height()].map(|side| (side >> level).max(1));
        let ([width, height], [wide, high]) = (size(number), size(number - 1));
        let nests = number > 1 && wide.is_multiple_of(width) && high.is_multiple_of(height);
        let source = if nests { mip(exact, number - 1) } else { mip(base, 0) };
        let rows = if nests { high } else { base.height() };
        let parts = self.texture("parts", width, rows, self.widest(), false);
        [
            self.step(&self.columns, &source, 2, &mip(&parts, 0)),
            self.step(&self.rows, &mip(&parts, 0), 2, &mip(exact, number)),
        ]
    }

    /// The format that sums are kept in.
    fn widest(&self) -> Format {
        if self.format == Format::Rgba16Float {
            Format::Rgba32Float
        } else {
            self.format
        }
    }

    fn exact(&self, image: &wgpu::Texture, levels: bool) -> wgpu::Texture {
        self.texture("sums", image.width(), image.height(), self.widest(), levels)
    }

    fn texture(&self, label: &str, width: u32, height: u32, format: Format, levels: bool) -> wgpu::Texture {
        let usage = wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::STORAGE_BINDING;
        self.device.wgpu().create_texture(&wgpu::TextureDescriptor {
            label: Some(label),
            size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
            mip_level_count: if levels { width.max(height).ilog2() + 1 } else { 1 },
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: of_wgpu(format),
            usage: usage | wgpu::TextureUsages::COPY_SRC,
            view_formats: &[],
        })
    }

    /// The step that reads one view and stores to another, of the binding `to`.
    fn step(&self, pipeline: &wgpu::ComputePipeline, source: &View, to: u32, target: &View) -> Step {
        let layout = pipeline.get_bind_group_layout(0);
        let bound = self.device.wgpu().create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout: &layout,
            entries: &[(0, source), (to, target)].map(|(binding, bound)| wgpu::BindGroupEntry {
                binding,
                resource: wgpu::BindingResource::TextureView(&bound.view),
            }),
        });
        Step { pipeline: pipeline.clone(), bound, groups: target.size.map(|side| side.div_ceil(SIDE)) }
    }
}
