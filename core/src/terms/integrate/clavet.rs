//! Clavet's prediction and relaxation (Clavet et al. 2005; Pirovano eq. 2.35, corrected), all forces acting as one (N = 1).
//!
//! Order 1, stable to omega dt = 2 / sqrt 3 without damping, which it adds itself; not symplectic. One evaluation.
use super::euler::*;
use crate::arithmetic::real::*;

/// Prediction `x* = x_t + v_t dt`, m. Forces are evaluated there, with v_t.
#[inline(always)]
pub fn clavet_prediction<R: Real>(x: vec3<R>, v: vec3<R>, dt: R) -> vec3<R> {
    return euler_position(x, v, dt);
}

/// Relaxation `x_{t+1} = x* + a* dt^2`, m.
#[inline(always)]
pub fn clavet_relaxation<R: Real>(x: vec3<R>, a: vec3<R>, dt: R) -> vec3<R> {
    return x + a * (dt * dt);
}

/// `v_{t+1} = (x_{t+1} - x_t) / dt = v_t + a* dt`, m/s.
#[inline(always)]
pub fn clavet_velocity<R: Real>(v: vec3<R>, a: vec3<R>, dt: R) -> vec3<R> {
    return euler_velocity(v, a, dt);
}
