//! Finds the liquid particles at the free surface, by the gradient of the colour of all fluids together. Runs only with
//! air.
use crate::arithmetic::lanes::{Lanes, xyz};
use crate::arithmetic::real::{less, real, select, vec3};
use crate::layout::f32x4;
use crate::passes::beyond::{self, Front};
use crate::passes::by_model;
use crate::passes::context::Step;
use crate::passes::group::{Group, fold};
use crate::passes::local::particles;
use crate::passes::pairs::{self, Job, PairPass, cells, lists};
use crate::terms::air::{is_exposed, total_gradient};
use crate::terms::geometry::flush3;

/// Fills `total_colour_gradient`.
pub(crate) fn run(step: &mut Step<'_, '_>) {
    let (particles, cells, lists) = (particles!(step), cells!(step), lists!(step));
    pairs::run(step.setup, step.executor, particles, cells, lists, &Exposure, step.scratch.total_colour_gradient);
}

/// Computes the gradient of the colour of all active particles. In w it stores 1 for an exposed particle, a liquid
/// particle with no particles on one of its sides, and 0 for all others.
struct Exposure;

impl PairPass for Exposure {
    fn work(job: &mut Job<'_, Self>) {
        // the specialised variants are for scenes without air
        by_model::run_general(job);
    }

    #[inline(always)]
    fn group<R: Lanes>(&self, group: &Group<'_>, own: &mut [f32x4]) -> u32 {
        let (m, p) = (group.setup.model, group.setup.parameters);
        if group.are_walls() {
            own.fill([0.0; 4]);
            return 0;
        }
        let a = group.receivers::<R>();
        let none = real::<R>(0.0);
        let sum = fold!(group: R, is zero with itself, |slots| {
            let vec3 { x, y, z } = total_gradient(m, p, a, group.neighbours(slots));
            [x, y, z, none]
        });
        let mut sum = xyz(sum);
        if m.has_closed_walls == 1 {
            sum = sum - beyond::of_density(group.setup, Front::of(a)).surface;
        }
        let normal = flush3(sum);
        let exposed = is_exposed(p, normal, a.wall, a.fluid);
        let is_wall = less(none, a.wall);
        let of = |x: R| select(x, none, is_wall);
        R::rows([of(normal.x), of(normal.y), of(normal.z), of(exposed)], own);
        0
    }
}
