//! Numbers in the vector registers of x86-64: four in an SSE register, which every such processor has, eight in an AVX
//! register, and sixteen in an AVX-512 register.
//!
//! The vectors are written with intrinsics. A compiler that has to find vector code for arrays takes ten times as long,
//! and does not always find it.
#![expect(clippy::undocumented_unsafe_blocks, reason = "what makes all of them sound is said once, at the macro")]
#![expect(unsafe_code, reason = "vector instructions are only to be had as intrinsics")]
use super::blocks::Blocks;
use super::codes::{FEW, Offsets, ROW_BITS, WINDOW_BITS, Windows, slot};
use super::real::Real;
use super::root::floor;
use crate::layout::f32x4;
use core::arch::x86_64::*;
use core::ops::{Add, Mul, Neg, Sub};

/// Declares a vector: its register, lanes and masks, and the instruction of each operation.
///
/// SAFETY of all code that this macro expands to: the intrinsics need the instructions of the processor, and valid
/// memory. SSE2 is part of every x86-64. Vectors of AVX and AVX-512 are made only inside the work that
/// `level::run_avx2` and `level::run_avx512` run, where the processor is known to have the instructions. In memory the
/// intrinsics access no more bytes than the slices were checked to have, or than arrays have by their types; `codes`
/// asserts that these are enough.
macro_rules! vector {
    ($(#[$doc:meta])* $name:ident: $register:ty, $lanes:literal lanes, masks: $mask:ty, by $by:ident,
        $set:ident $add:ident $sub:ident $mul:ident $div:ident $max:ident $min:ident $root:ident $xor:ident
        $and_not:ident $low:ident $high:ident $shuffle:ident $load:ident $store:ident,
        less: $less:expr, select: $select:expr) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug)]
        pub(crate) struct $name($register);

        vector!(operator $name Add add $add);
        vector!(operator $name Sub sub $sub);
        vector!(operator $name Mul mul $mul);

        impl Neg for $name {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                $name(unsafe { $xor(self.0, $set(-0.0)) })
            }
        }

        impl Real for $name {
            type Mask = $mask;
            const LANES: usize = $lanes;
            #[inline(always)]
            fn splat(x: f32) -> Self {
                $name(unsafe { $set(x) })
            }
            #[inline(always)]
            fn from_lanes(mut f: impl FnMut(usize) -> f32) -> Self {
                let mut lanes = [0.0; $lanes];
                let mut i = 0;
                while i < $lanes {
                    lanes[i] = f(i);
                    i += 1;
                }
                Self::read_lanes(&lanes)
            }
            #[inline(always)]
            fn lane(self, i: usize) -> f32 {
                let mut lanes = [0.0; $lanes];
                self.write_lanes(&mut lanes);
                lanes[i]
            }
            #[inline(always)]
            fn any(mask: $mask) -> bool {
                unsafe { $by::any(mask) }
            }
            #[inline(always)]
            fn div(self, y: Self) -> Self {
                $name(unsafe { $div(self.0, y.0) })
            }
            #[inline(always)]
            fn root(self) -> Self {
                $name(unsafe { $root(self.0) })
            }
            #[inline(always)]
            fn abs(self) -> Self {
                $name(unsafe { $and_not($set(-0.0), self.0) })
            }
            #[inline(always)]
            fn floor(self) -> Self {
                Self::from_lanes(|i| floor(self.lane(i)))
            }
            #[inline(always)]
            fn less(self, y: Self) -> $mask {
                unsafe { $less(self.0, y.0) }
            }
            #[inline(always)]
            fn select(no: Self, yes: Self, mask: $mask) -> Self {
                $name(unsafe { $select(no.0, yes.0, mask) })
            }
            // These instructions return their second operand where the two are equal or one is NaN.
            #[inline(always)]
            fn larger(self, y: Self) -> Self {
                $name(unsafe { $max(y.0, self.0) })
            }
            #[inline(always)]
            fn smaller(self, y: Self) -> Self {
                $name(unsafe { $min(y.0, self.0) })
            }
        }

        impl Blocks for $name {
            #[inline(always)]
            fn of_rows<'r>(row: impl Fn(usize) -> &'r f32x4) -> Self {
                $name(unsafe { $by::of_rows(row) })
            }
            #[inline(always)]
            fn transpose([a, b, c, d]: [Self; 4]) -> [Self; 4] {
                unsafe {
                    let (ab_low, cd_low) = ($low(a.0, b.0), $low(c.0, d.0));
                    let (ab_high, cd_high) = ($high(a.0, b.0), $high(c.0, d.0));
                    [
                        $name($shuffle::<0b01_00_01_00>(ab_low, cd_low)),
                        $name($shuffle::<0b11_10_11_10>(ab_low, cd_low)),
                        $name($shuffle::<0b01_00_01_00>(ab_high, cd_high)),
                        $name($shuffle::<0b11_10_11_10>(ab_high, cd_high)),
                    ]
                }
            }
            #[inline(always)]
            fn first(self) -> Self {
                $name(unsafe { $shuffle::<0b00_00_00_00>(self.0, self.0) })
            }
            #[inline(always)]
            fn second(self) -> Self {
                $name(unsafe { $shuffle::<0b01_01_01_01>(self.0, self.0) })
            }
            #[inline(always)]
            fn third(self) -> Self {
                $name(unsafe { $shuffle::<0b10_10_10_10>(self.0, self.0) })
            }
            #[inline(always)]
            fn fourth(self) -> Self {
                $name(unsafe { $shuffle::<0b11_11_11_11>(self.0, self.0) })
            }
            #[inline(always)]
            fn block(self, block: usize) -> f32x4 {
                let mut out = [0.0; 4];
                unsafe { _mm_storeu_ps(out.as_mut_ptr(), $by::block(self.0, block)) };
                out
            }
            #[inline(always)]
            fn read_lanes(from: &[f32]) -> Self {
                let from = &from[..$lanes];
                $name(unsafe { $load(from.as_ptr()) })
            }
            #[inline(always)]
            fn write_lanes(self, to: &mut [f32]) {
                let to = &mut to[..$lanes];
                unsafe { $store(to.as_mut_ptr(), self.0) }
            }
            #[inline(always)]
            fn decode_lanes(codes: &[u16], windows: &Windows, offsets: &mut Offsets, limit: u32) -> bool {
                unsafe { $by::decode(&codes[..$lanes], windows, offsets, limit) }
            }
            #[inline(always)]
            fn compress(to: (&mut [u32], &mut [f32]), used: usize, codes: &[u32], numbers: Self, mask: $mask) -> usize {
                let (to, to_numbers) = (&mut to.0[used..][..$lanes], &mut to.1[used..][..$lanes]);
                used + unsafe { $by::compress(to, to_numbers, &codes[..$lanes], numbers.0, mask) }
            }
            #[inline(always)]
            fn permute(column: &[f32; FEW], index: Self) -> Self {
                $name(unsafe { $by::permute(column, index.0) })
            }
        }
    };
    (operator $name:ident $trait:ident $method:ident $intrinsic:ident) => {
        impl $trait for $name {
            type Output = Self;
            #[inline(always)]
            fn $method(self, y: Self) -> Self {
                $name(unsafe { $intrinsic(self.0, y.0) })
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

/// Loads a row into an SSE register.
#[inline(always)]
unsafe fn row(row: &f32x4) -> __m128 {
    unsafe { _mm_loadu_ps(row.as_ptr()) }
}

/// SSE2: one block of four lanes.
mod sse {
    use super::*;

    /// Selects by a mask. SSE2 has no blend instruction.
    #[inline(always)]
    pub(super) unsafe fn blend(no: __m128, yes: __m128, mask: __m128) -> __m128 {
        unsafe { _mm_or_ps(_mm_andnot_ps(mask, no), _mm_and_ps(mask, yes)) }
    }

    #[inline(always)]
    pub(super) unsafe fn any(mask: __m128) -> bool {
        unsafe { _mm_movemask_ps(mask) != 0 }
    }

    #[inline(always)]
    pub(super) unsafe fn of_rows<'r>(of: impl Fn(usize) -> &'r f32x4) -> __m128 {
        unsafe { row(of(0)) }
    }

    #[inline(always)]
    pub(super) unsafe fn block(x: __m128, _: usize) -> __m128 {
        x
    }

    #[inline(always)]
    pub(super) unsafe fn decode(codes: &[u16], windows: &Windows, offsets: &mut Offsets, limit: u32) -> bool {
        let mut all = true;
        for (offset, code) in offsets.0.iter_mut().zip(codes) {
            let slot = slot(*code, windows);
            *offset = slot << ROW_BITS;
            all &= slot < limit;
        }
        all
    }

    /// Appends the lanes one by one, since SSE2 cannot move lanes by a mask.
    #[inline(always)]
    pub(super) unsafe fn compress(
        to: &mut [u32],
        to_numbers: &mut [f32],
        codes: &[u32],
        numbers: __m128,
        mask: __m128,
    ) -> usize {
        let mask = unsafe { _mm_movemask_ps(mask) } as usize;
        let numbers: [f32; 4] = bytemuck::cast(numbers);
        let mut used = 0;
        for (i, (code, number)) in codes.iter().zip(numbers).enumerate() {
            (to[used], to_numbers[used]) = (*code, number);
            used += mask >> i & 1;
        }
        used
    }

    #[inline(always)]
    pub(super) unsafe fn permute(column: &[f32; FEW], index: __m128) -> __m128 {
        let index: [i32; 4] = bytemuck::cast(unsafe { _mm_cvttps_epi32(index) });
        let of = |i: usize| column[(index[i] as usize).min(FEW - 1)];
        unsafe { _mm_setr_ps(of(0), of(1), of(2), of(3)) }
    }
}

/// AVX2: two blocks of four lanes.
mod avx {
    use super::*;

    /// Selects with three instructions instead of one blend: most selections are between a number and zero, for which
    /// the compiler needs only one of the three.
    #[inline(always)]
    pub(super) unsafe fn select(no: __m256, yes: __m256, mask: __m256) -> __m256 {
        unsafe { _mm256_or_ps(_mm256_andnot_ps(mask, no), _mm256_and_ps(mask, yes)) }
    }

    /// For each mask, the indices of the lanes in which it holds, moved to the front, one byte per index.
    static FRONT: [u64; 256] = {
        let mut table = [0; 256];
        let mut mask = 0;
        while mask < 256 {
            let (mut lane, mut used) = (0, 0);
            while lane < 8 {
                if mask >> lane & 1 == 1 {
                    table[mask] |= (lane as u64) << (8 * used);
                    used += 1;
                }
                lane += 1;
            }
            mask += 1;
        }
        table
    };

    #[inline(always)]
    pub(super) unsafe fn any(mask: __m256) -> bool {
        unsafe { _mm256_movemask_ps(mask) != 0 }
    }

    #[inline(always)]
    pub(super) unsafe fn of_rows<'r>(of: impl Fn(usize) -> &'r f32x4) -> __m256 {
        unsafe { _mm256_insertf128_ps::<1>(_mm256_castps128_ps256(row(of(0))), row(of(1))) }
    }

    #[inline(always)]
    pub(super) unsafe fn block(x: __m256, block: usize) -> __m128 {
        unsafe { if block == 0 { _mm256_castps256_ps128(x) } else { _mm256_extractf128_ps::<1>(x) } }
    }

    #[inline(always)]
    pub(super) unsafe fn decode(codes: &[u16], windows: &Windows, offsets: &mut Offsets, limit: u32) -> bool {
        unsafe {
            let codes = _mm256_cvtepu16_epi32(_mm_loadu_si128(codes.as_ptr().cast()));
            let window = _mm256_srli_epi32::<{ WINDOW_BITS as i32 }>(codes);
            let within = _mm256_and_si256(codes, _mm256_set1_epi32((1 << WINDOW_BITS) - 1));
            let first = _mm256_permutevar8x32_epi32(_mm256_loadu_si256(windows.as_ptr().cast()), window);
            let slots = _mm256_add_epi32(first, within);
            let offset = _mm256_slli_epi32::<{ ROW_BITS as i32 }>(slots);
            _mm256_storeu_si256(offsets.0.as_mut_ptr().cast(), offset);
            // AVX2 only compares signed integers, but it has a minimum of unsigned ones.
            let last = _mm256_set1_epi32(limit.wrapping_sub(1) as i32);
            let is_below = _mm256_cmpeq_epi32(_mm256_min_epu32(slots, last), slots);
            limit > 0 && _mm256_movemask_epi8(is_below) == -1
        }
    }

    #[inline(always)]
    pub(super) unsafe fn compress(
        to: &mut [u32],
        to_numbers: &mut [f32],
        codes: &[u32],
        numbers: __m256,
        mask: __m256,
    ) -> usize {
        unsafe {
            let mask = _mm256_movemask_ps(mask) as usize;
            let front = _mm256_cvtepu8_epi32(_mm_loadl_epi64(core::ptr::from_ref(&FRONT[mask & 255]).cast()));
            let codes = _mm256_loadu_si256(codes.as_ptr().cast());
            _mm256_storeu_si256(to.as_mut_ptr().cast(), _mm256_permutevar8x32_epi32(codes, front));
            _mm256_storeu_ps(to_numbers.as_mut_ptr(), _mm256_permutevar8x32_ps(numbers, front));
            mask.count_ones() as usize
        }
    }

    #[inline(always)]
    pub(super) unsafe fn permute(column: &[f32; FEW], index: __m256) -> __m256 {
        unsafe {
            let index = _mm256_cvttps_epi32(index);
            let low = _mm256_permutevar8x32_ps(_mm256_loadu_ps(column.as_ptr()), index);
            let high = _mm256_permutevar8x32_ps(_mm256_loadu_ps(column[8..].as_ptr()), index);
            let is_high = _mm256_cmpgt_epi32(index, _mm256_set1_epi32(7));
            _mm256_blendv_ps(low, high, _mm256_castsi256_ps(is_high))
        }
    }
}

/// AVX-512: four blocks of four lanes.
mod avx512 {
    use super::*;

    #[inline(always)]
    pub(super) unsafe fn select(no: __m512, yes: __m512, mask: __mmask16) -> __m512 {
        unsafe { _mm512_mask_blend_ps(mask, no, yes) }
    }

    #[inline(always)]
    pub(super) unsafe fn any(mask: __mmask16) -> bool {
        mask != 0
    }

    #[inline(always)]
    pub(super) unsafe fn of_rows<'r>(of: impl Fn(usize) -> &'r f32x4) -> __m512 {
        unsafe {
            let low = _mm512_castps128_ps512(row(of(0)));
            let low = _mm512_insertf32x4::<1>(low, row(of(1)));
            _mm512_insertf32x4::<3>(_mm512_insertf32x4::<2>(low, row(of(2))), row(of(3)))
        }
    }

    #[inline(always)]
    pub(super) unsafe fn block(x: __m512, block: usize) -> __m128 {
        unsafe {
            match block {
                0 => _mm512_castps512_ps128(x),
                1 => _mm512_extractf32x4_ps::<1>(x),
                2 => _mm512_extractf32x4_ps::<2>(x),
                _ => _mm512_extractf32x4_ps::<3>(x),
            }
        }
    }

    #[inline(always)]
    pub(super) unsafe fn decode(codes: &[u16], windows: &Windows, offsets: &mut Offsets, limit: u32) -> bool {
        unsafe {
            let codes = _mm512_cvtepu16_epi32(_mm256_loadu_si256(codes.as_ptr().cast()));
            let window = _mm512_srli_epi32::<WINDOW_BITS>(codes);
            let within = _mm512_and_si512(codes, _mm512_set1_epi32((1 << WINDOW_BITS) - 1));
            let windows = _mm512_castsi256_si512(_mm256_loadu_si256(windows.as_ptr().cast()));
            let first = _mm512_permutexvar_epi32(window, windows);
            let slots = _mm512_add_epi32(first, within);
            _mm512_storeu_si512(offsets.0.as_mut_ptr().cast(), _mm512_slli_epi32::<ROW_BITS>(slots));
            _mm512_cmplt_epu32_mask(slots, _mm512_set1_epi32(limit as i32)) == !0
        }
    }

    #[inline(always)]
    pub(super) unsafe fn compress(
        to: &mut [u32],
        to_numbers: &mut [f32],
        codes: &[u32],
        numbers: __m512,
        mask: __mmask16,
    ) -> usize {
        unsafe {
            let codes = _mm512_loadu_si512(codes.as_ptr().cast());
            _mm512_storeu_si512(to.as_mut_ptr().cast(), _mm512_mask_compress_epi32(codes, mask, codes));
            _mm512_storeu_ps(to_numbers.as_mut_ptr(), _mm512_mask_compress_ps(numbers, mask, numbers));
            mask.count_ones() as usize
        }
    }

    #[inline(always)]
    pub(super) unsafe fn permute(column: &[f32; FEW], index: __m512) -> __m512 {
        unsafe { _mm512_permutexvar_ps(_mm512_cvttps_epi32(index), _mm512_loadu_ps(column.as_ptr())) }
    }
}

