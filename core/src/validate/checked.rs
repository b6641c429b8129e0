//! A scene that passed validation.
use crate::derive::Derived;
use crate::derive::initial_particles::initial_particles;
use crate::scene::{InitialParticle, Scene};
use core::ops::Deref;

/// A scene that can run, with all that is derived from it. Only [`Scene::check`] creates it.
#[derive(Clone, Debug, PartialEq)]
pub struct Checked<'s> {
    scene: &'s Scene,
    derived: Derived,
}

impl<'s> Checked<'s> {
    pub(super) fn new(scene: &'s Scene, derived: Derived) -> Checked<'s> {
        Checked { scene, derived }
    }

    /// Returns the scene.
    #[must_use]
    pub fn scene(&self) -> &'s Scene {
        self.scene
    }

    /// Returns the constants and counts derived from the scene.
    #[must_use]
    pub fn derived(&self) -> &Derived {
        &self.derived
    }

    /// Returns the scene's particles in the order of their ids: fluids, then walls, then inactive air.
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
