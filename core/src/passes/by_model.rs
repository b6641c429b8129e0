//! Loops over pairs are compiled twice at each level: for the usual scenes, of which the compiler knows most of the model, and for all
//! others. Each is a function of its own: unoptimised, the two in one would take more stack than a thread of a host may have.
use super::context::Setup;
use crate::arithmetic::lanes::Lanes;
use crate::arithmetic::level::Work;
use crate::layout::Model;

/// A job of a loop over pairs.
pub(crate) trait PairJob<'a> {
    /// The constants of its step.
    fn setup(&self) -> Setup<'a>;

    /// Does it by these constants, which are those of the step. `#[inline(always)]`, as for [`Work`].
    fn run_by<R: Lanes>(&mut self, setup: &Setup<'_>);
}

/// Does a job, by the model of the usual scenes where it can.
#[inline(always)]
pub(crate) fn run<'a>(job: &mut impl PairJob<'a>) {
    let Setup { simd, model, .. } = job.setup();
    if model.is_plain() { simd.run(Plain(job)) } else { simd.run(General(job)) }
}

/// Does a job that no usual scene has.
#[inline(always)]
pub(crate) fn run_general<'a>(job: &mut impl PairJob<'a>) {
    let simd = job.setup().simd;
    simd.run(General(job));
}

struct Plain<'j, J>(&'j mut J);
struct General<'j, J>(&'j mut J);

impl<'a, J: PairJob<'a>> Work for Plain<'_, J> {
    #[inline(always)]
    fn run<R: Lanes>(self) {
        let model = self.0.setup().model.plain();
        run_by::<R>(self.0, model);
    }
}

impl<'a, J: PairJob<'a>> Work for General<'_, J> {
    #[inline(always)]
    fn run<R: Lanes>(self) {
        let model = *self.0.setup().model;
        run_by::<R>(self.0, model);
    }
}

/// Model and parameters are copies of this function's own, so that the compiler sees that nothing changes them.
#[inline(always)]
fn run_by<'a, R: Lanes>(job: &mut impl PairJob<'a>, model: Model) {
    let setup = job.setup();
    let parameters = *setup.parameters;
    job.run_by::<R>(&Setup { model: &model, parameters: &parameters, ..setup });
}
