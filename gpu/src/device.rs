//! An open device, and the two modes in which programs reach its driver.
use crate::error::GpuError;
use crate::float_controls::FloatControls;
use crate::program::Intrinsics;
use crate::strict::spirv;
use std::borrow::Cow;

/// How programs reach the driver.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// The driver must execute every float operation exactly as written, so that results have the bits of the CPU.
    /// Needs Vulkan with pass-through shaders.
    Strict,
    /// The driver may optimise float operations. Works on any backend, without any promise about bits.
    Plain,
}

/// An open device.
#[derive(Clone, Debug)]
pub struct Gpu {
    pub(crate) device: wgpu::Device,
    pub(crate) queue: wgpu::Queue,
    pub(crate) info: wgpu::AdapterInfo,
    pub(crate) mode: Mode,
    pub(crate) intrinsics: Intrinsics,
    pub(crate) float_controls: FloatControls,
}

impl Gpu {
    /// Runs `make` inside wgpu's error scopes, so that errors found by wgpu are returned. Outside a scope wgpu would
    /// panic.
    pub(crate) fn with_error_scopes<T>(&self, make: impl FnOnce() -> Result<T, GpuError>) -> Result<T, GpuError> {
        let filters = [wgpu::ErrorFilter::OutOfMemory, wgpu::ErrorFilter::Validation, wgpu::ErrorFilter::Internal];
        let scopes = filters.map(|filter| self.device.push_error_scope(filter));
        let made = make();
        // scopes form a stack, so the last one pushed must be popped first
        let errors: Vec<_> = scopes.into_iter().rev().filter_map(|scope| pollster::block_on(scope.pop())).collect();
        match errors.first() {
            Some(error) => Err(GpuError::Device(error.to_string())),
            None => made,
        }
    }

    /// Returns the name and the driver of the adapter.
    #[must_use]
    pub fn name(&self) -> String {
        format!("{} ({} {})", self.info.name, self.info.driver, self.info.driver_info)
    }

    /// Returns how programs reach the driver.
    #[must_use]
    pub fn mode(&self) -> Mode {
        self.mode
    }

    /// Returns where division and square root come from on this device.
    #[must_use]
    pub fn intrinsics(&self) -> Intrinsics {
        self.intrinsics
    }

    /// Returns the float controls that the driver offers. Strict mode requests all of these.
    #[must_use]
    pub fn float_controls(&self) -> FloatControls {
        self.float_controls
    }

    /// Creates the shader module of a complete program whose entry point is `main`.
    pub(crate) fn module(&self, label: &str, wgsl: &str, workgroup: u32) -> Result<wgpu::ShaderModule, GpuError> {
        match self.mode {
            Mode::Plain => Ok(self.device.create_shader_module(wgpu::ShaderModuleDescriptor {
                label: Some(label),
                source: wgpu::ShaderSource::Wgsl(wgsl.into()),
            })),
            Mode::Strict => Ok(self.pass_through(label, spirv(wgsl, self.float_controls)?, workgroup)),
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
        // SAFETY: the SPIR-V comes from naga, which validated the module and added bounds checks. Only decorations
        // were added, and float controls that this device offers.
        unsafe { self.device.create_shader_module_passthrough(descriptor) }
    }
}
