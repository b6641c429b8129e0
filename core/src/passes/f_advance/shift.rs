//! Computes the velocity with which each particle is shifted in the next step, and adds it to that of XSPH if there is
//! one. Runs only with shifting.
use crate::arithmetic::lanes::{Lanes, xyz};
use crate::arithmetic::real::{less, real, vec3};
use crate::layout::f32x4;
use crate::passes::beyond::{self, Front};
use crate::passes::by_model;
use crate::passes::context::Step;
use crate::passes::group::{Group, fold};
use crate::passes::local::{own_numbers, particles};
use crate::passes::pairs::{self, Job, PairPass, cells, lists};
use crate::terms::geometry::flush3;
use crate::terms::pair::Local;
use crate::terms::renormalisation::inside_share;
use crate::terms::shifting::{
    TRANSPORT_VELOCITY, approach_squared, background_gradient, close_repulsion, concentration_gradient,
    fickian_velocity, lambda_gradient, transport_velocity,
};
use crate::terms::wall::if_free;

/// Fills `drift_velocity`, or adds to it.
pub(crate) fn run(step: &mut Step<'_, '_>) {
    let (particles, cells, lists) = (particles!(step), cells!(step), lists!(step));
    let pass = Shift { renormalised: step.scratch.renormalised_gradient };
    pairs::run(step.setup, step.executor, particles, cells, lists, &pass, step.new.drift_velocity);
}

/// Computes the velocities of shifting.
struct Shift<'a> {
    /// w: lambda. Empty if nothing needs it.
    renormalised: &'a [f32x4],
}

impl PairPass for Shift<'_> {
    fn work(job: &mut Job<'_, Self>) {
        by_model::run_one_material_or_general(job);
    }

    #[inline(always)]
    fn group<R: Lanes>(&self, group: &Group<'_>, own: &mut [f32x4]) -> u32 {
        let m = group.setup.model;
        if group.are_walls() {
            own.fill([0.0; 4]);
            return 0;
        }
        let a = group.receivers::<R>();
        let mut drift = if m.shifting == TRANSPORT_VELOCITY { transport(group, a) } else { self.fickian(group, a) };
        if m.has_xsph == 1 {
            drift = xyz(own_numbers::<R>(own)) + drift;
        }
        let vec3 { x, y, z } = if_free(m, flush3(drift), a.wall);
        R::rows([x, y, z, real(0.0)], own);
        0
    }
}

impl Shift<'_> {
    #[inline(always)]
    fn fickian<R: Lanes>(&self, group: &Group<'_>, a: Local<R>) -> vec3<R> {
        let (m, p, t, u) = (group.setup.model, group.setup.parameters, group.setup.tables, group.setup.uniform);
        let none = real::<R>(0.0);
        let [x, y, z, approach2] = fold!(group: R, is zero with itself, |slots| {
            let b = group.neighbours(slots);
            let vec3 { x, y, z } = concentration_gradient(m, p, t, a, b);
            [x, y, z, if m.has_shifting_speed == 0 { approach_squared(m, p, t, a, b) } else { none }]
        });
        let [.., lambda] = group.spread::<R>(self.renormalised);
        let (mut normal, mut repulsion) = ([none; 4], [none; 4]);
        // few particles are near a surface
        if R::any(less(inside_share(lambda), real(1.0))) {
            normal = fold!(group: R, is zero with itself, |slots| {
                let [.., lambda_b] = R::gather(self.renormalised, slots);
                let vec3 { x, y, z } = lambda_gradient(m, p, t, a, group.neighbours(slots), lambda, lambda_b);
                [x, y, z, none]
            });
            repulsion = fold!(group: R, is zero with itself, |slots| {
                let vec3 { x, y, z } = close_repulsion(m, p, t, a, group.neighbours(slots));
                [x, y, z, none]
            });
        }
        let mut concentration = vec3(x, y, z);
        if m.has_closed_walls == 1 {
            concentration = concentration - beyond::of_pressure(group.setup, Front::of(a)).surface;
        }
        fickian_velocity(m, p, u, concentration, xyz(repulsion), approach2, lambda, xyz(normal))
    }
}

#[inline(always)]
fn transport<R: Lanes>(group: &Group<'_>, a: Local<R>) -> vec3<R> {
    let (m, p, t, u) = (group.setup.model, group.setup.parameters, group.setup.tables, group.setup.uniform);
    let none = real::<R>(0.0);
    let sum = fold!(group: R, is zero with itself, |slots| {
        let vec3 { x, y, z } = background_gradient(m, p, t, a, group.neighbours(slots));
        [x, y, z, none]
    });
    let mut sum = xyz(sum);
    if m.has_closed_walls == 1 {
        // beyond the walls particles have the volume of this one
        sum = sum - beyond::of_pressure(group.setup, Front::of(a)).surface * real(2.0);
    }
    transport_velocity(m, p, u, a, sum)
}
