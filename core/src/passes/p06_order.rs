//! Ascending id inside each cell: the order of every sum, whatever the grid, its structure and the past.
//!
//! Air that is not there stays unsorted: nothing is ever summed over it, and it may be much in one cell.
//!
//! Insertion sort: a cell holds few particles, and most of them stood in this order before.
use super::Setup;
use crate::executor::{Executor, Jobs, parts, take};
use crate::grid::{Cells, is_limbo};
use core::ops::Range;

struct Job<'a> {
    cells: Range<usize>,
    first_slot: usize,
    order: &'a mut [u32],
    id: &'a mut [u32],
}

/// Fills `id` and puts `order` in order. With cell lists (`places` not 0), takes the members from `grid_cells` first.
pub(crate) fn run(
    setup: Setup<'_>,
    executor: &impl Executor,
    cells: Cells<'_>,
    (grid_cells, places): (&[u32], u32),
    old_id: &[u32],
    order: &mut [u32],
    id: &mut [u32],
) {
    let particles = old_id.len();
    let (mut orders, mut ids) = (order, id);
    let mut jobs = Jobs::new();
    for (share, slots) in cells.shares(parts(executor), particles) {
        let (order, id) = (take(&mut orders, slots.len()), take(&mut ids, slots.len()));
        let _ = jobs.push(Job { cells: share, first_slot: slots.start, order, id });
    }
    executor.run(&mut jobs, |job| {
        for cell in job.cells.clone() {
            let members = cells.members(cell);
            let slots = members.start - job.first_slot..members.end - job.first_slot;
            let order = &mut job.order[slots.clone()];
            if places > 0 {
                let first_place = cell * places as usize;
                order.copy_from_slice(&grid_cells[first_place..first_place + order.len()]);
            }
            if is_limbo(setup.model, setup.parameters, cell) {
                for (id, &slot) in job.id[slots].iter_mut().zip(&*order) {
                    *id = old_id[slot as usize];
                }
                continue;
            }
            sort(old_id, order, &mut job.id[slots]);
        }
    });
}

/// Sorts `order` by `old_id` and writes the sorted ids.
fn sort(old_id: &[u32], order: &mut [u32], id: &mut [u32]) {
    for i in 0..order.len() {
        let slot = order[i];
        let key = old_id[slot as usize];
        let mut j = i;
        while j > 0 && id[j - 1] > key {
            order[j] = order[j - 1];
            id[j] = id[j - 1];
            j -= 1;
        }
        order[j] = slot;
        id[j] = key;
    }
}

/// Slot of each particle, by id. Only with springs or air.
pub(crate) fn find(id: &[u32], slot_of: &mut [u32]) {
    for (slot, &id) in id.iter().enumerate() {
        slot_of[id as usize] = slot as u32;
    }
}
