//! Solids: what the fluid flows around, or what it lies in.
use glam::{Quat, Vec2, Vec3};
use heapless::Vec;

/// Largest number of solids in a scene.
pub const SOLIDS: usize = 16;

/// Largest number of corners of a polygon.
pub const CORNERS: usize = 16;

/// A solid: an obstacle in the fluid or, if it is `hollow`, a container around it. It is at rest, or it moves as the scene
/// prescribes or as the host program says.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub struct Solid {
    /// Shape, in a frame of its own, whose origin is the centre of the shape.
    pub shape: Shape,
    /// Whether the fluid is inside of the shape (default false: it is outside).
    #[cfg_attr(feature = "serde", serde(default))]
    pub hollow: bool,
    /// Position of the origin of the shape at the start, m (default 0).
    #[cfg_attr(feature = "serde", serde(default))]
    pub position: Vec3,
    /// Rotation of the shape at the start, as a unit quaternion (x, y, z, w; default none). In a scene file
    /// `turned: (0, 0, 30)` is easier to write.
    #[cfg_attr(feature = "serde", serde(default))]
    pub rotation: Quat,
    /// Rotation of the shape at the start by angles about x, then y, then z, degrees, which follows `rotation` (default
    /// 0).
    #[cfg_attr(feature = "serde", serde(default))]
    pub turned: Vec3,
    /// How it moves (default: it does not).
    #[cfg_attr(feature = "serde", serde(default))]
    pub motion: Motion,
    /// How the fluid feels it before it comes to it (default in closed form).
    #[cfg_attr(feature = "serde", serde(default))]
    pub model: SolidModel,
    /// Share of the normal velocity that remains after a reflection, 0 to 1 (default 0, no bounce). The share counts in
    /// proportion to the part of the path that lay behind the surface, as with
    /// [`Reflection::EnergyConserving`](super::Reflection::EnergyConserving).
    #[cfg_attr(feature = "serde", serde(default))]
    pub restitution: f32,
    /// Share of the tangential velocity, relative to the surface, that remains after a reflection, from 0 (no slip) to 1
    /// (free slip; default 1).
    #[cfg_attr(feature = "serde", serde(default = "free_slip"))]
    pub slip: f32,
    /// Dynamic viscosity between the solid and a fluid particle, Pa s, 0 or more (default `None`: that of the fluid
    /// particle, which means no slip; 0 means free slip). Only with [`SolidModel::ClosedForm`] and
    /// [`SolidModel::Particles`].
    #[cfg_attr(feature = "serde", serde(default))]
    pub dynamic_viscosity: Option<f32>,
    /// Strength of the repulsion, m2/s2, 0 or more (default 1). Only with [`SolidModel::Repulsion`]. To
    /// hold a column of water of the height h it needs to be about g h.
    #[cfg_attr(feature = "serde", serde(default = "usual_repulsion"))]
    pub repulsion: f32,
    /// Index of the fluid whose density the particles of the solid have (default 0). Only with
    /// [`SolidModel::Particles`].
    #[cfg_attr(feature = "serde", serde(default))]
    pub fluid: u32,
}

#[cfg(feature = "serde")]
fn free_slip() -> f32 {
    1.0
}

#[cfg(feature = "serde")]
fn usual_repulsion() -> f32 {
    1.0
}

impl Solid {
    /// Returns a solid at rest, in closed form, whose centre is at `position`.
    #[must_use]
    pub fn still(shape: Shape, position: impl Into<Vec3>) -> Solid {
        Solid {
            shape,
            hollow: false,
            position: position.into(),
            rotation: Quat::IDENTITY,
            turned: Vec3::ZERO,
            motion: Motion::Still,
            model: SolidModel::default(),
            restitution: 0.0,
            slip: 1.0,
            dynamic_viscosity: None,
            repulsion: 1.0,
            fluid: 0,
        }
    }

    /// Returns whether it has particles that move with it.
    pub(crate) fn carries(&self) -> bool {
        self.model == SolidModel::Particles && self.motion != Motion::Still
    }

