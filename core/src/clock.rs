//! The clock of a fluid: the next time step, and the simulated time. Its formulas are terms, which a GPU runs as well,
//! so that the clock of a GPU has the same bits.
use crate::layout::{Model, Parameters, Status, StepUniform};
use crate::passes::context::Maxima;
use crate::terms::time_step::{
    clock_after, clock_lost, is_overlong, step_half, step_inverse, step_limited, step_wanted,
};

/// Report on the time step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TimeReport {
    /// Simulated time, s.
    pub time: f64,
    /// The last accepted step, s; before the first step, the first time step.
    pub time_step: f32,
    /// Longest time step that the criteria allowed at the end of the last accepted step, s. With a fixed time step it
    /// equals `time_step`.
    pub wanted: f32,
    /// The next step, s.
    pub next: f32,
    /// Number of steps that were rejected and repeated with a shorter time step
    /// ([`AdaptiveTimeStep::reject_ratio`](crate::scene::AdaptiveTimeStep::reject_ratio)).
    pub rejected_steps: u32,
    /// Number of steps that should have been shorter than the shortest time step allowed.
    pub clamped_steps: u32,
    /// Number of times that a step was halved because it could not be made ([`Recovery`](crate::scene::Recovery)).
    pub halvings: u32,
}

/// The clock of a solver. It stores time as two numbers, `time` and the sum of its rounding errors, `lost`.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Clock {
    time: f32,
    lost: f32,
    last: f32,
    wanted: f32,
    rejected_steps: u32,
    clamped_steps: u32,
    halvings: u32,
}

impl Clock {
    /// Returns the clock before the first step, and sets the first time step in `u`: that of the scene, or a shorter
    /// one if the state at the start needs it.
    pub(crate) fn start(m: &Model, p: &Parameters, u: &mut StepUniform, maxima: Maxima) -> Clock {
        if m.has_changing_step == 0 {
            return Clock { last: u.time_step, wanted: u.time_step, ..Clock::default() };
        }
        let wanted = wanted(p, maxima);
        let limits = Parameters { max_time_step_growth: 1.0, ..*p };
        set_step(u, step_limited::<f32>(&limits, wanted, u.time_step));
        Clock { last: u.time_step, wanted, ..Clock::default() }
    }

    /// Advances the clock after a step with the numbers in `u`, and sets those of the next step. Returns false if the
    /// step is rejected and must be repeated with the new numbers.
    pub(crate) fn after(&mut self, m: &Model, p: &Parameters, u: &mut StepUniform, maxima: Maxima) -> bool {
        let step = u.time_step;
        let mut wanted = step;
        if m.has_changing_step == 1 {
            wanted = self::wanted(p, maxima);
            let again = is_overlong::<f32>(p, wanted, step) > 0.0;
            self.rejected_steps = self.rejected_steps.wrapping_add(u32::from(again));
            self.clamped_steps = self.clamped_steps.wrapping_add(u32::from(!again && wanted < p.smallest_time_step));
            set_step(u, step_limited::<f32>(p, wanted, step));
            if again {
                return false;
            }
        }
        (self.last, self.wanted) = (step, wanted);
        u.step = u.step.wrapping_add(1);
        let time = clock_after::<f32>(self.time, self.lost, step);
        (self.time, self.lost) = (time, clock_lost::<f32>(self.time, self.lost, step, time));
        true
    }

    /// Returns the two numbers of the simulated time, s.
    pub(crate) fn time(&self) -> [f32; 2] {
        [self.time, self.lost]
    }

    /// Counts how many times an accepted step was halved.
    pub(crate) fn shortened(&mut self, times: u32) {
        self.halvings = self.halvings.wrapping_add(times);
    }

    /// Returns the clock as it is saved: the two numbers of the time, the last time step and the longest one that the
    /// criteria allowed; then the counts of rejected, clamped and shortened steps.
    pub(crate) fn to_record(self) -> ([f32; 4], [u32; 3]) {
        let counts = [self.rejected_steps, self.clamped_steps, self.halvings];
        ([self.time, self.lost, self.last, self.wanted], counts)
    }

    /// Returns the clock that was saved.
    pub(crate) fn of_record(
        [time, lost, last, wanted]: [f32; 4],
        [rejected_steps, clamped_steps, halvings]: [u32; 3],
    ) -> Clock {
        Clock { time, lost, last, wanted, rejected_steps, clamped_steps, halvings }
    }

    pub(crate) fn report(&self, u: &StepUniform) -> TimeReport {
        TimeReport {
            time: f64::from(self.time) + f64::from(self.lost),
            time_step: self.last,
            wanted: self.wanted,
            next: u.time_step,
            rejected_steps: self.rejected_steps,
            clamped_steps: self.clamped_steps,
            halvings: self.halvings,
        }
    }

    /// Writes the state of the clock into the status from which a GPU continues.
    pub(crate) fn fill(&self, u: &StepUniform, status: &mut Status) {
        (status.clock, status.clock_lost) = (self.time, self.lost);
        (status.last_time_step, status.last_wanted) = (self.last, self.wanted);
        (status.rejected_steps, status.clamped_steps) = (self.rejected_steps, self.clamped_steps);
        status.halvings = self.halvings;
        (status.time_step, status.half_time_step) = (u.time_step, u.half_time_step);
        status.first_time_step = u.time_step;
        status.inverse_time_step = u.inverse_time_step;
    }
}

impl TimeReport {
    /// Returns the report of a GPU from its status.
    #[must_use]
    pub fn of(status: &Status) -> TimeReport {
        TimeReport {
            time: f64::from(status.clock) + f64::from(status.clock_lost),
            time_step: status.last_time_step,
            wanted: status.last_wanted,
            next: status.time_step,
            rejected_steps: status.rejected_steps,
            clamped_steps: status.clamped_steps,
            halvings: status.halvings,
        }
    }
}

fn wanted(p: &Parameters, maxima: Maxima) -> f32 {
    step_wanted::<f32>(p, maxima.speed2, maxima.acceleration2, maxima.sound)
}

/// Simulated time with a fixed time step. It is computed from the number of steps, and therefore has no rounding errors
/// of a sum over steps.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SteadyTime {
    /// Number of steps made when the time step was last changed.
    pub since: u64,
    /// Simulated time at that moment, s.
    pub at: f64,
}

impl SteadyTime {
    /// Returns the simulated time after `steps` steps, s. `time_step` is the length of steps since the last change, s.
    #[must_use]
    pub fn after(&self, steps: u64, time_step: f32) -> f64 {
        self.at + steps.saturating_sub(self.since) as f64 * f64::from(time_step)
    }

    /// Returns the simulated time for a time step that changes after `steps` steps. `time_step` is the length of the
    /// steps before the change, s.
    #[must_use]
    pub fn changed(&self, steps: u64, time_step: f32) -> SteadyTime {
        SteadyTime { since: steps, at: self.after(steps, time_step) }
    }
}

impl StepUniform {
    /// Returns the numbers with another time step, s.
    #[must_use]
    pub fn with_time_step(self, step: f32) -> StepUniform {
        let (half_time_step, inverse_time_step) = (step_half::<f32>(step), step_inverse::<f32>(step));
        StepUniform { time_step: step, half_time_step, inverse_time_step, ..self }
    }
}

/// Sets the time step, its half and its inverse.
pub(crate) fn set_step(u: &mut StepUniform, step: f32) {
    *u = u.with_time_step(step);
}
