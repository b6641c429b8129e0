//! The two of Euler's: all from what is known at the beginning of a step.
use crate::arithmetic::real::*;

/// Forward Euler (Pirovano eq. 2.29): order 1, unstable without damping at any step, not symplectic. One evaluation.
///
/// `x_{t+1} = x_t + v_t dt`, m; `v_{t+1} = v_t + f(x_t, v_t) dt`.
#[inline(always)]
pub fn euler_position<R: Real>(x: vec3<R>, v: vec3<R>, dt: R) -> vec3<R> {
    return x + v * dt;
}

/// Velocity of both after a step, m/s; forces are evaluated with it.
#[inline(always)]
pub fn euler_velocity<R: Real>(v: vec3<R>, a: vec3<R>, dt: R) -> vec3<R> {
    return v + a * dt;
}

/// Semi-implicit Euler (Pirovano eq. 2.30): order 1, stable to omega dt = 2, symplectic. One evaluation.
///
/// `v_{t+1} = v_t + f(x_t, v_t) dt`; `x_{t+1} = x_t + v_{t+1} dt`, m.
#[inline(always)]
pub fn semi_implicit_position<R: Real>(x: vec3<R>, v: vec3<R>, a: vec3<R>, dt: R) -> vec3<R> {
    return x + euler_velocity(v, a, dt) * dt;
}