    /// Returns the same solid with the fluid inside of it.
    #[must_use]
    pub fn hollow(self) -> Solid {
        Solid { hollow: true, ..self }
    }
}

/// Shape of a solid.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub enum Shape {
    /// The half space below y = 0.
    Plane,
    /// A ball; in 2D a disc.
    Ball {
        /// Radius, m.
        radius: f32,
    },
    /// A box; in 2D a rectangle, whose z does not matter.
    Box {
        /// Lengths of its edges, m.
        size: Vec3,
    },
    /// A cylinder with its axis along y (3D only).
    Cylinder {
        /// Radius, m.
        radius: f32,
        /// Height, m.
        height: f32,
    },
    /// All points within a distance from a line along y.
    Capsule {
        /// The distance, m.
        radius: f32,
        /// Length of the line, m.
        length: f32,
    },
    /// A flat sheet without thickness that stops what comes from above, and lets pass what comes from below: an open
    /// polygon with one side (Roy). It is a trapezoid in the plane of x and z, and in 2D a line along x. Several of
    /// them form a funnel. Only with [`SolidModel::Penalty`] and [`SolidModel::Repulsion`].
    Facet {
        /// Length along z, m; ignored in 2D.
        length: f32,
        /// Width along x at the lower end of z, m; in 2D its width.
        near: f32,
        /// Width along x at the upper end of z, m; ignored in 2D.
        far: f32,
    },
    /// A polygon in the plane of x and y, whose sides do not cross (2D only). All polygons of a scene have at most 64
    /// sides.
    Polygon {
        /// Its corners, counterclockwise, m.
        corners: Vec<Vec2, CORNERS>,
    },
}

/// How the fluid feels a solid.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[repr(u32)]
pub enum SolidModel {
    /// Not before a particle is inside: it is then put back, and its velocity is reflected (Pirovano, section 3.5.1).
    /// Sums near the surface miss what lies beyond it.
    Penalty = 0,
    /// In closed form: the part of the kernel that lies beyond the surface completes density, pressure force and
    /// friction, as with [`PlaneModel::ClosedForm`](super::PlaneModel::ClosedForm) (default). It takes account of
    /// curved surfaces and of the edges of boxes; at the corners of a polygon it takes the nearest side as a plane.
    #[default]
    ClosedForm = 1,
    /// As particles inside of the surface, whose pressure is chosen by
    /// [`Formulation::wall_pressure`](super::Formulation::wall_pressure).
    Particles = 2,
    /// It repels what comes near, the more the nearer, with the acceleration `repulsion (1 / d - 1 / H)` at the distance
    /// d, where H is the support radius (Roy). What comes inside all the same is treated as with `Penalty`.
    Repulsion = 3,
}

/// How a solid moves.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Motion {
    /// It does not.
    #[default]
    Still,
    /// As a function of time.
    Prescribed(Course),
    /// With the velocity that the host program has set last: [`Solver::move_solid`](crate::Solver::move_solid).
    Driven,
}

/// A motion as a function of the time t. With the phase of the oscillation `s = sin(360 deg (frequency t + phase))` the
/// position is `start + velocity t + amplitude s`, and the angle about the axis is
/// `360 deg turns_per_second t + rocking_degrees s`. The sine is accurate to 2e-7, and its phase to 1e-7 of the number
/// of periods so far.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default, deny_unknown_fields))]
pub struct Course {
    /// Constant part of the velocity, m/s (default 0).
    pub velocity: Vec3,
    /// Amplitude of the oscillation, m (default 0).
    pub amplitude: Vec3,
    /// Frequency of the oscillation, 1/s (default 0).
    pub frequency: f32,
    /// Phase of the oscillation at the start, in periods, 0 to 1 (default 0).
    pub phase: f32,
    /// Axis of the rotation through the origin of the shape; its length does not matter. In 2D it is along z (default:
    /// no rotation).
    pub axis: Vec3,
    /// Constant part of the rotation, turns per second (default 0).
    pub turns_per_second: f32,
    /// Amplitude of the angle, degrees (default 0).
    pub rocking_degrees: f32,
}
