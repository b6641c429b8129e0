//! Each particle into the slots of its cell (S1 section 6.2). Only with the index sort.
use crate::passes::context::Step;

/// Fills `cell_members`.
pub(crate) fn run<E>(step: &mut Step<'_, '_, E>) {
    let s = &mut *step.scratch;
    scatter(s.cell, s.rank, s.cell_start, s.cell_members);
}

/// Fills `members` with the slot of each particle.
pub(crate) fn scatter(cell: &[u32], rank: &[u32], start: &[u32], members: &mut [u32]) {
    for (slot, (&cell, &rank)) in cell.iter().zip(rank).enumerate() {
        members[(start[cell as usize] + rank) as usize] = slot as u32;
    }
}
