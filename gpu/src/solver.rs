//! The solver on a GPU: steps a fluid on the device without reading its particles back.
use crate::buffers::{Buffers, read};
use crate::device::Gpu;
use crate::error::GpuError;
use crate::pass_times::PassClock;
use crate::pipelines::{Dispatch, dispatches, record};
use core::mem::offset_of;
use millpond_core::backend::layout::{Parameters, Status, StepUniform};
use millpond_core::backend::live::LiveScene;
use millpond_core::backend::plan::arrays::Side;
use millpond_core::backend::{Pace, SteadyTime, verdict};
use millpond_core::{AirReport, Array, Census, CorrectionReport, Flux, Pass, Solver, TimeReport};

/// Number of steps that are recorded before the status is read. A failed step is detected at most this many steps late.
/// The device skips the steps recorded after it.
pub const STEPS_PER_STATUS: u32 = 64;

/// Number of steps that are submitted to the device at once.
const STEPS_PER_SUBMISSION: usize = 8;

/// A fluid on a GPU. Create it from a CPU solver, step it with [`GpuSolver::step`] or [`GpuSolver::advance`], and read
/// it back with [`GpuSolver::read`], or share its buffers with a renderer.
#[derive(Debug)]
pub struct GpuSolver {
    pub(crate) gpu: Gpu,
    pub(crate) buffers: Buffers,
    dispatches: Vec<Dispatch>,
    pub(crate) live: LiveScene,
    pub(crate) parameters: Parameters,
    pub(crate) uniform: StepUniform,
    pub(crate) steady: SteadyTime,
    pub(crate) fingerprint: u64,
    first_step: u64,
    pub(crate) pace: Pace,
    /// Time up to which [`GpuSolver::advance`] was asked to advance the fluid, s.
    pub(crate) due: f64,
    /// Number of active particles if none had come or gone.
    active_without_flux: i64,
    /// Number of accepted steps.
    steps: u64,
    /// Number of steps recorded, including rejected attempts.
    attempts: u64,
}

impl GpuSolver {
    /// Creates a solver that continues from the current state of a CPU solver, with the same plan.
    ///
    /// # Errors
    /// [`GpuError::TooLarge`] or [`GpuError::TooManyBuffers`] if the scene is too large for the device,
    /// [`GpuError::TooManySteps`] if the CPU solver has made more steps than a device can count, [`GpuError::CpuOnly`]
    /// if the scene makes a choice that only the CPU supports, and [`GpuError::Shader`] or [`GpuError::Device`] if a
    /// program is rejected or the device fails.
    pub fn new(gpu: &Gpu, solver: &Solver<'_>) -> Result<GpuSolver, GpuError> {
        let parameters = solver.parameters();
        let plan = solver.plan();
        countable(solver.steps())?;
        if plan.model.is_half_stencil == 1 {
            let why = "on a GPU two particles could add to the same third one at once; use FullStencil";
            return Err(GpuError::CpuOnly { choice: "grid.traversal HalfStencil", why });
        }
        let (buffers, dispatches) = gpu.with_error_scopes(|| {
            let buffers = Buffers::of(gpu, solver)?;
            let dispatches = dispatches(gpu, plan, &buffers, parameters)?;
            Ok((buffers, dispatches))
        })?;
        let census = solver.census();
        Ok(GpuSolver {
            gpu: gpu.clone(),
            buffers,
            dispatches,
            live: solver.live().clone(),
            parameters: *parameters,
            uniform: *solver.uniform(),
            steady: solver.steady_time(),
            fingerprint: solver.fingerprint(),
            first_step: solver.steps(),
            pace: Pace::of(&plan.model, parameters),
            due: solver.due(),
            active_without_flux: i64::from(census.active) + census.flux.removed as i64 - census.flux.born as i64,
            steps: solver.steps(),
            attempts: 0,
        })
    }

