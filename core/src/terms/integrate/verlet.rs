//! Verlet's: order 2 without damping, where all are stable to omega dt = 2 and symplectic; order 1 with it, since the velocity
//! in the force is not that of the place. One evaluation each.
use super::euler::*;
use crate::arithmetic::real::*;

/// Verlet (Pirovano eq. 2.31, corrected), m: `x_{t+1} = 2 x_t - x_{t-1} + a_t dt^2`, the last displacement `d_t = x_t - x_{t-1}` being
/// what is remembered: a difference of coordinates would have lost half of its digits.
#[inline(always)]
pub fn verlet_position<R: Real>(x: vec3<R>, d: vec3<R>, a: vec3<R>, dt: R) -> vec3<R> {
    return x + verlet_displacement(d, a, dt);
}

/// `d_{t+1} = d_t + a_t dt^2`, m.
#[inline(always)]
pub fn verlet_displacement<R: Real>(d: vec3<R>, a: vec3<R>, dt: R) -> vec3<R> {
    return d + a * (dt * dt);
}

/// `v_t = (x_{t+1} - x_{t-1}) / (2 dt)`, m/s, as soon as a_t is known: with `x_{t+1} - x_t = d_t + a_t dt^2` that is
/// `d_t / dt + a_t dt / 2`. Forces are evaluated with the one before.
#[inline(always)]
pub fn verlet_velocity<R: Real>(d: vec3<R>, a: vec3<R>, inverse_dt: R, half_dt: R) -> vec3<R> {
    return d * inverse_dt + a * half_dt;
}

/// The displacement that a velocity and an acceleration come from, m: `x_t - x_{t-1} = v_t dt - a_t dt^2 / 2`. At the start, and
/// after a wall, it stands for the history that there is none of: off by dt^3, so that the order stays 2.
#[inline(always)]
pub fn verlet_start<R: Real>(v: vec3<R>, a: vec3<R>, dt: R, half_dt: R) -> vec3<R> {
    return (v - a * half_dt) * dt;
}

/// Velocity Verlet (Pirovano eq. 2.32), m: `x_{t+1} = x_t + v_t dt + a_t dt^2 / 2`. Forces are evaluated with v_t.
#[inline(always)]
pub fn velocity_verlet_position<R: Real>(x: vec3<R>, v: vec3<R>, a: vec3<R>, dt: R, half_dt: R) -> vec3<R> {
    return x + v * dt + a * (half_dt * dt);
}

/// `v_{t+1} = v_t + (a_{t+1} + a_t) / 2 dt`, m/s.
#[inline(always)]
pub fn velocity_verlet_velocity<R: Real>(v: vec3<R>, new_a: vec3<R>, a: vec3<R>, half_dt: R) -> vec3<R> {
    return v + (new_a + a) * half_dt;
}

/// Modified velocity Verlet (Pirovano eq. 2.33, corrected), m/s: half kick, drift, forces at the new place with the half-step
/// velocity, half kick.
#[inline(always)]
pub fn modified_verlet_kick<R: Real>(v: vec3<R>, a: vec3<R>, half_dt: R) -> vec3<R> {
    return euler_velocity(v, a, half_dt);
}
