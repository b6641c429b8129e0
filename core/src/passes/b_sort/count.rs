//! Finds the cell of each particle, the number of particles in each cell, and the rank of each particle within its
//! cell: the number of particles of that cell that were counted before it.
//!
//! Counting is serial, since it takes only one increment per particle. On a GPU the ranks depend on the order of
//! threads; the pass `sort_by_id` removes that dependence. Inactive particles go to the last cell, whatever their
//! position.
use crate::arithmetic::lanes::Lanes;
use crate::arithmetic::level::Work;
use crate::executor::{AnyExecutor, Jobs, parts, shares, take};
use crate::grid::cell_of;
use crate::grid::lanes::cells_of;
use crate::layout::{NONE, f32x4};
use crate::memory::Sorting;
use crate::passes::context::{Setup, Step, sorting};
use crate::passes::lanes::is_inactive;
use core::ops::Range;

struct Job<'a> {
    setup: Setup<'a>,
    position: &'a [f32x4],
    velocity: &'a [f32x4],
    id: &'a [u32],
    cell: &'a mut [u32],
    /// Smallest `4 id + axis` of a coordinate outside the range of the grid, or [`NONE`].
    out_of_range: u32,
}

/// Fills `cell`, `rank` and the counters of the cells.
pub(crate) fn run(step: &mut Step<'_, '_>) {
    let Sorting { moved_position, moved_velocity, cell, rank, .. } = sorting!(step);
    step.found.status.out_of_range =
        find(step.setup, step.executor, [moved_position, moved_velocity], step.old.id, cell);
    if step.found.status.out_of_range == NONE {
        count(cell, rank, step.scratch.grid_cell_counters);
    }
}

/// Fills `cell`. Returns the smallest `4 id + axis` of a coordinate out of range, or [`NONE`].
fn find(
    setup: Setup<'_>,
    executor: &dyn AnyExecutor,
    [position, velocity]: [&[f32x4]; 2],
    id: &[u32],
    cell: &mut [u32],
) -> u32 {
    let mut cells = cell;
    let mut jobs = Jobs::new();
    for slots in shares(id.len(), parts(executor)) {
        let cell = take(&mut cells, slots.len());
        let (position, velocity) = (&position[slots.clone()], &velocity[slots.clone()]);
        let _ = jobs.push(Job { setup, position, velocity, id: &id[slots], cell, out_of_range: NONE });
    }
    executor.run(&mut jobs, work);
    jobs.iter().map(|job| job.out_of_range).min().unwrap_or(NONE)
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
        for first in (0..self.cell.len()).step_by(R::LANES) {
            let end = (first + R::LANES).min(self.cell.len());
            let row = |lane: usize| &self.position[(first + lane).min(end - 1)];
            let cells =
                if self.setup.model.has_inactive == 0 { cells_of::<R>(self.setup.parameters, row) } else { None };
            match cells {
                Some(cells) => self.cell[first..end].copy_from_slice(&cells[..end - first]),
                None => self.one_by_one(first..end),
            }
        }
    }
}

impl Job<'_> {
    /// Finds the cells of these particles without SIMD, and records coordinates out of range.
    #[inline(never)]
    fn one_by_one(&mut self, particles: Range<usize>) {
        let Setup { model: m, parameters: p, materials, .. } = self.setup;
        for i in particles {
            if m.has_inactive == 1 && is_inactive(materials, self.velocity[i][3]) {
                self.cell[i] = p.cells[3] - 1;
                continue;
            }
            match cell_of(p, self.position[i]) {
                Ok(cell) => self.cell[i] = cell,
                Err(axis) => self.out_of_range = self.out_of_range.min(4 * self.id[i] + axis),
            }
        }
    }
}

/// Fills `counter` and `rank`.
pub(crate) fn count(cell: &[u32], rank: &mut [u32], counter: &mut [u32]) {
    counter.fill(0);
    for (rank, &cell) in rank.iter_mut().zip(cell) {
        let count = &mut counter[cell as usize];
        *rank = *count;
        *count += 1;
    }
}
