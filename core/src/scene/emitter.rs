//! What adds particles to a running scene and takes them out again: emitters and drains.
use glam::Vec3;

/// Largest number of emitters in a scene.
pub const EMITTERS: usize = 8;

/// Largest number of drains in a scene.
pub const DRAINS: usize = 8;

/// An emitter: makes particles of a fluid, one layer after the other, so that a jet of this speed leaves its opening
/// (Pirovano, sections 4.1.4 and 4.1.5).
///
/// The particles of a layer lie on a square lattice across the opening, one particle spacing apart, and layers follow
/// each other at the same distance. A particle is not made where another one is closer than 3/4 of a spacing; it is
/// counted in [`Flux::blocked`](crate::Flux::blocked). Particles come from
/// [`Scene::spare_particles`](super::Scene::spare_particles).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub struct Emitter {
    /// Index of the fluid in [`Scene::fluids`](super::Scene::fluids) (default 0).
    #[cfg_attr(feature = "serde", serde(default))]
    pub fluid: u32,
    /// Centre of the opening, m.
    pub position: Vec3,
    /// Direction of the flow; its length does not matter.
    pub direction: Vec3,
    /// Speed of the flow along the direction, m/s, larger than 0.
    pub speed: f32,
    /// Shape and size of the opening.
    pub opening: Opening,
    /// Angle between the direction and the velocity at the rim of the opening, degrees, 0 to 80
    /// (default 0: a jet). With a larger angle it is a cone of spray, as from a point behind the opening.
    #[cfg_attr(feature = "serde", serde(default))]
    pub spread_degrees: f32,
    /// Time of the first layer, s, 0 or more (default 0).
    #[cfg_attr(feature = "serde", serde(default))]
    pub start: f32,
    /// How long the emitter runs, s, larger than 0 (default `None`: without end).
    #[cfg_attr(feature = "serde", serde(default))]
    pub duration: Option<f32>,
    /// How long each of its particles lives, s, larger than 0 (default `None`: until a drain takes it).
    #[cfg_attr(feature = "serde", serde(default))]
    pub life: Option<f32>,
}

impl Emitter {
    /// Returns a jet of fluid 0 that starts at once and does not end.
    #[must_use]
    pub fn jet(position: impl Into<Vec3>, direction: impl Into<Vec3>, speed: f32, opening: Opening) -> Emitter {
        let (position, direction) = (position.into(), direction.into());
        Emitter {
            fluid: 0,
            position,
            direction,
            speed,
            opening,
            spread_degrees: 0.0,
            start: 0.0,
            duration: None,
            life: None,
        }
    }
}

/// The opening of an emitter. In 2D both are a line across the direction.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Opening {
    /// A square with edges of this length, m.
    Square(f32),
    /// A circle with this diameter, m.
    Circle(f32),
}

impl Opening {
    /// Returns the edge or the diameter, m.
    #[must_use]
    pub fn width(self) -> f32 {
        let (Opening::Square(width) | Opening::Circle(width)) = self;
        width
    }
}

/// A region that takes fluid particles out of the scene. Each is counted in
/// [`Flux::removed`](crate::Flux::removed).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Drain {
    /// A box with this lowest and this highest corner, m.
    Box {
        /// Lowest corner, m.
        low: Vec3,
        /// Highest corner, m; larger than `low` along every axis (in 2D along x and y).
        high: Vec3,
    },
    /// A ball (in 2D a disc), m.
    Ball {
        /// Centre, m.
        centre: Vec3,
        /// Radius, m, larger than 0.
        radius: f32,
    },
}
