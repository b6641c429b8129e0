//! The GPU's public face: a fluid on the device, stepped without reading anything back.
use crate::buffers::{Buffers, read};
use crate::device::Gpu;
use crate::error::GpuError;
use crate::pipelines::{Dispatch, dispatches, record};
use core::mem::offset_of;
use millpond_core::hash::state_hash;
use millpond_core::layout::{Parameters, Status, f32x4};
use millpond_core::plan::arrays::{Class, Side};
use millpond_core::{AirReport, Array, CorrectionReport, SceneError, Solver, TimeReport, verdict};

/// Steps that are recorded before the status is read: a failed step is found at most this late, and costs nothing more.
pub const STEPS_PER_STATUS: u32 = 64;

/// A fluid on a device.
#[derive(Debug)]
pub struct GpuSolver {
    gpu: Gpu,
    buffers: Buffers,
    dispatches: Vec<Dispatch>,
    cell_places: u32,
    adaptive: bool,
    time_step: f32,
    first_step: u64,
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
    /// A scene too large for the device, or a shader refused.
    pub fn new(gpu: &Gpu, solver: &Solver<'_>) -> Result<GpuSolver, GpuError> {
        let parameters = solver.parameters();
        let plan = solver.plan();
        let (buffers, dispatches) = gpu.caught(|| {
            let buffers = Buffers::of(gpu, solver)?;
            let dispatches = dispatches(gpu, plan, &buffers, parameters.particle_count)?;
            Ok((buffers, dispatches))
        })?;
        Ok(GpuSolver {
            gpu: gpu.clone(),
            buffers,
            dispatches,
            cell_places: plan.model.cell_places,
            adaptive: plan.model.adaptive == 1,
            time_step: parameters.time_step,
            first_step: solver.steps(),
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
        while self.steps < until {
            let now = (until - self.steps).min(u64::from(STEPS_PER_STATUS));
            let mut encoder = self.gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
            for attempt in self.attempts..self.attempts + now {
                self.record(&mut encoder, attempt as usize % 2);
            }
            self.gpu.caught(|| Ok(self.gpu.queue.submit([encoder.finish()])))?;
            let status = self.status()?;
            self.attempts += now;
            self.steps = u64::from(status.steps);
            if status.failed == 1 {
                return Err(verdict(&status, self.cell_places).err().map_or_else(lost, GpuError::Step));
            }
        }
        Ok(())
    }

    /// Records an attempt at a step from state `old`. After one that is to be made again the next finds the states the other way
    /// round, and sits out.
    fn record(&self, encoder: &mut wgpu::CommandEncoder, old: usize) {
        let Buffers { head, parameters, .. } = &self.buffers;
        encoder.clear_buffer(head, size_of::<Status>() as u64, None);
        if self.adaptive {
            // the time step goes from the clock into the constants without the host ever seeing it
            let (from, to) = (offset_of!(Status, time_step), offset_of!(Parameters, time_step));
            let bytes = 3 * size_of::<f32>();
            encoder.copy_buffer_to_buffer(head, from as u64, parameters, to as u64, Some(bytes as u64));
        }
        record(&self.dispatches, encoder, old);
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
    /// Fewer or more nodes than the scene says, or a value that is not finite; the field then stays as it was.
    pub fn set_field(&mut self, nodes: &[f32x4]) -> Result<(), GpuError> {
        let (given, expected) = (nodes.len(), self.buffers.counts().field_nodes);
        if given != expected {
            return Err(SceneError::WrongLength { call: "set_field", what: "nodes", given, expected }.into());
        }
        if let Some(&value) = nodes.as_flattened().iter().find(|x| !x.is_finite()) {
            return Err(SceneError::NotFinite { field: "field", value }.into());
        }
        if expected > 0 {
            let field = self.buffers.array(Array::acceleration_field, Side::Only, 0);
            self.gpu.queue.write_buffer(field, 0, bytemuck::cast_slice(nodes));
        }
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
        let mut report = TimeReport::of(&self.status()?);
        if !self.adaptive {
            report.time = self.steps as f64 * f64::from(self.time_step);
        }
        Ok(report)
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
        status.first().copied().ok_or_else(lost)
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

    /// Steps that count.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.steps
    }
}

// the clock's three numbers stand side by side in both structs, so that one copy moves them
const _: () = assert!(offset_of!(Status, half_time_step) == offset_of!(Status, time_step) + 4);
const _: () = assert!(offset_of!(Status, inverse_time_step) == offset_of!(Status, time_step) + 8);
const _: () = assert!(offset_of!(Parameters, half_time_step) == offset_of!(Parameters, time_step) + 4);
const _: () = assert!(offset_of!(Parameters, inverse_time_step) == offset_of!(Parameters, time_step) + 8);

/// A status that contradicts itself.
fn lost() -> GpuError {
    GpuError::Device("the status says that a step failed, and not why".into())
}
