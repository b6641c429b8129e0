//! Computes the acceleration of each particle by pressure, viscosity and external forces. Where pressure is iterated
//! later, pressure is left out.
use crate::arithmetic::lanes::{Lanes, xyz};
use crate::arithmetic::real::{div, real, vec3};
use crate::layout::f32x4;
use crate::passes::beyond::{self, Front};
use crate::passes::by_model;
use crate::passes::context::{Setup, Step};
use crate::passes::field;
use crate::passes::group::{Group, fold};
use crate::passes::half_stencil;
use crate::passes::lists::GROUP;
use crate::passes::local::{own_numbers, particles};
use crate::passes::pairs::{self, Job, PairPass, cells, lists};
use crate::solids::{Solid, solids};
use crate::terms::beyond::{completed3, wall_push, wall_rub};
use crate::terms::exchange::{exchange_close, exchange_neighbour, exchange_share};
use crate::terms::external::{external_close, weight};
use crate::terms::neighbour::{acceleration_close, force_neighbour};
use crate::terms::pair::{Local, density_ratio};
use crate::terms::shifting::pressure_without_tension;
use crate::terms::viscosity::has_friction;
use crate::terms::wall::{EXTRAPOLATED, if_free};

/// Fills the accelerations, or those without pressure where pressure is iterated.
pub(crate) fn run(step: &mut Step<'_, '_>) {
    let (mut particles, cells, lists) = (particles!(step), cells!(step), lists!(step));
    if step.setup.model.wall_particles == EXTRAPOLATED {
        particles.velocity = step.scratch.seen_velocity;
    }
    let corrects = step.setup.model.corrects_pressure();
    let out = if corrects { &mut *step.scratch.non_pressure_acceleration } else { &mut *step.new.acceleration };
    if step.setup.model.is_half_stencil == 1 {
        half_stencil::force::sum_once(step.setup, step.executor, particles, cells, out);
        pairs::run(step.setup, step.executor, particles, cells, lists, &Summed, out);
    } else {
        let pass = Force { renormalised: step.scratch.renormalised_gradient };
        pairs::run(step.setup, step.executor, particles, cells, lists, &pass, out);
    }
}

/// Computes the acceleration of each particle.
struct Force<'a> {
    /// w: lambda. Empty if nothing needs it.
    renormalised: &'a [f32x4],
}

impl PairPass for Force<'_> {
    fn work(job: &mut Job<'_, Self>) {
        by_model::run(job);
    }

    #[inline(always)]
    fn group<R: Lanes>(&self, group: &Group<'_>, own: &mut [f32x4]) -> u32 {
        let setup = group.setup;
        let (m, p, t) = (setup.model, setup.parameters, setup.tables);
        if group.are_walls() {
            own.fill([0.0; 4]);
            return 0;
        }
        let a = group.receivers::<R>();
        let mut acting = a;
        if m.has_tensile_control == 1 {
            let [.., lambda] = group.spread(self.renormalised);
            acting.pressure = pressure_without_tension(a.pressure, lambda);
        }
        let none = real::<R>(0.0);
        let force = fold!(group: R, is zero with itself, |slots| {
            let vec3 { x, y, z } = force_neighbour(m, p, t, acting, group.neighbours(slots));
            [x, y, z, none]
        });
        close(group, a, acting.pressure, xyz(force), own);
        0
    }
}

/// Computes the acceleration from the summed force density, the exchange of velocities, walls in closed form and
/// external forces. `acting` is the pressure with which the particle entered the sum.
#[inline(always)]
fn close<R: Lanes>(group: &Group<'_>, a: Local<R>, acting: R, force: vec3<R>, own: &mut [f32x4]) {
    let setup = group.setup;
    let (m, p, u) = (setup.model, setup.parameters, setup.uniform);
    let mut internal = acceleration_close(m, p, force, a);
    let none = real(0.0);
    let mut field = vec3(none, none, none);
    if m.has_acceleration_field == 1 {
        field = field::at(setup, a.position);
    }
    if m.has_closed_walls == 1 {
        let beyond = beyond::of_pressure(setup, Front::of(a));
        if !m.corrects_pressure() {
            let g = weight(m, p, u, density_ratio(m, a.deviation, a.rest_ratio)) + field;
            internal = internal + wall_push(m, p, a, acting, beyond, g);
        }
        if has_friction(m) {
            internal = internal + wall_rub(m, p, a, beyond);
        }
        internal = completed3(internal, beyond.gamma);
    }
    if m.has_repulsion == 1 {
        internal = internal + repelled(setup, a.position);
    }
    if m.has_velocity_exchange == 1 {
        let [x, y, z, shares] = fold!(group: R, is zero with itself, |slots| {
            let b = group.neighbours(slots);
            let vec3 { x, y, z } = exchange_neighbour(m, p, a, b);
            [x, y, z, exchange_share(m, p, a, b)]
        });
        internal = internal + vec3(x, y, z) * exchange_close(u, shares);
    }
    if m.has_acceleration_field == 1 {
        internal = internal + field;
    }
    let acceleration = external_close(m, p, u, internal, a.velocity, density_ratio(m, a.deviation, a.rest_ratio));
    let vec3 { x, y, z } = if_free(m, acceleration, a.wall);
    R::rows([x, y, z, real(0.0)], own);
}

/// Returns the acceleration with which the solids that repel act on the receivers.
#[inline(never)]
fn repelled<R: Lanes>(setup: &Setup<'_>, position: vec3<R>) -> vec3<R> {
    let mut each = [vec3(0.0, 0.0, 0.0); GROUP];
    for (receiver, own) in each.iter_mut().enumerate().take(R::RECEIVERS) {
        let lane = receiver * R::NEIGHBOURS;
        let place = vec3(position.x.lane(lane), position.y.lane(lane), position.z.lane(lane));
        let all = solids(setup.model, setup.parameters, setup.poses).filter(Solid::repels);
        *own = all.fold(*own, |sum, solid| sum + solid.repulsion(place));
    }
    let along = |axis: fn(vec3<f32>) -> f32| R::from_lanes(|lane| axis(each[lane / R::NEIGHBOURS]));
    vec3(along(|v| v.x), along(|v| v.y), along(|v| v.z))
}

/// Computes the same accelerations with the half stencil: the forces are summed already, and stand in the entries that
/// the results go to.
struct Summed;

impl PairPass for Summed {
    fn work(job: &mut Job<'_, Self>) {
        by_model::run_general(job);
    }

    #[inline(always)]
    fn group<R: Lanes>(&self, group: &Group<'_>, own: &mut [f32x4]) -> u32 {
        let a = group.receivers::<R>();
        let one = real::<R>(1.0);
        close(group, a, a.pressure, xyz(own_numbers::<R>(own)) * div(one, a.volume), own);
        0
    }
}
