//! Selects the compiled variant of a loop over pairs. At each SIMD level such a loop is compiled several times: for
//! common kinds of scene, for which the compiler then knows most of the model as constants ([`Known`]), and once for
//! all other scenes. Each variant is a separate function. In unoptimised builds one function with all variants would
//! need more stack than a thread of the caller may have.
use super::context::Setup;
use crate::arithmetic::lanes::Lanes;
use crate::arithmetic::level::Work;
use crate::plan::known::Known;

/// A job of a loop over pairs.
pub(crate) trait PairJob<'a> {
    /// Returns the constants of the step.
    fn setup(&self) -> Setup<'a>;

    /// Runs the job with these constants, which are equal to those of the step. Must be `#[inline(always)]`, as for
    /// [`Work`].
    fn run_by<R: Lanes>(&mut self, setup: &Setup<'_>);
}

/// Runs a job with the variant that knows most about its model.
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

/// Runs a job with the general variant: for passes that few scenes use.
#[inline(always)]
pub(crate) fn run_general<'a>(job: &mut impl PairJob<'a>) {
    let simd = job.setup().simd;
    simd.run(By::<_, { Known::Nothing as usize }>(job));
}

/// Runs a job with the variant for one material if it applies, else with the general one: for passes that few scenes
/// use, but that must be fast in the simplest of these scenes.
#[inline(always)]
pub(crate) fn run_one_material_or_general<'a>(job: &mut impl PairJob<'a>) {
    let Setup { simd, model, .. } = job.setup();
    match Known::of(model) {
        Known::OneMaterial => simd.run(By::<_, { Known::OneMaterial as usize }>(job)),
        _ => simd.run(By::<_, { Known::Nothing as usize }>(job)),
    }
}

/// A job to be run with variant number `KNOWN` of [`Known::ALL`].
struct By<'j, J, const KNOWN: usize>(&'j mut J);

impl<'a, J: PairJob<'a>, const KNOWN: usize> Work for By<'_, J, KNOWN> {
    #[inline(always)]
    fn run<R: Lanes>(self) {
        let setup = self.0.setup();
        // local copies, so that the compiler sees that nothing changes them
        let model = const { Known::ALL[KNOWN] }.in_model(setup.model);
        let parameters = *setup.parameters;
        self.0.run_by::<R>(&Setup { model: &model, parameters: &parameters, ..setup });
    }
}
