//! Which particles are close to which, for the caller. Nothing here is part of a step.
use crate::arithmetic::real::vec3;
use crate::grid::{Cells, Stencil, cell_of, is_inactive_cell};
use crate::layout::f32x4;
use crate::live::Constants;
use crate::memory::{Given, Sorting};
use crate::passes::b_sort::count::count;
use crate::passes::b_sort::scan::scan;
use crate::passes::b_sort::scatter::scatter;
use crate::passes::columns::Columns;
use crate::passes::context::Setup;
use crate::passes::lanes::is_inactive;
use crate::passes::local::Particles;
use crate::solver::Solver;
use crate::terms::pair::{pair_scale, separation, squared_ratio};
use crate::terms::support::support_close;

/// The particles of a fluid, sorted into cells by their present positions. [`Solver::neighbours`] returns it.
#[derive(Debug)]
pub struct Neighbours<'s, 'm> {
    pub(crate) solver: &'s Solver<'m>,
}

impl<'m> Solver<'m> {
    /// Sorts the particles into cells, and returns which of them are close to which. The cells lie in memory of the
    /// step, and so this needs `&mut self`, but no particle changes.
    ///
    /// ```
    /// # use millpond_core::glam::Vec3;
    /// # use millpond_core::scene::{Block, Dimension, Fluid, Scene};
    /// # use millpond_core::{OwnedMemory, Solver};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let block = Block { size: Vec3::splat(0.5), ..Block::default() };
    /// # let scene = Scene::of(Dimension::Three, 0.05, 0.001, Fluid::default(), block);
    /// # let mut memory = OwnedMemory::of(&scene.check()?);
    /// # let mut solver = Solver::new(&scene, memory.lend())?;
    /// let neighbours = solver.neighbours();
    /// let mut pairs = 0;
    /// neighbours.each_pair(|a, b| pairs += u32::from(a < b));
    /// println!("{pairs} pairs, {:.1} neighbours of a particle", neighbours.average());
    /// # Ok(())
    /// # }
    /// ```
    pub fn neighbours(&mut self) -> Neighbours<'_, 'm> {
        self.sort_again();
        Neighbours { solver: self }
    }

    /// Writes the slots, sorted by cell and id, to `source_slot`. This is needed because penalty planes move particles
    /// after a step has sorted them, and because a failed step leaves the cells of its attempt behind.
    fn sort_again(&mut self) {
        self.has_lists = false;
        let (m, p) = (self.plan().model, *self.parameters());
        let current = self.current_index();
        let state = &self.memory.states[current];
        let (materials, scratch) = (&self.constants.materials, &mut self.memory.scratch);
        let Sorting { source_slot, cell: cells, rank, .. } = Sorting::of(scratch.neighbours, state.id.len());
        for ((cell, x), v) in cells.iter_mut().zip(state.position.iter()).zip(state.velocity.iter()) {
            if m.has_inactive == 1 && is_inactive(materials, v[3]) {
                *cell = p.cells[3] - 1;
                continue;
            }
            // a particle that a penalty plane moved beyond the range, which the next step reports, is put in cell 0,
            // where the distance test finds no neighbours of it
            *cell = cell_of(&p, *x).unwrap_or(0);
        }
        count(cells, rank, scratch.grid_cell_counters);
        scan(scratch.grid_cell_counters, scratch.cell_start);
        scatter(cells, rank, scratch.cell_start, source_slot);
        let cells = Cells { start: scratch.cell_start, counter: scratch.grid_cell_counters };
        for cell in 0..cells.start.len() {
            source_slot[cells.members(cell)].sort_unstable_by_key(|&slot| state.id[slot as usize]);
        }
    }
}

impl Neighbours<'_, '_> {
    /// Calls `visit` with the ids of all pairs inside each other's support, each pair in both directions and each
    /// particle with itself. The order is that in which the next step would sum the pairs with the full stencil if the
    /// particles did not move.
    pub fn each_pair(&self, mut visit: impl FnMut(u32, u32)) {
        let id = &self.solver.state().id;
        self.each_pair_of_slots(|a, b| visit(id[a], id[b]));
    }

    /// Mean number of particles inside the support radius of a fluid particle, including the particle itself.
    #[must_use]
    pub fn average(&self) -> f64 {
        let is_fluid = |slot: usize| !self.solver.is_wall(slot);
        let fluid = (0..self.solver.slots().len()).filter(|&slot| is_fluid(slot)).count();
        let mut pairs = 0u64;
        self.each_pair_of_slots(|a, _| pairs += u64::from(is_fluid(a)));
        pairs as f64 / fluid.max(1) as f64
    }

