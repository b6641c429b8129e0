//! The half stencil (Gourlay): each pair is computed once, and its contribution is added to both particles.
//!
//! The grid is cut into planes of cells. A plane is paired with the next plane, so its job writes to both. Planes that
//! do not write to the same particles are processed in parallel: first the even ones, then the odd ones. The last
//! plane, whose next plane is the first one, follows at the end, alone. The order in which the sum of a particle is
//! added up depends on this scheme and on the grid, but never on the number of threads. The disadvantage is that work
//! is divided by planes, however many particles each plane holds.
//!
//! The cells "ahead" of a cell are the half of its surrounding cells that it is paired with ([`ahead`]).

pub(crate) mod density;
pub(crate) mod force;

use super::by_model::PairJob;
use super::candidates::Candidates;
use super::context::Setup;
use super::lists::ROOM;
use super::local::Particles;
use crate::arithmetic::codes::MOST_LANES;
use crate::arithmetic::lanes::{Lanes, Slots};
use crate::arithmetic::real::vec3;
use crate::executor::{AnyExecutor, Jobs, parts, shares, take};
use crate::grid::Cells;
use crate::grid::half::{Planes, ahead};
use crate::layout::f32x4;
use crate::memory::MOST_LISTED;
use crate::terms::pair::{Local, separation, squared_ratio};
use core::array;
use core::ops::Range;

/// A sum over pairs, which contribute to both of their particles.
pub(crate) trait PairSum: Sync + Sized {
    /// Runs a job: see [`PairPass::work`](super::pairs::PairPass::work).
    fn work(job: &mut Job<'_, Self>);

    /// Returns the contributions of the pairs of particle `a`: first those to `a`, then those to the other particles.
    /// `q2` holds the squared distances over the squared support radius.
    fn of_pairs<R: Lanes>(&self, setup: &Setup<'_>, a: Local<R>, others: Others<'_>, q2: R) -> [[R; 4]; 2];
}

/// The other particles of some pairs of one particle.
#[derive(Clone, Copy)]
pub(crate) struct Others<'a> {
    particles: &'a Particles<'a>,
    slots: &'a Slots,
}

impl Others<'_> {
    /// Returns the data of the particles that the pair terms use.
    #[inline(always)]
    pub(crate) fn known<R: Lanes>(self, setup: &Setup<'_>) -> Local<R> {
        self.particles.neighbours(setup, self.slots)
    }
}

/// A job: every second plane from `first` on, one after the other, and the sums of all particles that they write to.
pub(crate) struct Job<'a, S> {
    setup: Setup<'a>,
    particles: Particles<'a>,
    cells: Cells<'a>,
    sum: &'a S,
    planes: Planes,
    /// The first plane, and the number of planes.
    first: usize,
    count: usize,
    /// The first slot and the sums of the particles in these planes and in the planes that follow each of them.
    own: (usize, &'a mut [f32x4]),
    /// The first slot and the sums of other particles: those of the first plane in the job of the last plane, else
    /// none.
    others: (usize, &'a mut [f32x4]),
}

/// Adds the contributions of all pairs to the sums. The pair of a particle with itself is not included.
pub(crate) fn run<S: PairSum>(
    setup: Setup<'_>,
    executor: &dyn AnyExecutor,
    particles: Particles<'_>,
    cells: Cells<'_>,
    sum: &S,
    sums: &mut [f32x4],
) {
    let planes = Planes::of(setup.parameters, setup.model.is_3d);
    for parity in 0..2 {
        // planes of this parity, without the last plane of the grid
        let count = (planes.count - parity) / 2;
        let mut jobs = Jobs::new();
        let (mut rest, mut passed) = (&mut *sums, 0);
        for share in shares(count, parts(executor).min(count)) {
            let first = parity + 2 * share.start;
            let slots = planes.slots(cells, first..first + 2 * share.len());
            take(&mut rest, slots.start - passed);
            let own = (slots.start, take(&mut rest, slots.len()));
            passed = slots.end;
            let others: (usize, &mut [f32x4]) = (0, &mut []);
            let _ = jobs.push(Job { setup, particles, cells, sum, planes, first, count: share.len(), own, others });
        }
        executor.run(&mut jobs, S::work);
    }
    let last = planes.count - 1;
    let (first, own) = (planes.slots(cells, 0..1), planes.slots(cells, last..planes.count));
    let (before, behind) = sums.split_at_mut(own.start);
    let others = (first.start, &mut before[first]);
    S::work(&mut Job {
        setup,
        particles,
        cells,
        sum,
        planes,
        first: last,
        count: 1,
        own: (own.start, &mut behind[..own.len()]),
        others,
    });
}

impl<S: PairSum> Job<'_, S> {
    /// Returns the sum of the particle in a slot.
    #[inline(always)]
    fn of(&mut self, slot: usize) -> &mut f32x4 {
        let (first, own) = &mut self.own;
        if slot.wrapping_sub(*first) < own.len() {
            return &mut own[slot - *first];
        }
        let (first, others) = &mut self.others;
        &mut others[slot - *first]
    }
}

