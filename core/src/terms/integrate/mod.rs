//! The integrators (Pirovano, section 2.3.1 with the errata), one family a file, and which of them a scene takes.
//!
//! A step of each is: [`moved`] and [`velocity_for_forces`], the forces there, [`velocity_after`], [`position_after`] and
//! [`history_after`]. `a` and `history` are those of the beginning of the step. What is remembered of the steps before is, with
//! [`VERLET`], the last displacement, and with the three of Beeman the acceleration before.
use super::geometry::*;
use crate::arithmetic::real::*;
use crate::layout::{Model, Parameters, StepUniform};

pub mod beeman;
pub mod clavet;
pub mod euler;
pub mod leapfrog;
pub mod verlet;
texts!(beeman clavet euler leapfrog verlet);

use beeman::*;
use clavet::*;
use euler::*;
use leapfrog::*;
use verlet::*;

/// Pirovano eq. 2.33.
pub const MODIFIED_VELOCITY_VERLET: u32 = 0;
/// Pirovano eq. 2.29.
pub const EULER: u32 = 1;
/// Pirovano eq. 2.30.
pub const SEMI_IMPLICIT_EULER: u32 = 2;
/// Pirovano eq. 2.31.
pub const VERLET: u32 = 3;
/// Pirovano eq. 2.32.
pub const VELOCITY_VERLET: u32 = 4;
/// Pirovano eq. 2.34.
pub const LEAPFROG: u32 = 5;
/// Pirovano eq. 2.35.
pub const PREDICTION_RELAXATION: u32 = 6;
/// Pirovano eq. 2.36.
pub const BEEMAN: u32 = 7;
/// Pirovano eq. 2.37.
pub const VELOCITY_CORRECTED_BEEMAN: u32 = 8;
/// Pirovano eq. 2.38.
pub const POSITION_CORRECTED_BEEMAN: u32 = 9;

/// Does it remember the acceleration before?
#[inline(always)]
pub fn is_beeman(m: &Model) -> bool {
    return m.integrator == BEEMAN
        || m.integrator == VELOCITY_CORRECTED_BEEMAN
        || m.integrator == POSITION_CORRECTED_BEEMAN;
}

/// Does it remember something of the steps before?
#[inline(always)]
pub fn has_history(m: &Model) -> bool {
    return m.integrator == VERLET || is_beeman(m);
}

/// Does the end of its step need the acceleration at the beginning?
#[inline(always)]
pub fn needs_start_acceleration(m: &Model) -> bool {
    return has_history(m) || m.integrator == VELOCITY_VERLET || m.integrator == LEAPFROG;
}

/// Does it move particles once more after the forces?
#[inline(always)]
pub fn moves_again(m: &Model) -> bool {
    return m.integrator == PREDICTION_RELAXATION || m.integrator == POSITION_CORRECTED_BEEMAN;
}

/// Are forces evaluated with the very velocity that a step ends with?
#[inline(always)]
pub fn knows_velocity(m: &Model) -> bool {
    return m.integrator == EULER || m.integrator == SEMI_IMPLICIT_EULER;
}

/// Do passes over pairs need the velocities at the end of a step before there are any?
#[inline(always)]
pub fn needs_predicted_velocity(m: &Model) -> bool {
    return m.has_internal_energy == 1 || m.has_xsph == 1 || m.is_reevaluated == 1;
}

/// Where forces are evaluated, m.
#[inline(always)]
pub fn moved<R: Real>(m: &Model, u: &StepUniform, x: vec3<R>, v: vec3<R>, a: vec3<R>, history: vec3<R>) -> vec3<R> {
    let dt: R = real(u.time_step);
    let half_dt: R = real(u.half_time_step);
    if m.integrator == EULER {
        return flush3(euler_position(x, v, dt));
    }
    if m.integrator == SEMI_IMPLICIT_EULER {
        return flush3(semi_implicit_position(x, v, a, dt));
    }
    if m.integrator == VERLET {
        return flush3(verlet_position(x, history, a, dt));
    }
    if m.integrator == VELOCITY_VERLET {
        return flush3(velocity_verlet_position(x, v, a, dt, half_dt));
    }
    if m.integrator == LEAPFROG {
        return flush3(leapfrog_position(x, v, a, dt, half_dt));
    }
    if m.integrator == PREDICTION_RELAXATION {
        return flush3(clavet_prediction(x, v, dt));
    }
    if is_beeman(m) {
        return flush3(beeman_position(x, v, a, history, dt));
    }
    return flush3(euler_position(x, modified_verlet_kick(v, a, half_dt), dt));
}

/// With which velocity, m/s.
#[inline(always)]
pub fn velocity_for_forces<R: Real>(m: &Model, u: &StepUniform, v: vec3<R>, a: vec3<R>, history: vec3<R>) -> vec3<R> {
    let half_dt: R = real(u.half_time_step);
    if knows_velocity(m) {
        return flush3(euler_velocity(v, a, real(u.time_step)));
    }
    if m.integrator == MODIFIED_VELOCITY_VERLET {
        return flush3(modified_verlet_kick(v, a, half_dt));
    }
    if m.integrator == VELOCITY_CORRECTED_BEEMAN || m.integrator == POSITION_CORRECTED_BEEMAN {
        return flush3(beeman_prediction(v, a, history, half_dt));
    }
    return v;
}

