//! What `tests/bare` steps, and `tests/core_stands_alone.rs` beside it.
use millpond_core::scene::{Block, Container, Dimension, Fluid, Grid, Scene};

/// A thousand particles in the corner of a box.
pub fn scene() -> Scene {
    let water = Fluid { speed_of_sound: 20.0, dynamic_viscosity: 2.0, ..Fluid::default() };
    let block = Block { size: [0.5; 3], jitter: 0.02, ..Block::default() };
    let mut scene = Scene::of(Dimension::Three, 0.05, 0.001, water, block);
    scene.gravity = [0.0, -9.81, 0.0];
    scene.container = Some(Container { bounce: 0.5, slip: 0.9, ..Container::closed([0.0; 3], [1.0, 1.0, 0.5]) });
    scene.grid = Grid { cells: [8, 8, 8], ..Grid::default() };
    scene
}
