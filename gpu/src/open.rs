//! Opens a device. Any adapter will do, including a software one; for strict mode it must pass the test of the
//! intrinsics.
use crate::device::{Gpu, Mode};
use crate::error::GpuError;
use crate::float_controls::FloatControls;
use crate::intrinsics::{WordReport, test_intrinsics};
use crate::program::Intrinsics;

impl Gpu {
    /// Opens the first adapter that supports `mode` and whose name contains `wanted` (any name for `None`). Hardware
    /// adapters are tried before software adapters.
    ///
    /// # Errors
    /// No adapter has that name, or the reason why the last adapter tried could not be used.
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

    /// Uses a device that your program has already opened, so that a renderer and a fluid can share it. Strict mode
    /// needs Vulkan and [`wgpu::Features::PASSTHROUGH_SHADERS`] among the features of the device.
    ///
    /// # Errors
    /// The device does not support strict mode, or an intrinsic has other bits on it than on the CPU.
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
        let mut gpu = Gpu { device, queue, info, mode, intrinsics: Intrinsics::Native, float_controls };
        if mode == Mode::Strict && gpu.verify_intrinsics().is_err() {
            gpu.intrinsics = Intrinsics::Exact;
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
        // needed only to time passes
        wanted.required_features |= adapter.features() & wgpu::Features::TIMESTAMP_QUERY;
        // buffers may be as large as the adapter allows
        let limits = adapter.limits();
        wanted.required_limits.max_storage_buffer_binding_size = limits.max_storage_buffer_binding_size;
        wanted.required_limits.max_buffer_size = limits.max_buffer_size;
        // most scenes bind at most eight storage buffers in a pass, wgpu's default limit; where a scene binds more than
        // the adapter allows, an error names the pass
        wanted.required_limits.max_storage_buffers_per_shader_stage = limits.max_storage_buffers_per_shader_stage;
        let (device, queue) = pollster::block_on(adapter.request_device(&wanted))
            .map_err(|e| GpuError::NoDevice { adapter: info.name.clone(), reason: e.to_string() })?;
        Gpu::with_device(device, queue, info, mode)
    }

    /// Returns an error if an intrinsic has other bits than core's.
    fn verify_intrinsics(&self) -> Result<(), GpuError> {
        let reports = self.with_error_scopes(|| test_intrinsics(self, &self.intrinsics.prelude()))?;
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
    // SAFETY: pass-through is the only experimental feature in use, and it is given only valid SPIR-V from naga.
    unsafe { wgpu::ExperimentalFeatures::enabled() }
}
