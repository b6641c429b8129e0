//! The intrinsics of the terms. WGSL has the same intrinsics, from its prelude or built in, with the same order of
//! arguments and the same bits.
//!
//! Every intrinsic is correctly rounded or a pure selection, so that scalar code, SIMD lanes and GPU cannot differ.
//! `larger` and `smaller` compare and select, because the built-in `max` and `min` of WGSL leave the results for -0 and
//! NaN open.
use crate::layout::{TABLE_ENTRIES, Tables};
use core::ops::{Add, Mul, Neg, Sub};

/// A number of the physics: one `f32`, or several in lanes. Literals stand on the right: `x * 2.0`.
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
    /// One truth value per lane.
    type Mask: Copy;
    /// Number of lanes in a value.
    const LANES: usize;
    /// Returns a value with the same number in every lane.
    fn splat(x: f32) -> Self;
    /// Returns a value whose lane `i` is `f(i)`.
    fn from_lanes(f: impl FnMut(usize) -> f32) -> Self;
    /// Returns the number in lane `i`.
    fn lane(self, i: usize) -> f32;
    /// Returns whether the mask holds in any lane.
    fn any(mask: Self::Mask) -> bool;
    /// Returns the correctly rounded quotient.
    fn div(self, y: Self) -> Self;
    /// Returns the correctly rounded square root.
    fn root(self) -> Self;
    /// Returns the magnitude.
    fn abs(self) -> Self;
    /// Returns the largest integer that is not greater than the number.
    fn floor(self) -> Self;
    /// Returns `self < y`; false for NaN.
    fn less(self, y: Self) -> Self::Mask;
    /// Returns `yes` where the mask holds, else `no`.
    fn select(no: Self, yes: Self, mask: Self::Mask) -> Self;
    /// Returns the larger of two numbers; `self` where they are equal or one is NaN.
    #[inline(always)]
    fn larger(self, y: Self) -> Self {
        Self::select(self, y, self.less(y))
    }
    /// Returns the smaller of two numbers; `self` where they are equal or one is NaN.
    #[inline(always)]
    fn smaller(self, y: Self) -> Self {
        Self::select(self, y, y.less(self))
    }
}

/// Converts a literal, or a constant of the scene, to a number of the physics.
#[inline(always)]
pub fn real<R: Real>(x: f32) -> R {
    R::splat(x)
}

/// Returns the correctly rounded quotient `x / y`.
#[inline(always)]
pub fn div<R: Real>(x: R, y: R) -> R {
    x.div(y)
}

/// Returns the correctly rounded square root.
#[inline(always)]
pub fn root<R: Real>(x: R) -> R {
    x.root()
}

/// Returns the magnitude.
#[inline(always)]
pub fn abs<R: Real>(x: R) -> R {
    x.abs()
}

/// Returns the largest integer that is not greater than `x`. Devices differ in the sign of a zero result, so no term
/// may pass it on.
#[inline(always)]
pub fn floor<R: Real>(x: R) -> R {
    x.floor()
}

/// Returns an entry of one of the tables; 0 where there is no such entry. `entry` is an integer.
#[inline(always)]
pub fn lookup<R: Real>(tables: &Tables, table: u32, entry: R) -> R {
    let first = table as usize * TABLE_ENTRIES;
    R::from_lanes(|lane| tables.get(first + entry.lane(lane) as usize).copied().unwrap_or(0.0))
}

/// Returns `x < y`; false for NaN.
#[inline(always)]
pub fn less<R: Real>(x: R, y: R) -> R::Mask {
    x.less(y)
}

/// Returns `yes` where the mask holds, else `no` (the argument order of WGSL).
#[inline(always)]
pub fn select<R: Real>(no: R, yes: R, mask: R::Mask) -> R {
    R::select(no, yes, mask)
}

/// Returns the larger of two numbers; `x` where they are equal or one is NaN.
#[inline(always)]
pub fn larger<R: Real>(x: R, y: R) -> R {
    x.larger(y)
}

/// Returns the smaller of two numbers; `x` where they are equal or one is NaN.
#[inline(always)]
pub fn smaller<R: Real>(x: R, y: R) -> R {
    x.smaller(y)
}

/// Replaces denormals and -0 by +0. Some devices flush denormals, so stored numbers are never denormal and never -0.
#[inline(always)]
pub fn flush<R: Real>(x: R) -> R {
    select(x, real(0.0), less(abs(x), real(f32::MIN_POSITIVE)))
}

/// Three numbers. The type and its constructor share the name, as in WGSL.
#[derive(Clone, Copy, Debug)]
#[expect(non_camel_case_types, reason = "the terms are WGSL too, where the type has this name")]
pub struct vec3<R> {
    /// Component along x.
    pub x: R,
    /// Component along y.
    pub y: R,
    /// Component along z.
    pub z: R,
}

/// Returns a vector from its components.
#[inline(always)]
pub fn vec3<R>(x: R, y: R, z: R) -> vec3<R> {
    vec3 { x, y, z }
}

impl<R: Real> vec3<R> {
    /// Returns the first three of four stored numbers, the same in every lane.
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
