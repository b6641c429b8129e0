//! The vocabulary of the terms. WGSL has the same words, from its prelude or built in,
//! with the same argument order and the same bits.
//!
//! Every word is exactly rounded or a pure selection, so that scalar, lanes and GPU cannot differ. `larger` and
//! `smaller` compare and select: WGSL's own `max` and `min` leave -0 and NaN open.
use crate::layout::{TABLE_ENTRIES, Tables};
use core::ops::{Add, Mul, Neg, Sub};

/// A number of the physics: `f32`, or several of them. Literals stand on the right: `x * 2.0`.
pub trait Real:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Neg<Output = Self>
    + Add<f32, Output = Self>
    + Sub<f32, Output = Self>
    + Mul<f32, Output = Self>
{
    /// One truth value a lane.
    type Mask: Copy;
    /// How many numbers one value holds.
    const LANES: usize;
    /// The same number in every lane.
    fn splat(x: f32) -> Self;
    /// Lane `i` is `f(i)`.
    fn from_lanes(f: impl FnMut(usize) -> f32) -> Self;
    /// The number in lane `i`.
    fn lane(self, i: usize) -> f32;
    /// True where any lane is.
    fn any(mask: Self::Mask) -> bool;
    /// Correctly rounded quotient.
    fn div(self, y: Self) -> Self;
    /// Correctly rounded square root.
    fn root(self) -> Self;
    /// Magnitude.
    fn abs(self) -> Self;
    /// The largest whole number that is not larger.
    fn floor(self) -> Self;
    /// `self < y`; false for NaN.
    fn less(self, y: Self) -> Self::Mask;
    /// `yes` where the mask holds, else `no`.
    fn select(no: Self, yes: Self, mask: Self::Mask) -> Self;
    /// The larger of two; `self` where they compare equal or not at all.
    #[inline(always)]
    fn larger(self, y: Self) -> Self {
        Self::select(self, y, self.less(y))
    }
    /// The smaller of two; `self` where they compare equal or not at all.
    #[inline(always)]
    fn smaller(self, y: Self) -> Self {
        Self::select(self, y, y.less(self))
    }
}

/// A literal, or a constant of the scene, as a number.
#[inline(always)]
pub fn real<R: Real>(x: f32) -> R {
    R::splat(x)
}

/// Correctly rounded quotient `x / y`.
#[inline(always)]
pub fn div<R: Real>(x: R, y: R) -> R {
    x.div(y)
}

/// Correctly rounded square root.
#[inline(always)]
pub fn root<R: Real>(x: R) -> R {
    x.root()
}

/// Magnitude.
#[inline(always)]
pub fn abs<R: Real>(x: R) -> R {
    x.abs()
}

/// The largest whole number that is not larger. Devices disagree about the sign of a zero: no term may let it through.
#[inline(always)]
pub fn floor<R: Real>(x: R) -> R {
    x.floor()
}

/// An entry of one of the tables, its index being a whole number; 0 where there is none.
#[inline(always)]
pub fn lookup<R: Real>(tables: &Tables, table: u32, entry: R) -> R {
    let first = table as usize * TABLE_ENTRIES;
    R::from_lanes(|lane| tables.get(first + entry.lane(lane) as usize).copied().unwrap_or(0.0))
}

/// `x < y`; false for NaN.
#[inline(always)]
pub fn less<R: Real>(x: R, y: R) -> R::Mask {
    x.less(y)
}

/// `yes` where the mask holds, else `no` (WGSL's argument order).
#[inline(always)]
pub fn select<R: Real>(no: R, yes: R, mask: R::Mask) -> R {
    R::select(no, yes, mask)
}

/// The larger of two; `x` where they compare equal or not at all.
#[inline(always)]
pub fn larger<R: Real>(x: R, y: R) -> R {
    x.larger(y)
}

/// The smaller of two; `x` where they compare equal or not at all.
#[inline(always)]
pub fn smaller<R: Real>(x: R, y: R) -> R {
    x.smaller(y)
}

/// Denormals and -0 become +0: some devices flush them, so what is stored never holds one.
#[inline(always)]
pub fn flush<R: Real>(x: R) -> R {
    select(x, real(0.0), less(abs(x), real(f32::MIN_POSITIVE)))
}

/// Three numbers. The type and its constructor share the name, as in WGSL.
#[derive(Clone, Copy, Debug)]
#[expect(non_camel_case_types, reason = "the terms are WGSL too, where the type has this name")]
pub struct vec3<R> {
    /// Along x.
    pub x: R,
    /// Along y.
    pub y: R,
    /// Along z.
    pub z: R,
}

/// A vector of its components.
#[inline(always)]
pub fn vec3<R>(x: R, y: R, z: R) -> vec3<R> {
    vec3 { x, y, z }
}

impl<R: Real> vec3<R> {
    /// The first three of four stored numbers, the same in every lane.
    #[inline(always)]
    pub fn splat(a: [f32; 4]) -> Self {
        vec3(real(a[0]), real(a[1]), real(a[2]))
    }
}

impl<R: Real> Add for vec3<R> {
    type Output = Self;
    #[inline(always)]
    fn add(self, o: Self) -> Self {
        vec3(self.x + o.x, self.y + o.y, self.z + o.z)
    }
}

impl<R: Real> Sub for vec3<R> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, o: Self) -> Self {
        vec3(self.x - o.x, self.y - o.y, self.z - o.z)
    }
}

impl<R: Real> Mul<R> for vec3<R> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, s: R) -> Self {
        vec3(self.x * s, self.y * s, self.z * s)
    }
}

impl Real for f32 {
    type Mask = bool;
    const LANES: usize = 1;
    #[inline(always)]
    fn splat(x: f32) -> f32 {
        x
    }
    #[inline(always)]
    fn from_lanes(mut f: impl FnMut(usize) -> f32) -> f32 {
        f(0)
    }
    #[inline(always)]
    fn lane(self, _: usize) -> f32 {
        self
    }
    #[inline(always)]
    fn any(mask: bool) -> bool {
        mask
    }
    #[inline(always)]
    fn div(self, y: f32) -> f32 {
        self / y
    }
    #[inline(always)]
    fn root(self) -> f32 {
        super::root::root4([self; 4])[0]
    }
    #[inline(always)]
    fn abs(self) -> f32 {
        f32::abs(self)
    }
    #[inline(always)]
    fn floor(self) -> f32 {
        super::root::floor(self)
    }
    #[inline(always)]
    fn less(self, y: f32) -> bool {
        self < y
    }
    #[inline(always)]
    fn select(no: f32, yes: f32, mask: bool) -> f32 {
        if mask { yes } else { no }
    }
}
