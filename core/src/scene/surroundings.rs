//! What holds a fluid and drives it from outside, and the cells that cover it.
use super::choice::{FACES, Face, GridStructure, Reflection, Traversal};
use glam::Vec3;
use heapless::Vec;

/// Walls of particles that a scene can have.
pub const WALLS: usize = 8;

/// A box with penalty walls (Pirovano, section 3.5.1). Along a periodic axis it has none.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub struct Container {
    /// Lowest corner, m.
    pub low: Vec3,
    /// Highest corner, m.
    pub high: Vec3,
    /// Share of the normal velocity that a wall gives back, 0 to 1 (default 0).
    #[cfg_attr(feature = "serde", serde(default, alias = "bounce"))]
    pub restitution: f32,
    /// Share of the tangential velocity that a wall leaves, 0 (no slip) to 1 (default 1).
    #[cfg_attr(feature = "serde", serde(default = "default_slip"))]
    pub slip: f32,
    /// How much of a bounce is given back (default energy conserving).
    #[cfg_attr(feature = "serde", serde(default))]
    pub reflection: Reflection,
    /// Faces that are not there, such as a lid (Pirovano's direction control; default none missing).
    #[cfg_attr(feature = "serde", serde(default))]
    pub open: Vec<Face, FACES>,
}

#[cfg(feature = "serde")]
fn default_slip() -> f32 {
    1.0
}

impl Container {
    /// A closed box that gives back nothing and lets everything slide.
    #[must_use]
    pub fn closed(low: impl Into<Vec3>, high: impl Into<Vec3>) -> Container {
        let (low, high) = (low.into(), high.into());
        Container { low, high, restitution: 0.0, slip: 1.0, reflection: Reflection::default(), open: Vec::new() }
    }
}

/// A wall made of particles that stand still: neighbours to the fluid in every sum, so that it feels pressure and drag.
/// Two layers with mirrored pressure (Hinsch 2024, section 6.3), three as quasi-fluid (Pirovano, section 3.5.3).
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub struct Wall {
    /// Its shape.
    pub shape: WallShape,
    /// Velocity with which its surface slides past, m/s (default still). The particles themselves stay, as those of a
    /// conveyor belt would be replaced by others.
    #[cfg_attr(feature = "serde", serde(default))]
    pub velocity: Vec3,
    /// Which fluid it is like where it is quasi-fluid: its particles have that one's density (default 0, the first).
    #[cfg_attr(feature = "serde", serde(default))]
    pub fluid: u32,
    /// Dynamic viscosity between it and a particle, Pa s (default the particle's own: no slip; 0: free slip).
    #[cfg_attr(feature = "serde", serde(default))]
    pub dynamic_viscosity: Option<f32>,
}

impl Wall {
    /// One that stands still, of the first fluid's viscosity: no slip.
    #[must_use]
    pub fn still(shape: WallShape) -> Wall {
        Wall { shape, velocity: Vec3::ZERO, fluid: 0, dynamic_viscosity: None }
    }
}

/// Shape of a wall.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub enum WallShape {
    /// A rectangle across an axis; its layers lie behind it.
    Plane {
        /// What it is to the fluid: a floor has the fluid above it, a ceiling below.
        face: Face,
        /// Lowest corner, m.
        low: Vec3,
        /// Highest corner, m; along the face's axis the same as `low`.
        high: Vec3,
    },
    /// A hollow box; its layers lie outside.
    Box {
        /// Lowest corner of the inside, m.
        low: Vec3,
        /// Highest corner of the inside, m.
        high: Vec3,
        /// Faces that are not there (default none missing).
        #[cfg_attr(feature = "serde", serde(default))]
        open: Vec<Face, FACES>,
    },
}

/// A domain that wraps around: what leaves on one side comes back on the other, and sees across.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub struct Periodic {
    /// Lowest corner, m.
    pub low: Vec3,
    /// Highest corner, m.
    pub high: Vec3,
    /// Along x, y, z?
    pub axes: [bool; 3],
}

/// Air that moves past and drags the fluid along (Pirovano, section 2.2.5's `f_other`): `a = drag (velocity - v)`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub struct Wind {
    /// Velocity of the air, m/s.
    pub velocity: Vec3,
    /// Share of the difference in velocity that is lost in a second, 1/s.
    pub drag: f32,
}

/// A lattice of accelerations that the host fills, as often as it likes
/// ([`Solver::set_field`](crate::Solver::set_field)): between its nodes the field is linear, and beyond
/// the outermost it falls to nothing within a spacing.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub struct AccelerationField {
    /// Place of the first node, m.
    pub low: Vec3,
    /// Distance between nodes, m.
    pub spacing: f32,
    /// Nodes along x, y, z, at least 2 each; in 2D the one along z is ignored.
    pub counts: [u32; 3],
}

/// The cells that neighbours are looked up in. They wrap, so the simulated volume is unbounded.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields, default))]
pub struct Grid {
    /// Cells along x, y, z (default 32 each, Pirovano, section 4.2.2). At least 3; in 2D the one along z is ignored, and along a
    /// periodic axis there are as many as fit. With too few, particles that are far apart share cells. That costs
    /// time; it never changes a bit with the full stencil, but does with the half stencil, whose sums follow the cells.
    pub cells: [u32; 3],
    /// How particles get into cells.
    pub structure: GridStructure,
    /// How neighbours are walked (default the full stencil).
    pub traversal: Traversal,
}

impl Default for Grid {
    fn default() -> Self {
        Grid { cells: [32, 32, 32], structure: GridStructure::IndexSort, traversal: Traversal::FullStencil }
    }
}
