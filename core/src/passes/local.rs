//! What the pair passes read of particles, and how it gets into the lanes.
use super::{Setup, is_wall, kind, load, load_one, row_of};
use crate::arithmetic::real::{Real, real, vec3};
use crate::layout::{Kinds, f32x4};
use crate::terms::pair::{Local, Stiffness};

/// The arrays that pairs are made of.
#[derive(Clone, Copy)]
pub(crate) struct Particles<'a> {
    pub position: &'a [f32x4],
    pub velocity: &'a [f32x4],
    /// Empty where a pass has no use for it.
    pub density_pressure: &'a [f32x4],
    /// Its third numbers are the supports, where they vary.
    pub previous: &'a [f32x4],
}

impl Particles<'_> {
    /// Particles `first ..= last` in the lanes.
    #[inline(always)]
    pub(super) fn receivers<R: Real>(&self, setup: &Setup<'_>, first: usize, last: usize) -> Local<R> {
        let p = setup.parameters;
        let one = real::<R>(1.0);
        let of = |i| load_one::<R>(self.density_pressure, first, last, i);
        let known = !self.density_pressure.is_empty();
        let none = real::<R>(0.0);
        let [deviation, pressure, near_pressure, volume] =
            if known { [of(0), of(1), of(2), of(3)] } else { [none, none, none, none] };
        let row = |rows: &Kinds, i: usize| row_of::<R>(setup.model, rows, self.velocity, first, last, i);
        Local {
            position: load(self.position, first, last),
            velocity: load(self.velocity, first, last),
            support: if setup.model.variable_support == 1 { load_one(self.previous, first, last, 2) } else { one },
            mass: load_one(self.position, first, last, 3),
            deviation,
            pressure,
            near_pressure,
            volume,
            viscosity: row(&p.species, 0),
            wall: row(&p.species, 1),
            rest: row(&p.species, 2),
            fluid: row(&p.species, 3),
            sound: row(&p.states, 2),
            equation: row(&p.states, 3),
            tension: row(&p.corrections, 3),
        }
    }

    /// What closes the density of particles `first ..= last`.
    #[inline(always)]
    pub(super) fn stiffness<R: Real>(&self, setup: &Setup<'_>, first: usize, last: usize) -> Stiffness<R> {
        let p = setup.parameters;
        let row = |rows: &Kinds, i: usize| row_of::<R>(setup.model, rows, self.velocity, first, last, i);
        Stiffness {
            state: row(&p.states, 0),
            near: row(&p.states, 1),
            thinning: row(&p.corrections, 0),
            offset: row(&p.corrections, 1),
            compressibility: row(&p.corrections, 2),
        }
    }

    /// Particle `b` in every lane.
    #[inline(always)]
    pub(super) fn neighbour<R: Real>(&self, setup: &Setup<'_>, b: usize) -> Local<R> {
        let p = setup.parameters;
        let x = self.position[b];
        let v = self.velocity[b];
        let [deviation, pressure, near_pressure, volume] = self.density_pressure.get(b).copied().unwrap_or_default();
        let kind = if setup.model.species == 1 { kind(v[3]) } else { 0 };
        let [viscosity, wall, rest, fluid] = p.species[kind].map(real);
        let [.., sound, equation] = p.states[kind].map(real);
        Local {
            position: vec3::splat(x),
            velocity: vec3::splat(v),
            support: real(if setup.model.variable_support == 1 { self.previous[b][2] } else { 1.0 }),
            mass: real(x[3]),
            deviation: real(deviation),
            pressure: real(pressure),
            near_pressure: real(near_pressure),
            volume: real(volume),
            viscosity,
            wall,
            rest,
            fluid,
            sound,
            equation,
            tension: real(p.corrections[kind][3]),
        }
    }

    /// Are all particles `first ..= last` walls', or air that is not there? Nothing acts on those.
    #[inline(always)]
    pub(super) fn are_walls(&self, setup: &Setup<'_>, first: usize, last: usize) -> bool {
        let held = setup.model.wall_particles != 0 || setup.model.air == 1;
        held && self.velocity[first..=last].iter().all(|v| is_wall(setup.parameters, v[3]))
    }
}
