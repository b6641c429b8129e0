//! Helpers shared by the tests across crates, in addition to those of the crates: built-in scenes.
#![allow(dead_code, unreachable_pub, reason = "each test uses its part")]
use millpond::scenes::{Changes, LoadedScene, load};
use millpond_core::scene::{PlaneModel, Scene};

#[path = "../../gpu/tests/support/mod.rs"]
mod of_gpu;
#[allow(unused_imports, reason = "each test uses its part")]
pub use of_gpu::*;

/// Loads a built-in scene with these changes.
pub fn scene(name: &str, set: &[&str]) -> LoadedScene {
    let changes = Changes { set: set.iter().map(|s| (*s).to_owned()).collect(), particles: None };
    load(name, &changes).expect("a built-in scene")
}

/// Makes the container of a scene one of penalty planes, which go with every choice.
pub fn with_penalty_planes(scene: &mut Scene) {
    if let Some(container) = &mut scene.container {
        container.model = PlaneModel::Penalty;
    }
}

/// Loads a built-in scene with about this number of particles.
pub fn scaled(name: &str, particles: u64) -> LoadedScene {
    load(name, &Changes { set: Vec::new(), particles: Some(particles) }).expect("a built-in scene")
}
