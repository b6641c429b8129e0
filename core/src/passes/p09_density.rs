//! Density of each particle from its neighbours, and the pressures that follow.
//!
//! A block is up to `LANES` particles of one cell, one a lane, which walk the common candidates together: first to list
//! those that any of them can see, then to sum over that list, which the later passes use too. Who is not listed would
//! add exact zeros.
use super::local::Particles;
use super::pairs::NOT_LISTED;
use super::{Setup, kind, load, load_one, row_of};
use crate::arithmetic::level::Work;
use crate::arithmetic::real::{Real, less, real, select, vec3};
use crate::executor::{Executor, Jobs, parts, share_of, take};
use crate::grid::{Cells, Stencil, is_limbo};
use crate::layout::{Model, f32x4};
use crate::terms::correction::pressure_carried;
use crate::terms::density::{
    continuity_neighbour, deviation_of_sum, deviation_rate, deviation_stepped, is_stepped, number_density_neighbour,
    summed_neighbour, volume_by_number, volume_close,
};
use crate::terms::kernel::if_inside;
use crate::terms::near::{ARTICLE, near_density_neighbour, near_pressure_close};
use crate::terms::pair::{pair_scale, separation, squared_ratio};
use crate::terms::state::{pressure_close, pressure_of_state};
use crate::terms::wall::{MIRRORED, mass_seen};
use core::ops::Range;

struct Job<'a> {
    setup: Setup<'a>,
    sorted: Cells<'a>,
    particles: Particles<'a>,
    cells: Range<usize>,
    first_slot: usize,
    out: &'a mut [f32x4],
    block: &'a mut [[u32; 2]],
    list: &'a mut [u32],
    first_entry: usize,
}

/// Fills `out` (deviation, pressure, near pressure, volume), `block` and `list`.
pub(crate) fn run(
    setup: Setup<'_>,
    executor: &impl Executor,
    sorted: Cells<'_>,
    particles: Particles<'_>,
    out: &mut [f32x4],
    block: &mut [[u32; 2]],
    list: &mut [u32],
) {
    let count = particles.position.len();
    let entries = list.len();
    let (mut outs, mut blocks, mut lists) = (out, block, list);
    let mut jobs = Jobs::new();
    for (cells, slots) in sorted.shares(parts(executor), count) {
        // each job's part of the lists, in proportion to its particles
        let [first_entry, last_entry] = [slots.start, slots.end].map(|slot| share_of(entries, slot, count.max(1)));
        let job = Job {
            setup,
            sorted,
            particles,
            cells,
            first_slot: slots.start,
            out: take(&mut outs, slots.len()),
            block: take(&mut blocks, slots.len()),
            list: take(&mut lists, last_entry - first_entry),
            first_entry,
        };
        let _ = jobs.push(job);
    }
    executor.run(&mut jobs, work);
}

/// The particles of a block, and what tells them who is near.
struct Near<'a, R> {
    setup: &'a Setup<'a>,
    particles: &'a Particles<'a>,
    x_a: vec3<R>,
    v_a: vec3<R>,
    support_a: R,
    rest_a: R,
}

impl<R: Real> Near<'_, R> {
    #[inline(always)]
    fn scale(&self, b: usize) -> R {
        let m = self.setup.model;
        let support_b = if m.variable_support == 1 { self.particles.previous[b][2] } else { 1.0 };
        pair_scale(m, self.support_a, real(support_b))
    }

    #[inline(always)]
    fn q2(&self, b: usize, scale: R) -> R {
        let (m, p) = (self.setup.model, self.setup.parameters);
        let x_ab = separation(m, p, self.x_a, vec3::splat(self.particles.position[b]));
        squared_ratio(m, p, x_ab, scale)
    }

    /// Mass of `b`, over that of a particle of the first fluid.
    #[inline(always)]
    fn mass(&self, b: usize) -> R {
        let (m, p) = (self.setup.model, self.setup.parameters);
        let mass = real(self.particles.position[b][3]);
        if m.fluids == 0 {
            return mass;
        }
        let [_, wall, rest, _] = p.species[kind(self.particles.velocity[b][3])].map(real);
        mass_seen(m, self.rest_a, mass, rest, wall)
    }

    /// What `b` adds to the three sums: of density or its rate, of the near density, of the number density.
    #[inline(always)]
    fn add(&self, [sum, mut near, mut number]: [R; 3], b: usize) -> [R; 3] {
        let (m, p, t) = (self.setup.model, self.setup.parameters, self.setup.tables);
        let x_b = self.particles.position[b];
        let (mass_b, scale) = (self.mass(b), self.scale(b));
        let q2 = self.q2(b, scale);
        let added = if is_stepped(m) {
            // where the pair was in the middle of the step
            let v_ab = self.v_a - vec3::splat(self.particles.velocity[b]);
            let x_ab = separation(m, p, self.x_a, vec3::splat(x_b)) - v_ab * real(p.half_time_step);
            if_inside(q2, continuity_neighbour(m, p, t, x_ab, v_ab, mass_b, scale))
        } else {
            summed_neighbour(m, t, mass_b, q2, scale)
        };
        if m.near_pressure == ARTICLE {
            near = near + near_density_neighbour(m, mass_b, q2, scale);
        }
        if m.numbers == 1 {
            number = number + number_density_neighbour(m, t, q2, scale);
        }
        [sum + added, near, number]
    }
}

