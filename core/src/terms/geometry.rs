//! What the physics needs of vectors. The builtins `dot` and `length` leave their order open, so here they are spelled.
use crate::arithmetic::real::*;

/// `a . b`, summed left to right.
#[inline(always)]
pub fn dot3<R: Real>(a: vec3<R>, b: vec3<R>) -> R {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Squared length.
#[inline(always)]
pub fn length2<R: Real>(a: vec3<R>) -> R {
    return dot3(a, a);
}

/// What may be stored: no denormals, no -0.
#[inline(always)]
pub fn flush3<R: Real>(a: vec3<R>) -> vec3<R> {
    return vec3(flush(a.x), flush(a.y), flush(a.z));
}
