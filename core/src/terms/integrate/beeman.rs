//! The three Beeman integrators (Beeman 1976; Capone 2009). They use the acceleration of the previous step, and
//! evaluate forces once per step.
//!
//! The weights are written over their common denominator, so that their sums are exact in any precision. The correctors
//! start from the prediction, which differs from the corrected value by a multiple of the second difference
//! `a_{t+1} - 2 a_t + a_{t-1}`.
use crate::arithmetic::real::*;

/// Position `x_{t+1} = x_t + v_t dt + (2/3 a_t - 1/6 a_{t-1}) dt^2` (Pirovano, eqs. 2.36 to 2.38), m.
#[inline(always)]
pub fn beeman_position<R: Real>(x: vec3<R>, v: vec3<R>, a: vec3<R>, old_a: vec3<R>, dt: R) -> vec3<R> {
    let sixth = div(dt * dt, real(6.0));
    return x + v * dt + (a * real(4.0) - old_a) * sixth;
}

/// Velocity of Beeman (Pirovano, eq. 2.36, corrected), m/s: `v_{t+1} = v_t + (1/3 a_{t+1} + 5/6 a_t - 1/6 a_{t-1}) dt`.
/// Forces are evaluated with v_t. Without damping the order is 2, the scheme is stable up to omega dt = 2, and its
/// positions are those of Verlet; with damping the order is 1.
#[inline(always)]
pub fn beeman_velocity<R: Real>(v: vec3<R>, new_a: vec3<R>, a: vec3<R>, old_a: vec3<R>, dt: R) -> vec3<R> {
    let sixth = div(dt, real(6.0));
    return v + (new_a * real(2.0) + a * real(5.0) - old_a) * sixth;
}

/// Predicted velocity `v_t + (3/2 a_t - 1/2 a_{t-1}) dt` (Pirovano, eqs. 2.37 and 2.38), m/s, with which forces are
/// evaluated.
#[inline(always)]
pub fn beeman_prediction<R: Real>(v: vec3<R>, a: vec3<R>, old_a: vec3<R>, half_dt: R) -> vec3<R> {
    return v + (a * real(3.0) - old_a) * half_dt;
}

/// Second difference `a_{t+1} - 2 a_t + a_{t-1}`, m/s2.
#[inline(always)]
pub fn second_difference<R: Real>(new_a: vec3<R>, a: vec3<R>, old_a: vec3<R>) -> vec3<R> {
    return new_a - a * real(2.0) + old_a;
}

/// Velocity of the velocity-corrected Beeman integrator (Pirovano, eq. 2.37), m/s, from the prediction:
/// `v_t + (1/3 a_{t+1} + 5/6 a_t - 1/6 a_{t-1}) dt`. The order is 2, also with damping. Without damping it equals
/// Beeman.
#[inline(always)]
pub fn velocity_corrected<R: Real>(prediction: vec3<R>, second: vec3<R>, dt: R) -> vec3<R> {
    let third = div(dt, real(3.0));
    return prediction + second * third;
}

/// Velocity of the position-corrected Beeman integrator (Pirovano, eq. 2.38, corrected), m/s, from the prediction:
/// `v_t + (5/12 a_{t+1} + 8/12 a_t - 1/12 a_{t-1}) dt`. The order is 3 without damping and 2 with it. Without damping
/// the amplitude grows by a factor of 1 + (omega dt)^4 / 24 at small steps, and only steps from omega dt = 0.738 to
/// sqrt(3 / 2) are stable.
#[inline(always)]
pub fn position_corrected_velocity<R: Real>(prediction: vec3<R>, second: vec3<R>, dt: R) -> vec3<R> {
    let share = div(dt * 5.0, real(12.0));
    return prediction + second * share;
}

/// Position of the position-corrected Beeman integrator, `x_t + v_t dt + (1/6 a_{t+1} + 1/3 a_t) dt^2`, m, from the
/// prediction.
#[inline(always)]
pub fn position_corrected<R: Real>(prediction: vec3<R>, second: vec3<R>, dt: R) -> vec3<R> {
    let sixth = div(dt * dt, real(6.0));
    return prediction + second * sixth;
}
