//! The moved particles into their slots, so that members of a cell stand side by side.
use crate::executor::{Executor, Jobs, parts, shares, take};
use crate::layout::f32x4;

struct Job<'a> {
    order: &'a [u32],
    out: &'a mut [f32x4],
}

/// `out[slot] = waiting[order[slot]]`.
pub(crate) fn run(executor: &impl Executor, order: &[u32], waiting: &[f32x4], out: &mut [f32x4]) {
    let mut outs = out;
    let mut jobs = Jobs::new();
    for slots in shares(order.len(), parts(executor)) {
        let out = take(&mut outs, slots.len());
        let _ = jobs.push(Job { order: &order[slots], out });
    }
    executor.run(&mut jobs, |job| {
        for (out, &slot) in job.out.iter_mut().zip(job.order) {
            *out = waiting[slot as usize];
        }
    });
}
