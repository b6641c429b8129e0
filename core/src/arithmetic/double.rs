//! One `f64`: it evaluates the terms with twice the digits, for constants that are derived from them.
use super::real::Real;
use core::ops::{Add, Mul, Neg, Sub};

/// One `f64`. The literals of the terms are `f32`, so one that is not a binary fraction is only accurate to the digits
/// of `f32`.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Double(pub f64);

macro_rules! operator {
    ($trait:ident $method:ident $op:tt) => {
        impl $trait for Double {
            type Output = Self;
            fn $method(self, y: Self) -> Self {
                Double(self.0 $op y.0)
            }
        }
        impl $trait<f32> for Double {
            type Output = Self;
            fn $method(self, y: f32) -> Self {
                Double(self.0 $op f64::from(y))
            }
        }
    };
}
operator!(Add add +);
operator!(Sub sub -);
operator!(Mul mul *);

impl Neg for Double {
    type Output = Self;
    fn neg(self) -> Self {
        Double(-self.0)
    }
}

impl Real for Double {
    type Mask = bool;
    const LANES: usize = 1;
    fn splat(x: f32) -> Self {
        Double(f64::from(x))
    }
    fn from_lanes(mut f: impl FnMut(usize) -> f32) -> Self {
        Double(f64::from(f(0)))
    }
    fn lane(self, _: usize) -> f32 {
        self.0 as f32
    }
    fn any(mask: bool) -> bool {
        mask
    }
    fn div(self, y: Self) -> Self {
        Double(self.0 / y.0)
    }
    fn root(self) -> Self {
        Double(libm::sqrt(self.0))
    }
    fn abs(self) -> Self {
        Double(self.0.abs())
    }
    fn floor(self) -> Self {
        Double(libm::floor(self.0))
    }
    fn less(self, y: Self) -> bool {
        self.0 < y.0
    }
    fn select(no: Self, yes: Self, mask: bool) -> Self {
        if mask { yes } else { no }
    }
}
