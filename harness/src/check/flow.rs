//! Functions that the studies share: starting a scene, stepping it to a time, and means over its particles.
use super::Context;
use crate::failure::Failure;
use crate::output::progress;
use millpond_core::OwnedMemory;
use millpond_core::backend::hash::tree_sum;
use millpond_core::scene::{Dimension, Grid, InitialParticle, Scene};
use millpond_core::{Checked, Particle, Plan, Requirements, SceneError, Solver};

/// Checks a study's scene and derives its constants.
///
/// # Errors
/// The scene cannot run.
pub(super) fn checked<'s>(study: &str, scene: &'s Scene) -> Result<Checked<'s>, Failure> {
    scene.check().map_err(refused_by(study))
}

/// Converts the error of a scene in a study.
pub(super) fn refused_by(study: &str) -> impl Fn(SceneError) -> Failure {
    move |error| Failure::Scene { origin: format!("check {study}"), error }
}

/// Returns memory for a scene with this number of particles.
pub(super) fn heap_for(scene: &Checked<'_>, particles: usize) -> OwnedMemory {
    OwnedMemory::with(&Requirements::of(scene).for_particles(particles))
}

/// Returns a solver with these particles in place of those of the scene's lattice.
///
/// # Errors
/// The scene cannot start.
pub(super) fn start_with<'m>(
    study: &str,
    scene: &Checked<'_>,
    places: Vec<InitialParticle>,
    heap: &'m mut OwnedMemory,
) -> Result<Solver<'m>, Failure> {
    Solver::with_particles(scene, Plan::of(scene), places.len(), places, heap.lend()).map_err(refused_by(study))
}

/// Returns the number of steps of `scene` that comes nearest to `seconds`, at least one.
pub(super) fn steps_to(scene: &Scene, seconds: f64) -> u64 {
    (seconds / f64::from(scene.time_step)).round().max(1.0) as u64
}

/// Makes `steps` steps, and calls `look` after each `every` of them. A progress bar has this title.
///
/// # Errors
/// A step fails.
pub(super) fn step<'m>(
    title: &str,
    context: &Context,
    solver: &mut Solver<'m>,
    steps: u64,
    every: u64,
    mut look: impl FnMut(&mut Solver<'m>),
) -> Result<(), Failure> {
    let bar = progress(title, steps);
    for done in 1..=steps {
        solver.step(&context.pool)?;
        if done.is_multiple_of(every.max(1)) {
            look(solver);
        }
        bar.inc(1);
    }
    bar.finish_and_clear();
    Ok(())
}

/// Returns a grid with this number of cells along each axis of the scene.
pub(super) fn grid(dimension: Dimension, cells: u32) -> Grid {
    let z = if dimension == Dimension::Two { 1 } else { cells };
    Grid { cells: [cells, cells, z], ..Grid::default() }
}

/// Returns the fluid particles in the order of their ids, without wall particles and inactive air particles.
pub(super) fn fluid(solver: &Solver<'_>) -> Vec<Particle> {
    solver.particles().filter(|particle| !particle.is_wall && !particle.is_inactive).collect()
}

/// Returns the mean of a number over items, summed by a fixed tree; NaN if there are no items.
pub(super) fn mean<T>(of: &[T], number: impl Fn(&T) -> f64) -> f64 {
    tree_sum(of.len(), &|i| number(&of[i])) / of.len() as f64
}

/// Returns the larger number, or NaN if one of them is NaN.
pub(super) fn larger(a: f64, b: f64) -> f64 {
    if a >= b || a.is_nan() { a } else { b }
}

/// Returns the smallest distance between two particles, m.
pub(super) fn closest_pair(solver: &mut Solver<'_>) -> f64 {
    let particles: Vec<Particle> = solver.particles().collect();
    let mut closest = f32::INFINITY;
    solver.neighbours().each_pair(|a, b| {
        if a < b {
            let distance = particles[a as usize].position.distance(particles[b as usize].position);
            closest = closest.min(distance);
        }
    });
    f64::from(closest)
}

/// Returns the root mean square speed of the fluid, m/s.
pub(super) fn rms_speed(solver: &Solver<'_>) -> f64 {
    mean(&fluid(solver), |particle| f64::from(particle.velocity.length_squared())).sqrt()
}
