//! First half of the integrator: advances particles to the positions at which forces are evaluated. The particles are
//! not sorted yet, so the results stay in the old slots, in `moved_position` and `moved_velocity`.
use crate::arithmetic::lanes::Lanes;
use crate::arithmetic::level::Work;
use crate::arithmetic::real::real;
use crate::executor::{Jobs, parts, shares, take};
use crate::layout::f32x4;
use crate::memory::{Sorting, State};
use crate::passes::context::{Setup, Step, sorting};
use crate::passes::lanes::{load, load_if_any, row_of, store_xyz};
use crate::terms::integrate::{drift, moved, velocity_for_forces, wrap};
use crate::terms::shifting::drifts;
use crate::terms::wall::only_if_free;
use core::ops::Range;

struct Job<'a> {
    setup: Setup<'a>,
    old: &'a State<'a>,
    slots: Range<usize>,
    moved_position: &'a mut [f32x4],
    moved_velocity: &'a mut [f32x4],
}

/// Fills `moved_position` and `moved_velocity`.
pub(crate) fn run(step: &mut Step<'_, '_>) {
    let (setup, executor, old) = (step.setup, step.executor, step.old);
    let Sorting { moved_position: mut positions, moved_velocity: mut velocities, .. } = sorting!(step);
    let mut jobs = Jobs::new();
    for slots in shares(old.id.len(), parts(executor)) {
        let (moved_position, moved_velocity) = (take(&mut positions, slots.len()), take(&mut velocities, slots.len()));
        let _ = jobs.push(Job { setup, old, slots, moved_position, moved_velocity });
    }
    executor.run(&mut jobs, work);
}

/// Runs a job. This function is compiled once, in this crate: see
/// [`PairPass::work`](crate::passes::pairs::PairPass::work).
fn work(job: &mut Job<'_>) {
    let simd = job.setup.simd;
    simd.run(job);
}

impl Work for &mut Job<'_> {
    #[inline(always)]
    fn run<R: Lanes>(self) {
        let Setup { model: m, parameters: p, materials, uniform: u, .. } = self.setup;
        let old = self.old;
        // copies mass and material, which are the fourth numbers
        self.moved_position.copy_from_slice(&old.position[self.slots.clone()]);
        self.moved_velocity.copy_from_slice(&old.velocity[self.slots.clone()]);
        for first in self.slots.clone().step_by(R::LANES) {
            let end = (first + R::LANES).min(self.slots.end);
            let last = end - 1;
            let (x, v) = (load::<R>(old.position, first, last), load::<R>(old.velocity, first, last));
            let a = load(old.acceleration, first, last);
            let history = load_if_any(old.history, first, last);
            let mut place = moved(m, u, x, v, a, history);
            if drifts(m) {
                place = drift(place, load(old.drift_velocity, first, last), real(u.time_step));
            }
            if m.wall_particles != 0 || m.has_inactive == 1 {
                place = only_if_free(m, x, place, row_of(m, &materials.properties, old.velocity, first, last, 1));
            }
            let own = first - self.slots.start..end - self.slots.start;
            store_xyz(&mut self.moved_velocity[own.clone()], velocity_for_forces(m, u, v, a, history));
            store_xyz(&mut self.moved_position[own], wrap(m, p, place));
        }
    }
}
