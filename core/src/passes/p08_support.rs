//! Support radius of each particle from its density before the step. Only with variable supports.
use super::{Setup, load_one};
use crate::arithmetic::level::Work;
use crate::arithmetic::real::Real;
use crate::executor::{Executor, Jobs, parts, shares, take};
use crate::layout::f32x4;
use crate::terms::support::support_close;

struct Job<'a> {
    setup: Setup<'a>,
    previous: &'a mut [f32x4],
}

/// Fills the third number of `previous`.
pub(crate) fn run(setup: Setup<'_>, executor: &impl Executor, previous: &mut [f32x4]) {
    let count = previous.len();
    let mut rest = previous;
    let mut jobs = Jobs::new();
    for slots in shares(count, parts(executor)) {
        let _ = jobs.push(Job { setup, previous: take(&mut rest, slots.len()) });
    }
    executor.run(&mut jobs, work);
}

/// Compiled once, in this crate: see [`PairPass::work`](super::pairs::PairPass::work).
fn work(job: &mut Job<'_>) {
    let simd = job.setup.simd;
    simd.run(job);
}

impl Work for &mut Job<'_> {
    #[inline(always)]
    fn run<R: Real>(self) {
        let count = self.previous.len();
        for first in (0..count).step_by(R::LANES) {
            let end = (first + R::LANES).min(count);
            let deviation = load_one::<R>(self.previous, first, end - 1, 0);
            let support = support_close(self.setup.model, self.setup.parameters, deviation);
            for (lane, previous) in self.previous[first..end].iter_mut().enumerate() {
                previous[2] = support.lane(lane);
            }
        }
    }
}
