//! A compute shader that turns lists of numbers into a list of numbers.

use std::collections::BTreeSet;

use crate::shader::Shader;
use crate::Error;

use super::{Device, Dispatch, Texture};

/// A compute shader with a fixed convention for its bindings:
///
/// - group 0, binding 0: the output, `var<storage, read_write>` of an array of 4-byte numbers or their vectors;
/// - group 0, bindings 1, 2, …: the inputs in order, `var<storage, read>` arrays;
/// - group 1, bindings 0, 1, 2, 3, …: texture, sampler, texture, sampler, … in order.
///
/// What the shader does not mention is not bound. Invocation `i` of many is found as
/// `id.x + id.y * groups.x * WIDTH` from the global invocation id, the number of workgroups and the width of a
/// workgroup; there may be more invocations than asked for, which must return.
#[derive(Clone, Debug)]
pub struct Kernel {
    pub(super) device: Device,
    pub(super) pipeline: wgpu::ComputePipeline,
    pub(super) width: u32,
    pub(super) bindings: BTreeSet<(u32, u32)>,
}

/// One use of a kernel.
#[derive(Clone, Copy, Debug)]
pub struct Work<'a> {
    /// The lists of numbers that the kernel reads. Bits are kept, so that integers can travel as floats.
    pub inputs: &'a [&'a [f32]],
    /// The textures that it reads.
    pub textures: &'a [&'a Texture],
    /// How many invocations it needs.
    pub invocations: usize,
    /// How many numbers it writes. What it leaves unwritten is NaN.
    pub output: usize,
}

impl Kernel {
    /// Compiles the compute entry point of a WGSL text: naga validates it and writes it for the device.
    ///
    /// # Errors
    /// [`Error::Shader`] where naga refuses the text, [`Error::Device`] where the entry point is missing or the device
    /// refuses the pipeline.
    pub fn new(device: &Device, text: &str, entry: &str) -> Result<Self, Error> {
        let (width, bindings) = interface(text, entry)?;
        let pipeline = device.checked(&format!("compiling `{entry}`"), || {
            let module = device.wgpu().create_shader_module(wgpu::ShaderModuleDescriptor {
                label: Some(entry),
                source: wgpu::ShaderSource::Wgsl(text.into()),
            });
            device.wgpu().create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
                label: Some(entry),
                layout: None,
                module: &module,
                entry_point: Some(entry),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                cache: None,
            })
        })?;
        Ok(Self { device: device.clone(), pipeline, width, bindings })
    }

    /// Uploads the inputs, for one or many runs.
    ///
    /// # Errors
    /// [`Error::Size`] for an empty list or a list over the device's limits, [`Error::Device`] where the bindings do
    /// not fit the kernel's.
    pub fn prepare(&self, work: &Work<'_>) -> Result<Dispatch, Error> {
        Dispatch::new(self, work)
    }

    /// The numbers that the kernel writes for the given inputs.
    ///
    /// # Errors
    /// Those of [`Kernel::prepare`] and [`Dispatch::run`].
    pub fn run(&self, work: &Work<'_>) -> Result<Vec<f32>, Error> {
        self.prepare(work)?.run()
    }
}

/// The width of a workgroup, and the bindings that the entry point mentions.
fn interface(text: &str, entry: &str) -> Result<(u32, BTreeSet<(u32, u32)>), Error> {
    let shader = Shader::new("kernel.wgsl", text.to_owned())?;
    let (module, info) = shader.parsed();
    let compute = |point: &naga::EntryPoint| point.name == entry && point.stage == naga::ShaderStage::Compute;
    let Some(number) = module.entry_points.iter().position(compute) else {
        return Err(Error::Device { message: format!("the text has no compute entry point `{entry}`") });
    };
    let width = module.entry_points[number].workgroup_size[0];
    let used = info.get_entry_point(number);
    let bindings = module.global_variables.iter().filter(|&(handle, _)| !used[handle].is_empty());
    let bindings = bindings.filter_map(|(_, variable)| variable.binding).map(|at| (at.group, at.binding)).collect();
    Ok((width, bindings))
}
