//! Computes the inward surface normal of each particle's fluid, and the curvature where it follows from the colour of
//! that fluid. Runs only where a surface tension or the caller needs normals.
use crate::arithmetic::lanes::Lanes;
use crate::arithmetic::real::{less, real, select, vec3};
use crate::layout::f32x4;
use crate::passes::beyond::{self, Front};
use crate::passes::by_model;
use crate::passes::context::Step;
use crate::passes::group::{Group, fold};
use crate::passes::local::particles;
use crate::passes::pairs::{self, Job, PairPass, cells, lists};
use crate::terms::geometry::flush3;
use crate::terms::tension::{CURVATURE, colour_gradient, colour_laplacian, curvature_of_colour};

/// Fills the normals.
pub(crate) fn run(step: &mut Step<'_, '_>) {
    let (particles, cells, lists) = (particles!(step), cells!(step), lists!(step));
    pairs::run(step.setup, step.executor, particles, cells, lists, &Normals, step.new.normal);
}

/// Computes the gradient of the colour, and the curvature in w.
struct Normals;

impl PairPass for Normals {
    fn work(job: &mut Job<'_, Self>) {
        by_model::run_one_material_or_general(job);
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
        let [x, y, z, laplacian] = fold!(group: R, |slots| {
            let b = group.neighbours(slots);
            let vec3 { x, y, z } = colour_gradient(m, p, a, b);
            [x, y, z, if m.tension == CURVATURE { colour_laplacian(m, p, a, b) } else { none }]
        });
        let mut normal = vec3(x, y, z);
        if m.has_closed_walls == 1 {
            normal = normal - beyond::of_density(group.setup, Front::of(a)).surface;
        }
        let normal = flush3(normal);
        let curvature = if m.tension == CURVATURE { curvature_of_colour(p, normal, laplacian) } else { none };
        let is_wall = less(none, a.wall);
        let of = |x: R| select(x, none, is_wall);
        R::rows([of(normal.x), of(normal.y), of(normal.z), of(curvature)], own);
        0
    }
}
