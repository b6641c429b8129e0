//! The arrays on the device: core's bytes, in two states that trade places.
use crate::bindings::Array;
use crate::device::Gpu;
use crate::error::GpuError;
use bytemuck::{Pod, Zeroable, cast_slice};
use millpond_core::Solver;
use millpond_core::layout::{Parameters, Status, TABLE_WORDS, f32x4};
use millpond_core::terms::integrate::needs_earlier;

/// What a command is about, where its pass alone does not say it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Role {
    /// Nothing more.
    Usual,
    /// A gather from the first of these to the second.
    Gather([Array; 2]),
    /// Forces that are evaluated again, with the velocities ahead.
    Again,
}

/// One of the two states.
#[derive(Debug)]
pub(crate) struct StateBuffers {
    pub position: wgpu::Buffer,
    pub velocity: wgpu::Buffer,
    pub acceleration: wgpu::Buffer,
    pub density_pressure: wgpu::Buffer,
    pub smoothing: wgpu::Buffer,
    pub heat: wgpu::Buffer,
    pub normal: wgpu::Buffer,
    pub history: wgpu::Buffer,
    pub ends: wgpu::Buffer,
    pub id: wgpu::Buffer,
}

/// All of them.
#[derive(Debug)]
pub(crate) struct Buffers {
    pub parameters: wgpu::Buffer,
    pub tables: wgpu::Buffer,
    pub field: wgpu::Buffer,
    pub head: wgpu::Buffer,
    pub states: [StateBuffers; 2],
    cell: wgpu::Buffer,
    rank: wgpu::Buffer,
    begin: wgpu::Buffer,
    order: wgpu::Buffer,
    grid_cells: wgpu::Buffer,
    previous: wgpu::Buffer,
    free: wgpu::Buffer,
    earlier: wgpu::Buffer,
    ahead: wgpu::Buffer,
    slot_of: wgpu::Buffer,
    bare: wgpu::Buffer,
    birth: wgpu::Buffer,
    springs_of: wgpu::Buffer,
    plastic: bool,
    corrects_pressure: bool,
}

/// Makes buffers; an empty array gets one entry, since a binding cannot be empty.
pub(crate) struct Maker<'g> {
    gpu: &'g Gpu,
    usage: wgpu::BufferUsages,
}

