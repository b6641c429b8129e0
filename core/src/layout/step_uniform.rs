//! What may change from step to step: everything else that a pass reads of a scene is constant.
use super::{f32x4, shared};

shared! {
    /// The numbers of a step. A device copies its time step and its number from the status before each attempt.
    pub struct StepUniform {
        /// Acceleration of gravity, m/s2; w unused.
        pub gravity: f32x4,
        /// Velocity of the wind, m/s, and its drag, 1/s.
        pub wind: f32x4,
        /// Time step, s.
        pub time_step: f32,
        /// Half of it, s.
        pub half_time_step: f32,
        /// One over it, 1/s.
        pub inverse_time_step: f32,
        /// Steps that were made before this one.
        pub step: u32,
    }
}

impl StepUniform {
    /// The same step with time standing still: it evaluates the forces and moves nothing. One over the step stays what it is: only
    /// exchanges read it, which even out whichever way time runs.
    pub(crate) fn at_rest(self) -> StepUniform {
        StepUniform { time_step: 0.0, half_time_step: 0.0, ..self }
    }

    /// The same step back in time.
    pub(crate) fn backwards(self) -> StepUniform {
        StepUniform { time_step: -self.time_step, half_time_step: -self.half_time_step, ..self }
    }
}
