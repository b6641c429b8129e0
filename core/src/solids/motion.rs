//! The poses of solids: where a solid is at a time, and how fast it moves.
use crate::arithmetic::real::{flush, vec3};
use crate::layout::{DRIVEN, Model, ON_COURSE, POSE_STRIDE, Parameters, SOLID_STRIDE, StepUniform, f32x4};
use crate::terms::geometry::flush3;
use crate::terms::integrate::{drift, wrap};
use crate::terms::motion::{
    cosine_of_turns, course_angle, course_position, course_spin, course_velocity, half_turn, inverse_norm, phase_at,
    sine_of_turns, swing_rate, turned_scalar, turned_vector,
};
use crate::terms::time_step::clock_after;

/// Returns the rows of the pose of a solid at the end of a step that begins at the time of the clock.
pub(crate) fn moved(
    (m, p, u): (&Model, &Parameters, &StepUniform),
    rows: &[f32x4],
    old: &[f32x4],
    [clock, lost]: [f32; 2],
) -> [f32x4; POSE_STRIDE] {
    match rows[0][3] {
        ON_COURSE => on_course(m, p, rows, clock_after::<f32>(clock, lost, u.time_step)),
        DRIVEN => {
            let half = half_turn(u, vec3::splat(old[3]));
            let (q, w) = (vec3::splat(old[1]), old[1][3]);
            let (vector, scalar) = (turned_vector(half, 1.0, q, w), turned_scalar(half, 1.0, q, w));
            let norm = inverse_norm(vector, scalar);
            let vector = flush3(vector * norm);
            let place = wrap(m, p, drift(vec3::splat(old[0]), vec3::splat(old[2]), u.time_step));
            let turned = [vector.x, vector.y, vector.z, flush(scalar * norm)];
            [[place.x, place.y, place.z, 0.0], turned, old[2], old[3]]
        }
        _ => [old[0], old[1], old[2], old[3]],
    }
}

/// Returns the pose at a time on the course of a solid.
pub(crate) fn on_course(m: &Model, p: &Parameters, rows: &[f32x4], time: f32) -> [f32x4; POSE_STRIDE] {
    let phase = phase_at(rows[3][3], rows[5][3], time);
    let (swing, rate) = (sine_of_turns(phase), swing_rate(rows[3][3], phase));
    let (velocity, amplitude, axis) = (vec3::splat(rows[5]), vec3::splat(rows[6]), vec3::splat(rows[7]));
    let place = wrap(m, p, course_position(vec3::splat(rows[3]), velocity, amplitude, time, swing));
    let angle = course_angle(rows[7][3], rows[6][3], time, swing) * 0.5;
    let (turn, cosine) = (axis * sine_of_turns(angle), cosine_of_turns(angle));
    let (q, w) = (vec3::splat(rows[4]), rows[4][3]);
    let vector = flush3(turned_vector(turn, cosine, q, w));
    let speed = course_velocity(velocity, amplitude, rate);
    let spin = course_spin(axis, rows[7][3], rows[6][3], rate);
    [
        [place.x, place.y, place.z, 0.0],
        [vector.x, vector.y, vector.z, flush(turned_scalar(turn, cosine, q, w))],
        [speed.x, speed.y, speed.z, 0.0],
        [spin.x, spin.y, spin.z, 0.0],
    ]
}

/// Writes the poses at the end of a step into `new`; `old` are those at its start, and sides of polygons, which follow
/// the poses, never change.
pub(crate) fn move_all(
    (m, p, u): (&Model, &Parameters, &StepUniform),
    clock: [f32; 2],
    old: &[f32x4],
    new: &mut [f32x4],
) {
    new.copy_from_slice(old);
    let solids = p.solids.chunks_exact(SOLID_STRIDE).take(p.solid_counts[0] as usize);
    let poses = old.chunks_exact(POSE_STRIDE).zip(new.chunks_exact_mut(POSE_STRIDE));
    for (rows, (old, new)) in solids.zip(poses) {
        new.copy_from_slice(&moved((m, p, u), rows, old, clock));
    }
}
