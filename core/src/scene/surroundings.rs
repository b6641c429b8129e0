//! Walls of particles, periodic domain, wind and acceleration field of a scene.
use super::container::{FACES, Face};
use glam::Vec3;
use heapless::Vec;

/// Largest number of walls in a scene.
pub const WALLS: usize = 8;

/// A wall of fixed particles. They are neighbours of the fluid particles in every sum, so the wall exerts pressure and
/// viscous drag. It has as many layers as the support radius reaches: with mirrored pressure at least two (Hinsch 2024,
/// section 6.3), as dynamic boundary particles at least three (Pirovano, section 3.5.3).
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub struct Wall {
    /// Shape of the wall.
    pub shape: WallShape,
    /// Velocity with which the wall's surface slides, m/s (default 0). The particles themselves do not move, as if the
    /// wall were an endless conveyor belt. The component along the normal of a plane must be 0.
    #[cfg_attr(feature = "serde", serde(default))]
    pub velocity: Vec3,
    /// Index of the fluid whose density the wall particles have (default 0). It matters with
    /// [`WallPressure::Dynamic`](super::WallPressure::Dynamic); with
    /// [`WallPressure::Extrapolated`](super::WallPressure::Extrapolated) its equation of state turns the pressure of
    /// the wall into a density.
    #[cfg_attr(feature = "serde", serde(default))]
    pub fluid: u32,
    /// Dynamic viscosity between the wall and a fluid particle, Pa s, 0 or more (default `None`: that of the fluid
    /// particle, which means no slip; 0 means free slip, also with
    /// [`Viscosity::Artificial`](super::Viscosity::Artificial), which does not use the value otherwise).
    #[cfg_attr(feature = "serde", serde(default))]
    pub dynamic_viscosity: Option<f32>,
}

impl Wall {
    /// Returns a wall at rest with the defaults: no slip, and the density of the first fluid.
    #[must_use]
    pub fn still(shape: WallShape) -> Wall {
        Wall { shape, velocity: Vec3::ZERO, fluid: 0, dynamic_viscosity: None }
    }
}

/// Shape of a wall.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub enum WallShape {
    /// A rectangle perpendicular to an axis. The layers of particles lie behind it, on the side away from the fluid.
    Plane {
        /// Face of the fluid's space that the rectangle forms: a floor has the fluid above it, a ceiling below it.
        face: Face,
        /// Lowest corner, m.
        low: Vec3,
        /// Highest corner, m. It equals `low` along the axis of the face; along the other axes the extent is rounded
        /// to whole particle spacings, at least one.
        high: Vec3,
    },
    /// A hollow box. The layers of particles lie outside of it.
    Box {
        /// Lowest corner of the inside, m.
        low: Vec3,
        /// Highest corner of the inside, m. The extents are rounded to whole particle spacings, at least one.
        high: Vec3,
        /// Faces without particles (default none).
        #[cfg_attr(feature = "serde", serde(default))]
        open: Vec<Face, FACES>,
    },
}

/// A periodic domain: particles that leave it on one side enter on the opposite side, and neighbours are found across
/// the boundary.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub struct Periodic {
    /// Lowest corner, m.
    pub low: Vec3,
    /// Highest corner, m. Along a periodic axis the extent must hold at least 3 cells of the grid, a cell being a
    /// little longer than the support radius, and every block and wall must fit into it.
    pub high: Vec3,
    /// Whether the domain is periodic along x, y and z. Along the other axes `low` and `high` are ignored.
    pub axes: [bool; 3],
}

/// A wind that drags the fluid along with the acceleration `drag (velocity - v)` (`f_other` of Pirovano, section
/// 2.2.5).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub struct Wind {
    /// Velocity of the wind, m/s. In 2D its z component must be 0.
    pub velocity: Vec3,
    /// Drag coefficient, 1/s, 0 or more: acceleration per difference of velocity.
    pub drag: f32,
}

/// Lattice of an acceleration field supplied by the caller, who may set it before any step
/// ([`Solver::set_acceleration_field`](crate::Solver::set_acceleration_field); 0 until then). Between the nodes the
/// field is interpolated linearly; beyond the outermost nodes it falls to 0 within one spacing.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub struct AccelerationField {
    /// Position of the first node, m.
    pub low: Vec3,
    /// Distance between nodes, m, larger than 0.
    pub spacing: f32,
    /// Number of nodes along x, y, z: at least 2 each, at most 2^22 in all (64 MiB). In 2D the number along z is
    /// ignored.
    pub counts: [u32; 3],
}
