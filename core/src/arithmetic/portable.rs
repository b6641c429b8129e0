//! Eight numbers side by side in a plain array, for processors whose vectors have no file of their own here: LLVM finds
//! instructions for them where it can.
//!
//! One particle a lane, never a sum across lanes: so eight lanes give the bits of eight scalar runs.
use super::real::Real;
use super::root::{floor, root4};
use core::ops::{Add, Mul, Neg, Sub};

/// Lanes of the vector path. Sixteen lost to eight where it was tried: a cell seldom holds so many particles.
pub const LANES: usize = 8;

/// `LANES` numbers side by side.
#[derive(Clone, Copy, Debug)]
pub struct Lanes(pub [f32; LANES]);

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
    fn floor(self) -> Self {
        each!(i => floor(self.0[i]))
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
