//! A scene that passed validation.
use crate::derive::Derived;
use crate::derive::initial_particles::initial_particles;
use crate::derive::recommended_step::recommended_step;
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

    /// Returns a time step that is stable for most scenes, s: the shortest of 0.15 of the time in which sound crosses
    /// the support radius, of what viscosity allows, and of what gravity allows, which are the defaults of
    /// [`AdaptiveTimeStep`](crate::scene::AdaptiveTimeStep). Surface tension and springs may need a shorter one.
    #[must_use]
    pub fn recommended_time_step(&self) -> f32 {
        recommended_step(self.scene, &self.derived)
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