    /// Makes `count` time steps. Only the status is read back, every [`STEPS_PER_STATUS`] steps.
    ///
    /// # Errors
    /// [`GpuError::Step`] if a step cannot be made. The fluid is then as it was before that step, and this solver makes
    /// no further steps: to continue, read the state with [`GpuSolver::read`] and start from it with a changed scene.
    /// [`GpuError::TooManySteps`] if a device cannot count that many steps, and [`GpuError::Device`] if the device
    /// fails.
    pub fn step(&mut self, count: u32) -> Result<(), GpuError> {
        let until = self.steps + u64::from(count);
        countable(until)?;
        while self.steps < until {
            self.attempt((until - self.steps).min(u64::from(STEPS_PER_STATUS)), None)?;
        }
        Ok(())
    }

    /// Makes one time step and returns the time of each pass on the device, ms, in the order of the step. A pass that
    /// runs several times is listed several times.
    ///
    /// # Errors
    /// Those of [`GpuSolver::step`]; also [`GpuError::NoPassTimes`] if the device cannot time its passes, and
    /// [`GpuError::TooManyPasses`] if a step has more passes than can be timed.
    pub fn step_timed(&mut self) -> Result<Vec<(Pass, f64)>, GpuError> {
        let until = self.steps + 1;
        countable(until)?;
        let clock = self.gpu.with_error_scopes(|| PassClock::new(&self.gpu, self.dispatches.len()))?;
        while self.steps < until {
            self.attempt(1, Some(&clock))?;
        }
        let times = clock.milliseconds(&self.gpu)?;
        Ok(self.dispatches.iter().map(Dispatch::pass).zip(times).collect())
    }

    /// Records `count` attempts at a step, submits them, and reads the status.
    fn attempt(&mut self, count: u64, clock: Option<&PassClock>) -> Result<(), GpuError> {
        let attempts: Vec<u64> = (self.attempts..self.attempts + count).collect();
        // the device executes a submission while the next one is being recorded
        for some in attempts.chunks(STEPS_PER_SUBMISSION) {
            let mut encoder = self.gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
            for attempt in some {
                self.record(&mut encoder, *attempt as usize % 2, clock);
            }
            if let Some(clock) = clock {
                clock.resolve(&mut encoder);
            }
            self.gpu.with_error_scopes(|| Ok(self.gpu.queue.submit([encoder.finish()])))?;
            self.attempts += some.len() as u64;
        }
        let status = self.status()?;
        self.steps = u64::from(status.steps);
        if status.failed == 1 {
            return Err(verdict(&status, self.buffers.model().cell_places)
                .err()
                .map_or_else(inconsistent_status, GpuError::Step));
        }
        Ok(())
    }

    /// Records an attempt at a step that reads state `old`. After a rejected attempt the two states have the wrong
    /// roles for the next attempt, so the device skips that one.
    fn record(&self, encoder: &mut wgpu::CommandEncoder, old: usize, clock: Option<&PassClock>) {
        let Buffers { head, step, .. } = &self.buffers;
        encoder.clear_buffer(head, size_of::<Status>() as u64, None);
        // the time step and the number of the step are copied on the device, so that the host need not read them
        let mut copy = |from: usize, to: usize, words: usize| {
            let bytes = (words * size_of::<u32>()) as u64;
            encoder.copy_buffer_to_buffer(head, from as u64, step, to as u64, Some(bytes));
        };
        copy(offset_of!(Status, steps), offset_of!(StepUniform, step), 1);
        if self.has_changing_step() {
            copy(offset_of!(Status, time_step), offset_of!(StepUniform, time_step), 3);
        }
        record(&self.dispatches, encoder, old, clock);
    }

    /// Index of the state that is the fluid. The two states swap roles with each accepted step.
    pub(crate) fn current(&self) -> usize {
        (self.steps - self.first_step) as usize % 2
    }

    /// Buffer of the positions, for a renderer that shares the device ([`Gpu::with_device`]): `[f32; 4]` each, m,
    /// sorted by cell; ignore w. The positions alternate between two buffers with each accepted step, so get the buffer
    /// again after stepping.
    #[must_use]
    pub fn position_buffer(&self) -> &wgpu::Buffer {
        self.buffers.array(Array::position, Side::Old, self.current())
    }

