//! Errors of the GPU backend.
use crate::float_controls::FloatControls;
use millpond_core::{SceneError, SolidError, StepError};

/// Why a device, a pipeline or a step is not available.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum GpuError {
    /// There is no adapter, or none whose name contains the given text.
    #[error(
        "no GPU adapter was found{}: install its driver, or a software driver",
        .wanted.as_ref().map(|w| format!(" whose name contains {w:?}")).unwrap_or_default()
    )]
    NoAdapter {
        /// Part of the name that was requested.
        wanted: Option<String>,
    },
    /// The adapter could not open a device.
    #[error("adapter {adapter} could not open a device: {reason}")]
    NoDevice {
        /// Name of the adapter.
        adapter: String,
        /// The message of wgpu.
        reason: String,
    },
    /// Strict mode passes SPIR-V through to the driver, which this adapter does not support.
    #[error(
        "strict mode needs Vulkan with pass-through shaders, which adapter {adapter} ({backend}) lacks: use plain mode"
    )]
    NoStrictMode {
        /// Name of the adapter.
        adapter: String,
        /// Name of its backend: Vulkan, Metal ...
        backend: String,
    },
    /// The device computes an intrinsic with other bits than core, even in strict mode.
    #[error(
        "adapter {adapter} computes `{word}` unlike the CPU for {differing} of {tried} inputs: use plain mode; {}",
        .controls.lack()
    )]
    LooseArithmetic {
        /// Name of the adapter.
        adapter: String,
        /// The first intrinsic that differs.
        word: &'static str,
        /// Number of inputs whose results differ.
        differing: usize,
        /// Number of inputs tried.
        tried: usize,
        /// The float controls that the driver offers, all of which were requested.
        controls: FloatControls,
    },
    /// A solid could not be moved.
    #[error(transparent)]
    Solid(#[from] SolidError),
    /// The scene makes a choice that only the CPU supports.
    #[error("{choice} is supported on the CPU only: {why}")]
    CpuOnly {
        /// The choice: its field and value.
        choice: &'static str,
        /// Why a device does not support it, and what to choose instead.
        why: &'static str,
    },
    /// The shader compiler rejected a program. This is a defect of this crate.
    #[error("the shader compiler rejected a program, which is a defect of millpond: {0}")]
    Shader(String),
    /// A buffer would be larger than the device allows.
    #[error("buffer {array} needs {bytes} bytes, but the device allows {limit}: use fewer particles or grid cells")]
    TooLarge {
        /// Name of the buffer, usually that of an array.
        array: &'static str,
        /// Size that is needed, bytes.
        bytes: u64,
        /// Largest size that the device allows, bytes.
        limit: u64,
    },
    /// A pass of the scene binds more storage buffers than the device allows.
    #[error(
        "pass {pass} binds {needed} storage buffers, but the device allows {limit}: switch off a feature of the scene"
    )]
    TooManyBuffers {
        /// Name of the pass.
        pass: &'static str,
        /// Number of storage buffers that it binds.
        needed: u32,
        /// Largest number that the device allows.
        limit: u32,
    },
    /// The device offers no timestamp queries, so passes cannot be timed.
    #[error("adapter {adapter} lacks timestamp queries, which time passes: use another adapter, or step without times")]
    NoPassTimes {
        /// Name of the adapter.
        adapter: String,
    },
    /// A step has more passes than can be timed at once.
    #[error(
        "a step of this scene runs {passes} passes, but at most {most} can be timed: lower model.correction.iterations"
    )]
    TooManyPasses {
        /// Number of passes of a step, repetitions included.
        passes: usize,
        /// Largest number of passes that can be timed.
        most: usize,
    },
    /// The device failed, or stopped responding.
    #[error("the device failed: {0}")]
    Device(String),
    /// A change was made before the first step. That step begins with accelerations that the CPU has already
    /// evaluated.
    #[error("{call} was called before the first step: call it on the CPU solver, before GpuSolver::new")]
    BeforeFirstStep {
        /// Name of the function that was called.
        call: &'static str,
    },
    /// More steps were made or requested than a device can count.
    #[error("a device cannot count {steps} steps, only {most}: continue on the CPU, or start a new solver")]
    TooManySteps {
        /// Number of steps made or requested, counted from the start of the simulation.
        steps: u64,
        /// Largest number of steps that a device can count.
        most: u64,
    },
    /// A step failed. The fluid is as it was before that step.
    #[error(transparent)]
    Step(#[from] StepError),
    /// Input from the caller does not fit the scene.
    #[error(transparent)]
    Scene(#[from] SceneError),
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_refusal_names_what_the_driver_lacks() {
        let refusal = |controls| {
            let (adapter, word) = ("Pond".into(), "flush");
            GpuError::LooseArithmetic { adapter, word, differing: 3, tried: 8, controls }.to_string()
        };
        let start = "adapter Pond computes `flush` unlike the CPU for 3 of 8 inputs: use plain mode; the driver ";
        let all = FloatControls { denorm_preserve: true, rounding_rte: true, signed_zero_inf_nan_preserve: true };
        let lacking = "does not offer DenormPreserve for 32-bit floats, so it may flush denormals";
        assert_eq!(refusal(FloatControls { denorm_preserve: false, ..all }), format!("{start}{lacking}"));
        let nor = "nor RoundingModeRTE, so it may round otherwise than to nearest; nor SignedZeroInfNanPreserve, so it \
                   may ignore the sign of zero, infinities and NaN";
        assert_eq!(refusal(FloatControls::default()), format!("{start}{lacking}; {nor}"));
        let none = "was asked for every float control of 32 bits and offers them all";
        assert_eq!(refusal(all), format!("{start}{none}"));
    }
}
