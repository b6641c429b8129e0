//! Makes as many steps as fit into a simulated time, as on the CPU. The code that decides how many is core's.
use crate::error::GpuError;
use crate::solver::GpuSolver;
use millpond_core::backend::layout::{Status, StepUniform};
use millpond_core::backend::{Pace, Paced, advance, step_until};
use millpond_core::{Advance, TimeReport};
use std::mem::offset_of;

impl Paced for GpuSolver {
    type Error = GpuError;

    fn due(&mut self) -> &mut f64 {
        &mut self.due
    }

    fn clock(&mut self) -> Result<TimeReport, GpuError> {
        // only an adaptive time step is determined on the device, where reading it takes time
        if self.has_changing_step() { self.time_report() } else { Ok(self.steady_report()) }
    }

    fn pace(&self) -> Pace {
        self.pace
    }

    fn make(&mut self, steps: u32) -> Result<(), GpuError> {
        self.step(steps)
    }

    fn set_next(&mut self, step: f32) {
        let StepUniform { time_step, half_time_step, inverse_time_step, .. } = self.uniform.with_time_step(step);
        // the fourth is the step to return to if the next one cannot be made
        let numbers = [time_step, half_time_step, inverse_time_step, time_step];
        let at = offset_of!(Status, time_step) as u64;
        self.gpu.queue.write_buffer(&self.buffers.head, at, bytemuck::cast_slice(&numbers));
    }
}

impl GpuSolver {
    /// Advances the fluid by `seconds` of simulated time, in at most `most_steps` steps. The steps are those of
    /// [`Solver::advance`](millpond_core::Solver::advance), bit for bit in strict mode.
    ///
    /// # Errors
    /// Those of [`Solver::advance`](millpond_core::Solver::advance), and a device that fails.
    pub fn advance(&mut self, seconds: f64, most_steps: u32) -> Result<Advance, GpuError> {
        advance(self, seconds, most_steps)
    }

    /// Steps the fluid up to a point in simulated time, s, in at most `most_steps` steps. The steps are those of
    /// [`Solver::step_until`](millpond_core::Solver::step_until).
    ///
    /// # Errors
    /// Those of [`Solver::step_until`](millpond_core::Solver::step_until), and a device that fails.
    pub fn step_until(&mut self, time: f64, most_steps: u32) -> Result<Advance, GpuError> {
        step_until(self, time, most_steps)
    }
}
