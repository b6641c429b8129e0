//! Enters each particle into the list of its cell, which has a fixed number of places (the CUDA design, Pirovano,
//! section 4.4.2). Runs only with cell lists.
use crate::layout::NONE;
use crate::memory::Sorting;
use crate::passes::context::{Step, sorting};

/// Fills `grid_cells`. Records a cell that has too few places.
pub(crate) fn run(step: &mut Step<'_, '_>) {
    let Sorting { cell, rank, .. } = sorting!(step);
    let status = &mut step.found.status;
    status.cell_full = fill(cell, rank, step.setup.model.cell_places, step.scratch.grid_cells);
    let counters = &*step.scratch.grid_cell_counters;
    status.cell_count = if status.cell_full == NONE { 0 } else { counters[status.cell_full as usize] };
}

/// Fills `grid_cells` with `places` entries per cell. Returns the smallest index of a cell with too few places, or
/// [`NONE`].
fn fill(cell: &[u32], rank: &[u32], places: u32, grid_cells: &mut [u32]) -> u32 {
    let mut full = NONE;
    for (slot, (&cell, &rank)) in cell.iter().zip(rank).enumerate() {
        if rank < places {
            grid_cells[(cell * places + rank) as usize] = slot as u32;
        } else {
            full = full.min(cell);
        }
    }
    full
}
