//! The solver on a GPU: steps a fluid on the device without reading its particles back.
use crate::bindings::is_on_device;
use crate::buffers::{Buffers, read};
use crate::device::Gpu;
use crate::error::GpuError;
use crate::pass_times::PassClock;
use crate::pipelines::{Dispatch, dispatches, record};
use core::mem::offset_of;
use millpond_core::backend::arithmetic::real::{div, vec3};
use millpond_core::backend::hash::state_hash;
use millpond_core::backend::layout::{Status, StepUniform, f32x4};
use millpond_core::backend::live::{Change, LiveScene};
use millpond_core::backend::plan::arrays::{Class, Side};
use millpond_core::backend::save::{Record, saved_bytes, write};
use millpond_core::backend::terms::integrate::history_rescaled;
use millpond_core::backend::{Pace, SteadyTime, verdict};
use millpond_core::glam::Vec3;
use millpond_core::scene::Wind;
use millpond_core::{AirReport, Array, CorrectionReport, Pass, SceneError, Solver, TimeReport};

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
    live: LiveScene,
    pub(crate) uniform: StepUniform,
    steady: SteadyTime,
    fingerprint: u64,
    first_step: u64,
    pub(crate) pace: Pace,
    /// Time up to which [`GpuSolver::advance`] was asked to advance the fluid, s.
    pub(crate) due: f64,
    /// Number of accepted steps.
    steps: u64,
    /// Number of steps recorded, including rejected attempts.
    attempts: u64,
}

/// A state that was read back: its arrays, in the slots of the device.
#[derive(Clone, Debug)]
pub struct Readback {
    arrays: Vec<Vec<u32>>,
}

impl Readback {
    /// An array of the state as words of four bytes; empty for an array that the scene does not need, or that is not
    /// part of the state.
    #[must_use]
    pub fn words(&self, array: Array) -> &[u32] {
        &self.arrays[array as usize]
    }

    /// An array of vectors.
    fn vectors(&self, array: Array) -> &[f32x4] {
        bytemuck::cast_slice(self.words(array))
    }

    /// Positions, m; the fourth number is the mass over the mass of a particle of the same fluid at rest.
    #[must_use]
    pub fn position(&self) -> &[f32x4] {
        self.vectors(Array::position)
    }

    /// Velocities, m/s; the fourth number is the material.
    #[must_use]
    pub fn velocity(&self) -> &[f32x4] {
        self.vectors(Array::velocity)
    }

    /// Slot of each particle in these arrays, by id.
    #[must_use]
    pub fn slots(&self) -> &[u32] {
        self.words(Array::slot_of_id)
    }

