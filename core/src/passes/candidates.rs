//! The candidates of a cell: all particles in the cell and in the cells around it, among which its neighbours are. Each
//! coordinate has its own array, so that lanes can test several candidates at once.
use crate::arithmetic::codes::MOST_LANES;
use crate::arithmetic::lanes::Lanes;
use crate::arithmetic::real::{less, real, vec3};
use crate::layout::f32x4;
use crate::passes::context::Setup;
use crate::passes::lists::ROOM;
use crate::terms::pair::{pair_scale, separation, squared_ratio};
use core::ops::Range;

/// Largest number of candidates of a cell. Particles of a cell with more are not listed.
const MOST: usize = 1024;

/// Spare entries after the last candidate, for lanes that are not all in use.
const SPARE: usize = MOST_LANES;

/// The x coordinate of unused entries. No position there is within a support radius.
const FAR: f32 = f32::INFINITY;

/// The candidates of a cell, in the order in which sums are added up.
#[repr(align(64))]
pub(crate) struct Candidates {
    x: [f32; MOST + SPARE],
    y: [f32; MOST + SPARE],
    z: [f32; MOST + SPARE],
    support: [f32; MOST + SPARE],
    code: [u32; MOST + SPARE],
    count: usize,
    is_complete: bool,
}

impl Candidates {
    /// Returns an empty set.
    pub(crate) fn none() -> Candidates {
        let empty = [0.0; MOST + SPARE];
        Candidates {
            x: empty,
            y: empty,
            z: empty,
            support: empty,
            code: [0; MOST + SPARE],
            count: 0,
            is_complete: false,
        }
    }

    /// Removes all candidates.
    pub(crate) fn clear(&mut self) {
        self.count = 0;
        self.is_complete = false;
    }

    /// Returns whether all candidates of the cell are in the set.
    pub(crate) fn are_complete(&self) -> bool {
        self.is_complete
    }

    /// Adds a run of slots. `shift` is the wrapping difference between code and slot. Returns false if there is no
    /// room.
    #[inline(always)]
    pub(crate) fn add<R: Lanes>(&mut self, position: &[f32x4], support: &[f32], run: Range<usize>, shift: u32) -> bool {
        let (first, count) = (self.count, run.len());
        if count > MOST - first {
            return false;
        }
        for offset in (0..count).step_by(R::LANES) {
            let (from, to) = (run.start + offset, first + offset);
            // entries beyond the run are overwritten by the next run
            let [x, y, z, _] = match position.get(from..from + R::LANES) {
                Some(rows) => R::load(|lane| &rows[lane]),
                None => R::load(|lane| &position[(from + lane).min(position.len() - 1)]),
            };
            x.write(&mut self.x[to..]);
            y.write(&mut self.y[to..]);
            z.write(&mut self.z[to..]);
        }
        for (code, slot) in self.code[first..first + count].iter_mut().zip(run.start as u32..) {
            *code = slot.wrapping_add(shift);
        }
        if !support.is_empty() {
            self.support[first..first + count].copy_from_slice(&support[run]);
        }
        self.count += count;
        true
    }

    /// Completes the set after its last run.
    pub(crate) fn close(&mut self) {
        self.is_complete = true;
        self.x[self.count..self.count + SPARE].fill(FAR);
    }

    /// Writes the codes and the values of `q^2` of all neighbours of a particle at `x`, taken from the candidates from
    /// `first` on. Returns the number of neighbours, or [`ROOM`] if they do not fit.
    #[inline(always)]
    pub(crate) fn near<R: Lanes>(
        &self,
        setup: &Setup<'_>,
        first: usize,
        x: f32x4,
        support: f32,
        (codes, q2s): (&mut [u32; ROOM], &mut [f32; ROOM]),
    ) -> usize {
        let (m, p) = (setup.model, setup.parameters);
        let x_a = vec3::<R>::splat(x);
        let lanes = R::LANES;
        let [xs, ys, zs] = [&self.x, &self.y, &self.z].map(|x| x[first..].chunks_exact(lanes));
        let places = xs.zip(ys).zip(zs);
        let all = places.zip(self.support[first..].chunks_exact(lanes)).zip(self.code[first..].chunks_exact(lanes));
        let mut used = 0;
        for ((((x, y), z), support_b), code) in all.take((self.count - first).div_ceil(lanes)) {
            if used > ROOM - R::LANES {
                return ROOM;
            }
            let x_b = vec3(R::read(x), R::read(y), R::read(z));
            let support_b = if m.has_variable_support == 1 { R::read(support_b) } else { real(1.0) };
            let scale = pair_scale(m, real(support), support_b);
            let q2 = squared_ratio(m, p, separation(m, p, x_a, x_b), scale);
            used = R::append((codes, q2s), used, code, q2, less(q2, real(1.0)));
        }
        used
    }
}
