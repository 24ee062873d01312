//! A device without a window, and its errors as values.

use crate::Error;

/// What to do where no device answers.
const ADVICE: &str = "on Debian or Ubuntu install Mesa's lavapipe: apt-get install mesa-vulkan-drivers";

/// A Vulkan device (or what the host's wgpu offers) and its queue; threads may share it.
#[derive(Clone, Debug)]
pub struct Device {
    device: wgpu::Device,
    queue: wgpu::Queue,
    label: String,
}

impl Device {
    /// The fastest device of the machine, headless, with every limit that its adapter offers, and with filtering of
    /// 32-bit floats and timestamps where it has them. `VK_ICD_FILENAMES` chooses the Vulkan driver,
    /// `WGPU_VALIDATION=1` turns the validation layer on.
    ///
    /// # Errors
    /// [`Error::Device`] where no adapter is found, with the way to get one, or where the adapter refuses the device.
    pub fn new() -> Result<Self, Error> {
        let instance = wgpu::Instance::new(wgpu::InstanceDescriptor {
            // Never DEBUG, which debug builds default to: naga then writes OpSource WGSL, and older layers refuse it.
            flags: wgpu::InstanceFlags::empty().with_env(),
            ..wgpu::InstanceDescriptor::new_without_display_handle()
        });
        let options = wgpu::RequestAdapterOptions {
            power_preference: wgpu::PowerPreference::HighPerformance,
            ..Default::default()
        };
        let adapter = pollster::block_on(instance.request_adapter(&options))
            .map_err(|_| Error::Device { message: format!("no graphics device answers; {ADVICE}") })?;
        let wanted = wgpu::Features::FLOAT32_FILTERABLE | wgpu::Features::TIMESTAMP_QUERY;
        let descriptor = wgpu::DeviceDescriptor {
            label: Some("prefilter"),
            required_features: adapter.features() & wanted,
            required_limits: adapter.limits(),
            ..Default::default()
        };
        let (device, queue) = pollster::block_on(adapter.request_device(&descriptor)).map_err(|error| {
            let name = adapter.get_info().name;
            Error::Device { message: format!("{name} refuses a device ({error}); {ADVICE}") }
        })?;
        Ok(Self::from_wgpu(device, queue))
    }

    /// A device that the host has already.
    pub fn from_wgpu(device: wgpu::Device, queue: wgpu::Queue) -> Self {
        let info = device.adapter_info();
        let driver = format!("{} {}", info.driver, info.driver_info);
        let label = format!("{} ({}, {:?})", info.name, driver.trim(), info.backend);
        Self { device, queue, label }
    }

    /// The names of the adapter, its driver and the backend.
    pub fn label(&self) -> &str {
        &self.label
    }

    /// The device, for hosts that make resources of their own.
    pub fn wgpu(&self) -> &wgpu::Device {
        &self.device
    }

    /// The device's queue.
    pub fn queue(&self) -> &wgpu::Queue {
        &self.queue
    }

    /// Whether every given feature is turned on.
    pub(super) fn has(&self, features: wgpu::Features) -> bool {
        self.device.features().contains(features)
    }

    /// Runs calls of wgpu and turns what wgpu finds wrong in them into an error that begins with `doing`.
    pub(super) fn checked<T>(&self, doing: &str, calls: impl FnOnce() -> T) -> Result<T, Error> {
        let filters = [wgpu::ErrorFilter::Internal, wgpu::ErrorFilter::OutOfMemory, wgpu::ErrorFilter::Validation];
        let scopes = filters.map(|filter| self.device.push_error_scope(filter));
        let value = calls();
        let mut found = None;
        for scope in scopes.into_iter().rev() {
            let error = pollster::block_on(scope.pop());
            found = found.or(error);
        }
        match found {
            None => Ok(value),
            Some(error) => Err(Error::Device { message: format!("{doing}: {error}") }),
        }
    }

    /// Waits until the queue is empty.
    pub(super) fn wait(&self) -> Result<(), Error> {
        let waited = self.device.poll(wgpu::PollType::wait_indefinitely());
        waited.map(|_| ()).map_err(|error| Error::Device { message: format!("waiting for {}: {error}", self.label) })
    }
}
