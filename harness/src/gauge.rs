//! A gauge of a scene: a quantity at a chosen place.
use glam::Vec3;
use millpond_core::Solver;
use millpond_core::scene::{Face, Scene};
use serde::{Deserialize, Serialize};

/// A gauge of a scene file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Gauge {
    /// Its name in tables.
    pub name: String,
    /// What it measures, and where.
    pub measures: Measures,
}

/// What a gauge measures. Positions are in m.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Measures {
    /// Pressure at a point, Pa; 0 where there is no fluid. It is the same at every kind of wall
    /// ([`millpond_core::Neighbours::sample`]).
    Pressure(Vec3),
    /// Velocity at a point, m/s; 0 where there is no fluid.
    Velocity(Vec3),
    /// Height of the fluid's surface above a point, against gravity, m; 0 where there is none. The point should be a
    /// support radius away from walls.
    Level(Vec3),
    /// Force of the fluid on a wall of particles, N (per metre of depth in 2D), by its index in `walls`.
    ForceOnWall(u32),
    /// Force of the fluid on a face of the container, if its walls are in closed form, N (per metre of depth in 2D).
    ForceOnFace(Face),
}

impl Measures {
    /// The point at which it measures, if it has one.
    pub fn point_mut(&mut self) -> Option<&mut Vec3> {
        match self {
            Measures::Pressure(point) | Measures::Velocity(point) | Measures::Level(point) => Some(point),
            Measures::ForceOnWall(_) | Measures::ForceOnFace(_) => None,
        }
    }

    /// Returns the unit, and the names of the components of a vector.
    pub(crate) fn unit(self) -> (&'static str, &'static [&'static str]) {
        match self {
            Measures::Pressure(_) => ("Pa", &[""]),
            Measures::Velocity(_) => ("m/s", &[" x", " y", " z"]),
            Measures::Level(_) => ("m", &[""]),
            Measures::ForceOnWall(_) | Measures::ForceOnFace(_) => ("N", &[" x", " y", " z"]),
        }
    }

    /// Measures the present state.
    pub(crate) fn read(self, scene: &Scene, solver: &mut Solver<'_>) -> Vec<f32> {
        let neighbours = solver.neighbours();
        match self {
            Measures::Pressure(at) => vec![neighbours.sample(at).map_or(0.0, |there| there.pressure)],
            Measures::Velocity(at) => {
                neighbours.sample(at).map_or(Vec3::ZERO, |there| there.velocity).to_array().to_vec()
            }
            Measures::Level(above) => vec![neighbours.level(above, -scene.gravity).unwrap_or(0.0)],
            Measures::ForceOnWall(wall) => neighbours.force_on_wall(wall as usize).to_array().to_vec(),
            Measures::ForceOnFace(face) => neighbours.force_on_face(face).to_array().to_vec(),
        }
    }
}
