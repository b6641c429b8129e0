//! A particle at the start, created from the blocks and walls of the scene or given by the caller.
use glam::Vec3;

/// One particle at the start. Its internal energy is that of its fluid
/// ([`Fluid::internal_energy`](super::Fluid::internal_energy)).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InitialParticle {
    /// Position, m. In 2D z must be 0.
    pub position: Vec3,
    /// Velocity, m/s; for a wall particle the velocity with which the wall's surface slides. In 2D z must be 0.
    pub velocity: Vec3,
    /// Number of its material. The material of a fluid has the fluid's number; blocks with a viscosity of their own,
    /// walls and inactive air have higher ones, which
    /// [`Checked::initial_particles`](crate::Checked::initial_particles) shows.
    pub material: u32,
    /// Mass over the mass of a particle of its fluid at rest, larger than 0. It must be 1 unless the plan supports
    /// other masses ([`Formulation::initialize_hydrostatic`](super::Formulation::initialize_hydrostatic), or a plan of
    /// everything).
    pub mass: f32,
    /// Deviation of its density from the rest density, `rho / rho0 - 1`.
    pub deviation: f32,
    /// Pressure, Pa, from which a pressure correction starts.
    pub pressure: f32,
}

impl InitialParticle {
    /// Returns a particle of the first fluid with its rest density.
    #[must_use]
    pub fn at(position: impl Into<Vec3>, velocity: impl Into<Vec3>) -> InitialParticle {
        InitialParticle::of_fluid(0, position, velocity)
    }

    /// Returns a particle of the fluid with this number, with the fluid's rest density.
    #[must_use]
    pub fn of_fluid(fluid: u32, position: impl Into<Vec3>, velocity: impl Into<Vec3>) -> InitialParticle {
        let (position, velocity) = (position.into(), velocity.into());
        InitialParticle { position, velocity, material: fluid, mass: 1.0, deviation: 0.0, pressure: 0.0 }
    }
}
