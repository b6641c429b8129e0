//! What a scene file holds: a scene, how long it runs, and how it is drawn.
use crate::gauge::Gauge;
use millpond_core::scene::Scene;
use serde::{Deserialize, Serialize};

/// A scene, how long it runs, and how it is drawn.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SceneFile {
    /// A one-line description.
    pub about: String,
    /// Default simulated time of a run, s.
    pub duration: f64,
    /// View of the pictures.
    pub camera: Camera,
    /// Quantity that gives the particles their colours.
    pub shade: Shade,
    /// Gauges, which `run --out` records as time series (default none).
    #[serde(default)]
    pub gauges: Vec<Gauge>,
    /// The scene itself.
    pub scene: Scene,
}

/// View of the pictures of a scene.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Camera {
    /// Along the z axis onto the xy plane, without perspective.
    Flat,
    /// In perspective, from a circle around the middle of the scene.
    Orbit {
        /// Rotation about the y axis, degrees.
        yaw_degrees: f32,
        /// Height above the horizon, degrees.
        pitch_degrees: f32,
    },
}

/// Quantity that gives particles their colours. For a number, the values at the two ends of the colour map.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Shade {
    /// Speed, m/s.
    Speed(f32, f32),
    /// Density, kg/m3.
    Density(f32, f32),
    /// The fluid of the particle, in the colour of [`Fluid::colour`](millpond_core::scene::Fluid::colour).
    Fluid,
}
