//! Second half of the integrator, followed by the penalty planes.
use crate::arithmetic::lanes::Lanes;
use crate::arithmetic::level::Work;
use crate::arithmetic::real::{less, real, vec3};
use crate::executor::{Jobs, parts, shares, take};
use crate::layout::f32x4;
use crate::passes::context::{Setup, Step};
use crate::passes::lanes::{load, load_if_any, row_of, store_xyz};
use crate::terms::boundary::{depth_behind, depth_if_free, put_back, reflect, select_if_behind};
use crate::terms::geometry::flush3;
use crate::terms::integrate::{
    has_history, history_after, history_reversed, moves_again, needs_predicted_velocity, needs_start_acceleration,
    position_after, velocity_after, wrap,
};
use crate::terms::wall::only_if_free;

struct Job<'a> {
    setup: Setup<'a>,
    position: &'a mut [f32x4],
    velocity: &'a mut [f32x4],
    history: &'a mut [f32x4],
    acceleration: &'a [f32x4],
    start_acceleration: &'a [f32x4],
    predicted_velocity: &'a [f32x4],
}

/// Finishes positions, velocities and the history of the integrator.
pub(crate) fn run(step: &mut Step<'_, '_>) {
    let (setup, new) = (step.setup, &mut *step.new);
    // an evaluation of forces without a step has the arrays of its scene, but does not fill them
    let if_needed = |needed: bool, array| if needed { array } else { &[][..] };
    let start_acceleration = if_needed(needs_start_acceleration(setup.model), &*step.scratch.start_acceleration);
    let predicted_velocity = if_needed(needs_predicted_velocity(setup.model), &*step.scratch.end_velocity);
    let count = new.id.len();
    let (mut positions, mut velocities, mut histories) = (&mut *new.position, &mut *new.velocity, &mut *new.history);
    let mut jobs = Jobs::new();
    for slots in shares(count, parts(step.executor)) {
        let history = if histories.is_empty() { &mut [] } else { take(&mut histories, slots.len()) };
        let job = Job {
            setup,
            position: take(&mut positions, slots.len()),
            velocity: take(&mut velocities, slots.len()),
            history,
            acceleration: &new.acceleration[slots.clone()],
            start_acceleration: start_acceleration.get(slots.clone()).unwrap_or_default(),
            predicted_velocity: predicted_velocity.get(slots).unwrap_or_default(),
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
        let Setup { model: m, parameters: p, materials, uniform: u, .. } = self.setup;
        let count = self.velocity.len();
        for first in (0..count).step_by(R::LANES) {
            let end = (first + R::LANES).min(count);
            let last = end - 1;
            let a = load::<R>(self.acceleration, first, last);
            let start_acceleration = load_if_any(self.start_acceleration, first, last);
            let before = load_if_any(self.history, first, last);
            let mut v = if self.predicted_velocity.is_empty() {
                velocity_after(m, u, load(self.velocity, first, last), a, start_acceleration, before)
            } else {
                load(self.predicted_velocity, first, last)
            };
            let mut history = history_after(m, u, start_acceleration, before);
            if m.has_container == 1 || moves_again(m) {
                let mut x = load::<R>(self.position, first, last);
                let wall = row_of::<R>(m, &materials.properties, self.velocity, first, last, 1);
                if moves_again(m) {
                    x = wrap(m, p, only_if_free(m, x, position_after(m, u, x, a, start_acceleration, before), wall));
                }
                if m.has_container == 1 {
                    let mut is_flushed = false;
                    for plane in &p.planes[..p.plane_count as usize] {
                        let normal = vec3::splat(*plane);
                        let depth = depth_if_free(m, depth_behind(x, normal, real(plane[3])), wall);
                        if !has_history(m) && !R::any(less(real(0.0), depth)) {
                            // no particle in the lanes is behind the plane, so it only flushes denormals, once for all
                            // planes
                            if !is_flushed {
                                (v, x) = (flush3(v), flush3(x));
                            }
                            is_flushed = true;
                            continue;
                        }
                        is_flushed = true;
                        v = reflect(m, p, u, v, normal, depth);
                        x = put_back(x, normal, depth);
                        if has_history(m) {
                            history = select_if_behind(history, history_reversed(m, u, v, a, history), depth);
                        }
                    }
                }
                // `black_box` keeps LLVM from carrying these values through the loop above in the layout of the store
                store_xyz(&mut self.position[first..end], core::hint::black_box(x));
            }
            if has_history(m) {
                store_xyz(&mut self.history[first..end], core::hint::black_box(history));
            }
            let v = core::hint::black_box(v);
            store_xyz(&mut self.velocity[first..end], v);
        }
    }
}
