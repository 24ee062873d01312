//! A kernel with its inputs in place, to run once or to time.

use std::time::Instant;

use crate::Error;

use super::{Device, Kernel, Work};

/// The bits that the output holds before a run: a quiet NaN, so that what a kernel leaves out is seen.
const UNWRITTEN: u32 = 0x7fc0_0000;

/// A kernel with its inputs and textures on the device.
#[derive(Clone, Debug)]
pub struct Dispatch {
    device: Device,
    pipeline: wgpu::ComputePipeline,
    groups: [u32; 2],
    bind_groups: Vec<(u32, wgpu::BindGroup)>,
    output: wgpu::Buffer,
}

impl Dispatch {
    pub(super) fn new(kernel: &Kernel, work: &Work<'_>) -> Result<Self, Error> {
        let device = &kernel.device;
        check(device, work)?;
        let groups = groups(device, kernel.width, work.invocations)?;
        device.checked("binding a kernel's inputs", || {
            let storage = wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::COPY_SRC;
            let output = buffer(device, "output", 4 * work.output as u64, storage);
            let inputs: Vec<wgpu::Buffer> = work.inputs.iter().map(|values| input(device, values)).collect();
            let buffers = std::iter::once(&output).chain(&inputs).map(wgpu::Buffer::as_entire_binding).collect();
            let textures = work.textures.iter().flat_map(|texture| {
                let view = wgpu::BindingResource::TextureView(texture.view());
                [view, wgpu::BindingResource::Sampler(texture.sampler())]
            });
            let resources: [Vec<wgpu::BindingResource<'_>>; 2] = [buffers, textures.collect()];
            let bind_groups = (0..)
                .zip(resources)
                .filter_map(|(group, resources)| bind_group(kernel, group, resources).map(|bound| (group, bound)));
            let bind_groups = bind_groups.collect();
            let (device, pipeline) = (device.clone(), kernel.pipeline.clone());
            Self { device, pipeline, groups, bind_groups, output }
        })
    }

    /// The numbers that the kernel writes.
    ///
    /// # Errors
    /// [`Error::Device`] where the device refuses the work or is lost.
    pub fn run(&self) -> Result<Vec<f32>, Error> {
        let unwritten = vec![UNWRITTEN; (self.output.size() / 4) as usize];
        let staging = self.device.checked("running a kernel", || {
            let staging = readback(&self.device, self.output.size());
            self.device.queue().write_buffer(&self.output, 0, bytemuck::cast_slice(&unwritten));
            let mut encoder = self.encoder();
            self.encode(&mut encoder, None);
            encoder.copy_buffer_to_buffer(&self.output, 0, &staging, 0, self.output.size());
            self.device.queue().submit([encoder.finish()]);
            staging
        })?;
        read(&self.device, &staging)
    }

    /// Seconds that one run takes on the device: between two timestamps of it, or, where it has none, from submission
    /// to completion on the host's clock. The first run of a kernel may include the driver's compilation.
    ///
    /// # Errors
    /// [`Error::Device`] where the device refuses the work or is lost.
    pub fn time(&self) -> Result<f64, Error> {
        if self.device.has(wgpu::Features::TIMESTAMP_QUERY) {
            return self.timestamps();
        }
        let start = Instant::now();
        self.device.checked("timing a kernel", || {
            let mut encoder = self.encoder();
            self.encode(&mut encoder, None);
            self.device.queue().submit([encoder.finish()]);
        })?;
        self.device.wait()?;
        Ok(start.elapsed().as_secs_f64())
    }

    fn timestamps(&self) -> Result<f64, Error> {
        let staging = self.device.checked("timing a kernel", || {
            let set = self.device.wgpu().create_query_set(&wgpu::QuerySetDescriptor {
                label: Some("timestamps"),
                ty: wgpu::QueryType::Timestamp,
                count: 2,
            });
            let resolve = wgpu::BufferUsages::QUERY_RESOLVE | wgpu::BufferUsages::COPY_SRC;
            let resolved = buffer(&self.device, "timestamps", 16, resolve);
            let staging = readback(&self.device, 16);
            let mut encoder = self.encoder();
            self.encode(&mut encoder, Some(&set));
            encoder.resolve_query_set(&set, 0..2, &resolved, 0);
            encoder.copy_buffer_to_buffer(&resolved, 0, &staging, 0, 16);
            self.device.queue().submit([encoder.finish()]);
            staging
        })?;
        let ticks: Vec<u64> = read(&self.device, &staging)?;
        let elapsed = ticks.last().zip(ticks.first()).map_or(0, |(end, start)| end.saturating_sub(*start));
        Ok(elapsed as f64 * f64::from(self.device.queue().get_timestamp_period()) * 1e-9)
    }

    fn encoder(&self) -> wgpu::CommandEncoder {
        self.device.wgpu().create_command_encoder(&wgpu::CommandEncoderDescriptor::default())
    }

    fn encode(&self, encoder: &mut wgpu::CommandEncoder, timestamps: Option<&wgpu::QuerySet>) {
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor {
            label: None,
            timestamp_writes: timestamps.map(|query_set| wgpu::ComputePassTimestampWrites {
                query_set,
                beginning_of_pass_write_index: Some(0),
                end_of_pass_write_index: Some(1),
            }),
        });
        pass.set_pipeline(&self.pipeline);
        for (group, bound) in &self.bind_groups {
            pass.set_bind_group(*group, bound, &[]);
        }
        pass.dispatch_workgroups(self.groups[0], self.groups[1], 1);
    }
}

