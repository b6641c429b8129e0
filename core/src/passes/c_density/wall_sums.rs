//! Takes pressure and velocity from the fluid to the wall particles in it. Runs only with walls that are extrapolated.
use crate::arithmetic::lanes::Lanes;
use crate::arithmetic::real::{real, vec3};
use crate::layout::f32x4;
use crate::passes::by_model;
use crate::passes::context::{Setup, Step};
use crate::passes::field;
use crate::passes::group::{Group, fold};
use crate::passes::local::particles;
use crate::passes::pairs::{self, Job, PairPass, cells, lists};
use crate::terms::extrapolation::{
    extrapolates_velocity, wall_pressure, wall_pressure_neighbour, wall_velocity, wall_weight,
};

/// Fills the entries of wall particles in `seen_velocity`, with the pressure as the fourth number.
pub(crate) fn run(step: &mut Step<'_, '_>) {
    let (particles, cells, lists) = (particles!(step), cells!(step), lists!(step));
    pairs::run(step.setup, step.executor, particles, cells, lists, &WallSums, step.scratch.seen_velocity);
}

/// Computes the velocity of wall particles as viscosity sees it, and their pressure. The entries of fluid particles are
/// filled later.
struct WallSums;

impl PairPass for WallSums {
    fn work(job: &mut Job<'_, Self>) {
        by_model::run_general(job);
    }

    #[inline(always)]
    fn group<R: Lanes>(&self, group: &Group<'_>, own: &mut [f32x4]) -> u32 {
        let Setup { model: m, parameters: p, uniform: u, tables: t, .. } = *group.setup;
        if !group.have_walls() {
            return 0;
        }
        let a = group.receivers::<R>();
        let none = real::<R>(0.0);
        let field =
            if m.has_acceleration_field == 1 { field::at(group.setup, a.position) } else { vec3(none, none, none) };
        let [sum, weights, ..] = fold!(group: R, is zero with itself, |slots| {
            let b = group.neighbours(slots);
            let w = wall_weight(m, p, t, a, b);
            [wall_pressure_neighbour(m, p, u, a, b, field, w), w, none, none]
        });
        let mut seen = a.velocity;
        if extrapolates_velocity(m) {
            let [x, y, z, _] = fold!(group: R, is zero with itself, |slots| {
                let b = group.neighbours(slots);
                let vec3 { x, y, z } = b.velocity * wall_weight(m, p, t, a, b);
                [x, y, z, none]
            });
            seen = wall_velocity(a.velocity, vec3(x, y, z), weights);
        }
        R::rows([seen.x, seen.y, seen.z, wall_pressure(m, sum, weights)], own);
        0
    }
}
