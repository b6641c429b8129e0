//! Checks that an array of the new state is finite. Runs once for each array.
use crate::executor::{Jobs, parts, shares};
use crate::layout::{NONE, QUANTITIES_OF_ID, f32x4};
use crate::passes::context::Step;
use crate::plan::schedule::Command;

struct Job<'a> {
    array: &'a [f32x4],
    id: &'a [u32],
    /// Smallest id whose entry is not finite, or [`NONE`].
    not_finite: u32,
}

/// Records the smallest id of a particle with a number that is not finite and, for that id, the first such array.
pub(crate) fn run(step: &mut Step<'_, '_>) {
    let Command::Validate(array) = step.command else { return };
    let (entries, id): (&[f32x4], _) = (bytemuck::cast_slice(step.new.words(array)), &*step.new.id);
    let mut jobs = Jobs::new();
    for slots in shares(id.len(), parts(step.executor)) {
        let _ = jobs.push(Job { array: &entries[slots.clone()], id: &id[slots], not_finite: NONE });
    }
    step.executor.run(&mut jobs, |job| {
        for (entry, &id) in job.array.iter().zip(job.id) {
            // no early exit, so that the usual case, in which all numbers are finite, has no branches
            if !entry.iter().fold(true, |fine, x| fine & x.is_finite()) {
                job.not_finite = job.not_finite.min(id);
            }
        }
    });
    let smallest = jobs.iter().map(|job| job.not_finite).min().unwrap_or(NONE);
    if smallest != NONE {
        let status = &mut step.found.status;
        status.not_finite = status.not_finite.min(QUANTITIES_OF_ID * smallest + array as u32);
    }
}
