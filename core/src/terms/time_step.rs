//! How long the next step may be (Pirovano, section 2.3.5; Roy, section 3.3, step 5): what moves, what is accelerated, and sound must not
//! come too far in it, nor viscosity.
use super::geometry::*;
use super::state::*;
use crate::arithmetic::real::*;
use crate::layout::{Model, Parameters};

/// Square of a length that is not to overflow, (m/s)^2 or (m/s2)^2.
#[inline(always)]
pub fn bounded_square<R: Real>(x: vec3<R>) -> R {
    return smaller(length2(x), real(3.0e38));
}

/// Speed of sound of a particle, never negative, m/s.
#[inline(always)]
pub fn bounded_sound<R: Real>(m: &Model, deviation: R, sound: R, equation: R) -> R {
    return larger(smaller(sound_of_state(m, deviation, sound, equation), real(3.0e38)), real(0.0));
}

/// `C H / speed` (Pirovano eq. 2.41), s. Slower than a micrometre a second is still.
#[inline(always)]
pub fn step_by_speed<R: Real>(reach: R, speed: R) -> R {
    return div(reach, larger(speed, real(0.000001)));
}

/// `C sqrt(H / a)`, s; `reach` is `C^2 H`.
#[inline(always)]
pub fn step_by_acceleration<R: Real>(reach: R, acceleration: R) -> R {
    return root(step_by_speed(reach, acceleration));
}

/// The longest step that all criteria allow, s, by the largest squared speed, squared acceleration and speed of sound.
#[inline(always)]
pub fn step_wanted<R: Real>(p: &Parameters, speed2: R, acceleration2: R, sound: R) -> R {
    let by_speed = step_by_speed(real(p.speed_limit_length), root(speed2));
    let by_acceleration = step_by_acceleration(real(p.acceleration_reach), root(acceleration2));
    let by_sound = step_by_speed(real(p.sound_limit_length), sound);
    return smaller(smaller(by_speed, by_acceleration), smaller(by_sound, real(p.viscous_time_step)));
}

/// The next step, s: what is wanted, but no more than so many times the last one, and within the scene's limits.
#[inline(always)]
pub fn step_limited<R: Real>(p: &Parameters, wanted: R, last: R) -> R {
    let grown = smaller(wanted, last * p.max_time_step_growth);
    return larger(smaller(grown, real(p.largest_time_step)), real(p.smallest_time_step));
}

/// 1 for a step that is to be undone and made again, being so many times longer than what its end asks for, else 0. The shortest
/// step is never undone.
#[inline(always)]
pub fn is_overlong<R: Real>(p: &Parameters, wanted: R, step: R) -> R {
    if p.reject_ratio == 0.0 {
        return real(0.0);
    }
    let over = select(real(0.0), real(1.0), less(wanted * p.reject_ratio, step));
    return select(real(0.0), over, less(real(p.smallest_time_step), step));
}

/// Half of a step, s.
#[inline(always)]
pub fn step_half<R: Real>(step: R) -> R {
    return step * 0.5;
}

/// One over a step, 1/s.
#[inline(always)]
pub fn step_inverse<R: Real>(step: R) -> R {
    let one: R = real(1.0);
    return div(one, step);
}

/// The clock after a step, s. It is two numbers, of which the second is what the sums lost.
#[inline(always)]
pub fn clock_after<R: Real>(clock: R, step: R) -> R {
    return clock + step;
}

/// What the sums lost, this one too, s; of this one exactly (Neumaier 1974).
#[inline(always)]
pub fn clock_lost<R: Real>(clock: R, lost: R, step: R, after: R) -> R {
    return lost + (smaller(clock, step) - (after - larger(clock, step)));
}