/// Compiled once, in this crate: see [`PairPass::work`](super::pairs::PairPass::work).
fn work(job: &mut Job<'_>) {
    let simd = job.setup.simd;
    simd.run(job);
}

impl Work for &mut Job<'_> {
    #[inline(always)]
    fn run<R: Real>(self) {
        if self.setup.model.is_plain() {
            self.run_by::<R>(self.setup.model.plain());
        } else {
            self.run_by::<R>(*self.setup.model);
        }
    }
}

impl Job<'_> {
    /// All blocks by this model, parts of which the compiler may know.
    #[inline(always)]
    fn run_by<R: Real>(&mut self, model: Model) {
        let setup = Setup { model: &model, ..self.setup };
        let (m, p) = (setup.model, setup.parameters);
        let one = real::<R>(1.0);
        let none = real::<R>(0.0);
        let particles = &self.particles;
        let mut used = 0;
        for cell in self.cells.clone() {
            let members = self.sorted.members(cell);
            if members.is_empty() {
                continue;
            }
            if is_limbo(m, p, cell) {
                let slots = members.start - self.first_slot..members.end - self.first_slot;
                self.out[slots.clone()].fill([0.0, 0.0, 0.0, p.rest_volume]);
                self.block[slots].fill([0; 2]);
                continue;
            }
            let stencil = Stencil::around(p, m.layers as i32, self.sorted, cell);
            for first in members.clone().step_by(R::LANES) {
                let end = (first + R::LANES).min(members.end);
                let own = first - self.first_slot;
                let begin = used;
                // the box keeps LLVM from carrying the loops below in the shape of this load, at half their speed
                let near = Near::<R> {
                    setup: &setup,
                    particles,
                    x_a: core::hint::black_box(load::<R>(particles.position, first, end - 1)),
                    v_a: load::<R>(particles.velocity, first, end - 1),
                    support_a: if m.variable_support == 1 {
                        load_one(particles.previous, first, end - 1, 2)
                    } else {
                        one
                    },
                    rest_a: row_of(m, &p.species, particles.velocity, first, end - 1, 2),
                };
                // a mirroring wall has no density, and nobody acts on it
                let asleep = m.wall_particles == MIRRORED && particles.are_walls(&setup, first, end - 1);
                if !asleep {
                    for run in stencil.runs() {
                        for b in run {
                            // written always, kept if any lane sees it: cheaper than a branch that nobody can predict
                            if let Some(entry) = self.list.get_mut(used) {
                                *entry = b as u32;
                            }
                            used += usize::from(R::any(less(near.q2(b, near.scale(b)), one)));
                        }
                    }
                }
                let listed = used <= self.list.len();
                let mut sums = [none; 3];
                let own_list = Stencil::one(begin as u32, used as u32);
                let walk = if listed { &own_list } else { &stencil };
                for run in walk.runs().take(if asleep { 0 } else { usize::MAX }) {
                    for entry in run {
                        let b = if listed { self.list[entry] as usize } else { entry };
                        sums = near.add(sums, b);
                    }
                }
                let [sum, near_sum, number_sum] = sums;
                let previous = |i| load_one::<R>(particles.previous, first, end - 1, i);
                let mass = load_one::<R>(particles.position, first, end - 1, 3);
                let stiffness = particles.stiffness::<R>(&setup, first, end - 1);
                let mut deviation = if is_stepped(m) {
                    deviation_stepped(p, previous(0), deviation_rate(m, p, sum, mass, near.rest_a))
                } else {
                    deviation_of_sum(m, p, sum, mass, near.rest_a)
                };
                let mut pressure = if m.corrects_pressure() {
                    pressure_carried(m, previous(1))
                } else {
                    let equation = row_of(m, &p.states, particles.velocity, first, end - 1, 3);
                    pressure_of_state(m, deviation, stiffness.state, equation)
                };
                pressure = pressure_close(m, pressure);
                let mut near_pressure = near_pressure_close(m, deviation, near_sum, stiffness.near);
                if m.wall_particles == MIRRORED {
                    let wall = less(none, row_of(m, &p.species, particles.velocity, first, end - 1, 1));
                    deviation = select(deviation, none, wall);
                    pressure = select(pressure, none, wall);
                    near_pressure = select(near_pressure, none, wall);
                }
                let mut volume = volume_close(p, mass, deviation);
                if m.numbers == 1 {
                    let wall = row_of(m, &p.species, particles.velocity, first, end - 1, 1);
                    volume = volume_by_number(m, p, volume, number_sum, wall);
                }
                for (lane, out) in self.out[own..end - self.first_slot].iter_mut().enumerate() {
                    let of = |x: R| x.lane(lane);
                    *out = [of(deviation), of(pressure), of(near_pressure), of(volume)];
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
