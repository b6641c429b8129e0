//! Density of each particle from its neighbours, and the pressures that follow.
//!
//! A block is up to `LANES` particles of one cell, one a lane, which walk the common candidates together: first to list
//! those that any of them can see, then to sum over that list, which the force pass uses too. Who is not listed would
//! add exact zeros.
use super::{Setup, load};
use crate::arithmetic::level::Work;
use crate::arithmetic::real::{Real, less, real, vec3};
use crate::executor::{Executor, Jobs, parts, share_of, take};
use crate::grid::{Cells, Stencil};
use crate::layout::f32x4;
use crate::terms::density::{density_close, density_neighbour, volume_close};
use crate::terms::geometry::length2;
use crate::terms::state::{near_pressure_close, pressure_close};
use core::ops::Range;

/// Length of a neighbour list that did not fit: the block walks its stencil again.
pub(super) const NOT_LISTED: u32 = u32::MAX;

struct Job<'a> {
    setup: Setup<'a>,
    sorted: Cells<'a>,
    position: &'a [f32x4],
    cells: Range<usize>,
    first_slot: usize,
    out: &'a mut [f32x4],
    block: &'a mut [[u32; 2]],
    list: &'a mut [u32],
    first_entry: usize,
}

/// Fills `out` (density, pressure, near pressure, volume), `block` and `list`.
pub(crate) fn run(
    setup: Setup<'_>,
    executor: &impl Executor,
    sorted: Cells<'_>,
    position: &[f32x4],
    out: &mut [f32x4],
    block: &mut [[u32; 2]],
    list: &mut [u32],
) {
    let particles = position.len();
    let entries = list.len();
    let (mut outs, mut blocks, mut lists) = (out, block, list);
    let mut jobs = Jobs::new();
    for (cells, slots) in sorted.shares(parts(executor), particles) {
        // each job's part of the lists, in proportion to its particles
        let [first_entry, last_entry] = [slots.start, slots.end].map(|slot| share_of(entries, slot, particles.max(1)));
        let job = Job {
            setup,
            sorted,
            position,
            cells,
            first_slot: slots.start,
            out: take(&mut outs, slots.len()),
            block: take(&mut blocks, slots.len()),
            list: take(&mut lists, last_entry - first_entry),
            first_entry,
        };
        let _ = jobs.push(job);
    }
    executor.run(&mut jobs, |job| setup.simd.run(job));
}

impl Work for &mut Job<'_> {
    #[inline(always)]
    fn run<R: Real>(self) {
        let (m, p) = (self.setup.model, self.setup.parameters);
        let one = real::<R>(1.0);
        let mut used = 0;
        for cell in self.cells.clone() {
            let members = self.sorted.members(cell);
            if members.is_empty() {
                continue;
            }
            let stencil = Stencil::around(p, m.layers as i32, self.sorted, cell);
            for first in members.clone().step_by(R::LANES) {
                let end = (first + R::LANES).min(members.end);
                // the box keeps LLVM from carrying the loops below in the shape of this load, at half their speed
                let x_a = core::hint::black_box(load::<R>(self.position, first, end - 1));
                let q2_of = |x_b: &f32x4| length2(x_a - vec3::splat(*x_b)) * p.inverse_support_squared;
                let begin = used;
                for run in stencil.runs() {
                    for (b, x_b) in run.clone().zip(&self.position[run]) {
                        // written always, kept if any lane sees it: cheaper than a branch that nobody can predict
                        if let Some(entry) = self.list.get_mut(used) {
                            *entry = b as u32;
                        }
                        used += usize::from(R::any(less(q2_of(x_b), one)));
                    }
                }
                let listed = used <= self.list.len();
                let mut sum = real::<R>(0.0);
                if listed {
                    for &b in &self.list[begin..used] {
                        sum = sum + density_neighbour(m, q2_of(&self.position[b as usize]));
                    }
                } else {
                    for x_b in stencil.runs().flat_map(|run| &self.position[run]) {
                        sum = sum + density_neighbour(m, q2_of(x_b));
                    }
                }
                let density = density_close(p, sum);
                let pressure = pressure_close(m, p, density);
                let near_pressure = near_pressure_close(m, p, density);
                let volume = volume_close(p, density);
                let own = first - self.first_slot;
                for (lane, out) in self.out[own..end - self.first_slot].iter_mut().enumerate() {
                    let of = |x: R| x.lane(lane);
                    *out = [of(density), of(pressure), of(near_pressure), of(volume)];
                }
                let length = if listed { (used - begin) as u32 } else { NOT_LISTED };
                self.block[own] = [(self.first_entry + begin) as u32, length];
                if !listed {
                    used = begin;
                }
            }
        }
    }
}
