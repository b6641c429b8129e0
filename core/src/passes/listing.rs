//! The neighbour search, which fills the lists. A job walks the cells of its particles. For each cell it gathers the
//! candidates once: the particles of that cell and of the cells around it. Then it computes the distance of each
//! particle of the cell to all candidates, and keeps those within the support radius. When four consecutive particles,
//! a group, are done, their neighbours are stored in the lists (`lists.rs`).
//!
//! A neighbour is stored as a 16-bit code: the number of a window of consecutive slots, and a place in that window. All
//! codes of a group refer to the same set of windows. A group is not listed if one of its particles has too many
//! neighbours or candidates, if its codes would need two sets of windows, or if the memory of the lists is full. Such a
//! group searches its cells in every pass.
use super::by_model::PairJob;
use super::candidates::Candidates;
use super::context::Setup;
use super::group::{Group, Surroundings};
use super::lanes::is_wall;
use super::lists::{Filling, GROUP, Lists, ROOM, groups, share};
use super::local::Particles;
use super::pairs::present;
use crate::arithmetic::lanes::Lanes;
use crate::executor::{AnyExecutor, Jobs, parts, shares, take};
use crate::grid::{Cells, Stencil, cell_of};
use crate::layout::f32x4;
use crate::memory::MOST_LISTED;
use crate::terms::wall::MIRRORED;
use core::ops::Range;

