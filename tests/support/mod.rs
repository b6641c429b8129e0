//! What the tests share: small scenes, random numbers, and a device or a word about its absence.
#![allow(dead_code, unreachable_pub, reason = "each test uses its part")]
use std::io::Write as _;

use millpond::scenes::{Changes, Named, load};
use millpond_core::OwnedMemory;
use millpond_core::scene::{InitialParticle, Scene};
use millpond_core::{Checked, Plan, Requirements, Solver};
use millpond_gpu::{Gpu, Mode};

/// A built-in scene, changed.
pub fn scene(name: &str, set: &[&str]) -> Named {
    let changes = Changes { set: set.iter().map(|s| (*s).to_owned()).collect(), particles: None };
    load(name, &changes).expect("a built-in scene")
}

/// A built-in scene of about so many particles.
pub fn scaled(name: &str, particles: u64) -> Named {
    load(name, &Changes { set: Vec::new(), particles: Some(particles) }).expect("a built-in scene")
}

/// A scene with all that follows from it.
pub fn checked(scene: &Scene) -> Checked<'_> {
    scene.check().expect("a scene")
}

/// Memory for `count` particles in the cells of `scene`.
pub fn heap_for(scene: &Scene, count: usize) -> OwnedMemory {
    OwnedMemory::with(&Requirements::of(&checked(scene)).for_particles(count))
}

/// A solver of particles at rest at these places.
pub fn at_rest<'a>(scene: &Scene, positions: &[[f32; 3]], heap: &'a mut OwnedMemory) -> Solver<'a> {
    let places = positions.iter().map(|&position| InitialParticle::at(position, [0.0; 3]));
    let scene = checked(scene);
    Solver::with_particles(&scene, Plan::of(&scene), positions.len(), places, heap.lend()).expect("a scene")
}

/// Random numbers that are always the same ones (splitmix64).
pub struct Random(pub u64);

impl Random {
    /// Any bits.
    pub fn bits(&mut self) -> u32 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (z ^ (z >> 31)) as u32
    }

    /// Between 0 and 1.
    pub fn unit(&mut self) -> f32 {
        (self.bits() >> 8) as f32 / (1u32 << 24) as f32
    }
}

/// A device, or a line that the test is skipped; with `MILLPOND_REQUIRE_GPU=1` its absence is a failure.
pub fn device(test: &str, mode: Mode) -> Option<Gpu> {
    match Gpu::open(None, mode) {
        Ok(gpu) => {
            println!("{test}: on {}, which offers {:?}", gpu.name(), gpu.float_controls());
            Some(gpu)
        }
        Err(error) => {
            let required = std::env::var_os(millpond::fluid::REQUIRE_GPU).is_some_and(|v| v == "1");
            assert!(!required, "{test}: a GPU is required: {error}");
            // past the test runner's capture, so that a skipped test is seen
            let _ = writeln!(std::io::stderr(), "skipped: {test}: {error}");
            None
        }
    }
}
