//! What the passes over pairs share: blocks of particles, each with the neighbours that were listed before.
use super::context::Setup;
use super::local::Particles;
use crate::arithmetic::level::Work;
use crate::arithmetic::real::Real;
use crate::executor::{Executor, Jobs, parts, take};
use crate::grid::{Cells, Stencil};
use crate::layout::{Model, f32x4, u32x2};
use core::ops::Range;

/// Length of a neighbour list that did not fit: the block walks its stencil again.
pub(crate) const NOT_LISTED: u32 = u32::MAX;

/// The sorted particles and their neighbour lists.
#[derive(Clone, Copy)]
pub(crate) struct Lists<'a> {
    pub sorted: Cells<'a>,
    pub ranges: &'a [u32x2],
    pub neighbours: &'a [u32],
}

/// The lists of a step: a macro for the same reason as [`particles`](super::local::particles).
macro_rules! lists {
    ($step:ident) => {
        $crate::passes::pairs::Lists {
            sorted: $crate::passes::pairs::cells!($step),
            ranges: &*$step.scratch.neighbour_ranges,
            neighbours: &*$step.scratch.neighbours,
        }
    };
}
pub(crate) use lists;

/// The cells of a step.
macro_rules! cells {
    ($step:ident) => {
        $crate::grid::Cells { start: &*$step.scratch.cell_start, counter: &*$step.scratch.grid_cell_counters }
    };
}
pub(crate) use cells;

/// A block: up to as many particles of one cell as there are lanes, side by side from `first` on.
pub(crate) struct Block<'a> {
    pub(crate) setup: &'a Setup<'a>,
    pub(crate) particles: &'a Particles<'a>,
    pub(crate) lists: &'a Lists<'a>,
    cell: usize,
    pub(crate) first: usize,
    pub(crate) last: usize,
}

/// Folds the neighbours of a block in their order. Who is listed and no neighbour of a lane must add nothing to it.
///
/// A macro, since a closure cannot be told to be compiled into its caller, at its caller's SIMD level.
macro_rules! fold {
    ($block:ident, $start:expr, |$sum:pat_param, $b:ident| $add:expr) => {{
        let mut sum = $start;
        let (walk, listed) = $block.walk();
        for run in walk.runs() {
            for entry in run {
                // one loop for both, since whatever is added is compiled in once for each
                let $b = if listed { $block.lists.neighbours[entry] as usize } else { entry };
                let $sum = sum;
                sum = $add;
            }
        }
        // the box keeps LLVM from carrying the loops above in the shape of the stores that follow, at half their speed
        core::hint::black_box(sum)
    }};
}
pub(crate) use fold;

impl Block<'_> {
    /// Its neighbours: entries of its list, or, where that did not fit, the slots around it.
    #[inline(always)]
    pub(crate) fn walk(&self) -> (Stencil, bool) {
        let [begin, length] = self.lists.ranges[self.first];
        let (p, layers) = (self.setup.parameters, self.setup.model.layers as i32);
        if length == NOT_LISTED {
            (Stencil::around(p, layers, self.lists.sorted, self.cell), false)
        } else {
            (Stencil::one(begin, begin + length), true)
        }
    }
}

/// A pass that makes one entry a particle of what its neighbours add up to.
pub(crate) trait PairPass: Sync + Sized {
    /// Does a job: `job.run()`. Written out in each pass, and so compiled once, in this crate: what is generic is compiled again
    /// in every program that brings an executor of its own.
    fn work(job: &mut Job<'_, Self>);

    /// Fills the entries of a block. Returns a count, of which `run` takes the largest.
    fn block<R: Real>(&self, block: &Block<'_>, own: &mut [f32x4]) -> u32;
}

/// A share of the blocks.
pub(crate) struct Job<'a, P> {
    setup: Setup<'a>,
    particles: Particles<'a>,
    lists: Lists<'a>,
    pass: &'a P,
    cells: Range<usize>,
    first_slot: usize,
    out: &'a mut [f32x4],
    largest: u32,
}

/// Runs a pass over all blocks; returns the largest of what they return.
pub(crate) fn run<P: PairPass>(
    setup: Setup<'_>,
    executor: &impl Executor,
    particles: Particles<'_>,
    lists: Lists<'_>,
    pass: &P,
    out: &mut [f32x4],
) -> u32 {
    let mut outs = out;
    let mut jobs = Jobs::new();
    for (cells, slots) in lists.sorted.shares(parts(executor), particles.position.len()) {
        let out = take(&mut outs, slots.len());
        let _ = jobs.push(Job { setup, particles, lists, pass, cells, first_slot: slots.start, out, largest: 0 });
    }
    executor.run(&mut jobs, P::work);
    jobs.iter().map(|job| job.largest).max().unwrap_or(0)
}

/// Work on the usual scenes, and work on all others. Each is a function of its own at each level: unoptimised, the two in one would take
/// more stack than a thread of a host may have.
pub(crate) struct Plain<'j, J>(pub &'j mut J);
pub(crate) struct General<'j, J>(pub &'j mut J);

impl<P: PairPass> Work for Plain<'_, Job<'_, P>> {
    #[inline(always)]
    fn run<R: Real>(self) {
        self.0.run_by::<R>(self.0.setup.model.plain());
    }
}

impl<P: PairPass> Work for General<'_, Job<'_, P>> {
    #[inline(always)]
    fn run<R: Real>(self) {
        self.0.run_by::<R>(*self.0.setup.model);
    }
}

impl<P: PairPass> Job<'_, P> {
    /// All blocks of the job, at its SIMD level.
    #[inline(always)]
    pub(crate) fn run(&mut self) {
        let simd = self.setup.simd;
        if self.setup.model.is_plain() { simd.run(Plain(self)) } else { simd.run(General(self)) }
    }

    /// All blocks by this model, parts of which the compiler may know.
    #[inline(always)]
    fn run_by<R: Real>(&mut self, model: Model) {
        let setup = Setup { model: &model, ..self.setup };
        for cell in self.cells.clone() {
            let members = self.lists.sorted.members(cell);
            for first in members.clone().step_by(R::LANES) {
                let end = (first + R::LANES).min(members.end);
                let own = &mut self.out[first - self.first_slot..end - self.first_slot];
                let (particles, lists) = (&self.particles, &self.lists);
                let block = Block { setup: &setup, particles, lists, cell, first, last: end - 1 };
                let count = self.pass.block::<R>(&block, own);
                self.largest = self.largest.max(count);
            }
        }
    }
}
