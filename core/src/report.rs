//! What can be said of a fluid as a whole. Nothing here is part of a step.
use crate::arithmetic::real::vec3;
use crate::grid::{Cells, Stencil, cell_of};
use crate::hash::tree_sum;
use crate::passes::{p02_count, p04_scan, p05_place};
use crate::solver::Solver;
use crate::terms::geometry::length2;

/// How far the fluid is compressed beyond its rest density, as a share of it.
///
/// Only compression counts: at a free surface half of the neighbours are missing, so the summed density there is low
/// whatever the fluid does.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DensityError {
    /// Mean of `max(rho / rho0 - 1, 0)`.
    pub mean: f64,
    /// The largest.
    pub max: f64,
}

impl Solver<'_> {
    /// Compression of the fluid.
    #[must_use]
    pub fn density_error(&self) -> DensityError {
        let (slots, densities) = (self.slots(), &self.state().density_pressure);
        let rest = f64::from(self.parameters().rest_density);
        let error = |id: usize| (f64::from(densities[slots[id] as usize][0]) / rest - 1.0).max(0.0);
        let count = slots.len();
        DensityError {
            mean: tree_sum(count, &error) / count.max(1) as f64,
            max: (0..count).map(error).fold(0.0, f64::max),
        }
    }

    /// Calls `visit` with the ids of every pair inside each other's support, each pair in both directions and every
    /// particle with itself, in the order in which the next step would sum them where it did not move anything.
    pub fn each_pair(&mut self, mut visit: impl FnMut(u32, u32)) {
        let (p, layers) = (*self.parameters(), self.plan().model.layers as i32);
        self.sort_again();
        let state = self.state();
        let scratch = &self.memory.scratch;
        let cells = Cells { begin: scratch.begin, counter: scratch.counter };
        for cell in 0..cells.begin.len() {
            let members = cells.members(cell);
            if members.is_empty() {
                continue;
            }
            let stencil = Stencil::around(&p, layers, cells, cell);
            for a in &scratch.order[members] {
                for b in stencil.runs().flat_map(|run| &scratch.order[run]) {
                    let (a, b) = (*a as usize, *b as usize);
                    let x_ab = vec3::<f32>::splat(state.position[a]) - vec3::splat(state.position[b]);
                    if length2(x_ab) * p.inverse_support_squared < 1.0 {
                        visit(state.id[a], state.id[b]);
                    }
                }
            }
        }
    }

    /// Mean number of particles inside a support radius, each counting itself.
    #[must_use]
    pub fn average_neighbours(&mut self) -> f64 {
        let mut pairs = 0u64;
        self.each_pair(|_, _| pairs += 1);
        pairs as f64 / self.slots().len().max(1) as f64
    }

    /// Particles of the fullest cell: cell lists with fewer places would refuse this state.
    #[must_use]
    pub fn fullest_cell(&mut self) -> u32 {
        self.sort_again();
        self.memory.scratch.counter.iter().copied().max().unwrap_or(0)
    }

    /// Slots by cell and id, into `order`. Walls move particles after a step has sorted them, and a failed step leaves
    /// the cells of its attempt behind.
    fn sort_again(&mut self) {
        let p = *self.parameters();
        let current = self.current_index();
        let state = &self.memory.states[current];
        let scratch = &mut self.memory.scratch;
        for (cell, x) in scratch.cell.iter_mut().zip(state.position.iter()) {
            // one that a wall put beyond the range, where the next step refuses it, shows up in cell 0, near nobody
            *cell = cell_of(&p, *x).unwrap_or(0);
        }
        p02_count::run(scratch.cell, scratch.rank, scratch.counter);
        p04_scan::run(scratch.counter, scratch.begin);
        p05_place::run(scratch.cell, scratch.rank, scratch.begin, scratch.order);
        let cells = Cells { begin: scratch.begin, counter: scratch.counter };
        for cell in 0..cells.begin.len() {
            scratch.order[cells.members(cell)].sort_unstable_by_key(|&slot| state.id[slot as usize]);
        }
    }
}
