//! Computes the support radius of each particle from its density before the step. Runs only with variable supports.
use crate::arithmetic::lanes::Lanes;
use crate::arithmetic::level::Work;
use crate::executor::{Jobs, parts, shares, take};
use crate::layout::f32x4;
use crate::passes::context::{Setup, Step};
use crate::passes::lanes::load_one;
use crate::terms::support::support_close;

struct Job<'a> {
    setup: Setup<'a>,
    previous: &'a [f32x4],
    support: &'a mut [f32],
}

/// Fills `support_ratio`.
pub(crate) fn run(step: &mut Step<'_, '_>) {
    let (setup, s) = (step.setup, &mut *step.scratch);
    let (previous, mut supports) = (&*s.previous_density_pressure, &mut *s.support_ratio);
    let mut jobs = Jobs::new();
    for slots in shares(previous.len(), parts(step.executor)) {
        let support = take(&mut supports, slots.len());
        let _ = jobs.push(Job { setup, previous: &previous[slots], support });
    }
    step.executor.run(&mut jobs, work);
}

/// Runs a job. This function is compiled once, in this crate: see
/// [`PairPass::work`](crate::passes::pairs::PairPass::work).
fn work(job: &mut Job<'_>) {
    let simd = job.setup.simd;
    simd.run(job);
}

impl Work for &mut Job<'_> {
    #[inline(always)]
    fn run<R: Lanes>(self) {
        let count = self.previous.len();
        for first in (0..count).step_by(R::LANES) {
            let end = (first + R::LANES).min(count);
            let deviation = load_one::<R>(self.previous, first, end - 1, 0);
            let support = support_close(self.setup.model, self.setup.parameters, deviation);
            for (lane, out) in self.support[first..end].iter_mut().enumerate() {
                *out = support.lane(lane);
            }
        }
    }
}
