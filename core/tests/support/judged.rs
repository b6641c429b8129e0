//! Checks a scene after a change.
use millpond_core::SceneError;
use millpond_core::glam::Vec3;
use millpond_core::scene::{Block, Dimension, Fluid, Formulation, Recipe, Scene};

/// Returns whether a scene of one block is accepted after this change, or else the error.
pub(crate) fn judged(change: impl FnOnce(&mut Scene)) -> Result<(), SceneError> {
    let block = Block { size: Vec3::new(0.4, 0.4, 0.4), ..Block::default() };
    let mut scene = Scene::of(Dimension::Three, 0.05, 0.001, Fluid::default(), block);
    scene.average_neighbours = Some(32.0);
    scene.model = Formulation::of(Recipe::Pirovano);
    scene.gravity = Vec3::new(0.0, -9.81, 0.0);
    change(&mut scene);
    scene.check().map(|_| ())
}
