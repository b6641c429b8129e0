//! The common part of passes over pairs: a trait for the pass, and jobs over groups of receivers. A receiver is the
//! particle whose sum is computed.
use super::by_model::PairJob;
use super::context::Setup;
use super::group::{Group, Surroundings};
use super::lists::{GROUP, Lists, groups};
use super::local::Particles;
use crate::arithmetic::lanes::Lanes;
use crate::executor::{AnyExecutor, Jobs, parts, shares, take};
use crate::grid::Cells;
use crate::layout::f32x4;

/// Returns the neighbour lists of a step. The half stencil makes none. This is a macro for the same reason as
/// [`particles`](super::local::particles).
macro_rules! lists {
    ($step:ident) => {
        if $step.setup.model.makes_lists() {
            $crate::passes::lists::Lists::new(&$step.scratch.neighbours[..$step.list_words], $step.new.id.len())
        } else {
            $crate::passes::lists::Lists::NONE
        }
    };
}
pub(crate) use lists;

/// Returns the cells of a step.
macro_rules! cells {
    ($step:ident) => {
        $crate::grid::Cells { start: &*$step.scratch.cell_start, counter: &*$step.scratch.grid_cell_counters }
    };
}
pub(crate) use cells;

/// A pass that computes one entry per particle from a sum over its neighbours.
pub(crate) trait PairPass: Sync + Sized {
    /// Runs a job, by one of the functions in `by_model`: a pass chooses for which kinds of scene its loop is compiled.
    fn work(job: &mut Job<'_, Self>);

    /// Fills the entries of a group. Returns a number of which [`run`] takes the maximum, or 0 if the pass has none.
    fn group<R: Lanes>(&self, group: &Group<'_>, own: &mut [f32x4]) -> u32;

    /// Fills the entries of inactive particles, by default with zeros.
    fn absent(&self, _: &Setup<'_>, own: &mut [f32x4]) {
        own.fill([0.0; 4]);
    }
}

/// A job: a range of receivers that begins at the start of a group.
pub(crate) struct Job<'a, P> {
    surroundings: Surroundings<'a>,
    lists: Lists<'a>,
    pass: &'a P,
    /// Number of slots that hold active particles.
    present: usize,
    first_slot: usize,
    out: &'a mut [f32x4],
    largest: u32,
}

/// Runs a pass over all groups. Returns the maximum of the numbers that [`PairPass::group`] returned.
pub(crate) fn run<P: PairPass>(
    setup: Setup<'_>,
    executor: &dyn AnyExecutor,
    particles: Particles<'_>,
    cells: Cells<'_>,
    lists: Lists<'_>,
    pass: &P,
    out: &mut [f32x4],
) -> u32 {
    let (count, present) = (out.len(), present(&setup, cells, out.len()));
    let mut outs = out;
    let surroundings = Surroundings { setup, particles, cells };
    let mut jobs = Jobs::new();
    for groups in shares(groups(count), parts(executor)) {
        let (first_slot, end) = (groups.start * GROUP, (groups.end * GROUP).min(count));
        let out = take(&mut outs, end - first_slot);
        let _ = jobs.push(Job { surroundings, lists, pass, present, first_slot, out, largest: 0 });
    }
    executor.run(&mut jobs, P::work);
    jobs.iter().map(|job| job.largest).max().unwrap_or(0)
}

/// Returns the number of slots that hold active particles. Inactive particles lie in the last cell, and so in the last
/// slots.
pub(crate) fn present(setup: &Setup<'_>, cells: Cells<'_>, particles: usize) -> usize {
    let last = cells.start.last().map_or(particles, |&slot| slot as usize);
    if setup.model.has_inactive == 1 { last } else { particles }
}

impl<'a, P: PairPass> PairJob<'a> for Job<'a, P> {
    fn setup(&self) -> Setup<'a> {
        self.surroundings.setup
    }

    #[inline(always)]
    fn run_by<R: Lanes>(&mut self, setup: &Setup<'_>) {
        let (particles, lists) = (self.surroundings.particles, self.lists);
        let present = self.present.saturating_sub(self.first_slot).min(self.out.len());
        let (out, absent) = self.out.split_at_mut(present);
        for first in (0..out.len()).step_by(R::RECEIVERS) {
            let end = (first + R::RECEIVERS).min(out.len());
            let own = &mut out[first..end];
            let (first, last) = (self.first_slot + first, self.first_slot + end - 1);
            let group = Group { setup, particles, lists, surroundings: &self.surroundings, first, last };
            let count = self.pass.group::<R>(&group, own);
            self.largest = self.largest.max(count);
        }
        if !absent.is_empty() {
            self.pass.absent(setup, absent);
        }
    }
}
