//! Finds the largest speed, acceleration and speed of sound, which determine the next time step. Runs only with
//! adaptive time steps.
use crate::arithmetic::real::vec3;
use crate::executor::{Jobs, parts, shares};
use crate::layout::f32x4;
use crate::passes::context::{Maxima, Setup, Step};
use crate::passes::lanes::material_of;
use crate::terms::time_step::{bounded_sound, bounded_square};

struct Job<'a> {
    velocity: &'a [f32x4],
    acceleration: &'a [f32x4],
    density_pressure: &'a [f32x4],
    maxima: Maxima,
}

/// Finds the maxima of the new state.
pub(crate) fn run(step: &mut Step<'_, '_>) {
    let (setup, new) = (step.setup, &*step.new);
    let mut jobs = Jobs::new();
    for slots in shares(new.id.len(), parts(step.executor)) {
        let job = Job {
            velocity: &new.velocity[slots.clone()],
            acceleration: &new.acceleration[slots.clone()],
            density_pressure: &new.density_pressure[slots],
            maxima: Maxima::default(),
        };
        let _ = jobs.push(job);
    }
    step.executor.run(&mut jobs, |job| {
        for ((v, a), d) in job.velocity.iter().zip(job.acceleration).zip(job.density_pressure) {
            job.maxima = job.maxima.and(of_particle(&setup, *v, *a, *d));
        }
    });
    step.found.maxima = jobs.iter().fold(Maxima::default(), |all, job| all.and(job.maxima));
}

fn of_particle(setup: &Setup<'_>, v: f32x4, a: f32x4, density_pressure: f32x4) -> Maxima {
    let m = setup.model;
    let [.., sound, equation] = setup.materials.states[if m.has_materials == 1 { material_of(v[3]) } else { 0 }];
    Maxima {
        speed2: bounded_square(vec3::<f32>::splat(v)),
        acceleration2: bounded_square(vec3::<f32>::splat(a)),
        sound: bounded_sound::<f32>(m, density_pressure[0], sound, equation),
    }
}
