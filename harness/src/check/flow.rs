//! Starting a scene, stepping it to a time, and numbers of its particles.
use super::Context;
use crate::failure::Failure;
use crate::output::progress;
use millpond_core::OwnedMemory;
use millpond_core::backend::hash::tree_sum;
use millpond_core::scene::{Dimension, Grid, InitialParticle, Scene};
use millpond_core::{Checked, Particle, Plan, Requirements, SceneError, Solver};

/// A study's scene with all that follows from it.
///
/// # Errors
/// A scene that cannot run.
pub(super) fn checked<'s>(study: &str, scene: &'s Scene) -> Result<Checked<'s>, Failure> {
    scene.check().map_err(refused_by(study))
}

fn refused_by(study: &str) -> impl Fn(SceneError) -> Failure {
    move |error| Failure::Scene { origin: format!("check {study}"), error }
}

/// Memory for a scene with so many particles.
pub(super) fn heap_for(scene: &Checked<'_>, particles: usize) -> OwnedMemory {
    OwnedMemory::with(&Requirements::of(scene).for_particles(particles))
}

/// A solver with these particles in place of those of the scene's lattice.
///
/// # Errors
/// A scene that cannot start.
pub(super) fn start_with<'m>(
    study: &str,
    scene: &Checked<'_>,
    places: Vec<InitialParticle>,
    heap: &'m mut OwnedMemory,
) -> Result<Solver<'m>, Failure> {
    Solver::with_particles(scene, Plan::of(scene), places.len(), places, heap.lend()).map_err(refused_by(study))
}

/// Steps of `scene` that come nearest to `seconds`.
pub(super) fn steps_to(scene: &Scene, seconds: f64) -> u64 {
    (seconds / f64::from(scene.time_step)).round().max(1.0) as u64
}

/// Makes `steps` steps, and has a look after each `every` of them. A bar with this title shows how far it is.
///
/// # Errors
/// A step that could not be made.
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

/// A grid of so many cells along each axis of the scene.
pub(super) fn grid(dimension: Dimension, cells: u32) -> Grid {
    let z = if dimension == Dimension::Two { 1 } else { cells };
    Grid { cells: [cells, cells, z], ..Grid::default() }
}

/// The particles of the fluid, those of walls and air that is not there left out, in order of their ids.
pub(super) fn fluid(solver: &Solver<'_>) -> Vec<Particle> {
    solver.particles().filter(|particle| !particle.wall && !particle.inactive).collect()
}

/// Mean of a number over things, by one fixed tree; NaN of none.
pub(super) fn mean<T>(of: &[T], number: impl Fn(&T) -> f64) -> f64 {
    tree_sum(of.len(), &|i| number(&of[i])) / of.len() as f64
}

/// The larger one; a NaN stays one.
pub(super) fn larger(a: f64, b: f64) -> f64 {
    if a >= b || a.is_nan() { a } else { b }
}

/// Root of the mean square speed of the fluid, m/s.
pub(super) fn rms_speed(solver: &Solver<'_>) -> f64 {
    mean(&fluid(solver), |particle| f64::from(particle.velocity.length_squared())).sqrt()
}