impl<'a, S: PairSum> PairJob<'a> for Job<'a, S> {
    fn setup(&self) -> Setup<'a> {
        self.setup
    }

    #[inline(always)]
    fn run_by<R: Lanes>(&mut self, setup: &Setup<'_>) {
        let (cells, planes) = (self.cells, self.planes);
        let mut near = Near { candidates: Candidates::none(), codes: [0; ROOM], q2: [0.0; ROOM] };
        for plane in (self.first..).step_by(2).take(self.count) {
            for cell in plane * planes.cells..(plane + 1) * planes.cells {
                let members = cells.members(cell);
                if members.is_empty() {
                    continue;
                }
                self.gather::<R>(setup, cell, &mut near.candidates);
                for a in members.clone() {
                    self.with_those_ahead::<R>(setup, a, cell, members.clone(), &mut near);
                }
            }
        }
    }
}

/// The candidates of a cell, and the neighbours of one of its particles.
struct Near {
    candidates: Candidates,
    codes: [u32; ROOM],
    q2: [f32; ROOM],
}

impl<S: PairSum> Job<'_, S> {
    /// Gathers the particles of a cell and of the cells ahead. They stay incomplete if there are too many.
    #[inline(always)]
    fn gather<R: Lanes>(&self, setup: &Setup<'_>, cell: usize, candidates: &mut Candidates) {
        candidates.clear();
        for run in runs(setup, self.cells, cell, self.cells.members(cell)) {
            if !candidates.add::<R>(self.particles.position, &[], run, 0) {
                return;
            }
        }
        candidates.close();
    }

    /// Adds the pairs of a particle with the later particles of its own cell, and with those of the cells ahead.
    #[inline(always)]
    fn with_those_ahead<R: Lanes>(
        &mut self,
        setup: &Setup<'_>,
        a: usize,
        cell: usize,
        members: Range<usize>,
        near: &mut Near,
    ) {
        let (m, p, particles) = (setup.model, setup.parameters, self.particles);
        let own = particles.receivers::<R>(setup, a, a);
        let mut sum = *self.of(a);
        let mut count = ROOM;
        if near.candidates.are_complete() {
            let buffers = (&mut near.codes, &mut near.q2);
            count = near.candidates.near::<R>(setup, a + 1 - members.start, particles.position[a], 1.0, buffers);
        }
        if count <= MOST_LISTED {
            for first in (0..count).step_by(R::LANES) {
                let pairs = (count - first).min(R::LANES);
                // the buffers have room for all lanes after the last neighbour
                let others = array::from_fn(|lane| near.codes[first + lane]);
                let q2 = array::from_fn(|lane| near.q2[first + lane]);
                self.add::<R>(setup, own, &mut sum, pairs, &others, &q2);
            }
        } else {
            let x_a = vec3::<f32>::splat(particles.position[a]);
            for b in runs(setup, self.cells, cell, a + 1..members.end).flatten() {
                let x_ab = separation(m, p, x_a, vec3::splat(particles.position[b]));
                let q2 = squared_ratio(m, p, x_ab, 1.0);
                if q2 < 1.0 {
                    self.add::<R>(setup, own, &mut sum, 1, &[b as u32; MOST_LANES], &[q2; MOST_LANES]);
                }
            }
        }
        *self.of(a) = sum;
    }

    /// Adds the contributions of the pairs of a particle with the first `pairs` of these others, to the sum of the
    /// particle and to those of the others.
    #[inline(always)]
    fn add<R: Lanes>(
        &mut self,
        setup: &Setup<'_>,
        own: Local<R>,
        sum: &mut f32x4,
        pairs: usize,
        others: &[u32; MOST_LANES],
        q2: &[f32; MOST_LANES],
    ) {
        let particles = self.particles;
        let mut slots = Slots::first(particles.position.len());
        slots.set(others);
        let added = self.sum.of_pairs(setup, own, Others { particles: &particles, slots: &slots }, R::read(q2));
        let mut rows = [[[0.0; 4]; MOST_LANES]; 2];
        for (rows, added) in rows.iter_mut().zip(added) {
            R::store(added, &mut rows[..R::LANES]);
        }
        let [to_a, to_b] = &rows;
        for ((&b, to_a), to_b) in others.iter().zip(to_a).zip(to_b).take(pairs) {
            let sum_b = self.of(b as usize);
            for i in 0..4 {
                sum[i] += to_a[i];
                sum_b[i] += to_b[i];
            }
        }
    }
}

/// Returns runs of slots: `own`, which is a part of the cell, and those of the cells ahead.
#[inline(always)]
fn runs(setup: &Setup<'_>, cells: Cells<'_>, cell: usize, own: Range<usize>) -> impl Iterator<Item = Range<usize>> {
    core::iter::once(own).chain(ahead(setup.parameters, setup.model.is_3d, cells, cell))
}
