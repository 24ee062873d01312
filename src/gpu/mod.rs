//! Feature `gpu`: shaders on a device, without a window. The only place of the crate that names wgpu.
//!
//! A [`Device`] holds the tables of a module as [`Texture`]s and runs compute kernels over lists of numbers, which is
//! how the crate's own tests, figures and tools run WGSL: naga writes it as SPIR-V, and the Vulkan driver does the
//! rest.
//!
//! ```no_run
//! use prefilter::gpu::{Device, Kernel, Work};
//!
//! let device = Device::new()?;
//! let text = "
//! @group(0) @binding(0) var<storage, read_write> output: array<f32>;
//! @group(0) @binding(1) var<storage, read> heights: array<f32>;
//! @compute @workgroup_size(64)
//! fn main(@builtin(global_invocation_id) id: vec3u, @builtin(num_workgroups) groups: vec3u) {
//!     let index = id.x + id.y * groups.x * 64u;
//!     if index < arrayLength(&output) {
//!         output[index] = 2.0 * heights[index];
//!     }
//! }";
//! let kernel = Kernel::new(&device, text, "main")?;
//! let doubled = kernel.run(&Work { inputs: &[&[1.0, 2.0]], textures: &[], invocations: 2, output: 2 })?;
//! assert_eq!(doubled, [2.0, 4.0]);
//! # Ok::<(), prefilter::Error>(())
//! ```

mod device;
mod dispatch;
mod kernel;
mod moment_pass;
mod moment_pyramid;
mod texture;

pub use device::Device;
pub use dispatch::Dispatch;
pub use kernel::{Kernel, Work};
pub use moment_pass::MomentPass;
pub use moment_pyramid::MomentPyramid;
pub use texture::{Address, Texture};
