//! Adds the acceleration by the pressure of an iteration to the other accelerations. Runs only with pressure
//! correction.
use crate::arithmetic::lanes::{Lanes, xyz};
use crate::arithmetic::real::{real, vec3};
use crate::layout::f32x4;
use crate::passes::by_model;
use crate::passes::context::{Setup, Step};
use crate::passes::group::{Group, fold};
use crate::passes::local::particles;
use crate::passes::pairs::{self, Job, PairPass, cells, lists};
use crate::terms::geometry::flush3;
use crate::terms::neighbour::{acceleration_close, pressure_neighbour};
use crate::terms::wall::if_free;

/// Fills the accelerations.
pub(crate) fn run(step: &mut Step<'_, '_>) {
    let (particles, cells, lists) = (particles!(step), cells!(step), lists!(step));
    let pass = PressureForce { non_pressure: step.scratch.non_pressure_acceleration };
    pairs::run(step.setup, step.executor, particles, cells, lists, &pass, step.new.acceleration);
}

/// Computes accelerations from `non_pressure`, the accelerations without pressure.
struct PressureForce<'a> {
    non_pressure: &'a [f32x4],
}

impl PairPass for PressureForce<'_> {
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
        let a = group.receivers::<R>();
        let force = fold!(group: R, is zero with itself, |slots| {
            let vec3 { x, y, z } = pressure_neighbour(m, p, t, a, group.neighbours(slots));
            [x, y, z, real(0.0)]
        });
        let non_pressure = group.spread::<R>(self.non_pressure);
        let all = flush3(xyz(non_pressure) + acceleration_close(m, p, xyz(force), a));
        let vec3 { x, y, z } = if_free(m, all, a.wall);
        let [.., curvature] = non_pressure;
        R::rows([x, y, z, curvature], own);
        0
    }
}
