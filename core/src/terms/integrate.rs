//! Modified velocity Verlet (S0 eq. 2.33 per errata): half kick, drift, forces at the new place with the half-step
//! velocity, half kick.
use super::geometry::*;
use crate::arithmetic::real::*;
use crate::layout::{Model, Parameters};

/// `v + a dt`, m/s.
#[inline(always)]
pub fn kick<R: Real>(velocity: vec3<R>, acceleration: vec3<R>, dt: R) -> vec3<R> {
    return flush3(velocity + acceleration * dt);
}

/// Velocity at the end of the step, m/s: the half-step velocity and the kick that is about to come.
#[inline(always)]
pub fn velocity_at_step<R: Real>(p: &Parameters, velocity: vec3<R>, acceleration: vec3<R>) -> vec3<R> {
    return velocity + acceleration * real(p.half_time_step);
}

/// `x + v dt`, m.
#[inline(always)]
pub fn drift<R: Real>(position: vec3<R>, velocity: vec3<R>, dt: R) -> vec3<R> {
    return flush3(position + velocity * dt);
}

/// A coordinate, back inside its period.
#[inline(always)]
pub fn wrapped<R: Real>(x: R, low: f32, period: f32, inverse_period: f32) -> R {
    return x - floor((x - low) * inverse_period) * period;
}

/// A position, back inside a periodic domain.
#[inline(always)]
pub fn wrap<R: Real>(m: &Model, p: &Parameters, position: vec3<R>) -> vec3<R> {
    if m.periodic == 0 {
        return position;
    }
    let x = wrapped(position.x, p.domain_low[0], p.period[0], p.inverse_period[0]);
    let y = wrapped(position.y, p.domain_low[1], p.period[1], p.inverse_period[1]);
    let z = wrapped(position.z, p.domain_low[2], p.period[2], p.inverse_period[2]);
    return flush3(vec3(x, y, z));
}
