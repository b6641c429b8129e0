//! Finds the first slot of each cell: the running sum of the counts (Hinsch 2024, section 6.2).
use crate::passes::context::Step;

/// Fills `cell_start`.
pub(crate) fn run(step: &mut Step<'_, '_>) {
    scan(step.scratch.grid_cell_counters, step.scratch.cell_start);
}

/// Fills `start`.
pub(crate) fn scan(counter: &[u32], start: &mut [u32]) {
    let mut slot = 0;
    for (start, count) in start.iter_mut().zip(counter) {
        *start = slot;
        slot += count;
    }
}
