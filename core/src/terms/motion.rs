//! The motion of solids: frames, prescribed courses, and steps of a rotation.
use super::geometry::*;
use crate::arithmetic::real::*;
use crate::layout::StepUniform;

/// Returns `a x b`.
#[inline(always)]
pub fn cross3<R: Real>(a: vec3<R>, b: vec3<R>) -> vec3<R> {
    return vec3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

/// Returns a vector rotated by the unit quaternion with the vector part `q` and the scalar part `w`.
#[inline(always)]
pub fn rotated<R: Real>(q: vec3<R>, w: R, v: vec3<R>) -> vec3<R> {
    let t = cross3(q, v) * real(2.0);
    return v + t * w + cross3(q, t);
}

/// Returns a vector rotated back by a unit quaternion.
#[inline(always)]
pub fn rotated_back<R: Real>(q: vec3<R>, w: R, v: vec3<R>) -> vec3<R> {
    return rotated(q, -w, v);
}

/// Returns the vector part of the product of two quaternions: first the rotation by `b`, then that by `a`.
#[inline(always)]
pub fn turned_vector<R: Real>(a: vec3<R>, a_w: R, b: vec3<R>, b_w: R) -> vec3<R> {
    return cross3(a, b) + b * a_w + a * b_w;
}

/// Returns the scalar part of that product.
#[inline(always)]
pub fn turned_scalar<R: Real>(a: vec3<R>, a_w: R, b: vec3<R>, b_w: R) -> R {
    return a_w * b_w - dot3(a, b);
}

/// Returns the inverse of the length of a quaternion.
#[inline(always)]
pub fn inverse_norm<R: Real>(q: vec3<R>, w: R) -> R {
    let one: R = real(1.0);
    return div(one, root(length2(q) + w * w));
}

/// Returns half of the rotation of a step, the vector part of the quaternion whose scalar part is 1. The angle of that
/// quaternion is `2 atan(omega dt / 2)`, so a step has an error of order dt^3 (Cayley's map).
#[inline(always)]
pub fn half_turn<R: Real>(u: &StepUniform, spin: vec3<R>) -> vec3<R> {
    return spin * real(u.half_time_step);
}

/// Returns the velocity of a point of a solid, m/s; `arm` leads to it from the origin of the solid.
#[inline(always)]
pub fn velocity_at<R: Real>(velocity: vec3<R>, spin: vec3<R>, arm: vec3<R>) -> vec3<R> {
    return velocity + cross3(spin, arm);
}

/// Returns the sine of an angle given in turns. It is accurate to 2e-7.
#[inline(always)]
pub fn sine_of_turns<R: Real>(turns: R) -> R {
    let half: R = real(0.5);
    let x = turns - floor(turns + 0.5);
    // the sine of half a turn less the angle is the same
    let s = select(half, real(-0.5), less(x, real(0.0)));
    let r = select(x, s - x, less(real(0.25), abs(x)));
    let y = r * r;
    let a = y * 15.094643 - 42.058693;
    let b = a * y + 76.705864;
    let c = b * y - 81.60525;
    let d = c * y + 41.341704;
    return -((d * y - 6.2831855) * r);
}

/// Returns the cosine of an angle given in turns.
#[inline(always)]
pub fn cosine_of_turns<R: Real>(turns: R) -> R {
    return sine_of_turns(turns + 0.25);
}

/// Returns the phase of an oscillation, in periods, less the whole ones.
#[inline(always)]
pub fn phase_at<R: Real>(frequency: R, phase: R, time: R) -> R {
    let periods = frequency * time;
    return (periods - floor(periods)) + phase;
}

/// Returns the rate of the sine of the phase, 1/s.
#[inline(always)]
pub fn swing_rate<R: Real>(frequency: R, phase: R) -> R {
    return cosine_of_turns(phase) * (frequency * 6.2831855);
}

/// Returns the position on a course, m; `swing` is the sine of its phase.
#[inline(always)]
pub fn course_position<R: Real>(start: vec3<R>, velocity: vec3<R>, amplitude: vec3<R>, time: R, swing: R) -> vec3<R> {
    return flush3(start + velocity * time + amplitude * swing);
}

/// Returns the velocity on a course, m/s; `rate` is the rate of its swing.
#[inline(always)]
pub fn course_velocity<R: Real>(velocity: vec3<R>, amplitude: vec3<R>, rate: R) -> vec3<R> {
    return flush3(velocity + amplitude * rate);
}

/// Returns the angle on a course, turns; `steady` is the constant part of its rate, turns per second.
#[inline(always)]
pub fn course_angle<R: Real>(steady: R, rocking: R, time: R, swing: R) -> R {
    let turns = steady * time;
    return (turns - floor(turns)) + rocking * swing;
}

/// Returns the angular velocity on a course about a unit axis, 1/s.
#[inline(always)]
pub fn course_spin<R: Real>(axis: vec3<R>, steady: R, rocking: R, rate: R) -> vec3<R> {
    return flush3(axis * ((steady + rocking * rate) * 6.2831855));
}
