//! Leapfrog (Pirovano, eq. 2.34, corrected; Roy): velocities are half a step away from the positions.
//!
//! `x_{t+1} = x_t + v_{t+1/2} dt`, `v_{t+3/2} = v_{t+1/2} + a_{t+1} dt`. The velocity at the time of the position is
//! stored, so that the first step needs no special start and a step may be longer than the last one. Forces are
//! evaluated with `v_t = (v_{t-1/2} + v_{t+1/2}) / 2`, Pirovano's delayed velocity: of the velocities that could be
//! used, it is the one that gives Pirovano's stability limits. The order is 2 without damping and 1 with it. The scheme
//! is symplectic and evaluates forces once per step.
use super::euler::*;
use crate::arithmetic::real::*;

/// Half-step velocity `v_{t+1/2} = v_t + a_t dt / 2`, m/s.
#[inline(always)]
pub fn leapfrog_half_velocity<R: Real>(v: vec3<R>, a: vec3<R>, half_dt: R) -> vec3<R> {
    return euler_velocity(v, a, half_dt);
}

/// Position `x_{t+1} = x_t + v_{t+1/2} dt`, m.
#[inline(always)]
pub fn leapfrog_position<R: Real>(x: vec3<R>, v: vec3<R>, a: vec3<R>, dt: R, half_dt: R) -> vec3<R> {
    return x + leapfrog_half_velocity(v, a, half_dt) * dt;
}

/// Velocity `v_{t+1} = v_{t+1/2} + a_{t+1} dt / 2`, m/s: the mean of the half-step velocities before and after it.
#[inline(always)]
pub fn leapfrog_velocity<R: Real>(v: vec3<R>, new_a: vec3<R>, a: vec3<R>, half_dt: R) -> vec3<R> {
    return leapfrog_half_velocity(v, a, half_dt) + new_a * half_dt;
}
