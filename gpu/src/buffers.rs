//! The arrays on the device, with the same bytes as in core. Arrays of the state exist twice, as two states that swap
//! roles after each step.
use crate::bindings::{cell_blocks, is_on_device};
use crate::device::Gpu;
use crate::error::GpuError;
use bytemuck::{Pod, Zeroable, cast_slice};
use millpond_core::backend::layout::{Model, Status, TABLE_WORDS, f32x4};
use millpond_core::backend::memory::{Counts, Requirements};
use millpond_core::backend::plan::arrays::{Class, Side};
use millpond_core::{Array, Solver};

/// Distance in bytes between two uniforms that share a buffer. No device requires a larger alignment.
pub(crate) const UNIFORM_STRIDE: u64 = 256;

/// All buffers of a fluid.
#[derive(Debug)]
pub(crate) struct Buffers {
    pub parameters: wgpu::Buffer,
    /// The constants of the step.
    pub step: wgpu::Buffer,
    pub materials: wgpu::Buffer,
    pub tables: wgpu::Buffer,
    pub head: wgpu::Buffer,
    /// The index of each array, for commands that have to know which array they process.
    pub subjects: wgpu::Buffer,
    /// The copies of each array: none, one or two. The outer index is the array.
    arrays: Vec<Vec<wgpu::Buffer>>,
    requirements: Requirements,
}

/// Creates buffers. An empty array gets one entry, since a binding cannot be empty.
pub(crate) struct Maker<'g> {
    gpu: &'g Gpu,
    usage: wgpu::BufferUsages,
}

impl<'g> Maker<'g> {
    /// Returns a maker of storage buffers.
    pub(crate) fn storage(gpu: &'g Gpu) -> Maker<'g> {
        Maker { gpu, usage: wgpu::BufferUsages::STORAGE }
    }

    /// Creates a buffer of this size.
    pub(crate) fn allocate(&self, array: &'static str, bytes: usize) -> Result<wgpu::Buffer, GpuError> {
        let bytes = bytes.max(size_of::<f32x4>()) as u64;
        let limits = self.gpu.device.limits();
        let limit = limits.max_storage_buffer_binding_size.min(limits.max_buffer_size);
        if bytes > limit {
            return Err(GpuError::TooLarge { array, bytes, limit });
        }
        let usage = self.usage | wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::COPY_SRC;
        let descriptor = wgpu::BufferDescriptor { label: Some(array), size: bytes, usage, mapped_at_creation: false };
        Ok(self.gpu.device.create_buffer(&descriptor))
    }

    /// Creates a buffer with this content.
    pub(crate) fn filled<T: Pod>(&self, array: &'static str, content: &[T]) -> Result<wgpu::Buffer, GpuError> {
        let buffer = self.allocate(array, size_of_val(content))?;
        self.gpu.queue.write_buffer(&buffer, 0, cast_slice(content));
        Ok(buffer)
    }
}

impl Buffers {
    /// Creates the buffers for `solver` and writes its current state into state 0.
    pub(crate) fn of(gpu: &Gpu, solver: &Solver<'_>) -> Result<Buffers, GpuError> {
        let storage = Maker::storage(gpu);
        let uniform = Maker { gpu, usage: wgpu::BufferUsages::UNIFORM };
        let requirements = *solver.requirements();
        let make = |&array: &Array| -> Result<Vec<wgpu::Buffer>, GpuError> {
            if !is_on_device(array) {
                return Ok(Vec::new());
            }
            let bytes = requirements.entries(array) * array.words() * size_of::<u32>();
            let copies = requirements.copies(array);
            let buffers = (0..copies).map(|_| storage.allocate(array.name(), bytes)).collect::<Result<Vec<_>, _>>()?;
            if let (Some(first), Class::State | Class::Index | Class::Given) = (buffers.first(), array.class()) {
                gpu.queue.write_buffer(first, 0, cast_slice(solver.words(array)));
            }
            Ok(buffers)
        };
        // the counts of particles continue from those of the CPU
        let mut status = Status { air_alive: solver.air().active, ..Status::fine(solver.steps() as u32) };
        solver.census().flux.fill(&mut status);
        solver.fill_status(&mut status);
        let correction = solver.correction();
        status.last_iterations = correction.iterations;
        status.total_iterations = correction.total_iterations.min(u64::from(u32::MAX)) as u32;
        status.last_residual = correction.residual.to_bits();
        let cells = requirements.entries(Array::grid_cell_counters);
        let counters = cells + cell_blocks(cells as u32) as usize;
        let head = storage.allocate("head", size_of::<Status>() + counters * size_of::<u32>())?;
        gpu.queue.write_buffer(&head, 0, bytemuck::bytes_of(&status));
        let mut tables = vec![0; TABLE_WORDS];
        let own = solver.words(Array::kernel_tables);
        tables[..own.len()].copy_from_slice(own);
        let stride = UNIFORM_STRIDE as usize / size_of::<u32>();
        let subjects: Vec<u32> =
            (0..Array::COUNT * stride).map(|i| if i % stride == 0 { i / stride } else { 0 } as u32).collect();
        Ok(Buffers {
            parameters: uniform.filled("parameters", &[*solver.parameters()])?,
            step: uniform.filled("step", &[*solver.uniform()])?,
            materials: uniform.filled("materials", &[*solver.materials()])?,
            tables: uniform.filled("tables", &tables)?,
            head,
            subjects: uniform.filled("subjects", &subjects)?,
            arrays: Array::ALL.iter().map(make).collect::<Result<Vec<_>, _>>()?,
            requirements,
        })
    }

