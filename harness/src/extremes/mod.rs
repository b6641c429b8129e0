//! Scenes pushed to extremes, and what must come of each: a sound state, or a refusal by name that changes nothing. Never a
//! hang, a panic or numbers that mean nothing and do not say so.
//!
//! A [`Case`] is a scene, its particles and the [`End`] that it must come to: [`particles`] has those of odd particles,
//! [`coincident`] two at one place under every choice of formulas, [`settings`] those of odd scenes, [`inputs`] every number of
//! a scene as what no number should be. [`judge`] runs a case on every backend; `check extremes` and the tests look at the
//! same list.
pub mod coincident;
pub mod inputs;
mod judge;
mod measures;
pub mod particles;
pub mod settings;

pub use judge::{Fault, Verdict, judge};
pub use measures::Measure;

use crate::failure::Failure;
use crate::scenes::{Changes, load};
use crate::snapshot::Snapshot;
use millpond_core::scene::{GridStructure, InitialParticle, Scene};
use millpond_core::{SceneError, StepError};

/// A scene at an extreme.
#[derive(Clone, Debug)]
pub struct Case {
    /// What is extreme about it.
    pub name: String,
    /// What runs.
    pub scene: Scene,
    /// Its particles; none: those of the scene's own lattice.
    pub places: Option<Vec<InitialParticle>>,
    /// Steps to make.
    pub steps: u32,
    /// What must come of it.
    pub end: End,
}

/// What must come of a case.
#[derive(Clone, Copy, Debug)]
pub enum End {
    /// The scene or its particles are refused before anything moves, by such an error.
    Refused(fn(&SceneError) -> bool),
    /// The scene starts, and a step is refused by such an error.
    Stopped(fn(&StepError) -> bool),
    /// All steps are made, and this holds.
    Runs(Measure),
    /// A refusal of either kind; or all steps are made, and this holds.
    Either(Measure),
    /// The scene is refused for this field, by its whole path, as no number or as one outside of its bounds.
    NotANumber(&'static str),
    /// As [`End::Either`], but a refusal of the scene has a sentence that names one of these two.
    Naming([&'static str; 2], Measure),
}

/// A case whose steps were all made.
#[derive(Debug)]
pub struct Run<'a> {
    /// What ran.
    pub scene: &'a Scene,
    /// The state before the first step.
    pub start: &'a Snapshot,
    /// The state after the last one.
    pub end: &'a Snapshot,
    /// Simulated time, s.
    pub seconds: f64,
}

impl Case {
    /// With the particles of the scene's own lattice.
    fn of_scene(name: impl Into<String>, scene: Scene, steps: u32, end: End) -> Case {
        Case { name: name.into(), scene, places: None, steps, end }
    }

    /// With these particles.
    fn of_places(name: impl Into<String>, scene: &Scene, places: Vec<InitialParticle>, steps: u32, end: End) -> Case {
        Case { name: name.into(), scene: scene.clone(), places: Some(places), steps, end }
    }
}

/// All cases.
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

/// A built-in scene of about so many particles, sorted by an index: no crowd is too large for a cell of it. What is about cells that
/// are full says so itself.
fn built_in(name: &str, particles: u64) -> Result<Scene, Failure> {
    let mut scene = load(name, &Changes { set: Vec::new(), particles: Some(particles) })?.file.scene;
    scene.grid.structure = GridStructure::IndexSort;
    Ok(scene)
}