impl<'g> Maker<'g> {
    /// Of storage buffers.
    pub(crate) fn storage(gpu: &'g Gpu) -> Maker<'g> {
        Maker { gpu, usage: wgpu::BufferUsages::STORAGE }
    }

    /// A buffer of so many bytes.
    pub(crate) fn room(&self, array: &'static str, bytes: usize) -> Result<wgpu::Buffer, GpuError> {
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

    /// A buffer with this content.
    pub(crate) fn filled<T: Pod>(&self, array: &'static str, content: &[T]) -> Result<wgpu::Buffer, GpuError> {
        let buffer = self.room(array, size_of_val(content))?;
        self.gpu.queue.write_buffer(&buffer, 0, cast_slice(content));
        Ok(buffer)
    }
}

impl Buffers {
    /// With the current state of `solver` in state 0.
    pub(crate) fn of(gpu: &Gpu, solver: &Solver<'_>) -> Result<Buffers, GpuError> {
        let storage = Maker::storage(gpu);
        let uniform = Maker { gpu, usage: wgpu::BufferUsages::UNIFORM };
        let state = solver.state();
        let parameters: &Parameters = solver.parameters();
        let (n, cells) = (state.id.len(), parameters.cells[3] as usize);
        let places = cells * solver.plan().model.cell_places as usize;
        let words = |count: usize| count * size_of::<u32>();
        let vectors = n * size_of::<f32x4>();
        let m = &solver.plan().model;
        let if_needed = |needed: bool| if needed { vectors } else { 0 };
        // what became of the air so far goes on being counted
        let air = solver.air();
        let refused = air.refused.min(u64::from(u32::MAX)) as u32;
        let mut status = Status { air_alive: air.alive, air_refused: refused, ..Status::fine(solver.steps() as u32) };
        solver.fill_status(&mut status);
        let queue = if m.air == 1 { 2 * n - parameters.first_air as usize } else { 0 };
        let head = storage.room("head", size_of::<Status>() + words(cells))?;
        gpu.queue.write_buffer(&head, 0, bytemuck::bytes_of(&status));
        let mut tables = [0.0; TABLE_WORDS];
        tables[..solver.tables().len()].copy_from_slice(solver.tables());
        Ok(Buffers {
            parameters: uniform.filled("parameters", &[*parameters])?,
            tables: uniform.filled("tables", &tables)?,
            field: storage.filled("field", solver.field())?,
            head,
            states: [
                StateBuffers {
                    position: storage.filled("position", state.position)?,
                    velocity: storage.filled("velocity", state.velocity)?,
                    acceleration: storage.filled("acceleration", state.acceleration)?,
                    density_pressure: storage.filled("density_pressure", state.density_pressure)?,
                    smoothing: storage.filled("smoothing", state.smoothing)?,
                    heat: storage.filled("heat", state.heat)?,
                    normal: storage.filled("normal", state.normal)?,
                    history: storage.filled("history", state.history)?,
                    ends: storage.filled("spring ends", solver.spring_ends())?,
                    id: storage.filled("id", state.id)?,
                },
                StateBuffers {
                    position: storage.room("position", vectors)?,
                    velocity: storage.room("velocity", vectors)?,
                    acceleration: storage.room("acceleration", vectors)?,
                    density_pressure: storage.room("density_pressure", vectors)?,
                    smoothing: storage.room("smoothing", size_of_val(state.smoothing))?,
                    heat: storage.room("heat", size_of_val(state.heat))?,
                    normal: storage.room("normal", size_of_val(state.normal))?,
                    history: storage.room("history", size_of_val(state.history))?,
                    ends: storage.filled("spring ends", if m.plastic == 1 { solver.spring_ends() } else { &[] })?,
                    id: storage.room("id", words(n))?,
                },
            ],
            previous: storage.room("previous", if_needed(m.needs_previous()))?,
            free: storage.room("free", if_needed(m.corrects_pressure()))?,
            earlier: storage.room("earlier", if_needed(needs_earlier(m)))?,
            ahead: storage.room("ahead", if_needed(m.foresees()))?,
            slot_of: storage.room("slot_of", words(if m.springs == 1 || m.air == 1 { n } else { 0 }))?,
            bare: storage.room("bare", if_needed(m.air == 1))?,
            birth: storage.room("birth", words(queue))?,
            springs_of: storage.filled("springs", solver.springs_of())?,
            plastic: m.plastic == 1,
            corrects_pressure: m.corrects_pressure(),
            cell: storage.room("cell", words(n))?,
            rank: storage.room("rank", words(n))?,
            begin: storage.room("begin", words(cells))?,
            order: storage.room("order", words(n))?,
            grid_cells: storage.room("grid_cells", words(places))?,
        })
    }

    /// The buffer of an array when state `old` is the old one, in this role.
    pub(crate) fn array(&self, array: Array, old: usize, role: Role) -> &wgpu::Buffer {
        let (from, to) = (&self.states[old], &self.states[1 - old]);
        match array {
            Array::Head => &self.head,
            Array::OldPosition => &from.position,
            Array::OldVelocity => &from.velocity,
            Array::OldAcceleration => &from.acceleration,
            Array::OldDensityPressure => &from.density_pressure,
            Array::OldSmoothing => &from.smoothing,
            Array::OldHeat => &from.heat,
            Array::OldId => &from.id,
            Array::NewPosition => &to.position,
            Array::NewVelocity if role == Role::Again => &self.ahead,
            Array::NewVelocity => &to.velocity,
            Array::NewDensityPressure => &to.density_pressure,
            Array::NewSmoothing => &to.smoothing,
            Array::NewHeat => &to.heat,
            Array::NewNormal => &to.normal,
            Array::NewId => &to.id,
            Array::OldHistory => &from.history,
            Array::NewHistory => &to.history,
            Array::Earlier => &self.earlier,
            Array::Ahead => &self.ahead,
            Array::SlotOf => &self.slot_of,
            Array::Bare => &self.bare,
            Array::Birth => &self.birth,
            Array::SpringsOf => &self.springs_of,
            // lengths at rest that do not change stay in the first
            Array::OldEnds => {
                if self.plastic {
                    &from.ends
                } else {
                    &self.states[0].ends
                }
            }
            Array::NewEnds => {
                if self.plastic {
                    &to.ends
                } else {
                    &self.states[1].ends
                }
            }
            Array::Previous => &self.previous,
            Array::Free => &self.free,
            Array::ForceOut if self.corrects_pressure => &self.free,
            Array::NewAcceleration | Array::ForceOut => &to.acceleration,
            Array::FieldNodes => &self.field,
            Array::Cell => &self.cell,
            Array::Rank => &self.rank,
            Array::Begin => &self.begin,
            Array::Order => &self.order,
            Array::GridCells => &self.grid_cells,
            Array::GatherFrom | Array::GatherTo => {
                let Role::Gather([from, to]) = role else { unreachable!("only a gather binds these") };
                self.array(if array == Array::GatherFrom { from } else { to }, old, Role::Usual)
            }
        }
    }
}

/// Reads the first `count` entries of a buffer back.
pub(crate) fn read<T: Pod + Zeroable>(gpu: &Gpu, buffer: &wgpu::Buffer, count: usize) -> Result<Vec<T>, GpuError> {
    let bytes = (count * size_of::<T>()) as u64;
    if bytes == 0 {
        return Ok(Vec::new());
    }
    gpu.caught(|| read_bytes(gpu, buffer, bytes, count))
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
        // nobody listens any more only if polling failed, which is reported below
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
