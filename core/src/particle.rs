//! A particle, as a program that uses the solver sees it.
use crate::derive::material::INACTIVE_ROLE;
use crate::layout::{MATERIALS, f32x4};
use crate::solver::Solver;
use glam::Vec3;

/// A particle, in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Particle {
    /// The particle's number, which it keeps for as long as it lives.
    pub id: u32,
    /// Position, m.
    pub position: Vec3,
    /// Velocity, m/s.
    pub velocity: Vec3,
    /// Mass, kg (per metre of depth in 2D).
    pub mass: f32,
    /// Density, kg/m3.
    pub density: f32,
    /// Pressure, Pa.
    pub pressure: f32,
    /// Internal energy, J/kg; 0 unless the scene asks for it
    /// ([`Formulation::internal_energy`](crate::scene::Formulation)).
    pub internal_energy: f32,
    /// Whether the particle belongs to a wall.
    pub is_wall: bool,
    /// Whether the particle is an inactive one of the air layer. Nothing else about it means anything then.
    pub is_inactive: bool,
    /// Number of its fluid in [`Scene::fluids`](crate::scene::Scene::fluids); of a wall particle the fluid that the
    /// wall behaves like.
    pub fluid: u32,
    /// Inward normal of the fluid's surface, the gradient of its colour, 1/m; 0 unless the scene finds normals.
    pub normal: Vec3,
    /// Curvature of the surface, 1/m, positive where the fluid is convex; 0 away from the surface, and unless the
    /// surface tension needs it.
    pub curvature: f32,
    /// Whether the particle is at the surface, where the scene finds normals.
    pub is_at_surface: bool,
}

impl Solver<'_> {
    /// Returns all particles in the order of their ids: those of fluids, then those of walls, then those of the air
    /// layer, inactive ones included.
    pub fn particles(&self) -> impl ExactSizeIterator<Item = Particle> {
        let state = self.state();
        let vector = |[x, y, z, _]: f32x4| Vec3::new(x, y, z);
        self.slots().iter().enumerate().map(move |(id, &slot)| {
            let slot = slot as usize;
            let [deviation, pressure, ..] = state.density_pressure[slot];
            let (position, velocity) = (vector(state.position[slot]), vector(state.velocity[slot]));
            let [_, wall, rest, fluid] = self.properties_of(slot);
            let normal = state.normal.get(slot).map_or(Vec3::ZERO, |&normal| vector(normal));
            Particle {
                id: id as u32,
                position,
                velocity,
                mass: state.position[slot][3] * self.parameters().particle_mass * rest,
                density: (deviation + 1.0) * self.parameters().rest_density * rest,
                pressure,
                internal_energy: state.internal_energy.get(slot).map_or(0.0, |heat| heat[0]),
                is_wall: wall > 0.0 && wall < INACTIVE_ROLE,
                is_inactive: wall >= INACTIVE_ROLE,
                fluid: fluid as u32,
                normal,
                curvature: if self.plan().model.has_curvature() { state.acceleration[slot][3] } else { 0.0 },
                is_at_surface: normal.length() > self.parameters().surface_threshold,
            }
        })
    }

    /// Returns the positions of the particles of all fluids in the order of their ids, without walls and inactive
    /// particles: what a renderer draws. [`Solver::state`] has the same numbers as `[f32; 4]`, for all particles in the
    /// order in which they lie in memory.
    pub fn fluid_positions(&self) -> impl Iterator<Item = Vec3> {
        let position = &self.state().position;
        let fluid = self.slots().iter().map(|&slot| slot as usize).filter(|&slot| !self.is_wall(slot));
        fluid.map(|slot| Vec3::new(position[slot][0], position[slot][1], position[slot][2]))
    }

    /// The properties of the material of the particle in a slot ([`Materials::properties`]).
    pub(crate) fn properties_of(&self, slot: usize) -> f32x4 {
        let material = self.state().velocity[slot][3] as usize;
        let known = if self.plan().model.has_materials == 1 { material.min(MATERIALS - 1) } else { 0 };
        self.materials().properties[known]
    }

    /// Whether the particle in a slot belongs to a wall or is inactive.
    pub(crate) fn is_wall(&self, slot: usize) -> bool {
        self.properties_of(slot)[1] > 0.0
    }
}
