//! What the tests across crates share beside those of the crates: built-in scenes.
#![allow(dead_code, unreachable_pub, reason = "each test uses its part")]
use millpond::scenes::{Changes, LoadedScene, load};

#[path = "../../gpu/tests/support/mod.rs"]
mod of_gpu;
#[allow(unused_imports, reason = "each test uses its part")]
pub use of_gpu::*;

/// A built-in scene, changed.
pub fn scene(name: &str, set: &[&str]) -> LoadedScene {
    let changes = Changes { set: set.iter().map(|s| (*s).to_owned()).collect(), particles: None };
    load(name, &changes).expect("a built-in scene")
}

/// A built-in scene of about so many particles.
pub fn scaled(name: &str, particles: u64) -> LoadedScene {
    load(name, &Changes { set: Vec::new(), particles: Some(particles) }).expect("a built-in scene")
}
