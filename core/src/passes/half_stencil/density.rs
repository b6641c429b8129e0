//! The sums of density with the half stencil, where each pair is computed once.
use super::{Job, Others, PairSum, run};
use crate::arithmetic::lanes::Lanes;
use crate::arithmetic::real::real;
use crate::executor::AnyExecutor;
use crate::grid::Cells;
use crate::layout::f32x4;
use crate::passes::by_model;
use crate::passes::context::Setup;
use crate::passes::density_sums::of_neighbour;
use crate::passes::local::Particles;
use crate::terms::density::counts_masses;
use crate::terms::pair::Local;
use crate::terms::wall::mass_seen;

/// Fills `sums` with the sums of density, near density and number density.
pub(crate) fn sum_once(
    setup: Setup<'_>,
    executor: &dyn AnyExecutor,
    particles: Particles<'_>,
    cells: Cells<'_>,
    sums: &mut [f32x4],
) {
    // a particle is its own neighbour, but the loop over pairs does not include the particle itself
    for (slot, sum) in sums.iter_mut().enumerate() {
        let a: Local<f32> = particles.receivers(&setup, slot, slot);
        *sum = of_neighbour(&setup, mass_seen(setup.model, a.rest_ratio, a.mass, a.rest_ratio, a.wall), 0.0, 1.0);
    }
    run(setup, executor, particles, cells, &Sums, sums);
}

struct Sums;

impl PairSum for Sums {
    fn work(job: &mut Job<'_, Self>) {
        by_model::run_one_material_or_general(job);
    }

    #[inline(always)]
    fn of_pairs<R: Lanes>(&self, setup: &Setup<'_>, a: Local<R>, others: Others<'_>, q2: R) -> [[R; 4]; 2] {
        let one = real(1.0);
        if !counts_masses(setup.model) {
            // the contribution does not depend on the particles' masses
            return [of_neighbour(setup, one, q2, one); 2];
        }
        let b: Local<R> = others.known(setup);
        let seen = |a: Local<R>, b: Local<R>| mass_seen(setup.model, a.rest_ratio, b.mass, b.rest_ratio, b.wall);
        [of_neighbour(setup, seen(a, b), q2, one), of_neighbour(setup, seen(b, a), q2, one)]
    }
}
