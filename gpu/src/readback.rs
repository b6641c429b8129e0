//! Reading a fluid back from the device: its arrays, and the bytes that a solver continues from.
use crate::bindings::is_on_device;
use crate::buffers::read;
use crate::error::GpuError;
use crate::solver::GpuSolver;
use millpond_core::backend::hash::state_hash;
use millpond_core::backend::layout::f32x4;
use millpond_core::backend::plan::arrays::{Class, Side};
use millpond_core::backend::save::{Record, saved_bytes, write};
use millpond_core::{Array, RestoreError, Solver};

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

    /// Hash of all positions and velocities. It equals that of [`Solver::hash`](millpond_core::Solver::hash) if all
    /// bits are equal.
    #[must_use]
    pub fn hash(&self) -> u64 {
        state_hash(self.slots(), self.position(), self.velocity())
    }
}

impl GpuSolver {
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

    /// Hands the fluid to a CPU solver of the same scene, lets it be changed there, for example by
    /// [`Solver::spawn`](millpond_core::Solver::spawn), and takes its particles back; what else changes there is lost. It
    /// waits for the device and copies the whole state twice.
    ///
    /// # Errors
    /// [`GpuError::Device`] if the device fails, or if `host` is a solver of another scene.
    pub fn with_host<T>(
        &mut self,
        host: &mut Solver<'_>,
        change: impl FnOnce(&mut Solver<'_>) -> T,
    ) -> Result<T, GpuError> {
        let own = |error: RestoreError| GpuError::Device(error.to_string());
        host.restore(&self.save()?).map_err(own)?;
        let changed = change(host);
        let model = *self.buffers.model();
        for &array in Array::ALL {
            if matches!(array.class(), Class::State | Class::Index) && array.exists(&model) {
                let buffer = self.buffers.array(array, Side::Old, self.current());
                self.gpu.queue.write_buffer(buffer, 0, bytemuck::cast_slice(host.words(array)));
            }
        }
        let mut status = self.status()?;
        host.census().flux.fill(&mut status);
        status.air_alive = host.air().active;
        self.gpu.queue.write_buffer(&self.buffers.head, 0, bytemuck::bytes_of(&status));
        Ok(changed)
    }

    /// Writes the fluid as bytes, from which a CPU solver of the same scene can continue
    /// ([`Solver::restore`](millpond_core::Solver::restore)), and from that solver a GPU. In strict mode they are the
    /// bytes that the CPU would have saved after the same steps.
    ///
    /// # Errors
    /// [`GpuError::Device`] if the device fails.
    pub fn save(&self) -> Result<Vec<u8>, GpuError> {
        let state = self.read()?;
        let status = self.status()?;
        let time_step = if self.has_changing_step() { status.time_step } else { self.uniform.time_step };
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
}
