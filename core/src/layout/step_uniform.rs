//! The numbers that may change from step to step. Everything else that a pass reads of a scene is constant.
use super::{f32x4, shared};

shared! {
    /// The numbers of a step. On a GPU the time step and the number of the step are copied from the status before each
    /// attempt.
    pub struct StepUniform {
        /// Acceleration of gravity, m/s2; w unused.
        pub gravity: f32x4,
        /// Velocity of the wind, m/s; w: its drag coefficient, 1/s.
        pub wind: f32x4,
        /// Time step, s.
        pub time_step: f32,
        /// Half of the time step, s.
        pub half_time_step: f32,
        /// Inverse of the time step, 1/s.
        pub inverse_time_step: f32,
        /// Number of steps made before this one.
        pub step: u32,
    }
}

impl StepUniform {
    /// The same step with time at rest, which evaluates the forces and moves nothing. The inverse of the time step
    /// keeps its value: only velocity exchange uses it, and that evens out velocities in either direction of time.
    pub(crate) fn at_rest(self) -> StepUniform {
        StepUniform { time_step: 0.0, half_time_step: 0.0, ..self }
    }

    /// The same step backwards in time.
    pub(crate) fn backwards(self) -> StepUniform {
        StepUniform { time_step: -self.time_step, half_time_step: -self.half_time_step, ..self }
    }
}
