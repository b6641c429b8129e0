//! Eight numbers side by side: a plain array that LLVM turns into vector instructions wherever it is inlined into a
//! function compiled for them ([`level`](super::level)).
//!
//! One particle a lane, never a sum across lanes: so eight lanes give the bits of eight scalar runs.
use super::real::Real;
use core::ops::{Add, Mul, Neg, Sub};

/// Lanes of the vector path. Sixteen lost to eight where it was tried: a cell seldom holds so many particles.
pub const LANES: usize = 8;

/// `LANES` numbers side by side.
#[derive(Clone, Copy, Debug)]
pub struct Lanes(pub [f32; LANES]);

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

macro_rules! each {
    ($i:ident => $e:expr) => {{
        let mut out = [0.0f32; LANES];
        let mut $i = 0;
        while $i < LANES {
            out[$i] = $e;
            $i += 1;
        }
        Lanes(out)
    }};
}

macro_rules! operator {
    ($trait:ident $method:ident $op:tt) => {
        impl $trait for Lanes {
            type Output = Self;
            #[inline(always)]
            fn $method(self, y: Self) -> Self {
                each!(i => self.0[i] $op y.0[i])
            }
        }
        impl $trait<f32> for Lanes {
            type Output = Self;
            #[inline(always)]
            fn $method(self, y: f32) -> Self {
                each!(i => self.0[i] $op y)
            }
        }
    };
}
operator!(Add add +);
operator!(Sub sub -);
operator!(Mul mul *);

impl Neg for Lanes {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        each!(i => -self.0[i])
    }
}

impl Real for Lanes {
    /// All ones or all zeros a lane, so that selecting is bit logic.
    type Mask = [u32; LANES];
    const LANES: usize = LANES;
    #[inline(always)]
    fn splat(x: f32) -> Self {
        Lanes([x; LANES])
    }
    #[inline(always)]
    fn from_lanes(mut f: impl FnMut(usize) -> f32) -> Self {
        each!(i => f(i))
    }
    #[inline(always)]
    fn lane(self, i: usize) -> f32 {
        self.0[i]
    }
    #[inline(always)]
    fn any(mask: Self::Mask) -> bool {
        let mut all = 0;
        for m in mask {
            all |= m;
        }
        all != 0
    }
    #[inline(always)]
    fn div(self, y: Self) -> Self {
        each!(i => self.0[i] / y.0[i])
    }
    #[inline(always)]
    fn root(self) -> Self {
        let [a, b, c, d, e, f, g, h] = self.0;
        let ([a, b, c, d], [e, f, g, h]) = (root4([a, b, c, d]), root4([e, f, g, h]));
        Lanes([a, b, c, d, e, f, g, h])
    }
    #[inline(always)]
    fn abs(self) -> Self {
        each!(i => self.0[i].abs())
    }
    #[inline(always)]
    fn less(self, y: Self) -> Self::Mask {
        let mut out = [0u32; LANES];
        let mut i = 0;
        while i < LANES {
            out[i] = if self.0[i] < y.0[i] { !0 } else { 0 };
            i += 1;
        }
        out
    }
    #[inline(always)]
    fn select(no: Self, yes: Self, mask: Self::Mask) -> Self {
        each!(i => f32::from_bits((no.0[i].to_bits() & !mask[i]) | (yes.0[i].to_bits() & mask[i])))
    }
}
