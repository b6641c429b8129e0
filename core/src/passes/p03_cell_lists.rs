//! The CUDA design's cells (S0 section 4.4.2): each particle takes a place of its cell. Only with cell lists.
use crate::layout::NONE;

/// Fills `grid_cells`, `places` a cell; returns the smallest cell that has too few, or [`NONE`].
pub(crate) fn run(cell: &[u32], rank: &[u32], places: u32, grid_cells: &mut [u32]) -> u32 {
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