    /// Returns the buffer of an array when state `old` is the old one. An array that the scene never changes has one
    /// buffer, which serves as both its old and its new one.
    pub(crate) fn array(&self, array: Array, side: Side, old: usize) -> &wgpu::Buffer {
        let copies = &self.arrays[array as usize];
        let copy = match side {
            Side::Old => old,
            Side::New => 1 - old,
            Side::Only => 0,
        };
        copies.get(copy).unwrap_or_else(|| &copies[0])
    }

    /// Returns the sizes of all arrays.
    pub(crate) fn requirements(&self) -> &Requirements {
        &self.requirements
    }

    /// Returns the numbers of particles, cells and other items from which the sizes follow.
    pub(crate) fn counts(&self) -> &Counts {
        &self.requirements.counts
    }

    /// Returns the length of an array in words of four bytes.
    pub(crate) fn words(&self, array: Array) -> usize {
        self.requirements.entries(array) * array.words()
    }

    /// Returns the model, which determines the arrays that exist.
    pub(crate) fn model(&self) -> &Model {
        self.requirements.model()
    }
}

/// Reads the first `count` entries of a buffer back from the device.
pub(crate) fn read<T: Pod + Zeroable>(gpu: &Gpu, buffer: &wgpu::Buffer, count: usize) -> Result<Vec<T>, GpuError> {
    let bytes = (count * size_of::<T>()) as u64;
    if bytes == 0 {
        return Ok(Vec::new());
    }
    gpu.with_error_scopes(|| read_bytes(gpu, buffer, bytes, count))
}

fn read_bytes<T: Pod + Zeroable>(
    gpu: &Gpu,
    buffer: &wgpu::Buffer,
    bytes: u64,
    count: usize,
) -> Result<Vec<T>, GpuError> {
    let staging = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("staging"),
        size: bytes,
        usage: wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    let mut encoder = gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    encoder.copy_buffer_to_buffer(buffer, 0, &staging, 0, bytes);
    gpu.queue.submit([encoder.finish()]);
    let (tell, told) = std::sync::mpsc::channel();
    staging.map_async(wgpu::MapMode::Read, .., move |result| {
        // the receiver is gone only if polling failed, and that error is returned below
        let _ = tell.send(result);
    });
    let failed = |e: &dyn std::fmt::Display| GpuError::Device(e.to_string());
    gpu.device.poll(wgpu::PollType::wait_indefinitely()).map_err(|e| failed(&e))?;
    told.recv().map_err(|e| failed(&e))?.map_err(|e| failed(&e))?;
    let view = staging.get_mapped_range(..).map_err(|e| failed(&e))?;
    let mut out = vec![T::zeroed(); count];
    bytemuck::cast_slice_mut(&mut out).copy_from_slice(&view);
    Ok(out)
}
