//! What the pair passes read of particles, and how it gets into the lanes.
use super::{Setup, kind, load, load_one};
use crate::arithmetic::real::{Real, real, vec3};
use crate::layout::f32x4;
use crate::terms::pair::Local;

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
        let (viscosity, wall) = if setup.model.species == 1 {
            let kind = |lane: usize| kind(p, self.velocity[(first + lane).min(last)][3]);
            (R::from_lanes(|lane| kind(lane)[0]), R::from_lanes(|lane| kind(lane)[1]))
        } else {
            (real(p.species[0][0]), real(0.0))
        };
        Local {
            position: load(self.position, first, last),
            velocity: load(self.velocity, first, last),
            support: if setup.model.variable_support == 1 { load_one(self.previous, first, last, 2) } else { one },
            mass: load_one(self.position, first, last, 3),
            deviation,
            pressure,
            near_pressure,
            volume,
            viscosity,
            wall,
        }
    }

    /// Particle `b` in every lane.
    #[inline(always)]
    pub(super) fn neighbour<R: Real>(&self, setup: &Setup<'_>, b: usize) -> Local<R> {
        let p = setup.parameters;
        let x = self.position[b];
        let v = self.velocity[b];
        let [deviation, pressure, near_pressure, volume] = self.density_pressure.get(b).copied().unwrap_or_default();
        let [viscosity, wall, ..] = if setup.model.species == 1 { kind(p, v[3]) } else { p.species[0] };
        Local {
            position: vec3::splat(x),
            velocity: vec3::splat(v),
            support: real(if setup.model.variable_support == 1 { self.previous[b][2] } else { 1.0 }),
            mass: real(x[3]),
            deviation: real(deviation),
            pressure: real(pressure),
            near_pressure: real(near_pressure),
            volume: real(volume),
            viscosity: real(viscosity),
            wall: real(wall),
        }
    }

    /// Are all particles `first ..= last` walls'? Nothing acts on those.
    #[inline(always)]
    pub(super) fn are_walls(&self, setup: &Setup<'_>, first: usize, last: usize) -> bool {
        setup.model.wall_particles != 0
            && self.velocity[first..=last].iter().all(|v| kind(setup.parameters, v[3])[1] > 0.0)
    }
}
