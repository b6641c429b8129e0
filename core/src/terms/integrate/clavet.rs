//! Prediction and relaxation (Clavet et al. 2005; Pirovano, eq. 2.35, corrected), with all forces applied as one
//! (N = 1).
//!
//! The order is 1, and the scheme is not symplectic. Without damping of the forces it is stable up to omega
//! dt = 2 / sqrt 3; it adds damping of its own. Forces are evaluated once per step.
use super::euler::*;
use crate::arithmetic::real::*;

/// Predicted position `x* = x_t + v_t dt`, m. Forces are evaluated there, with v_t.
#[inline(always)]
pub fn clavet_prediction<R: Real>(x: vec3<R>, v: vec3<R>, dt: R) -> vec3<R> {
    return euler_position(x, v, dt);
}

/// Relaxed position `x_{t+1} = x* + a* dt^2`, m.
#[inline(always)]
pub fn clavet_relaxation<R: Real>(x: vec3<R>, a: vec3<R>, dt: R) -> vec3<R> {
    return x + a * (dt * dt);
}

/// Velocity `v_{t+1} = (x_{t+1} - x_t) / dt = v_t + a* dt`, m/s.
#[inline(always)]
pub fn clavet_velocity<R: Real>(v: vec3<R>, a: vec3<R>, dt: R) -> vec3<R> {
    return euler_velocity(v, a, dt);
}
