//! The GPU's public face: a fluid on the device, stepped without reading anything back.
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

/// Steps that are recorded before the status is read: a failed step is found at most this late, and costs nothing more.
pub const STEPS_PER_STATUS: u32 = 64;

/// Steps that are handed to the device at once.
const STEPS_PER_SUBMISSION: usize = 8;

/// A fluid on a device.
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
    /// Up to when [`GpuSolver::advance`] was asked for steps, s.
    pub(crate) due: f64,
    /// Steps that count.
    steps: u64,
    /// Steps that were recorded, those that do not count too.
    attempts: u64,
}

/// A state that was read back, array by array, in the slots of the device.
#[derive(Clone, Debug)]
pub struct Readback {
    arrays: Vec<Vec<u32>>,
}

impl Readback {
    /// An array of the state as words of four bytes; empty where the scene does without.
    #[must_use]
    pub fn words(&self, array: Array) -> &[u32] {
        &self.arrays[array as usize]
    }

    /// The same of an array of vectors.
    fn vectors(&self, array: Array) -> &[f32x4] {
        bytemuck::cast_slice(self.words(array))
    }

    /// Position, m.
    #[must_use]
    pub fn position(&self) -> &[f32x4] {
        self.vectors(Array::position)
    }

    /// Velocity, m/s.
    #[must_use]
    pub fn velocity(&self) -> &[f32x4] {
        self.vectors(Array::velocity)
    }

    /// Slot of each particle, by id.
    #[must_use]
    pub fn slots(&self) -> &[u32] {
        self.words(Array::slot_of_id)
    }

    /// The state hash, as core computes it.
    #[must_use]
    pub fn hash(&self) -> u64 {
        state_hash(self.slots(), self.position(), self.velocity())
    }
}

