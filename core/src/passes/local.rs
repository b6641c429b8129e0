//! What the pair passes read of particles, and how it gets into the lanes.
use super::context::Setup;
use super::lanes::{is_wall, kind, load, load_one, load_scalar, row_of};
use crate::arithmetic::real::{Real, real, vec3};
use crate::layout::{MaterialRows, f32x4};
use crate::terms::pair::{Local, Stiffness};

/// The arrays that pairs are made of.
#[derive(Clone, Copy)]
pub(crate) struct Particles<'a> {
    pub position: &'a [f32x4],
    pub velocity: &'a [f32x4],
    /// Empty where a pass makes it, or has no use for it.
    pub density_pressure: &'a [f32x4],
    /// Empty where supports do not vary.
    pub support: &'a [f32],
}

/// The particles of a step; `but density` without density and pressure, which a pass makes.
///
/// A macro, since a function would borrow the whole of the state, and a pass writes one of its arrays.
macro_rules! particles {
    ($step:ident) => {
        $crate::passes::local::Particles {
            density_pressure: &*$step.new.density_pressure,
            ..$crate::passes::local::particles!($step but density)
        }
    };
    ($step:ident but density) => {
        $crate::passes::local::Particles {
            position: &*$step.new.position,
            velocity: if matches!($step.command, $crate::plan::schedule::Command::RunAgain(_)) {
                &*$step.scratch.end_velocity
            } else {
                &*$step.new.velocity
            },
            density_pressure: &[],
            support: &*$step.scratch.support_ratio,
        }
    };
}
pub(crate) use particles;

impl Particles<'_> {
    /// Particles `first ..= last` in the lanes.
    #[inline(always)]
    pub(crate) fn receivers<R: Real>(&self, setup: &Setup<'_>, first: usize, last: usize) -> Local<R> {
        let materials = setup.materials;
        let of = |i| load_one::<R>(self.density_pressure, first, last, i);
        let known = !self.density_pressure.is_empty();
        let none = real::<R>(0.0);
        let [deviation, pressure, near_pressure, volume] =
            if known { [of(0), of(1), of(2), of(3)] } else { [none, none, none, none] };
        let row = |rows: &MaterialRows, i: usize| row_of::<R>(setup.model, rows, self.velocity, first, last, i);
        Local {
            position: load(self.position, first, last),
            velocity: load(self.velocity, first, last),
            support: self.supports(setup, first, last),
            mass: load_one(self.position, first, last, 3),
            deviation,
            pressure,
            near_pressure,
            volume,
            viscosity: row(&materials.species, 0),
            wall: row(&materials.species, 1),
            rest: row(&materials.species, 2),
            fluid: row(&materials.species, 3),
            sound: row(&materials.states, 2),
            equation: row(&materials.states, 3),
            tension: row(&materials.corrections, 3),
        }
    }

    /// Their support radii, over the scene's.
    #[inline(always)]
    pub(crate) fn supports<R: Real>(&self, setup: &Setup<'_>, first: usize, last: usize) -> R {
        if setup.model.variable_support == 1 { load_scalar(self.support, first, last) } else { real(1.0) }
    }

    /// That of particle `b`, in every lane.
    #[inline(always)]
    pub(crate) fn support_of<R: Real>(&self, setup: &Setup<'_>, b: usize) -> R {
        real(if setup.model.variable_support == 1 { self.support[b] } else { 1.0 })
    }

    /// What closes the density of particles `first ..= last`.
    #[inline(always)]
    pub(crate) fn stiffness<R: Real>(&self, setup: &Setup<'_>, first: usize, last: usize) -> Stiffness<R> {
        let materials = setup.materials;
        let row = |rows: &MaterialRows, i: usize| row_of::<R>(setup.model, rows, self.velocity, first, last, i);
        Stiffness {
            state: row(&materials.states, 0),
            near: row(&materials.states, 1),
            thinning: row(&materials.corrections, 0),
            offset: row(&materials.corrections, 1),
            compressibility: row(&materials.corrections, 2),
        }
    }

    /// Particle `b` in every lane.
    #[inline(always)]
    pub(crate) fn neighbour<R: Real>(&self, setup: &Setup<'_>, b: usize) -> Local<R> {
        let materials = setup.materials;
        let x = self.position[b];
        let v = self.velocity[b];
        let [deviation, pressure, near_pressure, volume] = self.density_pressure.get(b).copied().unwrap_or_default();
        let kind = if setup.model.species == 1 { kind(v[3]) } else { 0 };
        let [viscosity, wall, rest, fluid] = materials.species[kind].map(real);
        let [.., sound, equation] = materials.states[kind].map(real);
        Local {
            position: vec3::splat(x),
            velocity: vec3::splat(v),
            support: self.support_of(setup, b),
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
            tension: real(materials.corrections[kind][3]),
        }
    }

    /// Are all particles `first ..= last` walls', or inactive? Nothing acts on those.
    #[inline(always)]
    pub(crate) fn are_walls(&self, setup: &Setup<'_>, first: usize, last: usize) -> bool {
        let held = setup.model.wall_particles != 0 || setup.model.air == 1;
        held && self.velocity[first..=last].iter().all(|v| is_wall(setup.materials, v[3]))
    }
}
