//! Each particle into the slots of its cell (S1 section 6.2). Only with the index sort.

/// Fills `order` with the old slot of each new one.
pub(crate) fn run(cell: &[u32], rank: &[u32], begin: &[u32], order: &mut [u32]) {
    for (slot, (&cell, &rank)) in cell.iter().zip(rank).enumerate() {
        order[(begin[cell as usize] + rank) as usize] = slot as u32;
    }
}
