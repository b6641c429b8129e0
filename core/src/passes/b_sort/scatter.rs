//! Enters each particle into the slots of its cell (Hinsch 2024, section 6.2). Runs only with the index sort.
use crate::memory::Sorting;
use crate::passes::context::{Step, sorting};

/// Fills `cell_members`.
pub(crate) fn run(step: &mut Step<'_, '_>) {
    let Sorting { cell, rank, cell_members, .. } = sorting!(step);
    scatter(cell, rank, step.scratch.cell_start, cell_members);
}

/// Fills `members` with the old slot of each particle, cell by cell.
pub(crate) fn scatter(cell: &[u32], rank: &[u32], start: &[u32], members: &mut [u32]) {
    for (slot, (&cell, &rank)) in cell.iter().zip(rank).enumerate() {
        members[(start[cell as usize] + rank) as usize] = slot as u32;
    }
}
