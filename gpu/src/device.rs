//! Choosing a device. Any adapter will do, a software one too.
use crate::error::GpuError;
use crate::strict::spirv;
use crate::words::{WordReport, try_words};
use std::borrow::Cow;

/// How the programs reach the driver.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// Every float operation by the letter: the bits of the CPU. Needs Vulkan with pass-through shaders.
    Strict,
    /// As the driver likes it: any backend, no promise about bits.
    Plain,
}

/// An open device.
#[derive(Clone, Debug)]
pub struct Gpu {
    pub(crate) device: wgpu::Device,
    pub(crate) queue: wgpu::Queue,
    info: wgpu::AdapterInfo,
    mode: Mode,
}

impl Gpu {
    /// Opens the first adapter whose name contains `wanted` (any, without), hardware before software.
    ///
    /// # Errors
    /// No adapter, no device, or no strict mode on it.
    pub fn open(wanted: Option<&str>, mode: Mode) -> Result<Gpu, GpuError> {
        let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
        if mode == Mode::Strict {
            descriptor.backends = wgpu::Backends::VULKAN;
        }
        let instance = wgpu::Instance::new(descriptor);
        let mut adapters = pollster::block_on(instance.enumerate_adapters(wgpu::Backends::all()));
        adapters.sort_by_key(|a| a.get_info().device_type == wgpu::DeviceType::Cpu);
        let matches = |a: &wgpu::Adapter| wanted.is_none_or(|w| a.get_info().name.contains(w));
        let adapter = adapters
            .into_iter()
            .find(matches)
            .ok_or_else(|| GpuError::NoAdapter { wanted: wanted.map(str::to_owned) })?;
        Gpu::of(&adapter, mode)
    }

    fn of(adapter: &wgpu::Adapter, mode: Mode) -> Result<Gpu, GpuError> {
        let info = adapter.get_info();
        let strict = wgpu::Features::PASSTHROUGH_SHADERS;
        let mut wanted = wgpu::DeviceDescriptor { label: Some("millpond"), ..Default::default() };
        if mode == Mode::Strict {
            if info.backend != wgpu::Backend::Vulkan || !adapter.features().contains(strict) {
                let (adapter, backend) = (info.name, info.backend.to_string());
                return Err(GpuError::NoStrictMode { adapter, backend });
            }
            wanted.required_features = strict;
            wanted.experimental_features = experimental();
        }
        // buffers may be as large as the adapter takes
        let limits = adapter.limits();
        wanted.required_limits.max_storage_buffer_binding_size = limits.max_storage_buffer_binding_size;
        wanted.required_limits.max_buffer_size = limits.max_buffer_size;
        let (device, queue) = pollster::block_on(adapter.request_device(&wanted))
            .map_err(|e| GpuError::NoDevice { adapter: info.name.clone(), reason: e.to_string() })?;
        let gpu = Gpu { device, queue, info, mode };
        if mode == Mode::Strict {
            gpu.prove_words()?;
        }
        Ok(gpu)
    }

    /// Refuses a device whose words differ from core's.
    fn prove_words(&self) -> Result<(), GpuError> {
        match try_words(self)?.into_iter().find(|report| report.differing > 0) {
            None => Ok(()),
            Some(WordReport { word, tried, differing }) => {
                Err(GpuError::LooseArithmetic { adapter: self.name(), word, differing, tried })
            }
        }
    }

    /// Name and driver of the adapter.
    #[must_use]
    pub fn name(&self) -> String {
        format!("{} ({} {})", self.info.name, self.info.driver, self.info.driver_info)
    }

    /// How programs reach the driver.
    #[must_use]
    pub fn mode(&self) -> Mode {
        self.mode
    }

    /// A shader module of a complete program whose entry point is `main`.
    pub(crate) fn module(&self, label: &str, wgsl: &str, workgroup: u32) -> Result<wgpu::ShaderModule, GpuError> {
        match self.mode {
            Mode::Plain => Ok(self.device.create_shader_module(wgpu::ShaderModuleDescriptor {
                label: Some(label),
                source: wgpu::ShaderSource::Wgsl(wgsl.into()),
            })),
            Mode::Strict => Ok(self.pass_through(label, spirv(wgsl)?, workgroup)),
        }
    }

    #[expect(unsafe_code, reason = "pass-through is how a driver gets SPIR-V with NoContraction")]
    fn pass_through(&self, label: &str, words: Vec<u32>, workgroup: u32) -> wgpu::ShaderModule {
        let entry = wgpu::PassthroughShaderEntryPoint { name: "main".into(), workgroup_size: (workgroup, 1, 1) };
        let descriptor = wgpu::ShaderModuleDescriptorPassthrough {
            label: Some(label),
            entry_points: Cow::Owned(vec![entry]),
            spirv: Some(Cow::Owned(words)),
            ..Default::default()
        };
        // SAFETY: the words are naga's, of a validated module and with its bounds checks; only decorations were added.
        unsafe { self.device.create_shader_module_passthrough(descriptor) }
    }
}

#[expect(unsafe_code, reason = "wgpu counts pass-through among its experimental features")]
fn experimental() -> wgpu::ExperimentalFeatures {
    // SAFETY: the one experimental feature in use is pass-through, and it is given only naga's own valid SPIR-V.
    unsafe { wgpu::ExperimentalFeatures::enabled() }
}
