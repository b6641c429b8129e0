//! Runs a point of the map: once, or by bisection.
use super::axis::{Choice, TIME_STEP};
use super::bisect;
use super::classify::{Broken, CRITERIA, Criterion, TooManySteps, Trial, Verdict, classify};
use super::resume::{ResumeLog, key};
use super::{Courant, Outcome, Run};
use crate::energy::fastest_sound;
use crate::failure::Failure;
use crate::output::seconds;
use millpond_core::backend::derive::support_radius;
use millpond_core::scene::Scene;

/// Share of the support radius that sound crosses in the first time step of a bisection (Monaghan 1992).
const FIRST_COURANT: f32 = 0.4;

/// Smallest number of steps of a run: fewer steps say nothing about stability.
const FEWEST_STEPS: f64 = 20.0;

/// Smallest time step of a bisection, over the first one: as small as a viscosity of 1000 Pa s requires.
const SMALLEST_SHARE: f32 = 1.0 / 1024.0;

/// Number of halvings of the time step without effect on the density error, after which the fluid is taken as too soft
/// rather than the time step as too long; and the relative change of the time at which the error appears that counts as
/// no effect.
const HALVINGS_IN_VAIN: u32 = 3;
const SAME_TIME: f64 = 0.05;

/// A point that has not been run yet.
#[derive(Clone, Debug)]
pub(super) struct Point {
    pub(super) choice: Choice,
    /// The scene with the values of `choice` set.
    pub(super) scene: Scene,
}

/// Limits of each run.
#[derive(Clone, Copy, Debug)]
pub(super) struct Limits {
    /// Simulated time, s.
    pub(super) seconds: f64,
    pub(super) most_steps: u64,
}

/// Why a bisection ends without a result.
enum NoResult {
    /// The next run would need too many steps.
    TooManySteps(TooManySteps),
    /// The fluid is too soft: shorter time steps change nothing.
    TooSoft,
}

impl Limits {
    /// Runs a point, or returns its result if it is already finished.
    ///
    /// # Errors
    /// Returns an error if the file of finished points cannot be written.
    pub(super) fn run(self, point: &Point, ledger: &ResumeLog) -> Result<Run, Failure> {
        let pairs: Vec<String> = point.choice.iter().map(|(name, value)| format!("{name}={value}")).collect();
        let label = pairs.join(", ");
        // another version may step or judge differently
        let key = key(&label, &(&point.scene, self.seconds, env!("CARGO_PKG_VERSION"), CRITERIA))?;
        if let Some(run) = ledger.find(&key) {
            return Ok(run.clone());
        }
        let blank = Run {
            label,
            choice: point.choice.iter().cloned().collect(),
            outcome: Outcome::Refused,
            detail: String::new(),
            criterion: None,
            too_long: false,
            time_step: None,
            unstable_time_step: None,
            courant: None,
            particles: 0,
            steps: 0,
        };
        let listed = point.choice.iter().any(|(name, _)| name == TIME_STEP);
        let run = if listed { self.classified(&point.scene, blank) } else { self.bisected(&point.scene, blank) };
        if !run.too_long {
            ledger.add(&key, &run)?;
        }
        Ok(run)
    }

    /// Runs the scene once, with its own time step.
    fn classified(self, scene: &Scene, blank: Run) -> Run {
        let Trial { verdict, steps, particles } = classify(scene, self.seconds, self.most_steps, |_| ());
        let run = Run { steps, ..blank };
        let at_step = |run: Run| Run { time_step: Some(scene.time_step), courant: courant(scene), particles, ..run };
        match verdict {
            Verdict::Stable => {
                at_step(Run { outcome: Outcome::Stable, detail: format!("stable for {steps} steps"), ..run })
            }
            Verdict::Unstable(broken) => {
                let criterion = Some(broken.criterion);
                at_step(Run { outcome: Outcome::Unstable, detail: broken.to_string(), criterion, ..run })
            }
            Verdict::Refused(why) => Run { detail: why, ..run },
            Verdict::TooManySteps(too_many) => at_step(Run { detail: too_many.to_string(), too_long: true, ..run }),
        }
    }

