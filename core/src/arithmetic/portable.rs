//! Four numbers in a plain array, for processors without vectors of their own in this crate. LLVM uses vector
//! instructions for it where it can.
use super::blocks::Blocks;
use super::codes::{FEW, Offsets, ROW_BITS, Windows, slot};
use super::real::Real;
use super::root::{floor, root4};
use crate::layout::f32x4;
use core::ops::{Add, Mul, Neg, Sub};

/// Four numbers.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Four([f32; 4]);

macro_rules! each {
    ($i:ident => $e:expr) => {{
        let mut out = [0.0f32; 4];
        let mut $i = 0;
        while $i < 4 {
            out[$i] = $e;
            $i += 1;
        }
        Four(out)
    }};
}

macro_rules! operator {
    ($trait:ident $method:ident $op:tt) => {
        impl $trait for Four {
            type Output = Self;
            #[inline(always)]
            fn $method(self, y: Self) -> Self {
                each!(i => self.0[i] $op y.0[i])
            }
        }
        impl $trait<f32> for Four {
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

impl Neg for Four {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        each!(i => -self.0[i])
    }
}

impl Real for Four {
    /// All ones or all zeros per lane, so that a selection is bit logic.
    type Mask = [u32; 4];
    const LANES: usize = 4;
    #[inline(always)]
    fn splat(x: f32) -> Self {
        Four([x; 4])
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
    fn any([a, b, c, d]: [u32; 4]) -> bool {
        a | b | c | d != 0
    }
    #[inline(always)]
    fn div(self, y: Self) -> Self {
        each!(i => self.0[i] / y.0[i])
    }
    #[inline(always)]
    fn root(self) -> Self {
        Four(root4(self.0))
    }
    #[inline(always)]
    fn abs(self) -> Self {
        each!(i => self.0[i].abs())
    }
    #[inline(always)]
    fn floor(self) -> Self {
        each!(i => floor(self.0[i]))
    }
    #[inline(always)]
    fn less(self, y: Self) -> [u32; 4] {
        let mut out = [0u32; 4];
        let mut i = 0;
        while i < 4 {
            out[i] = if self.0[i] < y.0[i] { !0 } else { 0 };
            i += 1;
        }
        out
    }
    #[inline(always)]
    fn select(no: Self, yes: Self, mask: [u32; 4]) -> Self {
        each!(i => f32::from_bits((no.0[i].to_bits() & !mask[i]) | (yes.0[i].to_bits() & mask[i])))
    }
}

impl Blocks for Four {
    #[inline(always)]
    fn of_rows<'r>(row: impl Fn(usize) -> &'r f32x4) -> Self {
        Four(*row(0))
    }
    #[inline(always)]
    fn transpose([a, b, c, d]: [Self; 4]) -> [Self; 4] {
        let column = |i: usize| Four([a.0[i], b.0[i], c.0[i], d.0[i]]);
        [column(0), column(1), column(2), column(3)]
    }
    #[inline(always)]
    fn first(self) -> Self {
        Four([self.0[0]; 4])
    }
    #[inline(always)]
    fn second(self) -> Self {
        Four([self.0[1]; 4])
    }
    #[inline(always)]
    fn third(self) -> Self {
        Four([self.0[2]; 4])
    }
    #[inline(always)]
    fn fourth(self) -> Self {
        Four([self.0[3]; 4])
    }
    #[inline(always)]
    fn block(self, _: usize) -> f32x4 {
        self.0
    }
    #[inline(always)]
    fn read_lanes(from: &[f32]) -> Self {
        Four([from[0], from[1], from[2], from[3]])
    }
    #[inline(always)]
    fn write_lanes(self, to: &mut [f32]) {
        to[..4].copy_from_slice(&self.0);
    }
    #[inline(always)]
    fn decode_lanes(codes: &[u16], windows: &Windows, offsets: &mut Offsets, limit: u32) -> bool {
        let mut all = true;
        for (offset, code) in offsets.0.iter_mut().zip(&codes[..4]) {
            let slot = slot(*code, windows);
            *offset = slot << ROW_BITS;
            all &= slot < limit;
        }
        all
    }
    #[inline(always)]
    fn compress(to: (&mut [u32], &mut [f32]), used: usize, codes: &[u32], numbers: Self, mask: [u32; 4]) -> usize {
        let (to_codes, to_numbers, mut count) = (&mut to.0[used..][..4], &mut to.1[used..][..4], 0);
        for ((code, number), listed) in codes[..4].iter().zip(numbers.0).zip(mask) {
            (to_codes[count], to_numbers[count]) = (*code, number);
            count += (listed & 1) as usize;
        }
        used + count
    }
    #[inline(always)]
    fn permute(column: &[f32; FEW], index: Self) -> Self {
        each!(i => column[(index.0[i] as usize).min(FEW - 1)])
    }
}
