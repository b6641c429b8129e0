//! A device, and how programs reach its driver.
use crate::error::GpuError;
use crate::strict::spirv;
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
    pub(crate) info: wgpu::AdapterInfo,
    pub(crate) mode: Mode,
}

impl Gpu {
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