    /// Runs the scene as often as needed to find the largest stable time step.
    fn bisected(self, scene: &Scene, blank: Run) -> Run {
        let (mut steps_made, mut particles) = (0, 0);
        // the smallest time step that failed, and its verdict
        let mut failed: Option<(f32, Verdict)> = None;
        let mut softness = Softness::default();
        let mut any = false;
        let with_step = |time_step| Scene { time_step, ..scene.clone() };
        let start = first_step(scene);
        let most = (self.seconds / FEWEST_STEPS) as f32;
        let range = [(start * SMALLEST_SHARE).min(most), most];
        let found = bisect::edge(start, range, |time_step| {
            let trial = classify(&with_step(time_step), self.seconds, self.most_steps, |_| ());
            steps_made += trial.steps;
            particles = particles.max(trial.particles);
            match trial.verdict {
                Verdict::Stable => {
                    any = true;
                    return Ok(true);
                }
                Verdict::TooManySteps(too_many) => return Err(NoResult::TooManySteps(too_many)),
                other => failed = Some((time_step, other)),
            }
            // if any time step was stable, the fluid is not too soft, however similar the failures of longer time steps
            // are
            let in_vain = !any && softness.is_shown_by(failed.as_ref().map(|(_, verdict)| verdict));
            if in_vain { Err(NoResult::TooSoft) } else { Ok(false) }
        });
        let run = Run { steps: steps_made, ..blank };
        let (criterion, above) = match &failed {
            Some((step, Verdict::Unstable(broken))) => {
                (Some(broken.criterion), format!("at {}, {broken}", seconds(*step)))
            }
            Some((step, Verdict::Refused(why))) => (None, format!("at {}, {why}", seconds(*step))),
            _ => (None, "no longer time step was tried".into()),
        };
        let none_is = |run: Run, unstable_time_step| Run {
            outcome: Outcome::Unstable,
            criterion,
            unstable_time_step,
            particles,
            ..run
        };
        match (found, &failed) {
            (Err(NoResult::TooManySteps(too_many)), None) => {
                Run { detail: too_many.to_string(), too_long: true, ..run }
            }
            // no longer time step was stable, otherwise such short ones would not have been tried
            (Err(NoResult::TooManySteps(too_many)), Some(_)) => {
                Run { detail: format!("{too_many}; {above}"), too_long: true, criterion, ..run }
            }
            (Err(NoResult::TooSoft), _) => {
                let detail = format!("no time step is stable, and shorter ones change nothing: {above}");
                none_is(Run { detail, ..run }, failed.as_ref().map(|(step, _)| *step))
            }
            (Ok(edge), _) if edge.stable.is_some() => Run {
                outcome: Outcome::Stable,
                detail: format!("stable up to {}; {above}", edge.stable.map_or_else(String::new, seconds)),
                criterion,
                time_step: edge.stable,
                unstable_time_step: edge.unstable,
                courant: edge.stable.and_then(|step| courant(&with_step(step))),
                particles,
                ..run
            },
            (Ok(_), Some((_, Verdict::Refused(why)))) => Run { detail: why.clone(), ..run },
            (Ok(edge), _) => none_is(Run { detail: format!("no time step is stable: {above}"), ..run }, edge.unstable),
        }
    }
}

/// Distinguishes a fluid that is too soft, and is compressed too far with any time step, from a time step that is too
/// long.
#[derive(Debug, Default)]
struct Softness {
    /// Simulated time at which the density error appeared in the last trial, s.
    time: Option<f64>,
    /// Number of halvings that did not change it.
    in_vain: u32,
}

impl Softness {
    /// Adds the verdict on half of the last time step, and returns whether the fluid is known to be too soft.
    fn is_shown_by(&mut self, verdict: Option<&Verdict>) -> bool {
        let time = match verdict {
            Some(Verdict::Unstable(Broken { criterion: Criterion::DensityError, time, .. })) => Some(*time),
            _ => None,
        };
        let same = time.zip(self.time).is_some_and(|(now, last)| (now - last).abs() <= SAME_TIME * last);
        self.in_vain = if same { self.in_vain + 1 } else { 0 };
        self.time = time;
        self.in_vain >= HALVINGS_IN_VAIN
    }
}

/// Returns the first time step of a bisection, s: from the acoustic limit, or the time step of the scene if its
/// pressure solver removes that limit.
fn first_step(scene: &Scene) -> f32 {
    let acoustic = fastest_sound(scene).map(|sound| FIRST_COURANT * (support_radius(scene) / sound) as f32);
    acoustic.filter(|step| step.is_normal() && *step > 0.0).unwrap_or(scene.time_step)
}

/// Returns the Courant numbers of the scene's time step.
fn courant(scene: &Scene) -> Option<Courant> {
    let travelled = fastest_sound(scene)? * f64::from(scene.time_step);
    let spacing = (travelled / f64::from(scene.particle_spacing)) as f32;
    Some(Courant { support: (travelled / support_radius(scene)) as f32, spacing })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn broken(criterion: Criterion, time: f64) -> Verdict {
        Verdict::Unstable(Broken { criterion, time, words: String::new() })
    }

    #[test]
    fn a_density_error_that_stays_is_the_fluids() {
        let shown = |times: &[f64], criterion| {
            let mut softness = Softness::default();
            times.iter().any(|time| softness.is_shown_by(Some(&broken(criterion, *time))))
        };
        assert!(shown(&[0.5, 0.2, 0.2, 0.201, 0.2], Criterion::DensityError));
        assert!(!shown(&[0.2, 0.2, 0.2], Criterion::DensityError), "too few");
        assert!(!shown(&[0.4, 0.2, 0.1, 0.05, 0.025], Criterion::DensityError), "the time changes");
        assert!(!shown(&[0.2; 9], Criterion::EnergyGrowth));
    }

    #[test]
    fn a_point_is_refused_where_its_scene_is() {
        let limits = Limits { seconds: 0.01, most_steps: 1000 };
        let mut scene =
            crate::scenes::load("still-tank", &crate::scenes::Changes::default()).expect("built in").file.scene;
        scene.fluids[0].rest_density = -1.0;
        let run = limits.run(&Point { choice: Choice::new(), scene }, &ResumeLog::default()).expect("it has no file");
        assert_eq!((run.outcome, run.too_long), (Outcome::Refused, false));
        assert!(run.detail.contains("rest_density is -1"), "{}", run.detail);
    }
}
