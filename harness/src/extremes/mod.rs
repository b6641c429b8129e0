//! Extreme scenes and their expected results. Each must end in a valid state, or in an error that names the cause and
//! leaves the state unchanged. None may hang, panic, or end in a meaningless state without a warning.
//!
//! A [`Case`] is a scene with its particles and its expected [`End`]. [`particles`] has cases with unusual particles,
//! [`coincident`] two particles at the same position under every choice of formulas, [`settings`] unusual scenes, and
//! [`inputs`] invalid values for every number of a scene. [`judge`] runs a case on every backend. `check extremes` and
//! the tests use the same list of cases.
pub mod coincident;
pub mod inputs;
mod judge;
mod measures;
pub mod particles;
pub mod settings;

pub use judge::{Fault, Verdict, judge, judge_with_every_term};
pub use measures::Measure;

use crate::failure::Failure;
use crate::scenes::{Changes, load};
use crate::snapshot::Snapshot;
use millpond_core::scene::{GridStructure, InitialParticle, Scene};
use millpond_core::{SceneError, StepError};

/// An extreme scene.
#[derive(Clone, Debug)]
pub struct Case {
    /// Description, which is also its name.
    pub name: String,
    /// What runs.
    pub scene: Scene,
    /// The particles; `None` for those of the scene's own blocks.
    pub places: Option<Vec<InitialParticle>>,
    /// Number of steps to make.
    pub steps: u32,
    /// The expected result.
    pub end: End,
}

/// The expected result of a case.
#[derive(Clone, Copy, Debug)]
pub enum End {
    /// The scene or its particles are rejected before the first step, with an error for which the function returns
    /// true.
    Refused(fn(&SceneError) -> bool),
    /// The scene starts, and a step fails with an error for which the function returns true.
    Stopped(fn(&StepError) -> bool),
    /// All steps succeed, and the requirement holds.
    Runs(Measure),
    /// The scene is rejected, or a step fails, or all steps succeed and the requirement holds.
    Either(Measure),
    /// The scene is rejected as not finite or out of bounds, with an error that names this field by its whole path.
    NotANumber(&'static str),
    /// As [`End::Either`], but if the scene is rejected, the error message must name one of these two fields.
    Naming([&'static str; 2], Measure),
}

/// A case that ran to its end.
#[derive(Debug)]
pub struct Run<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// The state before the first step.
    pub start: &'a Snapshot,
    /// The state after the last one.
    pub end: &'a Snapshot,
    /// Simulated time, s.
    pub seconds: f64,
}

impl Case {
    /// Returns a case with the particles of the scene's own blocks.
    fn of_scene(name: impl Into<String>, scene: Scene, steps: u32, end: End) -> Case {
        Case { name: name.into(), scene, places: None, steps, end }
    }

    /// Returns a case with the given particles.
    fn of_places(name: impl Into<String>, scene: &Scene, places: Vec<InitialParticle>, steps: u32, end: End) -> Case {
        Case { name: name.into(), scene: scene.clone(), places: Some(places), steps, end }
    }
}

/// Returns all cases.
///
/// # Errors
/// A built-in scene that cannot be read.
pub fn cases() -> Result<Vec<Case>, Failure> {
    let mut cases = particles::cases()?;
    cases.extend(coincident::cases()?);
    cases.extend(settings::cases()?);
    cases.extend(inputs::cases()?);
    Ok(cases)
}

/// Returns a built-in scene of about `particles` particles with the index sort, in which a cell can hold any number of
/// particles. Cases about full cells set cell lists themselves.
fn built_in(name: &str, particles: u64) -> Result<Scene, Failure> {
    let mut scene = load(name, &Changes { set: Vec::new(), particles: Some(particles) })?.file.scene;
    scene.grid.structure = GridStructure::IndexSort;
    Ok(scene)
}
