//! Loops over pairs are compiled more than once at each level: for several kinds of scene, of which the compiler then knows most of
//! the model, and for all others. Each is a function of its own: unoptimised, all in one would take more stack than a thread of a host
//! may have.
use super::context::Setup;
use crate::arithmetic::lanes::Lanes;
use crate::arithmetic::level::Work;
use crate::plan::known::Known;

/// A job of a loop over pairs.
pub(crate) trait PairJob<'a> {
    /// The constants of its step.
    fn setup(&self) -> Setup<'a>;

    /// Does it by these constants, which are those of the step. `#[inline(always)]`, as for [`Work`].
    fn run_by<R: Lanes>(&mut self, setup: &Setup<'_>);
}

/// Does a job, by the most that is known of its model.
#[inline(always)]
pub(crate) fn run<'a>(job: &mut impl PairJob<'a>) {
    let Setup { simd, model, .. } = job.setup();
    match Known::of(model) {
        Known::OneMaterial => simd.run(By::<_, { Known::OneMaterial as usize }>(job)),
        Known::NoPeriods => simd.run(By::<_, { Known::NoPeriods as usize }>(job)),
        Known::Periods => simd.run(By::<_, { Known::Periods as usize }>(job)),
        Known::Nothing => simd.run(By::<_, { Known::Nothing as usize }>(job)),
    }
}

/// Does a job with nothing known: for passes that few scenes have.
#[inline(always)]
pub(crate) fn run_general<'a>(job: &mut impl PairJob<'a>) {
    let simd = job.setup().simd;
    simd.run(By::<_, { Known::Nothing as usize }>(job));
}

/// Does a job by one material, or with nothing known: for passes that few scenes have, and that must be fast in the plainest of these.
#[inline(always)]
pub(crate) fn run_one_material_or_general<'a>(job: &mut impl PairJob<'a>) {
    let Setup { simd, model, .. } = job.setup();
    match Known::of(model) {
        Known::OneMaterial => simd.run(By::<_, { Known::OneMaterial as usize }>(job)),
        _ => simd.run(By::<_, { Known::Nothing as usize }>(job)),
    }
}

/// A job, by what is known of its model: that number of [`Known::ALL`].
struct By<'j, J, const KNOWN: usize>(&'j mut J);

impl<'a, J: PairJob<'a>, const KNOWN: usize> Work for By<'_, J, KNOWN> {
    #[inline(always)]
    fn run<R: Lanes>(self) {
        let setup = self.0.setup();
        // copies of this function's own, so that the compiler sees that nothing changes them
        let model = const { Known::ALL[KNOWN] }.in_model(setup.model);
        let parameters = *setup.parameters;
        self.0.run_by::<R>(&Setup { model: &model, parameters: &parameters, ..setup });
    }
}
