//! Is a run stable? Criteria that hold for any scene, and the run that is held against them.
use super::bounds::{Bound, bounds};
use crate::energy::{DENSITY_LIMIT, GROWTH_LIMIT, driven_by, scale, total};
use crate::output::seconds;
use crate::scenes::MOST_BYTES;
use millpond_core::OwnedMemory;
use millpond_core::backend::derive::support_radius;
use millpond_core::scene::Scene;
use millpond_core::{Checked, Requirements, SceneError, Serial, Solver, StepError};
use serde::{Deserialize, Serialize};
use std::fmt;

/// Largest share of the fluid that may be outside of its walls by more than a support radius: a few drops leap over a rim,
/// walls that do not hold lose more.
const LOST_LIMIT: f64 = 0.01;

/// The limits together: points that were judged by others are not these.
pub(super) const CRITERIA: [f64; 3] = [GROWTH_LIMIT, DENSITY_LIMIT, LOST_LIMIT];

/// Steps between two looks: an explosion takes some tens of steps, and a look costs a few per cent of a step.
const LOOK_EVERY: u64 = 5;

/// By what a run showed itself to be unstable.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Criterion {
    /// The mechanical energy rose.
    EnergyGrowth,
    /// The fluid is compressed too far.
    DensityError,
    /// A step could not be made: somebody went where there are no numbers any more.
    NotFinite,
    /// A step could not be made: more came into a cell than it has places.
    CellFull,
    /// Particles left the walls.
    ParticlesLost,
}

impl Criterion {
    /// In words.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Criterion::EnergyGrowth => "energy growth",
            Criterion::DensityError => "density error",
            Criterion::NotFinite => "not finite",
            Criterion::CellFull => "cell full",
            Criterion::ParticlesLost => "particles lost",
        }
    }
}

/// What became of a run.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Verdict {
    /// It came to its end.
    Stable,
    /// It did not.
    Unstable(Broken),
    /// The scene cannot run.
    Refused(String),
    /// It was not made, or not to its end.
    TooManySteps(TooManySteps),
}

/// When and how a run broke a criterion.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Broken {
    pub(super) criterion: Criterion,
    /// Simulated time, s.
    pub(super) time: f64,
    /// How far it went.
    pub(super) words: String,
}

impl fmt::Display for Broken {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} after {}: {}", self.criterion.name(), seconds(self.time as f32), self.words)
    }
}

/// A run that takes more steps than are allowed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct TooManySteps {
    /// Steps that it takes.
    pub(super) needed: u64,
    /// Steps that it may take.
    pub(super) most: u64,
}

impl fmt::Display for TooManySteps {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "needs {} steps, and --most-steps allows {}", self.needed, self.most)
    }
}

/// Watches a run.
#[derive(Debug)]
pub(super) struct Judge {
    /// Energy that there is to spend, J; none where energy is not judged.
    scale: Option<f64>,
    /// Least mechanical energy so far, J.
    least: f64,
    bounds: Vec<Bound>,
}

impl Judge {
    /// Of a run at its start.
    pub(super) fn new(scene: &Checked<'_>, solver: &Solver<'_>) -> Judge {
        let scale = driven_by(scene).is_none().then(|| scale(scene, solver));
        // a box that never held all of the fluid loses none of it
        let fluid = || solver.particles().filter(|particle| !particle.wall && !particle.inactive);
        let holds = |bound: &Bound| !fluid().any(|particle| bound.is_outside(particle.position.to_array(), 0.0));
        let bounds = bounds(scene).into_iter().filter(holds).collect();
        Judge { scale, least: total(scene, solver), bounds }
    }

    /// The criterion that the state now breaks, if any.
    pub(super) fn look(&mut self, scene: &Checked<'_>, solver: &Solver<'_>) -> Option<Broken> {
        let broken = |criterion, words| Some(Broken { criterion, time: solver.time(), words });
        let energy = total(scene, solver);
        let compression = solver.density_error().mean;
        if !energy.is_finite() || !compression.is_finite() {
            return broken(Criterion::NotFinite, "the energy is no number any more".into());
        }
        let lost = self.lost(solver, support_radius(scene));
        if lost > LOST_LIMIT {
            return broken(Criterion::ParticlesLost, format!("{:.1} % of the fluid is outside", lost * 100.0));
        }
        if compression > DENSITY_LIMIT {
            let percent = compression * 100.0;
            return broken(Criterion::DensityError, format!("compressed by {percent:.1} % in the mean"));
        }
        self.least = self.least.min(energy);
        let growth = self.scale.map_or(0.0, |scale| (energy - self.least) / scale);
        if growth > GROWTH_LIMIT {
            let percent = growth * 100.0;
            return broken(Criterion::EnergyGrowth, format!("up by {percent:.1} % of what there was to spend"));
        }
        None
    }

