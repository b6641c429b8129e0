//! The neighbours of each block: up to `LANES` particles of one cell, one a lane, which walk common candidates together. Listed are
//! those that any of them can see; whoever is not would add exact zeros. All passes over pairs walk these lists.
use crate::arithmetic::level::Work;
use crate::arithmetic::real::{Real, less, real, vec3};
use crate::executor::{Executor, Jobs, parts, share_of, take};
use crate::grid::{Cells, Stencil, is_limbo};
use crate::layout::{Model, u32x2};
use crate::passes::context::{Setup, Step};
use crate::passes::lanes::load;
use crate::passes::local::{Particles, particles};
use crate::passes::pairs::{General, NOT_LISTED, Plain, cells};
use crate::terms::pair::{pair_scale, separation, squared_ratio};
use crate::terms::wall::MIRRORED;
use core::ops::Range;

struct Job<'a> {
    setup: Setup<'a>,
    sorted: Cells<'a>,
    particles: Particles<'a>,
    cells: Range<usize>,
    first_slot: usize,
    ranges: &'a mut [u32x2],
    list: &'a mut [u32],
    first_entry: usize,
}

/// Fills `neighbour_ranges` and `neighbours`.
pub(crate) fn run(step: &mut Step<'_, '_, impl Executor>) {
    let (setup, particles, sorted) = (step.setup, particles!(step but density), cells!(step));
    let count = particles.position.len();
    let (mut ranges, mut lists) = (&mut *step.scratch.neighbour_ranges, &mut *step.scratch.neighbours);
    let entries = lists.len();
    let mut jobs = Jobs::new();
    for (cells, slots) in sorted.shares(parts(step.executor), count) {
        // each job's part of the lists, in proportion to its particles
        let [first_entry, last_entry] = [slots.start, slots.end].map(|slot| share_of(entries, slot, count.max(1)));
        let job = Job {
            setup,
            sorted,
            particles,
            cells,
            first_slot: slots.start,
            ranges: take(&mut ranges, slots.len()),
            list: take(&mut lists, last_entry - first_entry),
            first_entry,
        };
        let _ = jobs.push(job);
    }
    step.executor.run(&mut jobs, work);
}

/// Compiled once, in this crate: see [`PairPass::work`](crate::passes::pairs::PairPass::work).
fn work(job: &mut Job<'_>) {
    let simd = job.setup.simd;
    if job.setup.model.is_plain() { simd.run(Plain(job)) } else { simd.run(General(job)) }
}

impl Work for Plain<'_, Job<'_>> {
    #[inline(always)]
    fn run<R: Real>(self) {
        self.0.run_by::<R>(self.0.setup.model.plain());
    }
}

impl Work for General<'_, Job<'_>> {
    #[inline(always)]
    fn run<R: Real>(self) {
        self.0.run_by::<R>(*self.0.setup.model);
    }
}

impl Job<'_> {
    /// All blocks by this model, parts of which the compiler may know.
    #[inline(always)]
    fn run_by<R: Real>(&mut self, model: Model) {
        let setup = Setup { model: &model, ..self.setup };
        let (m, p, particles) = (setup.model, setup.parameters, &self.particles);
        let one = real::<R>(1.0);
        let mut used = 0;
        for cell in self.cells.clone() {
            let members = self.sorted.members(cell);
            if members.is_empty() {
                continue;
            }
            if is_limbo(m, p, cell) {
                self.ranges[members.start - self.first_slot..members.end - self.first_slot].fill([0; 2]);
                continue;
            }
            let stencil = Stencil::around(p, m.layers as i32, self.sorted, cell);
            for first in members.clone().step_by(R::LANES) {
                let last = (first + R::LANES).min(members.end) - 1;
                let begin = used;
                // the box keeps LLVM from carrying the loop below in the shape of this load, at half its speed
                let x_a = core::hint::black_box(load::<R>(particles.position, first, last));
                let support_a = particles.supports::<R>(&setup, first, last);
                // a mirroring wall has no density, and nobody acts on it
                let asleep = m.wall_particles == MIRRORED && particles.are_walls(&setup, first, last);
                if !asleep {
                    for run in stencil.runs() {
                        for b in run {
                            let x_ab = separation(m, p, x_a, vec3::splat(particles.position[b]));
                            let scale = pair_scale(m, support_a, particles.support_of(&setup, b));
                            // written always, kept if any lane sees it: cheaper than a branch that nobody can predict
                            if let Some(entry) = self.list.get_mut(used) {
                                *entry = b as u32;
                            }
                            used += usize::from(R::any(less(squared_ratio(m, p, x_ab, scale), one)));
                        }
                    }
                }
                let listed = used <= self.list.len();
                let length = if listed { (used - begin) as u32 } else { NOT_LISTED };
                self.ranges[first - self.first_slot] = [(self.first_entry + begin) as u32, length];
                if !listed {
                    used = begin;
                }
            }
        }
    }
}
