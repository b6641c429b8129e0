//! The integrators (Pirovano, section 2.3.1, corrected), one family per file, and the selection of the scene's
//! integrator.
//!
//! A step of each consists of [`moved`] and [`velocity_for_forces`], the evaluation of forces, [`velocity_after`],
//! [`position_after`] and [`history_after`]. `a` and `history` are the values at the beginning of the step. The history
//! is the last displacement with [`VERLET`], and the acceleration of the previous step with the three Beeman
//! integrators.
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

/// Modified velocity Verlet (Pirovano, eq. 2.33, corrected).
pub const MODIFIED_VELOCITY_VERLET: u32 = 0;
/// Forward Euler (Pirovano, eq. 2.29).
pub const EULER: u32 = 1;
/// Semi-implicit Euler (Pirovano, eq. 2.30).
pub const SEMI_IMPLICIT_EULER: u32 = 2;
/// Verlet (Pirovano, eq. 2.31, corrected).
pub const VERLET: u32 = 3;
/// Velocity Verlet (Pirovano, eq. 2.32).
pub const VELOCITY_VERLET: u32 = 4;
/// Leapfrog (Pirovano, eq. 2.34, corrected).
pub const LEAPFROG: u32 = 5;
/// Prediction and relaxation (Clavet et al. 2005; Pirovano, eq. 2.35, corrected).
pub const PREDICTION_RELAXATION: u32 = 6;
/// Beeman (Pirovano, eq. 2.36, corrected).
pub const BEEMAN: u32 = 7;
/// Velocity-corrected Beeman (Pirovano, eq. 2.37).
pub const VELOCITY_CORRECTED_BEEMAN: u32 = 8;
/// Position-corrected Beeman (Pirovano, eq. 2.38, corrected).
pub const POSITION_CORRECTED_BEEMAN: u32 = 9;

/// Returns whether the integrator uses the acceleration of the previous step.
#[inline(always)]
pub fn is_beeman(m: &Model) -> bool {
    return m.integrator == BEEMAN
        || m.integrator == VELOCITY_CORRECTED_BEEMAN
        || m.integrator == POSITION_CORRECTED_BEEMAN;
}

/// Returns whether the integrator uses a quantity of the previous step.
#[inline(always)]
pub fn has_history(m: &Model) -> bool {
    return m.integrator == VERLET || is_beeman(m);
}

/// Returns whether the end of a step needs the acceleration at the start of the step.
#[inline(always)]
pub fn needs_start_acceleration(m: &Model) -> bool {
    return has_history(m) || m.integrator == VELOCITY_VERLET || m.integrator == LEAPFROG;
}

/// Returns whether the integrator moves particles once more after the forces are evaluated.
#[inline(always)]
pub fn moves_again(m: &Model) -> bool {
    return m.integrator == PREDICTION_RELAXATION || m.integrator == POSITION_CORRECTED_BEEMAN;
}

/// Returns whether forces are evaluated with the velocity at the end of the step.
#[inline(always)]
pub fn knows_velocity(m: &Model) -> bool {
    return m.integrator == EULER || m.integrator == SEMI_IMPLICIT_EULER;
}

/// Returns whether pair passes need the velocities at the end of the step before the second half of the integrator
/// runs.
#[inline(always)]
pub fn needs_predicted_velocity(m: &Model) -> bool {
    return m.has_internal_energy == 1 || m.has_xsph == 1 || m.is_reevaluated == 1;
}

/// Returns the position at which forces are evaluated, m.
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

/// Returns the velocity with which forces are evaluated, m/s.
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

/// Returns the velocity at the end of the step, m/s. `v` is the velocity with which forces were evaluated.
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

/// Returns the position at the end of the step, m. `x` is the position at which forces were evaluated.
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

/// Returns the history for the next step.
#[inline(always)]
pub fn history_after<R: Real>(m: &Model, u: &StepUniform, a: vec3<R>, history: vec3<R>) -> vec3<R> {
    if m.integrator == VERLET {
        return flush3(verlet_displacement(history, a, real(u.time_step)));
    }
    return a;
}

/// Returns the history of a particle that a wall has just reflected, or that has not made a step yet.
#[inline(always)]
pub fn history_reversed<R: Real>(m: &Model, u: &StepUniform, v: vec3<R>, new_a: vec3<R>, history: vec3<R>) -> vec3<R> {
    if m.integrator == VERLET {
        return flush3(verlet_start(v, new_a, real(u.time_step), real(u.half_time_step)));
    }
    return history;
}

/// Returns the history for a step that is `times` as long as the previous one. With [`VERLET`] that is the displacement
/// at the unchanged velocity.
#[inline(always)]
pub fn history_rescaled<R: Real>(m: &Model, history: vec3<R>, times: R) -> vec3<R> {
    if m.integrator == VERLET {
        return flush3(history * times);
    }
    return history;
}

/// Returns `v + a dt`, m/s.
#[inline(always)]
pub fn kick<R: Real>(velocity: vec3<R>, acceleration: vec3<R>, dt: R) -> vec3<R> {
    return flush3(euler_velocity(velocity, acceleration, dt));
}

/// Returns `x + v dt`, m.
#[inline(always)]
pub fn drift<R: Real>(position: vec3<R>, velocity: vec3<R>, dt: R) -> vec3<R> {
    return flush3(euler_position(position, velocity, dt));
}

/// Maps a coordinate back into its period.
#[inline(always)]
pub fn wrapped<R: Real>(x: R, low: f32, period: f32, inverse_period: f32) -> R {
    return x - floor((x - low) * inverse_period) * period;
}

/// Maps a position back into a periodic domain.
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
