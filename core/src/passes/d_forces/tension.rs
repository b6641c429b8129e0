//! Adds the acceleration by the curvature of the surface to the other accelerations. Runs only with a surface tension
//! that depends on curvature.
use crate::arithmetic::lanes::{Lanes, xyz};
use crate::arithmetic::real::{less, real, select, vec3};
use crate::layout::f32x4;
use crate::passes::by_model;
use crate::passes::context::{Setup, Step};
use crate::passes::group::{Group, fold};
use crate::passes::local::{own_numbers, particles};
use crate::passes::pairs::{self, Job, PairPass, cells, lists};
use crate::terms::geometry::flush3;
use crate::terms::tension::{NORMAL_CURVATURE, curvature_of_normals, normal_divergence, tension_close};

/// Adds to the accelerations, or to those without pressure where pressure is iterated.
pub(crate) fn run(step: &mut Step<'_, '_>) {
    let (particles, cells, lists) = (particles!(step), cells!(step), lists!(step));
    let corrects = step.setup.model.corrects_pressure();
    let out = if corrects { &mut *step.scratch.non_pressure_acceleration } else { &mut *step.new.acceleration };
    pairs::run(step.setup, step.executor, particles, cells, lists, &Tension { normal: step.new.normal }, out);
}

/// Adds to the accelerations, and stores the curvature in w.
struct Tension<'a> {
    normal: &'a [f32x4],
}

impl PairPass for Tension<'_> {
    fn work(job: &mut Job<'_, Self>) {
        by_model::run_one_material_or_general(job);
    }

    fn absent(&self, _: &Setup<'_>, _: &mut [f32x4]) {}

    #[inline(always)]
    fn group<R: Lanes>(&self, group: &Group<'_>, own: &mut [f32x4]) -> u32 {
        let (m, p) = (group.setup.model, group.setup.parameters);
        let none = real::<R>(0.0);
        if group.are_walls() {
            return 0;
        }
        let a = group.receivers::<R>();
        let [x, y, z, of_colour] = group.spread::<R>(self.normal);
        let normal = vec3(x, y, z);
        let curvature = if m.tension == NORMAL_CURVATURE {
            let sums = fold!(group: R, is zero with itself, |slots| {
                let normal_b = xyz(R::gather(self.normal, slots));
                let vec3 { x, y, z } = normal_divergence(m, p, a, group.neighbours(slots), normal, normal_b);
                [x, y, z, none]
            });
            curvature_of_normals(p, normal, xyz(sums))
        } else {
            of_colour
        };
        let pull = tension_close(m, p, a, normal, curvature);
        let before = own_numbers::<R>(own);
        let all = flush3(xyz(before) + pull);
        let is_wall = less(none, a.wall);
        let [x, y, z, w] = before;
        let [x, y, z] = [select(all.x, x, is_wall), select(all.y, y, is_wall), select(all.z, z, is_wall)];
        R::rows([x, y, z, select(curvature, w, is_wall)], own);
        0
    }
}
