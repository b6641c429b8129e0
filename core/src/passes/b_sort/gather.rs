//! An array into the slots after the step, so that members of a cell stand side by side. Runs once for each array that a step sorts.
use crate::executor::{Executor, Jobs, parts, shares, take};
use crate::layout::f32x4;
use crate::passes::context::Step;
use crate::plan::arrays::{Class, Side};
use crate::plan::schedule::Command;

struct Job<'a> {
    source_slot: &'a [u32],
    out: &'a mut [f32x4],
}

/// Moves the array that the command names: one of the old state, or of what the step works in, to one of the new state or of what the
/// step works in.
pub(crate) fn run(step: &mut Step<'_, '_, impl Executor>) {
    let Step { old, new, scratch, executor, command, .. } = step;
    let Command::Gather { from: (from, side), to } = *command else { return };
    let source_slot = core::mem::take(&mut scratch.source_slot);
    match (side, to.class()) {
        (Side::Old, Class::Scratch) => moved(*executor, source_slot, old.words(from), scratch.words_mut(to)),
        (Side::Old, _) => moved(*executor, source_slot, old.words(from), new.words_mut(to)),
        (_, _) => moved(*executor, source_slot, scratch.words(from), new.words_mut(to)),
    }
    scratch.source_slot = source_slot;
}

/// `to[slot] = from[source_slot[slot]]`.
fn moved(executor: &impl Executor, source_slot: &[u32], from: &[u32], to: &mut [u32]) {
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
