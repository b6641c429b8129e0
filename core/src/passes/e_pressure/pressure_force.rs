//! Adds the acceleration by the pressure of an iteration to the other accelerations. Runs only with pressure
//! correction.
use crate::arithmetic::lanes::{Lanes, xyz};
use crate::arithmetic::real::{real, vec3};
use crate::layout::f32x4;
use crate::passes::beyond::{self, Front};
use crate::passes::by_model;
use crate::passes::context::{Setup, Step};
use crate::passes::field;
use crate::passes::group::{Group, fold};
use crate::passes::local::particles;
use crate::passes::pairs::{self, Job, PairPass, cells, lists};
use crate::terms::beyond::{completed3, wall_push};
use crate::terms::external::weight;
use crate::terms::geometry::flush3;
use crate::terms::neighbour::{acceleration_close, pressure_neighbour};
use crate::terms::pair::density_ratio;
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
        let Setup { model: m, parameters: p, uniform: u, tables: t, .. } = *group.setup;
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
        let mut pushed = acceleration_close(m, p, xyz(force), a);
        if m.has_closed_walls == 1 {
            let beyond = beyond::of_pressure(group.setup, Front::of(a));
            let mut g = weight(m, p, u, density_ratio(m, a.deviation, a.rest_ratio));
            if m.has_acceleration_field == 1 {
                g = g + field::at(group.setup, a.position);
            }
            pushed = completed3(pushed + wall_push(m, p, a, a.pressure, beyond, g), beyond.gamma);
        }
        let all = flush3(xyz(non_pressure) + pushed);
        let vec3 { x, y, z } = if_free(m, all, a.wall);
        let [.., curvature] = non_pressure;
        R::rows([x, y, z, curvature], own);
        0
    }
}
