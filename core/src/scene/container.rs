//! The container of a scene: a box of planes, and its faces.
use glam::Vec3;
use heapless::Vec;

/// A box of planes. The fluid feels them before it comes to them ([`PlaneModel::ClosedForm`]), and a particle that is
/// found behind a plane is put back onto it, and its velocity is reflected (penalty planes; Pirovano, section 3.5.1).
/// There are no planes along a periodic axis, and in 2D none along z.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub struct Container {
    /// Lowest corner, m.
    pub low: Vec3,
    /// Highest corner, m; larger than `low` along every axis.
    pub high: Vec3,
    /// Coefficient of restitution: share of the normal velocity that remains after a reflection, 0 to 1 (default 0, no
    /// bounce).
    #[cfg_attr(feature = "serde", serde(default, alias = "bounce"))]
    pub restitution: f32,
    /// Share of the tangential velocity that remains after a reflection, from 0 (no slip) to 1 (free slip; default 1).
    #[cfg_attr(feature = "serde", serde(default = "default_slip"))]
    pub slip: f32,
    /// Whether the restitution applies in full or in proportion to the depth behind the plane (default in proportion,
    /// which conserves energy).
    #[cfg_attr(feature = "serde", serde(default))]
    pub reflection: Reflection,
    /// Faces without a plane, such as the lid (Pirovano's direction control; default none).
    #[cfg_attr(feature = "serde", serde(default))]
    pub open: Vec<Face, FACES>,
    /// How the fluid feels the planes before it comes to them (default as walls in closed form).
    #[cfg_attr(feature = "serde", serde(default))]
    pub model: PlaneModel,
    /// Dynamic viscosity between a plane and a fluid particle, Pa s, 0 or more (default `None`: that of the fluid
    /// particle, which means no slip; 0 means free slip). Only with [`PlaneModel::ClosedForm`]. With
    /// [`Viscosity::Artificial`](super::Viscosity::Artificial) and
    /// [`Viscosity::VelocityExchange`](super::Viscosity::VelocityExchange) the planes have free slip.
    #[cfg_attr(feature = "serde", serde(default))]
    pub dynamic_viscosity: Option<f32>,
    /// Faces that slide, as if they were endless conveyor belts (default none). Only with [`PlaneModel::ClosedForm`].
    #[cfg_attr(feature = "serde", serde(default))]
    pub sliding: Vec<Sliding, FACES>,
}

/// A face of the container that slides.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub struct Sliding {
    /// The face.
    pub face: Face,
    /// Its velocity, m/s. The component along the normal of the face must be 0.
    pub velocity: Vec3,
}

#[cfg(feature = "serde")]
fn default_slip() -> f32 {
    1.0
}

impl Container {
    /// Returns a closed box without bounce and with free slip.
    #[must_use]
    pub fn closed(low: impl Into<Vec3>, high: impl Into<Vec3>) -> Container {
        let (low, high) = (low.into(), high.into());
        Container {
            low,
            high,
            restitution: 0.0,
            slip: 1.0,
            reflection: Reflection::default(),
            open: Vec::new(),
            model: PlaneModel::default(),
            dynamic_viscosity: None,
            sliding: Vec::new(),
        }
    }
}

/// How much of the normal velocity a container wall returns to a particle that it reflects.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Reflection {
    /// The full [`restitution`](super::Container::restitution), however far the particle came behind the wall.
    Full = 0,
    /// The restitution times the share of the step's path that lay behind the wall, `depth / (|v| dt)`, at most 1
    /// (Kelager 2006; Pirovano, figure 3.8). This keeps a reflection from adding energy (default).
    #[default]
    EnergyConserving = 1,
}

/// How the fluid feels the planes of a container.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[repr(u32)]
pub enum PlaneModel {
    /// Not before a particle is behind a plane. Sums near a plane miss what lies beyond it.
    Penalty = 0,
    /// As a wall in closed form: the part of the kernel that lies beyond the planes completes density, pressure force
    /// and friction, as if the fluid went on there with the pressure that its weight gives it (Kulasegaram et al. 2004;
    /// Ferrand et al. 2013; default). It needs no wall particles.
    #[default]
    ClosedForm = 1,
}

/// Number of faces of a box.
pub const FACES: usize = 6;

/// A face of a box, named as seen from its inside.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Face {
    /// Lowest x.
    Left,
    /// Highest x.
    Right,
    /// Lowest y.
    Floor,
    /// Highest y.
    Ceiling,
    /// Lowest z.
    Back,
    /// Highest z.
    Front,
}

impl Face {
    /// All faces: low and high along x, then y, then z.
    pub const ALL: [Face; FACES] = [Face::Left, Face::Right, Face::Floor, Face::Ceiling, Face::Back, Face::Front];

    /// Returns the axis of the face's normal: 0, 1, 2 for x, y, z.
    #[must_use]
    pub fn axis(self) -> usize {
        self as usize / 2
    }

    /// Returns whether the face is the high one of its axis.
    #[must_use]
    pub fn is_high(self) -> bool {
        self as usize % 2 == 1
    }
}
