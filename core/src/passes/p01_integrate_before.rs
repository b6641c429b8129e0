//! First half of the integrator, and the cell that each particle comes to.
//!
//! Reads the old state in its slots. The new state's slots are not known yet, so the moved particles wait in two arrays
//! of the new state that are not in use before `p08_density` and `p09_force` fill them.
use super::{Setup, load, store};
use crate::arithmetic::level::Work;
use crate::arithmetic::real::{Real, real};
use crate::executor::{Executor, Jobs, parts, shares, take};
use crate::grid::cell_of;
use crate::layout::{NONE, Parameters, f32x4};
use crate::storage::State;
use crate::terms::integrate::{drift, kick};

struct Job<'a> {
    p: &'a Parameters,
    position: &'a [f32x4],
    velocity: &'a [f32x4],
    acceleration: &'a [f32x4],
    id: &'a [u32],
    moved_position: &'a mut [f32x4],
    moved_velocity: &'a mut [f32x4],
    cell: &'a mut [u32],
    /// Smallest `4 id + axis` beyond the grid's range.
    out_of_range: u32,
}

/// Fills `moved_position`, `moved_velocity` and `cell`; returns the smallest `4 id + axis` out of range, or [`NONE`].
pub(crate) fn run(
    setup: Setup<'_>,
    executor: &impl Executor,
    old: &State<'_>,
    moved_position: &mut [f32x4],
    moved_velocity: &mut [f32x4],
    cell: &mut [u32],
) -> u32 {
    let (mut positions, mut velocities, mut cells) = (moved_position, moved_velocity, cell);
    let mut jobs = Jobs::new();
    for slots in shares(old.id.len(), parts(executor)) {
        let count = slots.len();
        let job = Job {
            p: setup.parameters,
            position: &old.position[slots.clone()],
            velocity: &old.velocity[slots.clone()],
            acceleration: &old.acceleration[slots.clone()],
            id: &old.id[slots],
            moved_position: take(&mut positions, count),
            moved_velocity: take(&mut velocities, count),
            cell: take(&mut cells, count),
            out_of_range: NONE,
        };
        let _ = jobs.push(job);
    }
    executor.run(&mut jobs, |job| setup.simd.run(job));
    jobs.iter().map(|job| job.out_of_range).min().unwrap_or(NONE)
}

impl Work for &mut Job<'_> {
    #[inline(always)]
    fn run<R: Real>(self) {
        let (dt, half_dt) = (real::<R>(self.p.time_step), real::<R>(self.p.half_time_step));
        let count = self.id.len();
        for first in (0..count).step_by(R::LANES) {
            let end = (first + R::LANES).min(count);
            let last = end - 1;
            let v = kick::<R>(load(self.velocity, first, last), load(self.acceleration, first, last), half_dt);
            let x = drift::<R>(load(self.position, first, last), v, dt);
            store(&mut self.moved_velocity[first..end], v);
            store(&mut self.moved_position[first..end], x);
        }
        for ((cell, x), id) in self.cell.iter_mut().zip(&*self.moved_position).zip(self.id) {
            match cell_of(self.p, *x) {
                Ok(index) => *cell = index,
                Err(axis) => self.out_of_range = self.out_of_range.min(4 * id + axis),
            }
        }
    }
}
