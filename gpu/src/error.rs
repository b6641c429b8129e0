//! Every way in which the GPU backend can refuse.
use crate::float_controls::FloatControls;
use millpond_core::{SceneError, StepError};

/// Why there is no device, no pipeline or no step.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum GpuError {
    /// No adapter at all, or none of that name.
    #[error("no GPU adapter{}", .wanted.as_ref().map(|w| format!(" whose name contains {w:?}")).unwrap_or_default())]
    NoAdapter {
        /// Part of the name that was asked for.
        wanted: Option<String>,
    },
    /// The adapter gave no device.
    #[error("adapter {adapter} gives no device: {reason}")]
    NoDevice {
        /// Its name.
        adapter: String,
        /// What wgpu says.
        reason: String,
    },
    /// Strict mode needs SPIR-V passed through to the driver, which this adapter does not offer.
    #[error("strict mode needs Vulkan with pass-through shaders; adapter {adapter} ({backend}) has none")]
    NoStrictMode {
        /// Its name.
        adapter: String,
        /// Vulkan, Metal ...
        backend: String,
    },
    /// The device computes a word of the terms otherwise than core, even in strict mode.
    #[error(
        "adapter {adapter} computes `{word}` with other bits than the CPU ({differing} of {tried} inputs); {}",
        .controls.lack()
    )]
    LooseArithmetic {
        /// Its name.
        adapter: String,
        /// The first word that differs.
        word: &'static str,
        /// Inputs whose results differ.
        differing: usize,
        /// Inputs tried.
        tried: usize,
        /// What its driver was asked for, since it offers it.
        controls: FloatControls,
    },
    /// A choice that only the CPU has.
    #[error("{choice} is for the CPU alone: {why}")]
    CpuOnly {
        /// Which.
        choice: &'static str,
        /// Why.
        why: &'static str,
    },
    /// A shader was refused: a defect of this crate.
    #[error("shader refused: {0}")]
    Shader(String),
    /// An array is larger than the device takes.
    #[error("{array} needs {bytes} bytes, and the device takes {limit}")]
    TooLarge {
        /// Which array.
        array: &'static str,
        /// Its size.
        bytes: u64,
        /// The device's limit.
        limit: u64,
    },
    /// A pass of the scene binds more storage buffers than the device takes.
    #[error(
        "pass {pass} of this scene binds {needed} storage buffers, and the device takes {limit}: leave out a feature of the scene"
    )]
    TooManyBuffers {
        /// Which pass.
        pass: &'static str,
        /// Buffers that it binds.
        needed: u32,
        /// The device's limit.
        limit: u32,
    },
    /// The device has no clock that a pass could read.
    #[error("adapter {adapter} cannot time its passes: it offers no timestamp queries")]
    NoPassTimes {
        /// Its name.
        adapter: String,
    },
    /// A step of more passes than can be timed at once.
    #[error(
        "a step of this scene runs {passes} passes, and at most {most} can be timed: lower model.correction.iterations"
    )]
    TooManyPasses {
        /// Passes of a step, repetitions counted.
        passes: usize,
        /// The most.
        most: usize,
    },
    /// The device stopped answering.
    #[error("the device failed: {0}")]
    Device(String),
    /// A change before the first step, which begins with the accelerations that the CPU evaluated.
    #[error(
        "{call} comes before the fluid's first step: call it on the CPU solver that the device starts from, before GpuSolver::new"
    )]
    BeforeFirstStep {
        /// What was called.
        call: &'static str,
    },
    /// More steps than a device can count.
    #[error("{steps} steps are more than the {most} that a device can count: restart it from a CPU solver")]
    TooManySteps {
        /// Steps that were made or asked for.
        steps: u64,
        /// The most.
        most: u64,
    },
    /// A step could not be made; the fluid is as it was before it.
    #[error(transparent)]
    Step(#[from] StepError),
    /// What a host gave does not fit the scene.
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
        let start = "adapter Pond computes `flush` with other bits than the CPU (3 of 8 inputs); the driver ";
        let all = FloatControls { denorm_preserve: true, rounding_rte: true, signed_zero_inf_nan_preserve: true };
        let lacking = "does not offer DenormPreserve for 32-bit floats, so it may flush denormals";
        assert_eq!(refusal(FloatControls { denorm_preserve: false, ..all }), format!("{start}{lacking}"));
        let nor = "nor RoundingModeRTE, so it may round otherwise than to nearest; nor SignedZeroInfNanPreserve, so it may \
                   ignore the sign of zero, infinities and NaN";
        assert_eq!(refusal(FloatControls::default()), format!("{start}{lacking}; {nor}"));
        let none = "was asked for every float control of 32 bits and offers them all";
        assert_eq!(refusal(all), format!("{start}{none}"));
    }
}