impl GpuSolver {
    /// The fluid of a CPU solver, from its current state on, by the same plan.
    ///
    /// # Errors
    /// A scene too large for the device, a shader refused, or a choice that only the CPU has.
    pub fn new(gpu: &Gpu, solver: &Solver<'_>) -> Result<GpuSolver, GpuError> {
        let parameters = solver.parameters();
        let plan = solver.plan();
        countable(solver.steps())?;
        if plan.model.is_half_stencil == 1 {
            let why = "on a device two particles would add to a third at once; set it to FullStencil";
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

    /// Makes `count` time steps; reads back nothing but the status, and that every [`STEPS_PER_STATUS`] steps.
    ///
    /// # Errors
    /// A step that could not be made; the fluid then is as it was before that step, and no further step is made: start
    /// again from [`GpuSolver::read`] with another scene.
    pub fn step(&mut self, count: u32) -> Result<(), GpuError> {
        let until = self.steps + u64::from(count);
        countable(until)?;
        while self.steps < until {
            self.attempt((until - self.steps).min(u64::from(STEPS_PER_STATUS)), None)?;
        }
        Ok(())
    }

    /// Makes one time step and says how long each pass took on the device, in the order of the step, in milliseconds; a pass
    /// that runs more than once stands there as often.
    ///
    /// # Errors
    /// As for [`GpuSolver::step`]; also a device that cannot time its passes, or has no room for the times of so many.
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

    /// Records so many attempts at a step, and reads what became of them.
    fn attempt(&mut self, count: u64, clock: Option<&PassClock>) -> Result<(), GpuError> {
        let attempts: Vec<u64> = (self.attempts..self.attempts + count).collect();
        // the device works on some while the next ones are being recorded
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

    /// Records an attempt at a step from state `old`. After one that is to be made again the next finds the states the other way
    /// round, and sits out.
    fn record(&self, encoder: &mut wgpu::CommandEncoder, old: usize, clock: Option<&PassClock>) {
        let Buffers { head, step, .. } = &self.buffers;
        encoder.clear_buffer(head, size_of::<Status>() as u64, None);
        // the clock's numbers go into the step's without the host ever seeing them
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

    /// Which state is the fluid: they trade places at each step that counts.
    fn current(&self) -> usize {
        (self.steps - self.first_step) as usize % 2
    }

    /// The positions on the device, `[f32; 4]` each with w unused, sorted by cell: for a renderer that shares it
    /// ([`Gpu::with_device`]). Another buffer after each step that counts, one of two.
    #[must_use]
    pub fn position_buffer(&self) -> &wgpu::Buffer {
        self.buffers.array(Array::position, Side::Old, self.current())
    }

    /// The velocities, likewise.
    #[must_use]
    pub fn velocity_buffer(&self) -> &wgpu::Buffer {
        self.buffers.array(Array::velocity, Side::Old, self.current())
    }

    /// The host's field from now on, as [`Solver::set_field`] takes it.
    ///
    /// # Errors
    /// Fewer or more nodes than the scene says, or a value that is not finite; a call before the fluid's first step. The field then stays as it was.
    pub fn set_field(&mut self, points: &[f32x4]) -> Result<(), GpuError> {
        let (given, expected) = (points.len(), self.buffers.counts().field_nodes);
        if given != expected {
            return Err(SceneError::WrongLength { call: "set_field", what: "points", given, expected }.into());
        }
        if let Some(&value) = points.as_flattened().iter().find(|x| !x.is_finite()) {
            return Err(SceneError::NotFinite { field: "field", value }.into());
        }
        if expected > 0 {
            self.has_begun("set_field")?;
            let field = self.buffers.array(Array::acceleration_field, Side::Only, 0);
            self.gpu.queue.write_buffer(field, 0, bytemuck::cast_slice(points));
        }
        Ok(())
    }

    /// Another acceleration of gravity from now on, as [`Solver::set_gravity`] takes it.
    ///
    /// # Errors
    /// As there; also before the fluid's first step, when the CPU solver is the one to be told.
    pub fn set_gravity(&mut self, gravity: impl Into<Vec3>) -> Result<(), GpuError> {
        self.change("set_gravity", Change::Gravity(gravity.into()))
    }

    /// Another wind from now on, as [`Solver::set_wind`] takes it.
    ///
    /// # Errors
    /// As for [`GpuSolver::set_gravity`].
    pub fn set_wind(&mut self, wind: Option<Wind>) -> Result<(), GpuError> {
        self.change("set_wind", Change::Wind(wind))
    }

    /// Another time step from now on, s, as [`Solver::set_time_step`] takes it.
    ///
    /// # Errors
    /// As for [`GpuSolver::set_gravity`].
    pub fn set_time_step(&mut self, time_step: f32) -> Result<(), GpuError> {
        self.change("set_time_step", Change::TimeStep(time_step))
    }

    /// Another dynamic viscosity of a fluid from now on, Pa s, as [`Solver::set_viscosity`] takes it.
    ///
    /// # Errors
    /// As for [`GpuSolver::set_gravity`].
    pub fn set_viscosity(&mut self, fluid: u32, viscosity: f32) -> Result<(), GpuError> {
        self.change("set_viscosity", Change::Viscosity(fluid, viscosity))
    }

    /// Another surface tension of a fluid from now on, as [`Solver::set_surface_tension`] takes it.
    ///
    /// # Errors
    /// As for [`GpuSolver::set_gravity`].
    pub fn set_surface_tension(&mut self, fluid: u32, tension: f32) -> Result<(), GpuError> {
        self.change("set_surface_tension", Change::SurfaceTension(fluid, tension))
    }

    /// Another speed of sound of a fluid from now on, m/s, as [`Solver::set_speed_of_sound`] takes it.
    ///
    /// # Errors
    /// As for [`GpuSolver::set_gravity`].
    pub fn set_speed_of_sound(&mut self, fluid: u32, speed: f32) -> Result<(), GpuError> {
        self.change("set_speed_of_sound", Change::SpeedOfSound(fluid, speed))
    }

    /// Another constant of Tait's equation of a fluid from now on, Pa, as [`Solver::set_stiffness`] takes it.
    ///
    /// # Errors
    /// As for [`GpuSolver::set_gravity`].
    pub fn set_stiffness(&mut self, fluid: u32, stiffness: f32) -> Result<(), GpuError> {
        self.change("set_stiffness", Change::Stiffness(fluid, stiffness))
    }

    /// Does its time step follow from the state?
    pub(crate) fn is_adaptive(&self) -> bool {
        self.buffers.model().is_adaptive == 1
    }

    /// The first step begins with accelerations that the CPU evaluated, so that a change before it is the CPU's to make.
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
        // the device's clock writes the time step itself, where it follows from the state
        let bytes = bytemuck::bytes_of(&uniform);
        let fixed = if self.is_adaptive() { offset_of!(StepUniform, time_step) } else { size_of::<StepUniform>() };
        queue.write_buffer(step, 0, &bytes[..fixed]);
        Ok(())
    }

    /// What an integrator remembers of the last step, for one that is so many times as long.
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

    /// What the pressure correction came to; all zero with an equation of state.
    ///
    /// # Errors
    /// The device failed.
    pub fn correction(&self) -> Result<CorrectionReport, GpuError> {
        let status = self.status()?;
        Ok(CorrectionReport {
            iterations: status.last_iterations,
            total_iterations: u64::from(status.total_iterations),
            residual: f32::from_bits(status.last_residual),
        })
    }

    /// What became of the time step, as [`Solver::time_report`] says it.
    ///
    /// # Errors
    /// The device failed.
    pub fn time_report(&self) -> Result<TimeReport, GpuError> {
        let report = TimeReport::of(&self.status()?);
        Ok(if self.is_adaptive() {
            report
        } else {
            TimeReport { wanted: report.wanted, time_step: report.time_step, ..self.steady_report() }
        })
    }

    /// What the clock shows where all steps are alike, without asking the device.
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

    /// What became of the coat of air, as [`Solver::air`] says it; all zero where a scene has none.
    ///
    /// # Errors
    /// The device failed.
    pub fn air(&self) -> Result<AirReport, GpuError> {
        let status = self.status()?;
        Ok(AirReport { alive: status.air_alive, refused: u64::from(status.air_refused) })
    }

    /// What the device has to say for itself.
    ///
    /// # Errors
    /// The device failed.
    pub fn status(&self) -> Result<Status, GpuError> {
        let status: Vec<Status> = read(&self.gpu, &self.buffers.head, 1)?;
        status.first().copied().ok_or_else(inconsistent_status)
    }

    /// Reads the fluid back.
    ///
    /// # Errors
    /// The device failed.
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

    /// The fluid as bytes that a CPU solver of the same scene goes on from ([`Solver::restore`]), and from it another device: the same
    /// bytes as if the CPU had made the steps.
    ///
    /// # Errors
    /// The device failed.
    pub fn save(&self) -> Result<Vec<u8>, GpuError> {
        let state = self.read()?;
        let status = self.status()?;
        let time_step = if self.is_adaptive() { status.time_step } else { self.uniform.time_step };
        let record = Record::of_status(&status, self.steady, time_step, &self.live);
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

    /// Steps that count.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.steps
    }
}

// the clock's three numbers stand side by side in both structs, so that one copy moves them
const _: () = assert!(offset_of!(Status, half_time_step) == offset_of!(Status, time_step) + 4);
const _: () = assert!(offset_of!(Status, inverse_time_step) == offset_of!(Status, time_step) + 8);
const _: () = assert!(offset_of!(StepUniform, half_time_step) == offset_of!(StepUniform, time_step) + 4);
const _: () = assert!(offset_of!(StepUniform, inverse_time_step) == offset_of!(StepUniform, time_step) + 8);

/// Steps that a device can count.
const MOST_STEPS: u64 = u32::MAX as u64;

fn countable(steps: u64) -> Result<(), GpuError> {
    if steps > MOST_STEPS { Err(GpuError::TooManySteps { steps, most: MOST_STEPS }) } else { Ok(()) }
}

/// A status that contradicts itself.
fn inconsistent_status() -> GpuError {
    GpuError::Device("the status says that a step failed, and not why".into())
}
