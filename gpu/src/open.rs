//! Choosing a device. Any adapter will do, a software one too; for strict mode it must pass the words' test.
use crate::device::{Gpu, Mode};
use crate::error::GpuError;
use crate::float_controls::FloatControls;
use crate::intrinsics::{WordReport, test_intrinsics};
use crate::program::Intrinsics;

impl Gpu {
    /// Opens the first adapter whose name contains `wanted` (any, without) and that has this mode, hardware before
    /// software.
    ///
    /// # Errors
    /// No adapter of that name, or why the last of them was no good.
    pub fn open(wanted: Option<&str>, mode: Mode) -> Result<Gpu, GpuError> {
        let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
        if mode == Mode::Strict {
            descriptor.backends = wgpu::Backends::VULKAN;
        }
        let instance = wgpu::Instance::new(descriptor);
        let mut adapters = pollster::block_on(instance.enumerate_adapters(wgpu::Backends::all()));
        adapters.retain(|a| wanted.is_none_or(|w| a.get_info().name.contains(w)));
        adapters.sort_by_key(|a| a.get_info().device_type == wgpu::DeviceType::Cpu);
        let mut refused = GpuError::NoAdapter { wanted: wanted.map(str::to_owned) };
        for adapter in &adapters {
            match Gpu::of(adapter, mode) {
                Ok(gpu) => return Ok(gpu),
                Err(error) => refused = error,
            }
        }
        Err(refused)
    }

    /// A device that the host has already, for a renderer and a fluid that share it. Strict mode needs Vulkan and
    /// [`wgpu::Features::PASSTHROUGH_SHADERS`] among its features.
    ///
    /// # Errors
    /// No strict mode on it.
    pub fn with_device(
        device: wgpu::Device,
        queue: wgpu::Queue,
        info: wgpu::AdapterInfo,
        mode: Mode,
    ) -> Result<Gpu, GpuError> {
        let strict = device.features().contains(wgpu::Features::PASSTHROUGH_SHADERS);
        if mode == Mode::Strict && (info.backend != wgpu::Backend::Vulkan || !strict) {
            return Err(no_strict_mode(&info));
        }
        let float_controls = FloatControls::offered_by(&device);
        let mut gpu = Gpu { device, queue, info, mode, words: Intrinsics::Native, float_controls };
        if mode == Mode::Strict && gpu.verify_intrinsics().is_err() {
            gpu.words = Intrinsics::Exact;
            gpu.verify_intrinsics()?;
        }
        Ok(gpu)
    }

    fn of(adapter: &wgpu::Adapter, mode: Mode) -> Result<Gpu, GpuError> {
        let info = adapter.get_info();
        let strict = wgpu::Features::PASSTHROUGH_SHADERS;
        let mut wanted = wgpu::DeviceDescriptor { label: Some("millpond"), ..Default::default() };
        if mode == Mode::Strict {
            if info.backend != wgpu::Backend::Vulkan || !adapter.features().contains(strict) {
                return Err(no_strict_mode(&info));
            }
            wanted.required_features = strict;
            wanted.experimental_features = experimental();
        }
        // only to say how long a pass took
        wanted.required_features |= adapter.features() & wgpu::Features::TIMESTAMP_QUERY;
        // buffers may be as large as the adapter takes
        let limits = adapter.limits();
        wanted.required_limits.max_storage_buffer_binding_size = limits.max_storage_buffer_binding_size;
        wanted.required_limits.max_buffer_size = limits.max_buffer_size;
        // most scenes bind eight in a pass, wgpu's default; a scene that binds more is refused by name where there are fewer
        wanted.required_limits.max_storage_buffers_per_shader_stage = limits.max_storage_buffers_per_shader_stage;
        let (device, queue) = pollster::block_on(adapter.request_device(&wanted))
            .map_err(|e| GpuError::NoDevice { adapter: info.name.clone(), reason: e.to_string() })?;
        Gpu::with_device(device, queue, info, mode)
    }

    /// Refuses words that differ from core's.
    fn verify_intrinsics(&self) -> Result<(), GpuError> {
        let reports = self.with_error_scopes(|| test_intrinsics(self, &self.words.prelude()))?;
        match reports.into_iter().find(|report| report.differing > 0) {
            None => Ok(()),
            Some(WordReport { word, tried, differing }) => {
                let controls = self.float_controls;
                Err(GpuError::LooseArithmetic { adapter: self.name(), word, differing, tried, controls })
            }
        }
    }
}

fn no_strict_mode(info: &wgpu::AdapterInfo) -> GpuError {
    GpuError::NoStrictMode { adapter: info.name.clone(), backend: info.backend.to_string() }
}

#[expect(unsafe_code, reason = "wgpu counts pass-through among its experimental features")]
fn experimental() -> wgpu::ExperimentalFeatures {
    // SAFETY: the one experimental feature in use is pass-through, and it is given only naga's own valid SPIR-V.
    unsafe { wgpu::ExperimentalFeatures::enabled() }
}
