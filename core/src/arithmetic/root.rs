//! Square roots: the one operation that `core` lacks and every processor rounds correctly.

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
