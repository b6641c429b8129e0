//! Finds the neighbours of each particle, including itself, in the order in which sums are added up. All passes over
//! pairs read these lists. Where density depends on distances only, this pass does not run: the density pass finds the
//! neighbours while it sums the density.
use crate::arithmetic::lanes::Lanes;
use crate::layout::f32x4;
use crate::passes::by_model;
use crate::passes::context::{Setup, Step};
use crate::passes::group::Group;
use crate::passes::listing::{self, Job, Near, Visit};
use crate::passes::local::particles;
use crate::passes::pairs::cells;

/// Fills `neighbours`.
pub(crate) fn run(step: &mut Step<'_, '_>) {
    let (setup, particles, cells) = (step.setup, particles!(step but density), cells!(step));
    listing::run(
        setup,
        step.executor,
        particles,
        cells,
        &mut step.scratch.neighbours[..step.list_words],
        &NoVisit,
        &mut [],
    );
}

/// A visitor that does nothing: the pass only fills the lists.
struct NoVisit;

impl Visit for NoVisit {
    fn work(job: &mut Job<'_, Self>) {
        by_model::run(job);
    }

    #[inline(always)]
    fn visit<R: Lanes>(&self, _: &Group<'_>, _: &Near, _: &mut [f32x4]) {}

    #[inline(always)]
    fn search<R: Lanes>(&self, _: &Group<'_>, _: &mut [f32x4]) {}

    fn absent(&self, _: &Setup<'_>, _: &mut [f32x4]) {}
}
