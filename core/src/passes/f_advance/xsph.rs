//! Computes the XSPH velocity: a velocity that each particle moves with in the next step, in addition to its own.
//! Runs only with XSPH.
use crate::arithmetic::lanes::{Lanes, xyz};
use crate::arithmetic::real::{real, vec3};
use crate::layout::f32x4;
use crate::passes::by_model;
use crate::passes::context::{Setup, Step};
use crate::passes::group::{Group, fold};
use crate::passes::local::particles;
use crate::passes::pairs::{self, Job, PairPass, cells, lists};
use crate::terms::wall::if_free;
use crate::terms::xsph::{xsph_close, xsph_neighbour};

/// Fills `drift_velocity`.
pub(crate) fn run(step: &mut Step<'_, '_>) {
    let (particles, cells, lists) = (particles!(step), cells!(step), lists!(step));
    let pass = Xsph { predicted_velocity: step.scratch.end_velocity };
    pairs::run(step.setup, step.executor, particles, cells, lists, &pass, step.new.drift_velocity);
}

/// Computes XSPH velocities from the velocities at the end of the step.
struct Xsph<'a> {
    predicted_velocity: &'a [f32x4],
}

impl PairPass for Xsph<'_> {
    fn work(job: &mut Job<'_, Self>) {
        by_model::run_one_material_or_general(job);
    }

    #[inline(always)]
    fn group<R: Lanes>(&self, group: &Group<'_>, own: &mut [f32x4]) -> u32 {
        let Setup { model: m, parameters: p, tables: t, .. } = *group.setup;
        if group.are_walls() {
            own.fill([0.0; 4]);
            return 0;
        }
        let mut a = group.receivers::<R>();
        a.velocity = xyz(group.spread(self.predicted_velocity));
        let none = real::<R>(0.0);
        let sum = fold!(group: R, is zero with itself, |slots| {
            let mut b = group.neighbours::<R>(slots);
            b.velocity = xyz(R::gather(self.predicted_velocity, slots));
            let vec3 { x, y, z } = xsph_neighbour(m, p, t, a, b);
            [x, y, z, none]
        });
        let vec3 { x, y, z } = if_free(m, xsph_close(p, xyz(sum)), a.wall);
        R::rows([x, y, z, none], own);
        0
    }
}
