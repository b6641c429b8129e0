//! A time step for a scene that has none yet.
use super::derived::Derived;
use super::fluid::FluidConstants;
use super::scales::Scales;
use super::step_limits::StepLimits;
use crate::scene::{AdaptiveTimeStep, Fluid, Scene};
use glam::Vec3;

/// Returns the step that the default criteria of an adaptive step allow a fluid at its start, s.
pub(crate) fn recommended_step(scene: &Scene, derived: &Derived) -> f32 {
    let criteria = AdaptiveTimeStep::default();
    let limits = StepLimits::of(scene, &criteria, &Scales::of(scene), derived.kinematic_viscosity);
    // a speed of sound that follows from the time step cannot limit it: the fluids' own is meant
    let sound = |(fluid, constants): (&Fluid, &FluidConstants)| match scene.stiffness_for_time_step {
        Some(_) => fluid.speed_of_sound,
        None => constants.speed_of_sound as f32,
    };
    let sound = scene.fluids.iter().zip(&derived.fluids).map(sound).fold(0.0, f32::max);
    let moving = scene.blocks.iter().map(|block| block.velocity).chain(scene.walls.iter().map(|wall| wall.velocity));
    let speed = moving.map(Vec3::length).fold(0.0, f32::max);
    let by_sound = criteria.sound.unwrap_or_default() * derived.support_radius as f32 / sound;
    let by_speed = limits.speed / speed;
    let by_gravity = libm::sqrtf(limits.acceleration / scene.gravity.length());
    by_sound.min(by_speed).min(by_gravity).min(limits.viscosity)
}
