//! The two Euler integrators. They use only the state at the beginning of a step.
use crate::arithmetic::real::*;

/// Position of forward Euler (Pirovano, eq. 2.29), m: order 1, unstable at any step without damping, not symplectic,
/// one force evaluation per step.
///
/// `x_{t+1} = x_t + v_t dt`; `v_{t+1} = v_t + f(x_t, v_t) dt`.
#[inline(always)]
pub fn euler_position<R: Real>(x: vec3<R>, v: vec3<R>, dt: R) -> vec3<R> {
    return x + v * dt;
}

/// Velocity of both integrators after a step, m/s. Forces are evaluated with it.
#[inline(always)]
pub fn euler_velocity<R: Real>(v: vec3<R>, a: vec3<R>, dt: R) -> vec3<R> {
    return v + a * dt;
}

/// Position of semi-implicit Euler (Pirovano, eq. 2.30), m: order 1, stable up to omega dt = 2, symplectic, one force
/// evaluation per step.
///
/// `v_{t+1} = v_t + f(x_t, v_t) dt`; `x_{t+1} = x_t + v_{t+1} dt`.
#[inline(always)]
pub fn semi_implicit_position<R: Real>(x: vec3<R>, v: vec3<R>, a: vec3<R>, dt: R) -> vec3<R> {
    return x + euler_velocity(v, a, dt) * dt;
}
