//! Leapfrog (Pirovano eq. 2.34, corrected; Roy): velocities half a step beside the positions.
//!
//! `x_{t+1} = x_t + v_{t+1/2} dt`, `v_{t+3/2} = v_{t+1/2} + a_{t+1} dt`. What is kept is the velocity at the position, so that the
//! first step needs no other start and a step may be longer than the last. Forces are evaluated with
//! `v_t = (v_{t-1/2} + v_{t+1/2}) / 2`, Pirovano's velocity with a delay: of the velocities that could enter, it is the one with the
//! thesis' limits. Order 2 without damping and 1 with it, symplectic, one evaluation.
use super::euler::*;
use crate::arithmetic::real::*;

/// `v_{t+1/2} = v_t + a_t dt / 2`, m/s.
#[inline(always)]
pub fn leapfrog_half_velocity<R: Real>(v: vec3<R>, a: vec3<R>, half_dt: R) -> vec3<R> {
    return euler_velocity(v, a, half_dt);
}

/// `x_{t+1} = x_t + v_{t+1/2} dt`, m.
#[inline(always)]
pub fn leapfrog_position<R: Real>(x: vec3<R>, v: vec3<R>, a: vec3<R>, dt: R, half_dt: R) -> vec3<R> {
    return x + leapfrog_half_velocity(v, a, half_dt) * dt;
}

/// `v_{t+1} = v_{t+1/2} + a_{t+1} dt / 2`, m/s: the mean of the half steps around it.
#[inline(always)]
pub fn leapfrog_velocity<R: Real>(v: vec3<R>, new_a: vec3<R>, a: vec3<R>, half_dt: R) -> vec3<R> {
    return leapfrog_half_velocity(v, a, half_dt) + new_a * half_dt;
}
