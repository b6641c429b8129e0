//! Eight numbers in the vector registers of x86-64: in two of SSE's, which every such processor has, or in one of AVX's.
//!
//! Written in intrinsics: a compiler that is left to find vectors in arrays of eight takes ten times as long, and does not
//! always find them.
#![expect(clippy::undocumented_unsafe_blocks, reason = "what makes all of them sound is said once, at the macro")]
#![expect(unsafe_code, reason = "vector instructions are only to be had as intrinsics")]
use super::real::Real;
use super::root::floor;
use core::arch::x86_64::*;
use core::ops::{Add, Mul, Neg, Sub};

/// Declares a vector of eight numbers: its registers, numbered, and each operation on a register.
///
/// SAFETY of all that it expands to: the intrinsics need nothing but the processor's instructions. SSE2 is part of every
/// x86-64; vectors of AVX are made only inside of what `level::run_avx2` runs, where the processor was seen to have it.
macro_rules! vector {
    ($(#[$doc:meta])* $name:ident: [$register:ident; $count:literal] = [$($i:literal),*],
        $set:ident $add:ident $sub:ident $mul:ident $div:ident $root:ident $xor:ident $and_not:ident $any:ident,
        less: $less:expr, select: $select:expr) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug)]
        pub(crate) struct $name([$register; $count]);

        vector!(operators $name [$($i),*] Add add $add, Sub sub $sub, Mul mul $mul);

        impl Neg for $name {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                let sign = Self::splat(-0.0);
                $name([$(unsafe { $xor(self.0[$i], sign.0[$i]) }),*])
            }
        }

        impl Real for $name {
            type Mask = Self;
            const LANES: usize = 8;
            #[inline(always)]
            fn splat(x: f32) -> Self {
                $name([unsafe { $set(x) }; $count])
            }
            #[inline(always)]
            fn from_lanes(mut f: impl FnMut(usize) -> f32) -> Self {
                $name(bytemuck::cast([f(0), f(1), f(2), f(3), f(4), f(5), f(6), f(7)]))
            }
            #[inline(always)]
            fn lane(self, i: usize) -> f32 {
                bytemuck::cast::<_, [f32; 8]>(self.0)[i]
            }
            #[inline(always)]
            fn any(mask: Self) -> bool {
                [$(unsafe { $any(mask.0[$i]) }),*] != [0; $count]
            }
            #[inline(always)]
            fn div(self, y: Self) -> Self {
                $name([$(unsafe { $div(self.0[$i], y.0[$i]) }),*])
            }
            #[inline(always)]
            fn root(self) -> Self {
                $name([$(unsafe { $root(self.0[$i]) }),*])
            }
            #[inline(always)]
            fn abs(self) -> Self {
                let sign = Self::splat(-0.0);
                $name([$(unsafe { $and_not(sign.0[$i], self.0[$i]) }),*])
            }
            #[inline(always)]
            fn floor(self) -> Self {
                Self::from_lanes(|i| floor(self.lane(i)))
            }
            #[inline(always)]
            fn less(self, y: Self) -> Self {
                $name([$(unsafe { $less(self.0[$i], y.0[$i]) }),*])
            }
            #[inline(always)]
            fn select(no: Self, yes: Self, mask: Self) -> Self {
                $name([$(unsafe { $select(no.0[$i], yes.0[$i], mask.0[$i]) }),*])
            }
        }
    };
    (operators $name:ident $is:tt $($trait:ident $method:ident $intrinsic:ident),*) => {
        $(vector!(operator $name $is $trait $method $intrinsic);)*
    };
    (operator $name:ident [$($i:literal),*] $trait:ident $method:ident $intrinsic:ident) => {
        impl $trait for $name {
            type Output = Self;
            #[inline(always)]
            fn $method(self, y: Self) -> Self {
                $name([$(unsafe { $intrinsic(self.0[$i], y.0[$i]) }),*])
            }
        }
        impl $trait<f32> for $name {
            type Output = Self;
            #[inline(always)]
            fn $method(self, y: f32) -> Self {
                self.$method(Self::splat(y))
            }
        }
    };
}

/// SSE's blend, which it lacks.
#[inline(always)]
unsafe fn blend(no: __m128, yes: __m128, mask: __m128) -> __m128 {
    // SAFETY: SSE is part of every x86-64
    unsafe { _mm_or_ps(_mm_andnot_ps(mask, no), _mm_and_ps(mask, yes)) }
}

vector! {
    /// Eight numbers in two registers of SSE.
    Sse: [__m128; 2] = [0, 1],
    _mm_set1_ps _mm_add_ps _mm_sub_ps _mm_mul_ps _mm_div_ps _mm_sqrt_ps _mm_xor_ps _mm_andnot_ps _mm_movemask_ps,
    less: _mm_cmplt_ps,
    select: blend
}

vector! {
    /// Eight numbers in a register of AVX.
    Avx: [__m256; 1] = [0],
    _mm256_set1_ps _mm256_add_ps _mm256_sub_ps _mm256_mul_ps _mm256_div_ps _mm256_sqrt_ps _mm256_xor_ps
    _mm256_andnot_ps _mm256_movemask_ps,
    less: _mm256_cmp_ps::<_CMP_LT_OQ>,
    select: _mm256_blendv_ps
}
