//! The length of the next time step (Pirovano, section 2.3.5; Roy, section 3.3, step 5). It is limited by the speed and
//! the acceleration of the particles, by the speed of sound and by viscosity.
use super::geometry::*;
use super::state::*;
use crate::arithmetic::real::*;
use crate::layout::{Model, Parameters};

/// Returns the squared length, limited so that it does not overflow, (m/s)^2 or (m/s2)^2.
#[inline(always)]
pub fn bounded_square<R: Real>(x: vec3<R>) -> R {
    return smaller(length2(x), real(3.0e38));
}

/// Returns the speed of sound of a particle, limited to finite values of at least 0, m/s.
#[inline(always)]
pub fn bounded_sound<R: Real>(m: &Model, deviation: R, sound: R, equation: R) -> R {
    return larger(smaller(sound_of_state(m, deviation, sound, equation), real(3.0e38)), real(0.0));
}

/// Returns `C H / speed` (Pirovano, eq. 2.41), s. Speeds below one micrometre per second count as that speed.
#[inline(always)]
pub fn step_by_speed<R: Real>(reach: R, speed: R) -> R {
    return div(reach, larger(speed, real(0.000001)));
}

/// Returns `C sqrt(H / a)`, s; `reach` is `C^2 H`.
#[inline(always)]
pub fn step_by_acceleration<R: Real>(reach: R, acceleration: R) -> R {
    return root(step_by_speed(reach, acceleration));
}

/// Returns the longest step that all criteria allow, s, from the largest squared speed, squared acceleration and speed
/// of sound.
#[inline(always)]
pub fn step_wanted<R: Real>(p: &Parameters, speed2: R, acceleration2: R, sound: R) -> R {
    let by_speed = step_by_speed(real(p.speed_limit_length), root(speed2));
    let by_acceleration = step_by_acceleration(real(p.acceleration_limit_length), root(acceleration2));
    let by_sound = step_by_speed(real(p.sound_limit_length), sound);
    return smaller(smaller(by_speed, by_acceleration), smaller(by_sound, real(p.viscous_time_step)));
}

/// Returns the next step, s: the wanted step, limited by the largest growth over the last step and by the scene's
/// bounds.
#[inline(always)]
pub fn step_limited<R: Real>(p: &Parameters, wanted: R, last: R) -> R {
    let grown = smaller(wanted, last * p.max_time_step_growth);
    return larger(smaller(grown, real(p.largest_time_step)), real(p.smallest_time_step));
}

/// Returns 1 for a step that is to be rejected and repeated, because its length over the step wanted at its end exceeds
/// `reject_ratio`, else 0. A step of the smallest allowed length is never rejected.
#[inline(always)]
pub fn is_overlong<R: Real>(p: &Parameters, wanted: R, step: R) -> R {
    if p.reject_ratio == 0.0 {
        return real(0.0);
    }
    let over = select(real(0.0), real(1.0), less(wanted * p.reject_ratio, step));
    return select(real(0.0), over, less(real(p.smallest_time_step), step));
}

/// Returns half of a step, s.
#[inline(always)]
pub fn step_half<R: Real>(step: R) -> R {
    return step * 0.5;
}

/// Returns the inverse of a step, 1/s.
#[inline(always)]
pub fn step_inverse<R: Real>(step: R) -> R {
    let one: R = real(1.0);
    return div(one, step);
}

/// Returns what the sum of clock and step loses to rounding, s; exactly (Neumaier 1974).
#[inline(always)]
pub fn sum_lost<R: Real>(clock: R, step: R) -> R {
    return smaller(clock, step) - ((clock + step) - larger(clock, step));
}

/// Returns the clock after a step, s. The clock is two numbers, of which the second is what the first one lost to
/// rounding: never more than its last digit, so that the clock goes on however short a step is.
#[inline(always)]
pub fn clock_after<R: Real>(clock: R, lost: R, step: R) -> R {
    return (clock + step) + (lost + sum_lost(clock, step));
}

/// Returns the second number of the clock after a step, s; `after` is the first one.
#[inline(always)]
pub fn clock_lost<R: Real>(clock: R, lost: R, step: R, after: R) -> R {
    return (lost + sum_lost(clock, step)) - (after - (clock + step));
}
