//! Steps counted out by simulated time: how many steps fit into a frame of a game, or up to a point in time. Both
//! backends run this text, so both make the same steps.
use crate::clock::TimeReport;
use crate::error::StepError;
use crate::executor::Executor;
use crate::layout::{Model, Parameters};
use crate::solver::Solver;

/// What [`Solver::advance`] or [`Solver::step_until`] did.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Advance {
    /// Steps that were made.
    pub steps: u32,
    /// Time that was asked for and is not simulated yet, s: less than a step, and a little below zero where a step came
    /// early by a thousandth of its length. The next call of [`Solver::advance`] makes up for it.
    pub remainder: f64,
    /// Time that was given up, s: whole steps beyond the number that the caller allows. A game that cannot keep up runs
    /// in slow motion then, instead of falling behind for ever.
    pub dropped: f64,
}

/// Share of its length by which a step may come early. Without it rounding would decide, frame by frame, whether ten
/// steps of 1/600 s fit into 1/60 s.
const EARLY: f64 = 1e-3;

/// Share of a step that counts as no time left.
const LANDED: f64 = 1e-6;

/// A bound that is computed from the largest growth keeps this distance from the exact comparison, so that rounding
/// cannot make them differ.
const SAFETY: f64 = 1.0 + 1e-6;

/// A fluid whose steps are counted out.
pub trait Paced {
    /// Why a step cannot be made.
    type Error: From<StepError>;

    /// Up to when steps were asked for, s.
    fn due(&mut self) -> &mut f64;

    /// The clock.
    ///
    /// # Errors
    /// A device that fails.
    fn clock(&mut self) -> Result<TimeReport, Self::Error>;

    /// Limits of the next steps.
    fn pace(&self) -> Pace;

    /// Makes steps.
    ///
    /// # Errors
    /// A step that cannot be made.
    fn make(&mut self, steps: u32) -> Result<(), Self::Error>;

    /// Sets the length of the next step, s.
    fn set_next(&mut self, step: f32);
}

/// How the lengths of steps can change.
#[derive(Clone, Copy, Debug)]
pub struct Pace {
    changes: bool,
    growth: f64,
    longest: f64,
}

impl Pace {
    /// The pace of a scene by its constants.
    #[must_use]
    pub fn of(m: &Model, p: &Parameters) -> Pace {
        Pace {
            changes: m.has_changing_step == 1,
            growth: f64::from(p.max_time_step_growth),
            longest: f64::from(p.largest_time_step),
        }
    }

    /// Steps that certainly fit after one that fits, while `left` of the time, s, is at least `margin` times the next
    /// step, `step`.
    fn further(self, left: f64, step: f64, margin: f64, most: u32) -> u32 {
        if !self.changes {
            let fits = libm::floor(left / step - margin * SAFETY);
            return (fits.clamp(0.0, f64::from(u32::MAX)) as u32).min(most);
        }
        let (mut left, mut step, mut steps) = (left - step, step, 0);
        while steps < most {
            step = (step * self.growth).min(self.longest);
            if left < step * margin * SAFETY {
                break;
            }
            left -= step;
            steps += 1;
        }
        steps
    }
}

/// Advances a fluid by a time, in at most `most` steps: see [`Solver::advance`].
///
/// # Errors
/// As there.
pub fn advance<F: Paced>(fluid: &mut F, seconds: f64, most: u32) -> Result<Advance, F::Error> {
    if !(seconds.is_finite() && seconds >= 0.0) {
        return Err(StepError::InvalidTime { seconds }.into());
    }
    let margin = 1.0 - EARLY;
    let (pace, mut now) = (fluid.pace(), fluid.clock()?);
    // steps that were made by other calls count as asked for
    let was_due = *fluid.due();
    let is_ahead = was_due.is_finite() && was_due >= now.time - EARLY * f64::from(now.next);
    let due = seconds + if is_ahead { was_due } else { now.time };
    let mut steps = 0;
    while steps < most {
        let (left, next) = (due - now.time, f64::from(now.next));
        if left < next * margin {
            break;
        }
        let count = 1 + pace.further(left, next, margin, most - steps - 1);
        if let Err(error) = fluid.make(count) {
            // a refused step is not tried again for the time that was asked for
            *fluid.due() = f64::NEG_INFINITY;
            return Err(error);
        }
        steps += count;
        now = fluid.clock()?;
    }
    let (left, next) = (due - now.time, f64::from(now.next));
    // whole steps, of which one may come early
    let rest = libm::fmod(left, next);
    let rest = if rest < next * margin { rest } else { rest - next };
    let dropped = if left < next * margin { 0.0 } else { left - rest };
    *fluid.due() = due - dropped;
    Ok(Advance { steps, remainder: left - dropped, dropped })
}

