//! Sets pressure, density and volume of the wall particles, and fills the velocities that viscosity sees. Runs only
//! with walls that are extrapolated.
use crate::executor::{Jobs, parts, shares, take};
use crate::layout::f32x4;
use crate::passes::context::{Setup, Step};
use crate::passes::lanes::{is_inactive, is_wall, material_of};
use crate::passes::local::particles;
use crate::terms::density::volume_close;
use crate::terms::extrapolation::wall_deviation;

struct Job<'a> {
    setup: Setup<'a>,
    position: &'a [f32x4],
    velocity: &'a [f32x4],
    density_pressure: &'a mut [f32x4],
    seen_velocity: &'a mut [f32x4],
}

/// Completes `density_pressure` and `seen_velocity`.
pub(crate) fn run(step: &mut Step<'_, '_>) {
    let velocity = particles!(step but density).velocity;
    let mut states = &mut *step.new.density_pressure;
    let mut seen = &mut *step.scratch.seen_velocity;
    let mut jobs = Jobs::new();
    for slots in shares(velocity.len(), parts(step.executor)) {
        let job = Job {
            setup: step.setup,
            position: &step.new.position[slots.clone()],
            velocity: &velocity[slots.clone()],
            density_pressure: take(&mut states, slots.len()),
            seen_velocity: take(&mut seen, slots.len()),
        };
        let _ = jobs.push(job);
    }
    step.executor.run(&mut jobs, work);
}

fn work(job: &mut Job<'_>) {
    let Setup { model: m, parameters: p, materials, .. } = job.setup;
    let states = job.density_pressure.iter_mut().zip(&mut *job.seen_velocity);
    for ((state, seen), (position, velocity)) in states.zip(job.position.iter().zip(job.velocity)) {
        if !is_wall(materials, velocity[3]) || is_inactive(materials, velocity[3]) {
            *seen = *velocity;
            continue;
        }
        let pressure = seen[3];
        let [stiffness, _, _, equation] = materials.states[material_of(velocity[3])];
        let deviation = wall_deviation(m, p, pressure, stiffness, equation);
        *state = [deviation, pressure, 0.0, volume_close(p, position[3], deviation)];
        seen[3] = velocity[3];
    }
}
