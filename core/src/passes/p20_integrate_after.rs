//! Second half of the integrator, then the walls; and a look at every number that is about to become the state.
use super::{Setup, load, row_of, store_xyz};
use crate::arithmetic::level::Work;
use crate::arithmetic::real::{Real, real, vec3};
use crate::error::Quantity;
use crate::executor::{Executor, Jobs, parts, shares, take};
use crate::layout::{NONE, f32x4};
use crate::memory::State;
use crate::terms::boundary::{depth_behind, depth_if_free, put_back, reflect};
use crate::terms::integrate::kick;

struct Job<'a> {
    setup: Setup<'a>,
    position: &'a mut [f32x4],
    velocity: &'a mut [f32x4],
    acceleration: &'a [f32x4],
    density_pressure: &'a [f32x4],
    heat: &'a [f32x4],
    id: &'a [u32],
    /// Smallest `4 id + quantity` that is not finite.
    not_finite: u32,
}

/// Finishes `new`; returns the smallest `4 id + quantity` that is not finite, or [`NONE`].
pub(crate) fn run(setup: Setup<'_>, executor: &impl Executor, new: &mut State<'_>) -> u32 {
    let count = new.id.len();
    let (mut positions, mut velocities) = (&mut *new.position, &mut *new.velocity);
    let mut jobs = Jobs::new();
    for slots in shares(count, parts(executor)) {
        let job = Job {
            setup,
            position: take(&mut positions, slots.len()),
            velocity: take(&mut velocities, slots.len()),
            acceleration: &new.acceleration[slots.clone()],
            density_pressure: &new.density_pressure[slots.clone()],
            heat: new.heat.get(slots.clone()).unwrap_or_default(),
            id: &new.id[slots],
            not_finite: NONE,
        };
        let _ = jobs.push(job);
    }
    executor.run(&mut jobs, work);
    jobs.iter().map(|job| job.not_finite).min().unwrap_or(NONE)
}

/// Compiled once, in this crate: see [`PairPass::work`](super::pairs::PairPass::work).
fn work(job: &mut Job<'_>) {
    let simd = job.setup.simd;
    simd.run(&mut *job);
    job.look();
}

impl Work for &mut Job<'_> {
    #[inline(always)]
    fn run<R: Real>(self) {
        let (m, p) = (self.setup.model, self.setup.parameters);
        let half_dt = real::<R>(p.half_time_step);
        let count = self.id.len();
        for first in (0..count).step_by(R::LANES) {
            let end = (first + R::LANES).min(count);
            let mut v =
                kick::<R>(load(self.velocity, first, end - 1), load(self.acceleration, first, end - 1), half_dt);
            if m.walls == 1 {
                let mut x = load::<R>(self.position, first, end - 1);
                let wall = row_of::<R>(m, &p.species, self.velocity, first, end - 1, 1);
                for plane in &p.planes[..p.plane_count as usize] {
                    let normal = vec3::splat(*plane);
                    let depth = depth_if_free(m, depth_behind(x, normal, real(plane[3])), wall);
                    v = reflect(m, p, v, normal, depth);
                    x = put_back(x, normal, depth);
                }
                // boxed, lest LLVM carry the loop above in the shape of the store
                store_xyz(&mut self.position[first..end], core::hint::black_box(x));
            }
            let v = core::hint::black_box(v);
            store_xyz(&mut self.velocity[first..end], v);
        }
    }
}

impl Job<'_> {
    /// Finds the smallest offender; sums of exponents keep the usual case, nothing wrong, free of branches.
    fn look(&mut self) {
        for (i, id) in self.id.iter().enumerate() {
            let heat = self.heat.get(i).copied().unwrap_or_default();
            let all = [self.position[i], self.velocity[i], self.acceleration[i], self.density_pressure[i], heat];
            if !all.as_flattened().iter().fold(true, |fine, x| fine & x.is_finite()) {
                let first = all.iter().position(|a| !a.iter().all(|x| x.is_finite()));
                let quantity = first.unwrap_or(0).min(Quantity::Density as usize) as u32;
                self.not_finite = self.not_finite.min(4 * id + quantity);
            }
        }
    }
}
