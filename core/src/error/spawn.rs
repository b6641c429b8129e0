//! Errors of adding a particle.
use core::fmt;

/// A particle cannot be added ([`Solver::spawn`](crate::Solver::spawn)). The fluid is as it was.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum SpawnError {
    /// Another particle is nearer than 3/4 of a particle spacing.
    Taken,
    /// No inactive particle is left.
    NoSpare,
    /// The position lies behind a plane of the container.
    BehindPlane,
    /// The position lies in a solid.
    InSolid,
    /// The scene has no particles that can be inactive.
    NotPlanned,
    /// A number is not finite.
    NotFinite,
    /// The life is not larger than 0.
    LifeNotPositive,
    /// The scene has no fluid with this index.
    NoSuchFluid {
        /// The index.
        fluid: u32,
        /// Number of fluids of the scene.
        fluids: u32,
    },
    /// The scene is in 2D, but position or velocity has a component along z.
    OutOfPlane,
    /// The position is too far away for the grid.
    OutOfRange,
}

impl fmt::Display for SpawnError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            SpawnError::Taken => {
                write!(f, "another particle is nearer than 3/4 of a particle_spacing; choose another position")
            }
            SpawnError::NoSpare => {
                write!(f, "no inactive particle is left; increase spare_particles, or remove particles first")
            }
            SpawnError::InSolid => write!(f, "the position lies in a solid"),
            SpawnError::BehindPlane => write!(f, "the position lies behind a plane of the container"),
            SpawnError::NotPlanned => write!(f, "the scene has no spare_particles, emitters or drains; add some"),
            SpawnError::NotFinite => write!(f, "position, velocity and life must be finite numbers"),
            SpawnError::LifeNotPositive => write!(f, "life must be larger than 0; omit it for a particle without end"),
            SpawnError::NoSuchFluid { fluid, fluids } => {
                write!(f, "there is no fluid {fluid}: the scene has {fluids} fluids, counted from 0")
            }
            SpawnError::OutOfPlane => write!(f, "the scene is in 2D, so z must be 0"),
            SpawnError::OutOfRange => write!(f, "the position is too far from the origin of the grid"),
        }
    }
}

impl core::error::Error for SpawnError {}