vector! {
    /// Four numbers in an SSE register.
    Sse: __m128, 4 lanes, masks: __m128, by sse,
    _mm_set1_ps _mm_add_ps _mm_sub_ps _mm_mul_ps _mm_div_ps _mm_max_ps _mm_min_ps _mm_sqrt_ps _mm_xor_ps _mm_andnot_ps
    _mm_unpacklo_ps _mm_unpackhi_ps _mm_shuffle_ps _mm_loadu_ps _mm_storeu_ps,
    less: _mm_cmplt_ps, select: sse::blend
}

vector! {
    /// Eight numbers in an AVX register.
    Avx: __m256, 8 lanes, masks: __m256, by avx,
    _mm256_set1_ps _mm256_add_ps _mm256_sub_ps _mm256_mul_ps _mm256_div_ps _mm256_max_ps _mm256_min_ps _mm256_sqrt_ps
    _mm256_xor_ps _mm256_andnot_ps
    _mm256_unpacklo_ps _mm256_unpackhi_ps _mm256_shuffle_ps _mm256_loadu_ps _mm256_storeu_ps,
    less: _mm256_cmp_ps::<_CMP_LT_OQ>, select: avx::select
}

vector! {
    /// Sixteen numbers in an AVX-512 register.
    Avx512: __m512, 16 lanes, masks: __mmask16, by avx512,
    _mm512_set1_ps _mm512_add_ps _mm512_sub_ps _mm512_mul_ps _mm512_div_ps _mm512_max_ps _mm512_min_ps _mm512_sqrt_ps
    _mm512_xor_ps _mm512_andnot_ps
    _mm512_unpacklo_ps _mm512_unpackhi_ps _mm512_shuffle_ps _mm512_loadu_ps _mm512_storeu_ps,
    less: _mm512_cmp_ps_mask::<_CMP_LT_OQ>, select: avx512::select
}
