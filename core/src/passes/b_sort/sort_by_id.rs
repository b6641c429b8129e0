//! Sorts the particles of each cell by ascending id. This fixes the order in which sums over neighbours are added up,
//! whatever the number of cells, the grid structure and earlier steps.
//!
//! Inactive air particles stay unsorted: no sum includes them, and their one cell may hold many of them.
//!
//! The pass uses insertion sort, because a cell holds few particles, most of which were in this order in the step
//! before.
use crate::executor::{Jobs, parts, take};
use crate::grid::is_inactive_cell;
use crate::memory::Sorting;
use crate::passes::context::{Step, sorting};
use crate::passes::pairs::cells;

struct Job<'a> {
    first_cell: usize,
    first_slot: usize,
    source_slot: &'a mut [u32],
    id: &'a mut [u32],
}

/// Fills `source_slot` and `id`.
pub(crate) fn run(step: &mut Step<'_, '_>) {
    let (setup, old_id) = (step.setup, &*step.old.id);
    let places = setup.model.cell_places as usize;
    let Sorting { source_slot: mut sources, cell: cell_of, cell_members, .. } = sorting!(step);
    let (cell_of, cell_members, grid_cells) = (&*cell_of, &*cell_members, &*step.scratch.grid_cells);
    let cells = cells!(step);
    let mut ids = &mut *step.new.id;
    let mut jobs = Jobs::new();
    for (share, slots) in cells.shares(parts(step.executor), old_id.len()) {
        let (source_slot, id) = (take(&mut sources, slots.len()), take(&mut ids, slots.len()));
        let _ = jobs.push(Job { first_cell: share.start, first_slot: slots.start, source_slot, id });
    }
    step.executor.run(&mut jobs, |job| {
        let (mut cell, end) = (job.first_cell, job.first_slot + job.id.len());
        let mut next = job.first_slot;
        while next < end {
            if places == 0 {
                // the cell of the particle in the next slot is known, so empty cells need no visit
                cell = cell_of[cell_members[next] as usize] as usize;
            }
            while cells.counter[cell] == 0 {
                cell += 1;
            }
            let members = cells.members(cell);
            next = members.end;
            let slots = members.start - job.first_slot..members.end - job.first_slot;
            let first_place = cell * places;
            let unsorted =
                if places > 0 { &grid_cells[first_place..first_place + members.len()] } else { &cell_members[members] };
            let (source_slot, id) = (&mut job.source_slot[slots.clone()], &mut job.id[slots]);
            if is_inactive_cell(setup.model, setup.parameters, cell) {
                source_slot.copy_from_slice(unsorted);
                for (id, &slot) in id.iter_mut().zip(unsorted) {
                    *id = old_id[slot as usize];
                }
            } else {
                sort(old_id, unsorted, source_slot, id);
            }
            cell += 1;
        }
    });
}

/// Fills `sorted` with the slots in `unsorted`, in the order of their ids in `old_id`, and `id` with the sorted ids.
fn sort(old_id: &[u32], unsorted: &[u32], sorted: &mut [u32], id: &mut [u32]) {
    for (i, &slot) in unsorted.iter().enumerate() {
        let key = old_id[slot as usize];
        let mut j = i;
        while j > 0 && id[j - 1] > key {
            sorted[j] = sorted[j - 1];
            id[j] = id[j - 1];
            j -= 1;
        }
        sorted[j] = slot;
        id[j] = key;
    }
}
