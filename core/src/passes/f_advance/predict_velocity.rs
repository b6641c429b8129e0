//! Predicts the velocities at the end of the step. Runs only where passes over pairs need these in addition to the
//! velocities that forces are evaluated with.
use crate::arithmetic::lanes::Lanes;
use crate::arithmetic::level::Work;
use crate::executor::{Jobs, parts, shares, take};
use crate::layout::f32x4;
use crate::passes::context::{Setup, Step};
use crate::passes::lanes::{load_if_any, store_xyz};
use crate::terms::integrate::{needs_start_acceleration, velocity_after};

struct Job<'a> {
    setup: Setup<'a>,
    velocity: &'a [f32x4],
    acceleration: &'a [f32x4],
    history: &'a [f32x4],
    start_acceleration: &'a [f32x4],
    predicted_velocity: &'a mut [f32x4],
}

/// Fills `end_velocity`, with the material as the fourth number.
pub(crate) fn run(step: &mut Step<'_, '_>) {
    let new = &*step.new;
    let start_acceleration =
        if needs_start_acceleration(step.setup.model) { &*step.scratch.start_acceleration } else { &[] };
    let mut rest = &mut *step.scratch.end_velocity;
    let mut jobs = Jobs::new();
    for slots in shares(new.id.len(), parts(step.executor)) {
        let job = Job {
            setup: step.setup,
            velocity: &new.velocity[slots.clone()],
            acceleration: &new.acceleration[slots.clone()],
            history: new.history.get(slots.clone()).unwrap_or_default(),
            start_acceleration: start_acceleration.get(slots.clone()).unwrap_or_default(),
            predicted_velocity: take(&mut rest, slots.len()),
        };
        let _ = jobs.push(job);
    }
    step.executor.run(&mut jobs, work);
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
        let (m, u) = (self.setup.model, self.setup.uniform);
        let count = self.predicted_velocity.len();
        self.predicted_velocity.copy_from_slice(self.velocity);
        for first in (0..count).step_by(R::LANES) {
            let end = (first + R::LANES).min(count);
            let of = |array: &[f32x4]| load_if_any::<R>(array, first, end - 1);
            let v = velocity_after(
                m,
                u,
                of(self.velocity),
                of(self.acceleration),
                of(self.start_acceleration),
                of(self.history),
            );
            store_xyz(&mut self.predicted_velocity[first..end], v);
        }
    }
}
