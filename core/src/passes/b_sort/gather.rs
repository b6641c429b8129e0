//! Moves an array from the slots before the step into the slots after it, so that the particles of a cell lie side by
//! side. Runs once for each array that a step sorts.
use crate::executor::{AnyExecutor, Jobs, parts, shares, take};
use crate::layout::f32x4;
use crate::memory::Sorting;
use crate::passes::context::Step;
use crate::plan::arrays::{Class, Side};
use crate::plan::schedule::Command;

struct Job<'a> {
    source_slot: &'a [u32],
    out: &'a mut [f32x4],
}

/// Moves the array that the command names. The source is in the old state or among the sorting arrays, and the
/// destination is in the new state or in the scratch memory.
pub(crate) fn run(step: &mut Step<'_, '_>) {
    let Step { old, new, scratch, executor, command, .. } = step;
    let Command::Gather { from: (from, side), to } = *command else { return };
    // taken out of the scratch memory, because another of its arrays may be written
    let lists = core::mem::take(&mut scratch.neighbours);
    let sorting = Sorting::of(lists, old.id.len());
    let from = if side == Side::Old { old.words(from) } else { sorting.words(from) };
    let to = if to.class() == Class::Scratch { scratch.words_mut(to) } else { new.words_mut(to) };
    moved(*executor, sorting.source_slot, from, to);
    scratch.neighbours = lists;
}

/// `to[slot] = from[source_slot[slot]]`.
fn moved(executor: &dyn AnyExecutor, source_slot: &[u32], from: &[u32], to: &mut [u32]) {
    let from: &[f32x4] = bytemuck::cast_slice(from);
    let mut outs: &mut [f32x4] = bytemuck::cast_slice_mut(to);
    let mut jobs = Jobs::new();
    for slots in shares(source_slot.len(), parts(executor)) {
        let out = take(&mut outs, slots.len());
        let _ = jobs.push(Job { source_slot: &source_slot[slots], out });
    }
    executor.run(&mut jobs, |job| {
        for (out, &slot) in job.out.iter_mut().zip(job.source_slot) {
            *out = from[slot as usize];
        }
    });
}