    /// Number of pairs whose distance a step with the full stencil computes: each particle with all particles in its
    /// own cell and the cells around it.
    #[must_use]
    pub fn tested_pairs(&self) -> u64 {
        let (p, layers, cells) = (self.solver.parameters(), self.layers(), self.cells());
        let tested = |cell: usize| {
            let around = Stencil::around(p, layers, cells, cell).runs().map(|run| run.len()).sum::<usize>();
            u64::from(cells.counter[cell]) * around as u64
        };
        self.full_cells().map(tested).sum()
    }

    /// Number of particles in the fullest cell. Cell lists with fewer places would make this state fail.
    #[must_use]
    pub fn fullest_cell(&self) -> u32 {
        let counter = self.cells().counter;
        self.full_cells().map(|cell| counter[cell]).max().unwrap_or(0)
    }

    /// Calls `visit` with the slots of all pairs, as [`Neighbours::each_pair`] does with their ids.
    pub(crate) fn each_pair_of_slots(&self, mut visit: impl FnMut(usize, usize)) {
        let (p, m) = (self.solver.parameters(), &self.solver.plan().model);
        let (state, cells, layers) = (self.solver.state(), self.cells(), self.layers());
        let source_slot = self.solver.memory.scratch.source_slot(state.id.len());
        let support = |slot: usize| support_close(m, p, state.density_pressure[slot][0]);
        for cell in self.full_cells() {
            let stencil = Stencil::around(p, layers, cells, cell);
            for a in &source_slot[cells.members(cell)] {
                for b in stencil.runs().flat_map(|run| &source_slot[run]) {
                    let (a, b) = (*a as usize, *b as usize);
                    let (x_a, x_b) = (vec3::<f32>::splat(state.position[a]), vec3::splat(state.position[b]));
                    let x_ab = separation(m, p, x_a, x_b);
                    let scale = pair_scale(m, support(a), support(b));
                    if squared_ratio(m, p, x_ab, scale) < 1.0 {
                        visit(a, b);
                    }
                }
            }
        }
    }

    /// Returns the slots of the particles around a particle, the particle itself included.
    pub(crate) fn around(&self, slot: usize) -> impl Iterator<Item = usize> {
        let (solver, state) = (self.solver, self.solver.state());
        let support = support_close(&solver.plan().model, solver.parameters(), state.density_pressure[slot][0]);
        self.near(state.position[slot], support)
    }

    /// Returns the slots of the particles around a position with this support radius over that of the scene.
    pub(crate) fn near(&self, position: f32x4, own: f32) -> impl Iterator<Item = usize> {
        let (p, m) = (self.solver.parameters(), &self.solver.plan().model);
        let state = self.solver.state();
        let source_slot = self.solver.memory.scratch.source_slot(state.id.len());
        let cell = cell_of(p, position).unwrap_or(0) as usize;
        let stencil = Stencil::around(p, self.layers(), self.cells(), cell);
        let runs = stencil.runs().collect::<heapless::Vec<_, 27>>();
        runs.into_iter().flat_map(move |run| &source_slot[run]).map(|&b| b as usize).filter(move |&b| {
            let (x_a, x_b) = (vec3::<f32>::splat(position), vec3::splat(state.position[b]));
            let scale = pair_scale(m, own, support_close(m, p, state.density_pressure[b][0]));
            squared_ratio(m, p, separation(m, p, x_a, x_b), scale) < 1.0
        })
    }

    /// Calls `f` with what the terms of pairs read, for the present state.
    pub(crate) fn with_terms<T>(&self, f: impl FnOnce(&Setup<'_>, Particles<'_>) -> T) -> T {
        let (solver, state) = (self.solver, self.solver.state());
        let Constants { parameters, materials, step: uniform, .. } = &solver.constants;
        let columns = &Columns::of(materials, solver.live.materials());
        let Given { kernel_tables: tables, acceleration_field: field, .. } = &solver.memory.given;
        let (model, simd) = (&solver.plan().model, solver.simd());
        let particles = Particles {
            position: state.position,
            velocity: state.velocity,
            density_pressure: state.density_pressure,
            support: solver.memory.scratch.support_ratio,
        };
        let poses = &*state.pose;
        f(&Setup { model, parameters, materials, columns, uniform, tables, field, poses, simd }, particles)
    }

    fn cells(&self) -> Cells<'_> {
        let scratch = &self.solver.memory.scratch;
        Cells { start: scratch.cell_start, counter: scratch.grid_cell_counters }
    }

    /// Cells with active particles.
    fn full_cells(&self) -> impl Iterator<Item = usize> {
        let (cells, m, p) = (self.cells(), &self.solver.plan().model, self.solver.parameters());
        (0..cells.start.len()).filter(move |&cell| cells.counter[cell] > 0 && !is_inactive_cell(m, p, cell))
    }

    /// Number of layers of cells above and below a cell with neighbours: none in 2D.
    fn layers(&self) -> i32 {
        self.solver.plan().model.is_3d as i32
    }
}
