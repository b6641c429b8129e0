//! The forces between particles in newtons, with the half stencil. Each pair is computed once, and its forces are equal
//! and opposite.
use super::{Job, Others, PairSum, run};
use crate::arithmetic::lanes::Lanes;
use crate::arithmetic::real::{real, vec3};
use crate::executor::AnyExecutor;
use crate::grid::Cells;
use crate::layout::f32x4;
use crate::passes::by_model;
use crate::passes::context::Setup;
use crate::passes::local::Particles;
use crate::terms::neighbour::force_neighbour;
use crate::terms::pair::Local;

/// Fills `sums` with the force on each particle, N.
pub(crate) fn sum_once(
    setup: Setup<'_>,
    executor: &dyn AnyExecutor,
    particles: Particles<'_>,
    cells: Cells<'_>,
    sums: &mut [f32x4],
) {
    sums.fill([0.0; 4]);
    run(setup, executor, particles, cells, &Forces, sums);
}

struct Forces;

impl PairSum for Forces {
    fn work(job: &mut Job<'_, Self>) {
        by_model::run_one_material_or_general(job);
    }

    #[inline(always)]
    fn of_pairs<R: Lanes>(&self, setup: &Setup<'_>, a: Local<R>, others: Others<'_>, _: R) -> [[R; 4]; 2] {
        let (m, p, t) = (setup.model, setup.parameters, setup.tables);
        // force density times the volume of the particle that it acts on
        let vec3 { x, y, z } = force_neighbour(m, p, t, a, others.known(setup)) * a.volume;
        let none = real(0.0);
        [[x, y, z, none], [-x, -y, -z, none]]
    }
}
