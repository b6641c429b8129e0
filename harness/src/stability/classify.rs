//! Classification of runs as stable or unstable, by criteria that hold for any scene.
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

/// Largest share of the fluid that may be outside of its walls by more than a support radius. A few drops may splash
/// over a rim; walls that leak lose more.
const LOST_LIMIT: f64 = 0.01;

/// All limits. They are part of the key of a finished point, so that points judged by other limits are run again.
pub(super) const CRITERIA: [f64; 3] = [GROWTH_LIMIT, DENSITY_LIMIT, LOST_LIMIT];

/// Steps between two checks. An instability grows over some tens of steps, and a check costs a few per cent of a step.
const LOOK_EVERY: u64 = 5;

/// The criterion by which a run is unstable.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Criterion {
    /// The mechanical energy grew.
    EnergyGrowth,
    /// The fluid is compressed too far.
    DensityError,
    /// A step failed because a value of a particle is not finite, or out of range.
    NotFinite,
    /// A step failed because a cell got more particles than it has places.
    CellFull,
    /// Particles left the boxes that hold them.
    ParticlesLost,
}

impl Criterion {
    /// Returns its name.
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

/// Result of a run.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Verdict {
    /// The run reached its end without breaking a criterion.
    Stable,
    /// The run broke a criterion.
    Unstable(Broken),
    /// The scene cannot run.
    Refused(String),
    /// The run would need too many steps and was not made.
    TooManySteps(TooManySteps),
}

/// When and how a run broke a criterion.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Broken {
    pub(super) criterion: Criterion,
    /// Simulated time, s.
    pub(super) time: f64,
    /// Explanation with the value that was reached.
    pub(super) words: String,
}

impl fmt::Display for Broken {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} after {}: {}", self.criterion.name(), seconds(self.time as f32), self.words)
    }
}

/// A run that needs more steps than are allowed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct TooManySteps {
    /// Steps that it needs.
    pub(super) needed: u64,
    /// Steps that are allowed.
    pub(super) most: u64,
}

impl fmt::Display for TooManySteps {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "needs {} steps, but --most-steps allows {}", self.needed, self.most)
    }
}

/// Checks the state of a run against the criteria.
#[derive(Debug)]
pub(super) struct Judge {
    /// Energy that the scene can release, J; `None` if energy is not judged.
    scale: Option<f64>,
    /// Smallest mechanical energy so far, J.
    least: f64,
    bounds: Vec<Bound>,
}

impl Judge {
    /// Returns the judge of a run, from the state at its start.
    pub(super) fn new(scene: &Checked<'_>, solver: &Solver<'_>) -> Judge {
        let scale = driven_by(scene).is_none().then(|| scale(scene, solver));
        // a box that does not hold all of the fluid at the start cannot lose it
        let fluid = || solver.particles().filter(|particle| !particle.is_wall && !particle.is_inactive);
        let holds = |bound: &Bound| !fluid().any(|particle| bound.is_outside(particle.position.to_array(), 0.0));
        let bounds = bounds(scene).into_iter().filter(holds).collect();
        Judge { scale, least: total(scene, solver), bounds }
    }

    /// Returns the criterion that the current state breaks, if any.
    pub(super) fn look(&mut self, scene: &Checked<'_>, solver: &Solver<'_>) -> Option<Broken> {
        let broken = |criterion, words| Some(Broken { criterion, time: solver.time(), words });
        let energy = total(scene, solver);
        let compression = solver.density_error().mean;
        if !energy.is_finite() || !compression.is_finite() {
            return broken(Criterion::NotFinite, "the energy or the density is no longer finite".into());
        }
        let lost = self.lost(solver, support_radius(scene));
        if lost > LOST_LIMIT {
            return broken(Criterion::ParticlesLost, format!("{:.1} % of the fluid left its walls", lost * 100.0));
        }
        if compression > DENSITY_LIMIT {
            let percent = compression * 100.0;
            return broken(Criterion::DensityError, format!("the mean compression is {percent:.1} %"));
        }
        self.least = self.least.min(energy);
        let growth = self.scale.map_or(0.0, |scale| (energy - self.least) / scale);
        if growth > GROWTH_LIMIT {
            let percent = growth * 100.0;
            return broken(Criterion::EnergyGrowth, format!("it grew by {percent:.1} % of what the scene can release"));
        }
        None
    }

    /// Returns the share of the fluid that is outside of its boxes by more than a margin, m.
    fn lost(&self, solver: &Solver<'_>, margin: f64) -> f64 {
        let (mut lost, mut all) = (0u64, 0u64);
        for particle in solver.particles().filter(|particle| !particle.is_wall && !particle.is_inactive) {
            let outside = |bound: &Bound| bound.is_outside(particle.position.to_array(), margin);
            lost += u64::from(self.bounds.iter().any(outside));
            all += 1;
        }
        lost as f64 / all.max(1) as f64
    }
}

/// Result of a run with its costs.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Trial {
    pub(super) verdict: Verdict,
    /// Number of steps made.
    pub(super) steps: u64,
    /// Number of particles of the scene; 0 if it was refused.
    pub(super) particles: usize,
}

/// Runs a scene for `time` seconds of simulated time, or until it breaks a criterion, on the calling thread. `watch` is
/// called at the start and after each step.
pub(super) fn classify(scene: &Scene, time: f64, most: u64, mut watch: impl FnMut(&Solver<'_>)) -> Trial {
    let ended = |verdict, steps| Trial { verdict, steps, particles: 0 };
    let refused = |error: SceneError| ended(Verdict::Refused(error.to_string()), 0);
    if scene.adaptive.is_some() {
        return ended(Verdict::Refused("an adaptive scene has no fixed time step: --set adaptive=null".into()), 0);
    }
    let scene = &match scene.check() {
        Ok(scene) => scene,
        Err(error) => return refused(error),
    };
    let particles = scene.derived().particles();
    let ended = |verdict, steps| Trial { verdict, steps, particles };
    let bytes = Requirements::of(scene).bytes();
    if bytes > MOST_BYTES {
        return ended(Verdict::Refused(format!("it needs {bytes} bytes, but at most {MOST_BYTES} are allowed")), 0);
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

    /// Returns the verdict on `still-tank` with the given time step, s. Sound crosses its support in 2.3 ms.
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
