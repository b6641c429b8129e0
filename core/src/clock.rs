//! The clock of a fluid: the next time step, and how much time has passed. Its formulas are terms, so that a device's clock shows
//! the same bits.
use crate::layout::{Model, Parameters, Status, StepUniform};
use crate::passes::context::Maxima;
use crate::terms::time_step::{
    clock_after, clock_lost, is_overlong, step_half, step_inverse, step_limited, step_wanted,
};

/// What became of the time step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TimeReport {
    /// Simulated time, s.
    pub time: f64,
    /// The last step that counts, s; before the first one the first.
    pub time_step: f32,
    /// What the criteria asked for at its end, s; the same where all steps are alike.
    pub wanted: f32,
    /// The next step, s.
    pub next: f32,
    /// Steps that were undone and made again, shorter.
    pub rejected_steps: u32,
    /// Steps that should have been shorter than the shortest allowed.
    pub held: u32,
}

/// The clock of a solver.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Clock {
    time: f32,
    lost: f32,
    last: f32,
    wanted: f32,
    rejected_steps: u32,
    held: u32,
}

impl Clock {
    /// Before the first step: as long as the scene says, or as short as its state asks for.
    pub(crate) fn start(m: &Model, p: &Parameters, u: &mut StepUniform, maxima: Maxima) -> Clock {
        if m.is_adaptive == 0 {
            return Clock { last: u.time_step, wanted: u.time_step, ..Clock::default() };
        }
        let wanted = wanted(p, maxima);
        let limits = Parameters { max_time_step_growth: 1.0, ..*p };
        set_step(u, step_limited::<f32>(&limits, wanted, u.time_step));
        Clock { last: u.time_step, wanted, ..Clock::default() }
    }

    /// After a step by these numbers: sets those of the next one. False where the step is to be made again by them.
    pub(crate) fn after(&mut self, m: &Model, p: &Parameters, u: &mut StepUniform, maxima: Maxima) -> bool {
        let step = u.time_step;
        let mut wanted = step;
        if m.is_adaptive == 1 {
            wanted = self::wanted(p, maxima);
            let again = is_overlong::<f32>(p, wanted, step) > 0.0;
            self.rejected_steps = self.rejected_steps.wrapping_add(u32::from(again));
            self.held = self.held.wrapping_add(u32::from(!again && wanted < p.smallest_time_step));
            set_step(u, step_limited::<f32>(p, wanted, step));
            if again {
                return false;
            }
        }
        (self.last, self.wanted) = (step, wanted);
        u.step = u.step.wrapping_add(1);
        let time = clock_after::<f32>(self.time, step);
        (self.time, self.lost) = (time, clock_lost::<f32>(self.time, self.lost, step, time));
        true
    }

    /// As it is saved: its two numbers, the last step and what it should have been; steps made again, steps held.
    pub(crate) fn to_record(self) -> ([f32; 4], [u32; 2]) {
        ([self.time, self.lost, self.last, self.wanted], [self.rejected_steps, self.held])
    }

    /// As it was saved.
    pub(crate) fn of_record([time, lost, last, wanted]: [f32; 4], [rejected_steps, held]: [u32; 2]) -> Clock {
        Clock { time, lost, last, wanted, rejected_steps, held }
    }

    pub(crate) fn report(&self, u: &StepUniform) -> TimeReport {
        TimeReport {
            time: f64::from(self.time) + f64::from(self.lost),
            time_step: self.last,
            wanted: self.wanted,
            next: u.time_step,
            rejected_steps: self.rejected_steps,
            held: self.held,
        }
    }

    /// Writes what a device goes on from.
    pub(crate) fn fill(&self, u: &StepUniform, status: &mut Status) {
        (status.clock, status.clock_lost) = (self.time, self.lost);
        (status.last_time_step, status.last_wanted) = (self.last, self.wanted);
        (status.rejected_steps, status.held) = (self.rejected_steps, self.held);
        (status.time_step, status.half_time_step) = (u.time_step, u.half_time_step);
        status.first_time_step = u.time_step;
        status.inverse_time_step = u.inverse_time_step;
    }
}

impl TimeReport {
    /// As a device's status says it.
    #[must_use]
    pub fn of(status: &Status) -> TimeReport {
        TimeReport {
            time: f64::from(status.clock) + f64::from(status.clock_lost),
            time_step: status.last_time_step,
            wanted: status.last_wanted,
            next: status.time_step,
            rejected_steps: status.rejected_steps,
            held: status.held,
        }
    }
}

fn wanted(p: &Parameters, maxima: Maxima) -> f32 {
    step_wanted::<f32>(p, maxima.speed2, maxima.acceleration2, maxima.sound)
}

/// Time by steps that are all alike: exact, where a clock that adds them up is not.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SteadyTime {
    /// Steps that were made when the time step was last changed.
    pub since: u64,
    /// Simulated time then, s.
    pub at: f64,
}

impl SteadyTime {
    /// Time after so many steps, the last ones of this length, s.
    #[must_use]
    pub fn after(&self, steps: u64, time_step: f32) -> f64 {
        self.at + steps.saturating_sub(self.since) as f64 * f64::from(time_step)
    }

    /// From here on with another time step; the last ones were of this length.
    #[must_use]
    pub fn changed(&self, steps: u64, time_step: f32) -> SteadyTime {
        SteadyTime { since: steps, at: self.after(steps, time_step) }
    }
}

impl StepUniform {
    /// The same numbers with another time step, s.
    #[must_use]
    pub fn with_time_step(self, step: f32) -> StepUniform {
        let (half_time_step, inverse_time_step) = (step_half::<f32>(step), step_inverse::<f32>(step));
        StepUniform { time_step: step, half_time_step, inverse_time_step, ..self }
    }
}

/// Writes a time step where formulas look for it.
pub(crate) fn set_step(u: &mut StepUniform, step: f32) {
    *u = u.with_time_step(step);
}