/// Velocity at the end of the step, m/s, from the one that the forces were evaluated with.
#[inline(always)]
pub fn velocity_after<R: Real>(
    m: &Model,
    u: &StepUniform,
    v: vec3<R>,
    new_a: vec3<R>,
    a: vec3<R>,
    history: vec3<R>,
) -> vec3<R> {
    let dt: R = real(u.time_step);
    let half_dt: R = real(u.half_time_step);
    if knows_velocity(m) {
        return v;
    }
    if m.integrator == VERLET {
        return flush3(verlet_velocity(verlet_displacement(history, a, dt), new_a, real(u.inverse_time_step), half_dt));
    }
    if m.integrator == VELOCITY_VERLET {
        return flush3(velocity_verlet_velocity(v, new_a, a, half_dt));
    }
    if m.integrator == LEAPFROG {
        return flush3(leapfrog_velocity(v, new_a, a, half_dt));
    }
    if m.integrator == PREDICTION_RELAXATION {
        return flush3(clavet_velocity(v, new_a, dt));
    }
    if m.integrator == BEEMAN {
        return flush3(beeman_velocity(v, new_a, a, history, dt));
    }
    if m.integrator == VELOCITY_CORRECTED_BEEMAN {
        return flush3(velocity_corrected(v, second_difference(new_a, a, history), dt));
    }
    if m.integrator == POSITION_CORRECTED_BEEMAN {
        return flush3(position_corrected_velocity(v, second_difference(new_a, a, history), dt));
    }
    return flush3(modified_verlet_kick(v, new_a, half_dt));
}

/// Position at the end of the step, m, from where the forces were evaluated.
#[inline(always)]
pub fn position_after<R: Real>(
    m: &Model,
    u: &StepUniform,
    x: vec3<R>,
    new_a: vec3<R>,
    a: vec3<R>,
    history: vec3<R>,
) -> vec3<R> {
    let dt: R = real(u.time_step);
    if m.integrator == PREDICTION_RELAXATION {
        return flush3(clavet_relaxation(x, new_a, dt));
    }
    if m.integrator == POSITION_CORRECTED_BEEMAN {
        return flush3(position_corrected(x, second_difference(new_a, a, history), dt));
    }
    return x;
}

/// What the next step is to remember.
#[inline(always)]
pub fn history_after<R: Real>(m: &Model, u: &StepUniform, a: vec3<R>, history: vec3<R>) -> vec3<R> {
    if m.integrator == VERLET {
        return flush3(verlet_displacement(history, a, real(u.time_step)));
    }
    return a;
}

/// What a step is to remember of a particle that a wall has just turned, or that has only begun to move.
#[inline(always)]
pub fn history_turned<R: Real>(m: &Model, u: &StepUniform, v: vec3<R>, new_a: vec3<R>, history: vec3<R>) -> vec3<R> {
    if m.integrator == VERLET {
        return flush3(verlet_start(v, new_a, real(u.time_step), real(u.half_time_step)));
    }
    return history;
}

/// What a step is to remember where it is so many times as long as the one before: of [`VERLET`] the displacement at the same velocity.
#[inline(always)]
pub fn history_rescaled<R: Real>(m: &Model, history: vec3<R>, times: R) -> vec3<R> {
    if m.integrator == VERLET {
        return flush3(history * times);
    }
    return history;
}

/// `v + a dt`, m/s.
#[inline(always)]
pub fn kick<R: Real>(velocity: vec3<R>, acceleration: vec3<R>, dt: R) -> vec3<R> {
    return flush3(euler_velocity(velocity, acceleration, dt));
}

/// `x + v dt`, m.
#[inline(always)]
pub fn drift<R: Real>(position: vec3<R>, velocity: vec3<R>, dt: R) -> vec3<R> {
    return flush3(euler_position(position, velocity, dt));
}

/// A coordinate, back inside its period.
#[inline(always)]
pub fn wrapped<R: Real>(x: R, low: f32, period: f32, inverse_period: f32) -> R {
    return x - floor((x - low) * inverse_period) * period;
}

/// A position, back inside a periodic domain.
#[inline(always)]
pub fn wrap<R: Real>(m: &Model, p: &Parameters, position: vec3<R>) -> vec3<R> {
    if m.is_periodic == 0 {
        return position;
    }
    let x = wrapped(position.x, p.domain_low[0], p.period[0], p.inverse_period[0]);
    let y = wrapped(position.y, p.domain_low[1], p.period[1], p.inverse_period[1]);
    let z = wrapped(position.z, p.domain_low[2], p.period[2], p.inverse_period[2]);
    return flush3(vec3(x, y, z));
}
