//! What `core` lacks and every processor does exactly: square roots, and the floor.

/// Correctly rounded roots of four numbers. `core` has no `sqrt`, and `libm`'s is a scalar instruction in inline
/// assembly, which inside vector code costs 80 times as much.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
#[expect(unsafe_code, reason = "the vector square root is only to be had as an intrinsic")]
pub(crate) fn root4(x: [f32; 4]) -> [f32; 4] {
    // SAFETY: SSE, all that the intrinsic needs, is part of every x86-64.
    bytemuck::cast(unsafe { core::arch::x86_64::_mm_sqrt_ps(bytemuck::cast(x)) })
}

/// Correctly rounded roots of four numbers.
#[cfg(target_arch = "aarch64")]
#[inline(always)]
#[expect(unsafe_code, reason = "the vector square root is only to be had as an intrinsic")]
pub(crate) fn root4(x: [f32; 4]) -> [f32; 4] {
    use core::arch::aarch64::{vld1q_f32, vsqrtq_f32, vst1q_f32};
    let mut roots = [0.0; 4];
    // SAFETY: NEON, all that the intrinsics need, is part of every aarch64; both pointers span four numbers.
    unsafe { vst1q_f32(roots.as_mut_ptr(), vsqrtq_f32(vld1q_f32(x.as_ptr()))) };
    roots
}

/// Correctly rounded roots of four numbers.
#[cfg(not(any(target_arch = "x86_64", target_arch = "aarch64")))]
#[inline(always)]
pub(crate) fn root4(x: [f32; 4]) -> [f32; 4] {
    x.map(libm::sqrtf)
}

/// From here on every number is whole.
const ALL_WHOLE: f32 = 8_388_608.0;

/// The largest whole number that is not larger, by the conversions that vector instructions have.
#[inline(always)]
pub(crate) fn floor(x: f32) -> f32 {
    let towards_zero = x as i32 as f32;
    let down = if towards_zero > x { towards_zero - 1.0 } else { towards_zero };
    // a whole number stays, -0 too, and so does what is none
    if down != x && x.abs() < ALL_WHOLE { down } else { x }
}
