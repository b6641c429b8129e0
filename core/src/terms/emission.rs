//! Emitters and drains (Pirovano, sections 4.1.4 and 4.1.5): when the next layer of particles leaves an opening, where
//! its particles are, and which particles a drain takes.
//!
//! An emitter counts the time since its last layer. It does so in two numbers, of which the second is what the first
//! one lost to rounding (see the clock in `time_step`), so that many layers later the flow is still exact.
use super::geometry::*;
use super::integrate::*;
use super::time_step::*;
use crate::arithmetic::real::*;
use crate::layout::{Model, Parameters, StepUniform};

/// Returns the time since the last layer at the end of a step, s, if no layer leaves in it.
#[inline(always)]
pub fn time_since_layer<R: Real>(u: &StepUniform, since: R, lost: R) -> R {
    return clock_after(since, lost, real(u.time_step));
}

/// Returns what that time has lost to rounding at the end of a step, s.
#[inline(always)]
pub fn time_lost_since_layer<R: Real>(u: &StepUniform, since: R, lost: R) -> R {
    return clock_lost(since, lost, real(u.time_step), time_since_layer(u, since, lost));
}

/// Returns 1 if a layer leaves in a step, at whose end it is `since` seconds after the last one, else 0. `rest` is how
/// long the emitter still runs, s. Nothing leaves while time is at rest.
#[inline(always)]
pub fn layer_leaves<R: Real>(u: &StepUniform, since: R, interval: R, rest: R) -> R {
    let nothing: R = real(0.0);
    let due = select(real(1.0), nothing, less(since, interval));
    let running = select(nothing, due, less(nothing, rest));
    return select(nothing, running, less(nothing, real(u.time_step)));
}

/// Returns the position of a particle of a layer, m, `late` seconds after the layer has left the opening.
#[inline(always)]
pub fn emitted_position<R: Real>(m: &Model, p: &Parameters, place: vec3<R>, velocity: vec3<R>, late: R) -> vec3<R> {
    return wrap(m, p, flush3(place + velocity * late));
}

/// Returns how long a particle still lives after a step, s.
#[inline(always)]
pub fn life_after<R: Real>(u: &StepUniform, left: R) -> R {
    return left - u.time_step;
}

/// Returns 1 if `x` lies between `low` and `high`, else 0.
#[inline(always)]
pub fn is_between<R: Real>(x: R, low: R, high: R) -> R {
    let nothing: R = real(0.0);
    return select(select(nothing, real(1.0), less(low, x)), nothing, less(high, x));
}

/// Returns 1 for a position that a drain takes, else 0. A ball has its centre in `one`; a box, whose `radius2` is 0,
/// has its lowest corner there and its highest in `other`.
#[inline(always)]
pub fn is_drained<R: Real>(x: vec3<R>, one: vec3<R>, other: vec3<R>, radius2: R) -> R {
    let nothing: R = real(0.0);
    let across = is_between(x.x, one.x, other.x) * is_between(x.y, one.y, other.y);
    let in_box = across * is_between(x.z, one.z, other.z);
    let in_ball = select(nothing, real(1.0), less(length2(x - one), radius2));
    return select(in_box, in_ball, less(nothing, radius2));
}