    /// Share of the fluid that is outside by more than a margin.
    fn lost(&self, solver: &Solver<'_>, margin: f64) -> f64 {
        let (mut lost, mut all) = (0u64, 0u64);
        for particle in solver.particles().filter(|particle| !particle.wall && !particle.inactive) {
            let outside = |bound: &Bound| bound.is_outside(particle.position.to_array(), margin);
            lost += u64::from(self.bounds.iter().any(outside));
            all += 1;
        }
        lost as f64 / all.max(1) as f64
    }
}

/// What a run came to.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Trial {
    pub(super) verdict: Verdict,
    /// Steps that were made.
    pub(super) steps: u64,
    /// Particles of the scene; 0 where it was refused.
    pub(super) particles: usize,
}

/// Runs a scene for so many simulated seconds, or until it breaks a criterion, on the calling thread. `watch` sees it at its
/// start and after each step.
pub(super) fn classify(scene: &Scene, time: f64, most: u64, mut watch: impl FnMut(&Solver<'_>)) -> Trial {
    let ended = |verdict, steps| Trial { verdict, steps, particles: 0 };
    let refused = |error: SceneError| ended(Verdict::Refused(error.to_string()), 0);
    if scene.adaptive.is_some() {
        return ended(Verdict::Refused("adaptive leaves no time step to judge: --set adaptive=null".into()), 0);
    }
    let scene = &match scene.check() {
        Ok(scene) => scene,
        Err(error) => return refused(error),
    };
    let particles = scene.derived().particles();
    let ended = |verdict, steps| Trial { verdict, steps, particles };
    let bytes = Requirements::of(scene).bytes();
    if bytes > MOST_BYTES {
        return ended(Verdict::Refused(format!("the scene needs {bytes} bytes, and {MOST_BYTES} are given to one")), 0);
    }
    let needed = (time / f64::from(scene.time_step)).round().max(1.0) as u64;
    if needed > most {
        return ended(Verdict::TooManySteps(TooManySteps { needed, most }), 0);
    }
    let mut heap = OwnedMemory::of(scene);
    let mut solver = match Solver::new(scene, heap.lend()) {
        Ok(solver) => solver,
        Err(error) => return refused(error),
    };
    let mut judge = Judge::new(scene, &solver);
    watch(&solver);
    for step in 1..=needed {
        if let Err(error) = solver.step(&Serial) {
            let full = matches!(error, StepError::CellFull { .. });
            let criterion = if full { Criterion::CellFull } else { Criterion::NotFinite };
            let broken = Broken { criterion, time: solver.time(), words: error.to_string() };
            return ended(Verdict::Unstable(broken), step);
        }
        watch(&solver);
        if (step.is_multiple_of(LOOK_EVERY) || step == needed)
            && let Some(broken) = judge.look(scene, &solver)
        {
            return ended(Verdict::Unstable(broken), step);
        }
    }
    ended(Verdict::Stable, needed)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scenes::{Changes, load};
    use millpond_core::scene::AdaptiveTimeStep;

    /// What becomes of `still-tank`, whose sound crosses its support in 2.3 ms, in steps of so many seconds.
    fn tank(time_step: f32, most: u64) -> Verdict {
        let mut scene = load("still-tank", &Changes::default()).expect("it is built in").file.scene;
        scene.time_step = time_step;
        classify(&scene, 0.2, most, |_| ()).verdict
    }

    #[test]
    fn steps_that_are_short_enough_are_stable_and_others_break_a_criterion() {
        assert_eq!(tank(5e-4, 10_000), Verdict::Stable);
        assert!(matches!(tank(5e-3, 10_000), Verdict::Unstable(_)));
    }

    #[test]
    fn what_cannot_run_or_takes_too_long_is_told_apart() {
        assert!(matches!(tank(-1.0, 10_000), Verdict::Refused(_)));
        let mut scene = load("still-tank", &Changes::default()).expect("it is built in").file.scene;
        scene.adaptive = Some(AdaptiveTimeStep::default());
        assert!(matches!(classify(&scene, 0.2, 10_000, |_| ()).verdict, Verdict::Refused(_)));
        assert_eq!(tank(1e-3, 100), Verdict::TooManySteps(TooManySteps { needed: 200, most: 100 }));
    }
}