    /// Buffer of the velocities, m/s, in the form of [`GpuSolver::position_buffer`].
    #[must_use]
    pub fn velocity_buffer(&self) -> &wgpu::Buffer {
        self.buffers.array(Array::velocity, Side::Old, self.current())
    }

    /// Returns whether the length of time steps may change.
    pub(crate) fn has_changing_step(&self) -> bool {
        self.buffers.model().has_changing_step == 1
    }

    /// Result of the pressure correction; all zero with an equation of state. It waits for the device.
    ///
    /// # Errors
    /// [`GpuError::Device`] if the device fails.
    pub fn correction(&self) -> Result<CorrectionReport, GpuError> {
        let status = self.status()?;
        Ok(CorrectionReport {
            iterations: status.last_iterations,
            total_iterations: u64::from(status.total_iterations),
            residual: f32::from_bits(status.last_residual),
        })
    }

    /// Report on the time step, as [`Solver::time_report`] returns it. It waits for the device.
    ///
    /// # Errors
    /// [`GpuError::Device`] if the device fails.
    pub fn time_report(&self) -> Result<TimeReport, GpuError> {
        let report = TimeReport::of(&self.status()?);
        Ok(if self.has_changing_step() {
            report
        } else {
            TimeReport { wanted: report.wanted, time_step: report.time_step, ..self.steady_report() }
        })
    }

    /// Returns the report on a fixed time step, without reading from the device.
    pub(crate) fn steady_report(&self) -> TimeReport {
        let step = self.uniform.time_step;
        TimeReport {
            time: self.steady.after(self.steps, step),
            time_step: step,
            wanted: step,
            next: step,
            ..TimeReport::default()
        }
    }

    /// State of the layer of air, as [`Solver::air`] returns it; all zero in scenes without air. It waits for the
    /// device.
    ///
    /// # Errors
    /// [`GpuError::Device`] if the device fails.
    pub fn air(&self) -> Result<AirReport, GpuError> {
        let status = self.status()?;
        Ok(AirReport { active: status.air_alive, refused: u64::from(status.air_refused) })
    }

    /// The number of active particles, and how many came and went, as [`Solver::census`] returns them. It waits for the
    /// device.
    ///
    /// # Errors
    /// [`GpuError::Device`] if the device fails.
    pub fn census(&self) -> Result<Census, GpuError> {
        let flux = Flux::of_status(&self.status()?);
        Ok(Census { active: (self.active_without_flux + flux.born as i64 - flux.removed as i64) as u32, flux })
    }

    /// Reads the status that the last step wrote. It waits for the device.
    ///
    /// # Errors
    /// [`GpuError::Device`] if the device fails.
    pub fn status(&self) -> Result<Status, GpuError> {
        let status: Vec<Status> = read(&self.gpu, &self.buffers.head, 1)?;
        status.first().copied().ok_or_else(inconsistent_status)
    }

    /// Number of accepted steps, including those of the CPU solver from which it was created.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.steps
    }
}

// in both structs the three numbers of the time step are adjacent, so that one copy moves them
const _: () = assert!(offset_of!(Status, half_time_step) == offset_of!(Status, time_step) + 4);
const _: () = assert!(offset_of!(Status, inverse_time_step) == offset_of!(Status, time_step) + 8);
const _: () = assert!(offset_of!(StepUniform, half_time_step) == offset_of!(StepUniform, time_step) + 4);
const _: () = assert!(offset_of!(StepUniform, inverse_time_step) == offset_of!(StepUniform, time_step) + 8);

/// Largest number of steps that a device can count.
const MOST_STEPS: u64 = u32::MAX as u64;

fn countable(steps: u64) -> Result<(), GpuError> {
    if steps > MOST_STEPS { Err(GpuError::TooManySteps { steps, most: MOST_STEPS }) } else { Ok(()) }
}

/// Returns the error of a status that contradicts itself.
fn inconsistent_status() -> GpuError {
    GpuError::Device("the status reports a failed step without a reason".into())
}
