//! Vector functions of the physics. The built-in `dot` and `length` of WGSL leave the order of their operations open,
//! so these functions spell it out.
use crate::arithmetic::real::*;

/// Returns `a . b`, summed left to right.
#[inline(always)]
pub fn dot3<R: Real>(a: vec3<R>, b: vec3<R>) -> R {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Returns the squared length.
#[inline(always)]
pub fn length2<R: Real>(a: vec3<R>) -> R {
    return dot3(a, a);
}

/// Replaces denormals and -0 by +0 in each component, because neither may be stored.
#[inline(always)]
pub fn flush3<R: Real>(a: vec3<R>) -> vec3<R> {
    return vec3(flush(a.x), flush(a.y), flush(a.z));
}
