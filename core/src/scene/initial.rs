//! A particle at the start, of the scene's own blocks or of a host's.
use glam::Vec3;

/// One particle at the start. Its thermal energy is the fluid's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InitialParticle {
    /// Where, m.
    pub position: Vec3,
    /// How fast, m/s; of a wall's, how fast its surface slides.
    pub velocity: Vec3,
    /// Number of its material: that of a fluid is the fluid's own ([`Material`](crate::derive::Material)).
    pub material: u32,
    /// Mass over that of a particle of its fluid at rest.
    pub mass: f32,
    /// Density over the rest density, less one.
    pub deviation: f32,
    /// Pressure, Pa: where a pressure correction begins.
    pub pressure: f32,
}

impl InitialParticle {
    /// A particle of the first fluid, at rest density.
    #[must_use]
    pub fn at(position: impl Into<Vec3>, velocity: impl Into<Vec3>) -> InitialParticle {
        InitialParticle::of_fluid(0, position, velocity)
    }

    /// A particle of a fluid by number, at rest density.
    #[must_use]
    pub fn of_fluid(fluid: u32, position: impl Into<Vec3>, velocity: impl Into<Vec3>) -> InitialParticle {
        let (position, velocity) = (position.into(), velocity.into());
        InitialParticle { position, velocity, material: fluid, mass: 1.0, deviation: 0.0, pressure: 0.0 }
    }
}
