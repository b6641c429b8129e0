//! Operations that `core` lacks and that every processor computes exactly: square root and floor.

/// Returns the correctly rounded square roots of four numbers. `core` has no `sqrt`, and that of `libm` is a scalar
/// instruction in inline assembly, which costs 80 times as much inside vector code.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
#[expect(unsafe_code, reason = "the vector square root is only to be had as an intrinsic")]
pub(crate) fn root4(x: [f32; 4]) -> [f32; 4] {
    // SAFETY: the intrinsic needs only SSE, which is part of every x86-64.
    bytemuck::cast(unsafe { core::arch::x86_64::_mm_sqrt_ps(bytemuck::cast(x)) })
}

/// Returns the correctly rounded square roots of four numbers.
#[cfg(target_arch = "aarch64")]
#[inline(always)]
#[expect(unsafe_code, reason = "the vector square root is only to be had as an intrinsic")]
pub(crate) fn root4(x: [f32; 4]) -> [f32; 4] {
    use core::arch::aarch64::{vld1q_f32, vsqrtq_f32, vst1q_f32};
    let mut roots = [0.0; 4];
    // SAFETY: the intrinsics need only NEON, which is part of every aarch64; both pointers span four numbers.
    unsafe { vst1q_f32(roots.as_mut_ptr(), vsqrtq_f32(vld1q_f32(x.as_ptr()))) };
    roots
}

/// Returns the correctly rounded square roots of four numbers.
#[cfg(not(any(target_arch = "x86_64", target_arch = "aarch64")))]
#[inline(always)]
pub(crate) fn root4(x: [f32; 4]) -> [f32; 4] {
    x.map(libm::sqrtf)
}

/// Magnitude from which on every `f32` is an integer.
const ALL_WHOLE: f32 = 8_388_608.0;

/// Returns the largest integer that is not greater than `x`, by conversions that exist as vector instructions.
#[inline(always)]
pub(crate) fn floor(x: f32) -> f32 {
    let towards_zero = x as i32 as f32;
    let down = if towards_zero > x { towards_zero - 1.0 } else { towards_zero };
    // Integers, -0 among them, infinities and NaN stay as they are.
    if down != x && x.abs() < ALL_WHOLE { down } else { x }
}
