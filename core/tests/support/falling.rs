//! A falling block with an adaptive time step, for tests of the CPU and of a device.
use super::forms::wendland;
use millpond_core::backend::derive::support_radius;
use millpond_core::glam::Vec3;
use millpond_core::scene::{AdaptiveTimeStep, Block, Container, Dimension, Fluid, Grid, PlaneModel, Scene};

/// Returns a block that falls onto a floor: it moves slowly, then fast, and then hits hard.
pub fn falling() -> Scene {
    let fluid = Fluid { speed_of_sound: 20.0, dynamic_viscosity: 2.0, ..Fluid::default() };
    let block = Block {
        corner: Vec3::new(0.2, 0.02, 0.0),
        size: Vec3::new(0.3, 0.3, 0.0),
        velocity: Vec3::new(0.0, -2.0, 0.0),
        ..Block::default()
    };
    let mut scene = Scene::of(Dimension::Two, 0.025, 1e-3, fluid, block);
    scene.gravity = Vec3::new(0.0, -9.81, 0.0);
    scene.container = Some(Container { model: PlaneModel::Penalty, ..Container::closed([0.0; 3], [0.7, 0.7, 0.0]) });
    scene.grid = Grid { cells: [12, 12, 1], ..Grid::default() };
    scene.model = wendland();
    scene.adaptive = Some(AdaptiveTimeStep::default());
    scene
}

/// Returns the falling block with a criterion that tightens at the impact by more than a step may exceed it, so that
/// steps are rejected.
pub fn impact() -> Scene {
    let mut scene = falling();
    scene.time_step = 4e-3;
    scene.adaptive = Some(AdaptiveTimeStep {
        speed: None,
        sound: None,
        acceleration: Some(0.1),
        reject_ratio: Some(1.0),
        ..AdaptiveTimeStep::default()
    });
    scene
}

/// A few particles that leave the range of the grid in their first step, and do not in half of it.
pub fn leaving() -> Scene {
    let mut scene = falling();
    (scene.adaptive, scene.container, scene.time_step) = (None, None, 2e-3);
    scene.blocks[0].size = Vec3::new(0.1, 0.1, 0.0);
    let range = (1 << 22) as f32 * support_radius(&scene) as f32;
    scene.blocks[0].velocity = Vec3::new(1.5 * range / scene.time_step, 0.0, 0.0);
    scene
}
