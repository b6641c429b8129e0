//! The Verlet integrators. Without damping the order is 2, and all are stable up to omega dt = 2 and symplectic. With
//! damping the order is 1, since the velocity in the force does not belong to the time of the position. Each evaluates
//! forces once per step.
use super::euler::*;
use crate::arithmetic::real::*;

/// Position of Verlet (Pirovano, eq. 2.31, corrected), m: `x_{t+1} = 2 x_t - x_{t-1} + a_t dt^2`. The last displacement
/// `d_t = x_t - x_{t-1}` is stored, because a difference of coordinates would have lost half of its digits.
#[inline(always)]
pub fn verlet_position<R: Real>(x: vec3<R>, d: vec3<R>, a: vec3<R>, dt: R) -> vec3<R> {
    return x + verlet_displacement(d, a, dt);
}

/// Displacement `d_{t+1} = d_t + a_t dt^2`, m.
#[inline(always)]
pub fn verlet_displacement<R: Real>(d: vec3<R>, a: vec3<R>, dt: R) -> vec3<R> {
    return d + a * (dt * dt);
}

/// Velocity `v_t = (x_{t+1} - x_{t-1}) / (2 dt)`, m/s. Since `x_{t+1} - x_t = d_t + a_t dt^2`, it is
/// `d_t / dt + a_t dt / 2`, which is known as soon as a_t is. Forces are evaluated with the velocity of the previous
/// step.
#[inline(always)]
pub fn verlet_velocity<R: Real>(d: vec3<R>, a: vec3<R>, inverse_dt: R, half_dt: R) -> vec3<R> {
    return d * inverse_dt + a * half_dt;
}

/// Displacement that leads to a velocity under an acceleration, m: `x_t - x_{t-1} = v_t dt - a_t dt^2 / 2`. It replaces
/// the missing history at the start and after a reflection by a wall. Its error is of order dt^3, so the order stays 2.
#[inline(always)]
pub fn verlet_start<R: Real>(v: vec3<R>, a: vec3<R>, dt: R, half_dt: R) -> vec3<R> {
    return (v - a * half_dt) * dt;
}

/// Position of velocity Verlet (Pirovano, eq. 2.32), m: `x_{t+1} = x_t + v_t dt + a_t dt^2 / 2`. Forces are evaluated
/// with v_t.
#[inline(always)]
pub fn velocity_verlet_position<R: Real>(x: vec3<R>, v: vec3<R>, a: vec3<R>, dt: R, half_dt: R) -> vec3<R> {
    return x + v * dt + a * (half_dt * dt);
}

/// Velocity `v_{t+1} = v_t + (a_{t+1} + a_t) / 2 dt`, m/s.
#[inline(always)]
pub fn velocity_verlet_velocity<R: Real>(v: vec3<R>, new_a: vec3<R>, a: vec3<R>, half_dt: R) -> vec3<R> {
    return v + (new_a + a) * half_dt;
}

/// Half kick of modified velocity Verlet (Pirovano, eq. 2.33, corrected), m/s. A step is a half kick, a drift, the
/// forces at the new position with the half-step velocity, and a half kick.
#[inline(always)]
pub fn modified_verlet_kick<R: Real>(v: vec3<R>, a: vec3<R>, half_dt: R) -> vec3<R> {
    return euler_velocity(v, a, half_dt);
}