    /// Hash of all positions and velocities. It equals that of [`Solver::hash`] if all bits are equal.
    #[must_use]
    pub fn hash(&self) -> u64 {
        state_hash(self.slots(), self.position(), self.velocity())
    }
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
        Ok(GpuSolver {
            gpu: gpu.clone(),
            buffers,
            dispatches,
            live: solver.live().clone(),
            uniform: *solver.uniform(),
            steady: solver.steady_time(),
            fingerprint: solver.fingerprint(),
            first_step: solver.steps(),
            pace: Pace::of(&plan.model, parameters),
            due: solver.due(),
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
        if self.is_adaptive() {
            copy(offset_of!(Status, time_step), offset_of!(StepUniform, time_step), 3);
        }
        record(&self.dispatches, encoder, old, clock);
    }

    /// Index of the state that is the fluid. The two states swap roles with each accepted step.
    fn current(&self) -> usize {
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

    /// Sets the acceleration field supplied by the caller, from the next step on, as [`Solver::set_field`] does.
    ///
    /// # Errors
    /// [`SceneError::WrongLength`] if the scene has fewer or more nodes, [`SceneError::NotFinite`] for a value that is
    /// not finite, and [`GpuError::BeforeFirstStep`] before the first step of the fluid. The field stays as it was.
    pub fn set_field(&mut self, points: &[f32x4]) -> Result<(), GpuError> {
        let (given, expected) = (points.len(), self.buffers.counts().field_nodes);
        if given != expected {
            return Err(SceneError::WrongLength { call: "set_field", what: "points", given, expected }.into());
        }
        if let Some(&value) = points.as_flattened().iter().find(|x| !x.is_finite()) {
            return Err(SceneError::NotFinite { field: "acceleration_field", value }.into());
        }
        if expected > 0 {
            self.has_begun("set_field")?;
            let field = self.buffers.array(Array::acceleration_field, Side::Only, 0);
            self.gpu.queue.write_buffer(field, 0, bytemuck::cast_slice(points));
        }
        Ok(())
    }

    /// Sets the acceleration of gravity, m/s2, from the next step on, as [`Solver::set_gravity`] does.
    ///
    /// # Errors
    /// Those of [`Solver::set_gravity`]; also [`GpuError::BeforeFirstStep`] before the first step of the fluid: make
    /// the change on the CPU solver instead. The fluid stays as it was.
    pub fn set_gravity(&mut self, gravity: impl Into<Vec3>) -> Result<(), GpuError> {
        self.change("set_gravity", Change::Gravity(gravity.into()))
    }

    /// Sets the wind from the next step on, as [`Solver::set_wind`] does.
    ///
    /// # Errors
    /// Those of [`Solver::set_wind`] and [`GpuSolver::set_gravity`].
    pub fn set_wind(&mut self, wind: Option<Wind>) -> Result<(), GpuError> {
        self.change("set_wind", Change::Wind(wind))
    }

    /// Sets the time step, s, from the next step on, as [`Solver::set_time_step`] does.
    ///
    /// # Errors
    /// Those of [`Solver::set_time_step`] and [`GpuSolver::set_gravity`].
    pub fn set_time_step(&mut self, time_step: f32) -> Result<(), GpuError> {
        self.change("set_time_step", Change::TimeStep(time_step))
    }

    /// Sets the dynamic viscosity, Pa s, of a fluid from the next step on, as [`Solver::set_viscosity`] does.
    ///
    /// # Errors
    /// Those of [`Solver::set_viscosity`] and [`GpuSolver::set_gravity`].
    pub fn set_viscosity(&mut self, fluid: u32, viscosity: f32) -> Result<(), GpuError> {
        self.change("set_viscosity", Change::Viscosity(fluid, viscosity))
    }

    /// Sets the coefficient of surface tension of a fluid from the next step on, as [`Solver::set_surface_tension`]
    /// does.
    ///
    /// # Errors
    /// Those of [`Solver::set_surface_tension`] and [`GpuSolver::set_gravity`].
    pub fn set_surface_tension(&mut self, fluid: u32, tension: f32) -> Result<(), GpuError> {
        self.change("set_surface_tension", Change::SurfaceTension(fluid, tension))
    }

    /// Sets the speed of sound, m/s, of a fluid from the next step on, as [`Solver::set_speed_of_sound`] does.
    ///
    /// # Errors
    /// Those of [`Solver::set_speed_of_sound`] and [`GpuSolver::set_gravity`].
    pub fn set_speed_of_sound(&mut self, fluid: u32, speed: f32) -> Result<(), GpuError> {
        self.change("set_speed_of_sound", Change::SpeedOfSound(fluid, speed))
    }

    /// Sets the constant B of Tait's equation, Pa, of a fluid from the next step on, as [`Solver::set_stiffness`] does.
    ///
    /// # Errors
    /// Those of [`Solver::set_stiffness`] and [`GpuSolver::set_gravity`].
    pub fn set_stiffness(&mut self, fluid: u32, stiffness: f32) -> Result<(), GpuError> {
        self.change("set_stiffness", Change::Stiffness(fluid, stiffness))
    }

    /// Returns whether the length of time steps may change.
    pub(crate) fn is_adaptive(&self) -> bool {
        self.buffers.model().is_adaptive == 1
    }

    /// Rejects a call before the first step. That step begins with accelerations that the CPU evaluated, so the change
    /// must be made on the CPU solver.
    fn has_begun(&self, call: &'static str) -> Result<(), GpuError> {
        if self.steps == 0 { Err(GpuError::BeforeFirstStep { call }) } else { Ok(()) }
    }

    fn change(&mut self, call: &'static str, change: Change) -> Result<(), GpuError> {
        let (live, next) = self.live.changed(change)?;
        self.has_begun(call)?;
        let mut uniform = next.step;
        if matches!(change, Change::TimeStep(_)) {
            let times = div(uniform.time_step, self.uniform.time_step);
            self.rescale_history(times)?;
            self.steady = self.steady.changed(self.steps, self.uniform.time_step);
        } else {
            let StepUniform { gravity, wind, .. } = next.step;
            uniform = StepUniform { gravity, wind, ..self.uniform };
        }
        self.live = live;
        self.uniform = uniform;
        let Buffers { parameters, materials, step, .. } = &self.buffers;
        let queue = &self.gpu.queue;
        queue.write_buffer(parameters, 0, bytemuck::bytes_of(&next.parameters));
        queue.write_buffer(materials, 0, bytemuck::bytes_of(&next.materials));
        // with steps of changing length, the device itself writes the time step
        let bytes = bytemuck::bytes_of(&uniform);
        let fixed = if self.is_adaptive() { offset_of!(StepUniform, time_step) } else { size_of::<StepUniform>() };
        queue.write_buffer(step, 0, &bytes[..fixed]);
        Ok(())
    }

    /// Rescales the history of the integrator for a time step that is `times` as long as the last one.
    fn rescale_history(&self, times: f32) -> Result<(), GpuError> {
        let words = self.buffers.words(Array::history);
        if words == 0 {
            return Ok(());
        }
        let buffer = self.buffers.array(Array::history, Side::Old, self.current());
        let mut history: Vec<f32x4> = read(&self.gpu, buffer, words / 4)?;
        for entry in &mut history {
            let vec3 { x, y, z } = history_rescaled::<f32>(self.buffers.model(), vec3::splat(*entry), times);
            *entry = [x, y, z, 0.0];
        }
        self.gpu.queue.write_buffer(buffer, 0, bytemuck::cast_slice(&history));
        Ok(())
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
        Ok(if self.is_adaptive() {
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
        Ok(AirReport { alive: status.air_alive, refused: u64::from(status.air_refused) })
    }

    /// Reads the status that the last step wrote. It waits for the device.
    ///
    /// # Errors
    /// [`GpuError::Device`] if the device fails.
    pub fn status(&self) -> Result<Status, GpuError> {
        let status: Vec<Status> = read(&self.gpu, &self.buffers.head, 1)?;
        status.first().copied().ok_or_else(inconsistent_status)
    }

    /// Reads all arrays of the current state back. It waits for the device.
    ///
    /// # Errors
    /// [`GpuError::Device`] if the device fails.
    pub fn read(&self) -> Result<Readback, GpuError> {
        let model = self.buffers.model();
        let is_read = |array: Array| matches!(array.class(), Class::State | Class::Index) && array.exists(model);
        let words = |&array: &Array| {
            if !is_read(array) {
                return Ok(Vec::new());
            }
            let buffer = self.buffers.array(array, Side::Old, self.current());
            read(&self.gpu, buffer, self.buffers.words(array))
        };
        Ok(Readback { arrays: Array::ALL.iter().map(words).collect::<Result<Vec<_>, _>>()? })
    }

    /// Writes the fluid as bytes, from which a CPU solver of the same scene can continue ([`Solver::restore`]), and
    /// from that solver a GPU. In strict mode they are the bytes that the CPU would have saved after the same steps.
    ///
    /// # Errors
    /// [`GpuError::Device`] if the device fails.
    pub fn save(&self) -> Result<Vec<u8>, GpuError> {
        let state = self.read()?;
        let status = self.status()?;
        let time_step = if self.is_adaptive() { status.time_step } else { self.uniform.time_step };
        let record = Record::of_status(&status, self.steady, self.due, time_step, &self.live);
        let mut given = Vec::new();
        for array in Array::ALL.iter().copied().filter(|array| array.class() == Class::Given && is_on_device(*array)) {
            let there = array.exists(self.buffers.model());
            let words = if there { self.buffers.words(array) } else { 0 };
            let words: Vec<u32> =
                if words == 0 { Vec::new() } else { read(&self.gpu, self.buffers.array(array, Side::Only, 0), words)? };
            given.push((array, words));
        }
        let words = |array: Array| {
            let known = given.iter().find(|(given, _)| *given == array);
            known.map_or_else(|| state.words(array), |(_, words)| words.as_slice())
        };
        let requirements = self.buffers.requirements();
        let mut bytes = vec![0; saved_bytes(requirements)];
        let key = (requirements, self.fingerprint);
        write(key, &record, state.slots(), words, &mut bytes).map_err(|error| GpuError::Device(error.to_string()))?;
        Ok(bytes)
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
