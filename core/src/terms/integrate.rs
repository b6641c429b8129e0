//! Modified velocity Verlet (S0 eq. 2.33 per errata): half kick, drift, forces at the new place with the half-step
//! velocity, half kick.
use super::geometry::*;
use crate::arithmetic::real::*;

/// `v + a dt`, dt being half a step, m/s.
#[inline(always)]
pub fn kick<R: Real>(velocity: vec3<R>, acceleration: vec3<R>, dt: R) -> vec3<R> {
    return flush3(velocity + acceleration * dt);
}

/// `x + v dt`, m.
#[inline(always)]
pub fn drift<R: Real>(position: vec3<R>, velocity: vec3<R>, dt: R) -> vec3<R> {
    return flush3(position + velocity * dt);
}