/// Work that a pass does on the neighbours of each group while their distances are known. The density pass computes
/// densities in this way.
pub(crate) trait Visit: Sync + Sized {
    /// Runs a job: see [`PairPass::work`](super::pairs::PairPass::work).
    fn work(job: &mut Job<'_, Self>);

    /// Fills the entries `own` of the particles of `group`; `near` holds all their neighbours.
    fn visit<R: Lanes>(&self, group: &Group<'_>, near: &Near, own: &mut [f32x4]);

    /// Fills the entries of a group with too many neighbours to store; it has to search its cells.
    fn search<R: Lanes>(&self, group: &Group<'_>, own: &mut [f32x4]);

    /// Fills the entries of inactive particles.
    fn absent(&self, setup: &Setup<'_>, own: &mut [f32x4]);
}

/// The neighbours of a group while they are being found.
pub(crate) struct Near {
    codes: [[u32; ROOM]; GROUP],
    /// Squared distances of the pairs over their squared support radius.
    pub q2: [[f32; ROOM]; GROUP],
    /// Number of neighbours of each particle.
    pub counts: [usize; GROUP],
    /// The codes of the particles themselves.
    own: [u32; GROUP],
    /// Whether all codes of the group refer to the same windows.
    fits: bool,
}

/// A job: a range of groups.
pub(crate) struct Job<'a, V> {
    surroundings: Surroundings<'a>,
    present: usize,
    groups: Range<usize>,
    lists: Filling<'a>,
    visitor: &'a V,
    /// The entries that the visitor fills: one per particle, or none at all.
    out: &'a mut [f32x4],
}

/// Lists the neighbours of all particles, and passes those of each group to the visitor.
pub(crate) fn run<V: Visit>(
    setup: Setup<'_>,
    executor: &dyn AnyExecutor,
    particles: Particles<'_>,
    cells: Cells<'_>,
    neighbours: &mut [u32],
    visitor: &V,
    out: &mut [f32x4],
) {
    let count = particles.position.len();
    let present = present(&setup, cells, count);
    let surroundings = Surroundings { setup, particles, cells };
    let mut outs = out;
    let mut jobs = Jobs::new();
    let shares = shares(groups(count), parts(executor));
    for (groups, lists) in share(neighbours, count, shares) {
        let slots = groups.start * GROUP..(groups.end * GROUP).min(count);
        let out = if outs.is_empty() { &mut [] } else { take(&mut outs, slots.len()) };
        let _ = jobs.push(Job { surroundings, present, groups, lists, visitor, out });
    }
    executor.run(&mut jobs, V::work);
}

/// Data of a cell whose candidates were gathered.
struct Gathered {
    members: Range<usize>,
    /// Wrapping difference between code and slot for the particles of the cell.
    own_shift: u32,
    /// Whether the codes refer to other windows than those of the previous cell.
    are_windows_new: bool,
}

impl<'a, V: Visit> PairJob<'a> for Job<'a, V> {
    fn setup(&self) -> Setup<'a> {
        self.surroundings.setup
    }

    #[inline(always)]
    fn run_by<R: Lanes>(&mut self, setup: &Setup<'_>) {
        let (m, p, particles) = (setup.model, setup.parameters, self.surroundings.particles);
        let mut candidates = Candidates::none();
        let mut near = Near {
            codes: [[0; ROOM]; GROUP],
            q2: [[0.0; ROOM]; GROUP],
            counts: [0; GROUP],
            own: [0; GROUP],
            fits: true,
        };
        let first = self.groups.start * GROUP;
        let end = (self.groups.end * GROUP).min(self.present).max(first);
        let mut slot = first;
        while slot < end {
            // find the cell of the next particles, and all their candidates
            let cell = cell_of(p, particles.position[slot]);
            let Gathered { members, own_shift, are_windows_new } = if let Ok(cell) = cell {
                self.gather::<R>(setup, cell as usize, &mut candidates)
            } else {
                // the position is outside the range of the grid: such a step has failed in an earlier pass
                candidates.clear();
                Gathered { members: slot..slot + 1, own_shift: 0, are_windows_new: false }
            };
            near.fits &= !are_windows_new || slot.is_multiple_of(GROUP);
            let until = members.end.min(end);
            for a in slot..until {
                let i = a % GROUP;
                near.own[i] = (a as u32).wrapping_add(own_shift);
                // mirroring wall particles have no density and no acceleration, so they need no neighbours
                let asleep = m.wall_particles == MIRRORED && is_wall(setup.materials, particles.velocity[a][3]);
                near.counts[i] = if !candidates.are_complete() {
                    // the particle's own code is not known either
                    ROOM
                } else if asleep {
                    0
                } else {
                    let support = if m.has_variable_support == 1 { particles.support[a] } else { 1.0 };
                    candidates.near::<R>(
                        setup,
                        0,
                        particles.position[a],
                        support,
                        (&mut near.codes[i], &mut near.q2[i]),
                    )
                };
                if i + 1 == GROUP || a + 1 == end {
                    self.close::<R>(setup, &mut near, a, first);
                }
            }
            slot = until;
        }
        if let Some(absent) = self.out.get_mut(end - first..) {
            self.visitor.absent(setup, absent);
        }
    }
}

impl<V: Visit> Job<'_, V> {
    /// Stores the lists of the group that ends at slot `last`, and calls the visitor for it.
    #[inline(always)]
    fn close<R: Lanes>(&mut self, setup: &Setup<'_>, near: &mut Near, last: usize, first_of_job: usize) {
        let first = last - last % GROUP;
        let own = near.own[last - first];
        for rest in last + 1 - first..GROUP {
            near.counts[rest] = 0;
            near.own[rest] = own;
        }
        let known = near.counts.iter().all(|&count| count <= MOST_LISTED);
        self.lists.push(first / GROUP - self.groups.start, known && near.fits, &mut near.codes, near.counts, near.own);
        near.fits = true;
        if self.out.is_empty() {
            return;
        }
        for first in (first..=last).step_by(R::RECEIVERS) {
            let last = last.min(first + R::RECEIVERS - 1);
            let (particles, surroundings) = (self.surroundings.particles, &self.surroundings);
            let group = Group { setup, particles, lists: Lists::NONE, surroundings, first, last };
            let own = &mut self.out[first - first_of_job..=last - first_of_job];
            if known {
                self.visitor.visit::<R>(&group, near, own);
            } else {
                self.visitor.search::<R>(&group, own);
            }
        }
    }

    /// Gathers the candidates of a cell. They stay incomplete if there are too many to be listed.
    #[inline(always)]
    fn gather<R: Lanes>(&mut self, setup: &Setup<'_>, cell: usize, candidates: &mut Candidates) -> Gathered {
        let Surroundings { particles, cells, .. } = self.surroundings;
        let members = cells.members(cell);
        let mut gathered = Gathered { members: members.clone(), own_shift: 0, are_windows_new: false };
        let stencil = Stencil::around(setup.parameters, setup.model.is_3d as i32, cells, cell);
        let support = if setup.model.has_variable_support == 1 { particles.support } else { &[] };
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
                // the windows in use belong to cells that are done: start with new ones
                self.lists.reset();
                gathered.are_windows_new = true;
            }
        }
        gathered
    }
}

impl Near {
    /// Returns the squared distances to the neighbours from number `k` on. `first` is the first receiver, as an index
    /// into the group.
    #[inline(always)]
    pub(crate) fn q2_of<R: Lanes>(&self, first: usize, k: usize) -> R {
        R::numbers(|receiver| &self.q2[(first + receiver) % GROUP][k..])
    }
}
