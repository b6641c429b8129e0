//! A scene that can run.
use crate::derive::Derived;
use crate::derive::initial_particles::initial_particles;
use crate::scene::{InitialParticle, Scene};
use core::ops::Deref;

/// A scene that [`Scene::check`] accepted, which alone makes one of these, with all that follows from it.
#[derive(Clone, Debug, PartialEq)]
pub struct Checked<'s> {
    scene: &'s Scene,
    derived: Derived,
}

impl<'s> Checked<'s> {
    pub(super) fn new(scene: &'s Scene, derived: Derived) -> Checked<'s> {
        Checked { scene, derived }
    }

    /// The scene.
    #[must_use]
    pub fn scene(&self) -> &'s Scene {
        self.scene
    }

    /// What follows from it.
    #[must_use]
    pub fn derived(&self) -> &Derived {
        &self.derived
    }

    /// Its particles, in order of their ids: the fluids, then the walls, then air that is not there yet.
    pub fn initial_particles(&self) -> impl Iterator<Item = InitialParticle> {
        initial_particles(self.scene, &self.derived)
    }
}

impl Deref for Checked<'_> {
    type Target = Scene;

    fn deref(&self) -> &Scene {
        self.scene
    }
}
