//! The neighbours of each particle, itself among them, in the order of its sums. All passes over pairs walk these lists.
use super::candidates::Candidates;
use crate::arithmetic::lanes::Lanes;
use crate::arithmetic::level::Work;
use crate::executor::{Executor, Jobs, parts, shares};
use crate::grid::{Cells, Stencil, cell_of};
use crate::layout::Model;
use crate::passes::context::{Setup, Step};
use crate::passes::lanes::is_wall;
use crate::passes::lists::{CHUNK, Filling, GROUP, MOST_LISTED, groups, share};
use crate::passes::local::{Particles, particles};
use crate::passes::pairs::{General, Plain, cells, present};
use crate::terms::wall::MIRRORED;
use core::ops::Range;

struct Job<'a> {
    setup: Setup<'a>,
    cells: Cells<'a>,
    particles: Particles<'a>,
    present: usize,
    groups: Range<usize>,
    lists: Filling<'a>,
}

/// Fills `neighbours`.
pub(crate) fn run(step: &mut Step<'_, '_, impl Executor>) {
    let (setup, particles, cells) = (step.setup, particles!(step but density), cells!(step));
    let count = particles.position.len();
    let present = present(&setup, cells, count);
    let mut jobs = Jobs::new();
    let shares = shares(groups(count), parts(step.executor));
    for (groups, lists) in share(step.scratch.neighbours, count, shares) {
        let _ = jobs.push(Job { setup, cells, particles, present, groups, lists });
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
    fn run<R: Lanes>(self) {
        self.0.run_by::<R>(self.0.setup.model.plain());
    }
}

impl Work for General<'_, Job<'_>> {
    #[inline(always)]
    fn run<R: Lanes>(self) {
        self.0.run_by::<R>(*self.0.setup.model);
    }
}

/// A group that is being listed.
struct Growing {
    codes: [[u32; MOST_LISTED + CHUNK]; GROUP],
    counts: [usize; GROUP],
    /// The particles' own codes.
    own: [u32; GROUP],
    fits: bool,
}

/// What is known of a cell whose candidates were gathered.
struct Gathered {
    members: Range<usize>,
    /// What the members' codes are larger by than their slots.
    own_shift: u32,
    /// Do the codes refer to other windows than those of the cell before?
    are_windows_new: bool,
}

impl Job<'_> {
    /// All groups by this model, parts of which the compiler may know.
    #[inline(always)]
    fn run_by<R: Lanes>(&mut self, model: Model) {
        let setup = &Setup { model: &model, ..self.setup };
        let (m, p, particles) = (&model, self.setup.parameters, self.particles);
        let mut candidates = Candidates::none();
        let mut group =
            Growing { codes: [[0; MOST_LISTED + CHUNK]; GROUP], counts: [0; GROUP], own: [0; GROUP], fits: true };
        let end = (self.groups.end * GROUP).min(self.present);
        let mut slot = self.groups.start * GROUP;
        while slot < end {
            // the cell of the next particles, and all that may be near them
            let members = match cell_of(p, particles.position[slot]) {
                Ok(cell) => self.gather::<R>(setup, cell as usize, &mut candidates),
                // a step with such a particle ends before
                Err(_) => Gathered { members: slot..slot + 1, own_shift: 0, are_windows_new: false },
            };
            let Gathered { members, own_shift, are_windows_new } = members;
            group.fits &= !are_windows_new || slot % GROUP == 0;
            let listed = candidates.are_complete();
            let support = |slot: usize| if m.variable_support == 1 { particles.support[slot] } else { 1.0 };
            let until = members.end.min(end);
            for a in slot..until {
                let i = a % GROUP;
                // a mirroring wall has no density, and nobody acts on it
                let asleep = m.wall_particles == MIRRORED && is_wall(setup.materials, particles.velocity[a][3]);
                let codes = &mut group.codes[i];
                group.own[i] = (a as u32).wrapping_add(own_shift);
                group.counts[i] = match (listed, asleep) {
                    (false, _) => MOST_LISTED + 1,
                    (true, true) => 0,
                    (true, false) => candidates.near::<R>(setup, particles.position[a], support(a), codes),
                };
                if i + 1 < GROUP && a + 1 < end {
                    continue;
                }
                for rest in i + 1..GROUP {
                    group.counts[rest] = 0;
                    group.own[rest] = group.own[i];
                }
                let number = a / GROUP - self.groups.start;
                self.lists.push(number, group.fits, &mut group.codes, group.counts, group.own);
                group.fits = true;
            }
            slot = until;
        }
    }

    /// Gathers the candidates around a cell: not all of them, where they are too many to be listed.
    #[inline(always)]
    fn gather<R: Lanes>(
        &mut self,
        setup: &Setup<'_>,
        cell: usize,
        candidates: &mut Candidates,
    ) -> Gathered {
        let (particles, members) = (self.particles, self.cells.members(cell));
        let mut gathered = Gathered { members: members.clone(), own_shift: 0, are_windows_new: false };
        let stencil = Stencil::around(setup.parameters, setup.model.layers as i32, self.cells, cell);
        let support = if setup.model.variable_support == 1 { particles.support } else { &[] };
        for attempt in 0..2 {
            candidates.clear();
            let mut room = true;
            for run in stencil.runs() {
                let Some(shift) = self.lists.shift(&run) else {
                    room = false;
                    break;
                };
                if run.contains(&members.start) {
                    gathered.own_shift = shift;
                }
                if !candidates.add::<R>(particles.position, support, run, shift) {
                    return gathered;
                }
            }
            if room {
                candidates.close();
                return gathered;
            }
            if attempt == 0 {
                // the windows are those of cells that lie behind
                self.lists.reset();
                gathered.are_windows_new = true;
            }
        }
        gathered
    }
}
