//! SPIR-V's float controls for 32-bit floats: guarantees about float arithmetic that a driver gives if a program
//! requests them.
//!
//! A driver that offers none of them may still compute as core does, and one that offers all of them may not, so the
//! test of the intrinsics ([`crate::intrinsics`]) decides. Some drivers flush denormals unless a program requests
//! otherwise, so every control that is offered is requested.

/// The float controls that a driver offers for 32-bit floats; none by default.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FloatControls {
    /// Denormals are preserved, as operands and as results.
    pub denorm_preserve: bool,
    /// Results are rounded to nearest, ties to even.
    pub rounding_rte: bool,
    /// No expression is rewritten on the assumption that -0 equals 0, or that infinities and NaN do not occur.
    pub signed_zero_inf_nan_preserve: bool,
}

/// One float control, as defined by SPIR-V.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct FloatControl {
    /// Name of its capability and of its execution mode.
    name: &'static str,
    /// What a driver may do without it.
    without: &'static str,
    /// Number of the capability.
    pub(crate) capability: u32,
    /// Number of the execution mode.
    pub(crate) mode: u32,
}

const DENORM_PRESERVE: FloatControl =
    FloatControl { name: "DenormPreserve", without: "flush denormals", capability: 4464, mode: 4459 };
const ROUNDING_RTE: FloatControl =
    FloatControl { name: "RoundingModeRTE", without: "round otherwise than to nearest", capability: 4467, mode: 4462 };
const SIGNED_ZERO_INF_NAN_PRESERVE: FloatControl = FloatControl {
    name: "SignedZeroInfNanPreserve",
    without: "ignore the sign of zero, infinities and NaN",
    capability: 4466,
    mode: 4461,
};

impl FloatControls {
    /// Returns the controls that the driver of this device offers and that a program can request. There are none
    /// outside Vulkan, and none below Vulkan 1.2, where they would need an extension that wgpu does not enable.
    #[must_use]
    pub fn offered_by(device: &wgpu::Device) -> FloatControls {
        offered_by(device)
    }

    fn each(self) -> [(FloatControl, bool); 3] {
        [
            (DENORM_PRESERVE, self.denorm_preserve),
            (ROUNDING_RTE, self.rounding_rte),
            (SIGNED_ZERO_INF_NAN_PRESERVE, self.signed_zero_inf_nan_preserve),
        ]
    }

    /// Returns the controls that are offered.
    pub(crate) fn offered(self) -> impl Iterator<Item = FloatControl> {
        self.each().into_iter().filter_map(|(control, offered)| offered.then_some(control))
    }

    /// Returns the end of an error message about a driver that computes differently from core: the controls that it
    /// does not offer, and what it may do without them.
    pub(crate) fn lack(self) -> String {
        let lacking = self.each().into_iter().filter_map(|(control, offered)| (!offered).then_some(control));
        let clause = |(i, FloatControl { name, without, .. }): (usize, FloatControl)| match i {
            0 => format!("the driver does not offer {name} for 32-bit floats, so it may {without}"),
            _ => format!("nor {name}, so it may {without}"),
        };
        let clauses: Vec<String> = lacking.enumerate().map(clause).collect();
        if clauses.is_empty() {
            return "the driver was asked for every float control of 32 bits and offers them all".into();
        }
        clauses.join("; ")
    }
}

// the platforms on which wgpu supports Vulkan with the features that this crate requires
#[cfg(any(windows, target_os = "linux", target_os = "android", target_os = "freebsd"))]
#[expect(unsafe_code, reason = "wgpu does not tell what a driver offers for floats, so Vulkan itself is asked")]
fn offered_by(device: &wgpu::Device) -> FloatControls {
    use ash::vk;
    // SAFETY: the guard is only read from, and it is dropped before the device.
    let Some(raw) = (unsafe { device.as_hal::<wgpu::hal::api::Vulkan>() }) else {
        return FloatControls::default();
    };
    let (instance, physical) = (raw.shared_instance(), raw.raw_physical_device());
    let vulkan = instance.raw_instance();
    // SAFETY: a physical device is valid as long as its instance, which the guard keeps alive.
    let version = unsafe { vulkan.get_physical_device_properties(physical) }.api_version;
    if instance.instance_api_version().min(version) < vk::API_VERSION_1_2 {
        return FloatControls::default();
    }
    let mut controls = vk::PhysicalDeviceFloatControlsProperties::default();
    let mut properties = vk::PhysicalDeviceProperties2::default().push_next(&mut controls);
    // SAFETY: as above; instance and device support Vulkan 1.2, so both the call and the structure in the chain are
    // part of core Vulkan.
    unsafe { vulkan.get_physical_device_properties2(physical, &mut properties) };
    FloatControls {
        denorm_preserve: controls.shader_denorm_preserve_float32 == vk::TRUE,
        rounding_rte: controls.shader_rounding_mode_rte_float32 == vk::TRUE,
        signed_zero_inf_nan_preserve: controls.shader_signed_zero_inf_nan_preserve_float32 == vk::TRUE,
    }
}

#[cfg(not(any(windows, target_os = "linux", target_os = "android", target_os = "freebsd")))]
fn offered_by(_: &wgpu::Device) -> FloatControls {
    FloatControls::default()
}
