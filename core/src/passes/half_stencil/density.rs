//! The sums of density, each pair once. Only with the half stencil.
use super::{Job, Others, PairSum, run};
use crate::arithmetic::lanes::Lanes;
use crate::arithmetic::real::{Real, real};
use crate::executor::Executor;
use crate::grid::Cells;
use crate::layout::f32x4;
use crate::passes::by_model;
use crate::passes::context::Setup;
use crate::passes::local::Particles;
use crate::terms::density::{number_density_neighbour, summed_neighbour};
use crate::terms::near::{ARTICLE, near_density_neighbour};
use crate::terms::pair::{Local, weighs};
use crate::terms::wall::mass_seen;

/// Fills in the sums of density, of the near density and of the number density.
pub(crate) fn sum_once(
    setup: Setup<'_>,
    executor: &impl Executor,
    particles: Particles<'_>,
    cells: Cells<'_>,
    sums: &mut [f32x4],
) {
    // a particle is its own neighbour, but makes no pair with itself
    for (slot, sum) in sums.iter_mut().enumerate() {
        let a: Local<f32> = particles.receivers(&setup, slot, slot);
        *sum = share(&setup, mass_seen(setup.model, a.rest, a.mass, a.rest, a.wall), 0.0);
    }
    run(setup, executor, particles, cells, &Sums, sums);
}

/// What neighbours of these masses add to the sums.
#[inline(always)]
fn share<R: Real>(setup: &Setup<'_>, mass: R, q2: R) -> [R; 4] {
    let (m, t) = (setup.model, setup.tables);
    let (none, one) = (real::<R>(0.0), real::<R>(1.0));
    let near = if m.near_pressure == ARTICLE { near_density_neighbour(m, mass, q2, one) } else { none };
    let number = if m.numbers == 1 { number_density_neighbour(m, t, q2, one) } else { none };
    [summed_neighbour(m, t, mass, q2, one), near, number, none]
}

struct Sums;

impl PairSum for Sums {
    fn work(job: &mut Job<'_, Self>) {
        by_model::run_one_material_or_general(job);
    }

    #[inline(always)]
    fn of_pairs<R: Lanes>(&self, setup: &Setup<'_>, a: Local<R>, others: Others<'_>, q2: R) -> [[R; 4]; 2] {
        if !weighs(setup.model) {
            // whoever they are
            return [share(setup, real(1.0), q2); 2];
        }
        let b: Local<R> = others.known(setup);
        let seen = |a: Local<R>, b: Local<R>| mass_seen(setup.model, a.rest, b.mass, b.rest, b.wall);
        [share(setup, seen(a, b), q2), share(setup, seen(b, a), q2)]
    }
}
