//! A particle, as a host sees it.
use crate::derive::material::NOT_THERE;
use crate::layout::{MATERIALS, f32x4};
use crate::solver::Solver;
use glam::Vec3;

/// One particle, as a host sees it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Particle {
    /// Its number for as long as it lives.
    pub id: u32,
    /// m.
    pub position: Vec3,
    /// m/s.
    pub velocity: Vec3,
    /// kg/m3.
    pub density: f32,
    /// Pa.
    pub pressure: f32,
    /// J/kg; 0 where a scene keeps no account of it.
    pub internal_energy: f32,
    /// Does it belong to a wall?
    pub wall: bool,
    /// Is it air that is not there? Nothing else of it then means anything.
    pub inactive: bool,
    /// Number of its fluid; of a wall's, of the one that it is like.
    pub fluid: u32,
    /// Inward normal of its fluid's surface, the gradient of its colour, 1/m; 0 where a scene finds none.
    pub normal: Vec3,
    /// Curvature of the surface, 1/m, positive where the fluid is convex; 0 off the surface, and where no tension needs it.
    pub curvature: f32,
    /// Is it at the surface? (Where a scene finds normals.)
    pub at_surface: bool,
}

impl Solver<'_> {
    /// The particles, in order of their ids.
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
                density: (deviation + 1.0) * self.parameters().rest_density * rest,
                pressure,
                internal_energy: state.internal_energy.get(slot).map_or(0.0, |heat| heat[0]),
                wall: wall > 0.0 && wall < NOT_THERE,
                inactive: wall >= NOT_THERE,
                fluid: fluid as u32,
                normal,
                curvature: if self.plan().model.has_curvature() { state.acceleration[slot][3] } else { 0.0 },
                at_surface: normal.length() > self.parameters().surface_threshold,
            }
        })
    }

    /// The properties of the material of the particle in a slot ([`Materials::properties`]).
    pub(crate) fn properties_of(&self, slot: usize) -> f32x4 {
        let material = self.state().velocity[slot][3] as usize;
        let known = if self.plan().model.has_materials == 1 { material.min(MATERIALS - 1) } else { 0 };
        self.materials().properties[known]
    }

    /// Does the particle in a slot belong to a wall, or is it air that is not there?
    pub(crate) fn is_wall(&self, slot: usize) -> bool {
        self.properties_of(slot)[1] > 0.0
    }
}