/// Steps a fluid up to a time, in at most `most` steps: see [`Solver::step_until`].
///
/// # Errors
/// As there.
pub fn step_until<F: Paced>(fluid: &mut F, time: f64, most: u32) -> Result<Advance, F::Error> {
    let (pace, mut now) = (fluid.pace(), fluid.clock()?);
    // rounding may have carried the clock a little past the time
    if !(time.is_finite() && time >= now.time - EARLY * f64::from(now.next)) {
        return Err(StepError::InvalidTime { seconds: time }.into());
    }
    let mut steps = 0;
    while steps < most {
        let (left, next) = (time - now.time, f64::from(now.next));
        if !pace.changes {
            if left < next * (1.0 - EARLY) {
                break;
            }
            let count = 1 + pace.further(left, next, 1.0 - EARLY, most - steps - 1);
            fluid.make(count)?;
            steps += count;
        } else if left >= 2.0 * next {
            let count = 1 + pace.further(left, next, 2.0, most - steps - 1);
            fluid.make(count)?;
            steps += count;
        } else if left > next * LANDED {
            // the last one or two steps are shortened, so that neither is tiny
            let shorter = if left <= next { left } else { 0.5 * left };
            fluid.set_next(shorter as f32);
            let made = fluid.make(1);
            if made.is_err() {
                fluid.set_next(now.next);
            }
            made?;
            steps += 1;
            let after = fluid.clock()?;
            // the step after it need not grow from a shortened one, unless it had to be shorter still
            if (after.rejected_steps, after.halvings) == (now.rejected_steps, now.halvings) {
                fluid.set_next(after.next.max(now.next.min(after.wanted)));
                if left <= next {
                    now = after;
                    break;
                }
            }
        } else {
            break;
        }
        now = fluid.clock()?;
    }
    *fluid.due() = now.time;
    Ok(Advance { steps, remainder: time - now.time, dropped: 0.0 })
}

/// A CPU solver with the executor that runs its steps.
struct OnCpu<'a, 'm, E> {
    solver: &'a mut Solver<'m>,
    executor: &'a E,
}

impl<E: Executor> Paced for OnCpu<'_, '_, E> {
    type Error = StepError;

    fn due(&mut self) -> &mut f64 {
        &mut self.solver.due
    }

    fn clock(&mut self) -> Result<TimeReport, StepError> {
        Ok(self.solver.time_report())
    }

    fn pace(&self) -> Pace {
        Pace::of(&self.solver.plan.model, self.solver.parameters())
    }

    fn make(&mut self, steps: u32) -> Result<(), StepError> {
        (0..steps).try_for_each(|_| self.solver.step(self.executor))
    }

    fn set_next(&mut self, step: f32) {
        self.solver.set_next_step(step);
    }
}

impl Solver<'_> {
    /// Advances the fluid by `seconds` of simulated time, in as many time steps as that takes, and at most
    /// `most_steps`.
    ///
    /// This is the call for a game loop: once a frame, with the length of the frame. Time that is shorter than a step
    /// is carried into the next call, so that simulated time keeps up with the time asked for. Time beyond `most_steps`
    /// is dropped, and the answer says how much. The length of a step follows from the scene, and never from the frame
    /// rate.
    ///
    /// ```
    /// use millpond_core::glam::Vec3;
    /// use millpond_core::scene::{Block, Dimension, Fluid, Grid, Scene};
    /// use millpond_core::{Serial, Solver, Storage};
    ///
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let block = Block { size: Vec3::splat(0.4), ..Block::default() };
    /// let mut scene = Scene::of(Dimension::Three, 0.05, 0.001, Fluid::default(), block);
    /// scene.grid = Grid { cells: [8, 8, 8], ..Grid::default() };
    /// let mut storage: Box<Storage<512, 512>> = Storage::boxed();
    /// let mut solver = Solver::new(&scene, storage.lend())?;
    /// let frames = (0..6).map(|_| solver.advance(1.0 / 60.0, 100, &Serial)).collect::<Result<Vec<_>, _>>()?;
    /// assert_eq!(frames.iter().map(|frame| frame.steps).collect::<Vec<_>>(), [16, 17, 17, 16, 17, 17]);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`StepError::InvalidTime`] for a negative time or one that is not finite. Any other [`StepError`] where a step
    /// cannot be made: the fluid is as it was before that step, the steps before it count, and the time that was asked
    /// for is forgotten.
    pub fn advance(&mut self, seconds: f64, most_steps: u32, executor: &impl Executor) -> Result<Advance, StepError> {
        advance(&mut OnCpu { solver: self, executor }, seconds, most_steps)
    }

    /// Steps the fluid up to a point in simulated time, s, in at most `most_steps`.
    ///
    /// If the time step can change ([`Scene::adaptive`](crate::scene::Scene::adaptive) or
    /// [`Recovery::ShortenStep`](crate::scene::Recovery)), the last one or two steps are shortened, so that the clock
    /// shows that time to one part in 10^6 of a step, and the step after them has its usual length again. Otherwise the
    /// fluid stops at the last whole step before that time, and the remainder says how far away it is.
    ///
    /// # Errors
    /// [`StepError::InvalidTime`] for a time that has passed or is not finite. Any other [`StepError`] where a step
    /// cannot be made: the fluid is as it was before that step, and the steps before it count.
    pub fn step_until(&mut self, time: f64, most_steps: u32, executor: &impl Executor) -> Result<Advance, StepError> {
        step_until(&mut OnCpu { solver: self, executor }, time, most_steps)
    }
}