fn check(device: &Device, work: &Work<'_>) -> Result<(), Error> {
    let limits = device.wgpu().limits();
    let most = (limits.max_storage_buffer_binding_size.min(limits.max_buffer_size) / 4) as usize;
    let lists =
        work.inputs.iter().enumerate().map(|(number, list)| (format!("the length of input {number}"), list.len()));
    for (what, count) in lists.chain([("the length of the output".to_owned(), work.output)]) {
        if count == 0 || count > most {
            return Err(Error::Size { what, count, allowed: format!("1 to {most}") });
        }
    }
    Ok(())
}

/// Workgroups along x and y: one row where it is enough, full rows otherwise.
fn groups(device: &Device, width: u32, invocations: usize) -> Result<[u32; 2], Error> {
    let limit = device.wgpu().limits().max_compute_workgroups_per_dimension;
    let most = (limit as usize).saturating_mul(limit as usize).saturating_mul(width as usize);
    if invocations == 0 || invocations > most {
        let what = "the number of invocations".to_owned();
        return Err(Error::Size { what, count: invocations, allowed: format!("1 to {most}") });
    }
    let groups = invocations.div_ceil(width as usize);
    let row = groups.min(limit as usize);
    Ok([row as u32, groups.div_ceil(row) as u32])
}

fn buffer(device: &Device, label: &str, size: u64, usage: wgpu::BufferUsages) -> wgpu::Buffer {
    let descriptor = wgpu::BufferDescriptor { label: Some(label), size, usage, mapped_at_creation: false };
    device.wgpu().create_buffer(&descriptor)
}

fn readback(device: &Device, size: u64) -> wgpu::Buffer {
    buffer(device, "readback", size, wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST)
}

fn input(device: &Device, values: &[f32]) -> wgpu::Buffer {
    let usage = wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST;
    let made = buffer(device, "input", 4 * values.len() as u64, usage);
    device.queue().write_buffer(&made, 0, bytemuck::cast_slice(values));
    made
}

/// The resources of one group that the kernel mentions; none where it mentions none.
fn bind_group(kernel: &Kernel, group: u32, resources: Vec<wgpu::BindingResource<'_>>) -> Option<wgpu::BindGroup> {
    let entries = (0..).zip(resources).map(|(binding, resource)| wgpu::BindGroupEntry { binding, resource });
    let entries: Vec<_> = entries.filter(|entry| kernel.bindings.contains(&(group, entry.binding))).collect();
    if !kernel.bindings.iter().any(|at| at.0 == group) {
        return None;
    }
    let layout = kernel.pipeline.get_bind_group_layout(group);
    let descriptor = wgpu::BindGroupDescriptor { label: None, layout: &layout, entries: &entries };
    Some(kernel.device.wgpu().create_bind_group(&descriptor))
}

/// The content of a staging buffer, once the device has written it.
fn read<T: bytemuck::Pod>(device: &Device, staging: &wgpu::Buffer) -> Result<Vec<T>, Error> {
    let failed = |error: &dyn std::fmt::Display| Error::Device { message: format!("reading back: {error}") };
    let (sender, receiver) = std::sync::mpsc::channel();
    device.checked("reading back", || {
        // A closed channel means that the reader gave up: nobody is left to tell.
        staging.map_async(wgpu::MapMode::Read, .., move |mapped| drop(sender.send(mapped)));
    })?;
    device.wait()?;
    receiver.recv().map_err(|error| failed(&error))?.map_err(|error| failed(&error))?;
    let values = {
        let view = staging.get_mapped_range(..).map_err(|error| failed(&error))?;
        bytemuck::pod_collect_to_vec(&view)
    };
    staging.unmap();
    Ok(values)
}
