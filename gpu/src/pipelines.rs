//! A step as commands for the device: each command of the schedule gets a pipeline, bind groups for both roles of the
//! two states, and its number of work groups.
use crate::bindings::{Declared, UNIFORMS, bound, cell_blocks, declared, workgroup};
use crate::buffers::{Buffers, UNIFORM_STRIDE};
use crate::device::Gpu;
use crate::error::GpuError;
use crate::pass_times::PassClock;
use crate::program::program;
use millpond_core::backend::layout::{Model, Parameters, WORKGROUP};
use millpond_core::backend::plan::arrays::Side;
use millpond_core::backend::plan::passes::{Access, Bound, Threads};
use millpond_core::backend::plan::schedule::Command;
use millpond_core::{Array, Pass, Plan};
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

/// Largest number of work groups along one dimension of a dispatch (WebGPU's default limit).
const MOST_GROUPS: u32 = 65_535;

/// One dispatch.
#[derive(Clone, Debug)]
pub(crate) struct Dispatch {
    pass: Pass,
    pipeline: wgpu::ComputePipeline,
    /// Bind groups with state 0, and with state 1, as the old state.
    groups: [wgpu::BindGroup; 2],
    size: [u32; 2],
}

/// Creates dispatches from commands. A pass that runs more than once has one pipeline.
struct Recorder<'g> {
    gpu: &'g Gpu,
    buffers: &'g Buffers,
    model: Model,
    particles: u32,
    cells: u32,
    pipelines: BTreeMap<usize, (wgpu::BindGroupLayout, wgpu::ComputePipeline)>,
}

/// Returns the dispatches of a step. They include all repetitions of an iteration; on the device the repetitions after
/// the last one needed do nothing.
pub(crate) fn dispatches(
    gpu: &Gpu,
    plan: &Plan,
    buffers: &Buffers,
    of: &Parameters,
) -> Result<Vec<Dispatch>, GpuError> {
    let pipelines = BTreeMap::new();
    let (particles, cells) = (of.particle_count, of.cells[3]);
    let mut recorder = Recorder { gpu, buffers, model: plan.model, particles, cells, pipelines };
    let mut dispatches = Vec::new();
    recorder.add(&plan.schedule(), &mut dispatches)?;
    Ok(dispatches)
}

impl Recorder<'_> {
    fn add(&mut self, commands: &[Command], out: &mut Vec<Dispatch>) -> Result<(), GpuError> {
        let mut rest = commands.iter();
        while let Some(command) = rest.next() {
            if let Command::Repeat { commands: count, most } = command {
                let (body, after) = rest.as_slice().split_at((*count).into());
                let mut repeated = Vec::new();
                self.add(body, &mut repeated)?;
                (0..*most).for_each(|_| out.extend_from_slice(&repeated));
                rest = after.iter();
            } else if let Some(pass) = command.pass().filter(|pass| pass.threads() != Threads::Host) {
                out.push(self.dispatch(*command, pass)?);
            }
        }
        Ok(())
    }

    fn dispatch(&mut self, command: Command, pass: Pass) -> Result<Dispatch, GpuError> {
        let (layout, pipeline) = match self.pipelines.entry(pass as usize) {
            Entry::Occupied(known) => known.get().clone(),
            Entry::Vacant(place) => place.insert(pipeline(self.gpu, pass, &self.model)?).clone(),
        };
        let groups = [0, 1].map(|old| {
            let resources = self.resources(command, pass, old);
            bind_group(self.gpu, pass.name(), &layout, resources)
        });
        Ok(Dispatch { pass, pipeline, groups, size: self.size(pass) })
    }

    /// Returns what a command binds when state `old` is the old one.
    fn resources(&self, command: Command, pass: Pass, old: usize) -> Vec<wgpu::BindingResource<'_>> {
        let Buffers { parameters, step, materials, tables, head, .. } = self.buffers;
        let array = |array: Array, side: Side| self.buffers.array(array, side, old).as_entire_binding();
        let force = if self.model.corrects_pressure() {
            (Array::non_pressure_acceleration, Side::Only)
        } else {
            (Array::acceleration, Side::New)
        };
        let again = matches!(command, Command::RunAgain(_));
        let mut all: Vec<_> = [parameters, step, materials, tables, head].map(wgpu::Buffer::as_entire_binding).into();
        all.extend(bound(pass, &self.model).map(|binding| match binding.bound {
            Bound::Force if again => array(Array::acceleration, Side::New),
            Bound::Force => array(force.0, force.1),
            Bound::Copy(Side::New) if again && binding.array == Array::velocity => {
                array(Array::end_velocity, Side::Only)
            }
            Bound::Copy(side) => array(binding.array, side),
        }));
        match command {
            Command::Gather { from: (from, side), to } => {
                let to_side = if to.copies(&self.model) > 1 { Side::New } else { Side::Only };
                all.extend([array(from, side), array(to, to_side)]);
            }
            Command::Validate(checked) => {
                let subject = wgpu::BufferBinding {
                    buffer: &self.buffers.subjects,
                    offset: checked as u64 * UNIFORM_STRIDE,
                    size: std::num::NonZeroU64::new(16),
                };
                all.extend([array(checked, Side::New), wgpu::BindingResource::Buffer(subject)]);
            }
            _ => {}
        }
        all
    }

    /// Returns the number of work groups of a pass, in rows.
    fn size(&self, pass: Pass) -> [u32; 2] {
        let groups = match pass.threads() {
            Threads::Particles => self.particles.div_ceil(workgroup(pass)),
            Threads::Cells => cell_blocks(self.cells),
            Threads::Group | Threads::Host => 1,
        };
        in_rows(groups)
    }
}

impl Dispatch {
    /// Returns the pass that it runs.
    pub(crate) fn pass(&self) -> Pass {
        self.pass
    }

    fn record(&self, pass: &mut wgpu::ComputePass<'_>, old: usize) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &self.groups[old], &[]);
        pass.dispatch_workgroups(self.size[0], self.size[1], 1);
    }
}

/// Arranges work groups in rows that are no longer than a dispatch allows. Groups at the end may have no work.
fn in_rows(groups: u32) -> [u32; 2] {
    let rows = groups.div_ceil(MOST_GROUPS).max(1);
    [groups.div_ceil(rows), rows]
}

/// Records one step from state `old`. With `clock`, it also records the times at which each dispatch begins and ends.
pub(crate) fn record(
    dispatches: &[Dispatch],
    encoder: &mut wgpu::CommandEncoder,
    old: usize,
    clock: Option<&PassClock>,
) {
    let Some(clock) = clock else {
        let mut pass =
            encoder.begin_compute_pass(&wgpu::ComputePassDescriptor { label: Some("step"), timestamp_writes: None });
        for dispatch in dispatches {
            dispatch.record(&mut pass, old);
        }
        return;
    };
    for (i, dispatch) in dispatches.iter().enumerate() {
        let (label, timestamp_writes) = (Some(dispatch.pass.name()), Some(clock.around(i)));
        dispatch.record(&mut encoder.begin_compute_pass(&wgpu::ComputePassDescriptor { label, timestamp_writes }), old);
    }
}

/// Runs a program with two storage buffers once. The program reads the first buffer and writes the second.
pub(crate) fn dispatch_once(
    gpu: &Gpu,
    label: &str,
    wgsl: &str,
    [from, to]: [&wgpu::Buffer; 2],
    groups: u32,
) -> Result<(), GpuError> {
    use wgpu::BufferBindingType::Storage;
    let kinds = [Storage { read_only: true }, Storage { read_only: false }];
    let (layout, pipeline) = make_pipeline(gpu, label, wgsl, WORKGROUP, &kinds)?;
    let bind = bind_group(gpu, label, &layout, [from, to].map(wgpu::Buffer::as_entire_binding).into());
    let mut encoder = gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
    pass.set_pipeline(&pipeline);
    pass.set_bind_group(0, &bind, &[]);
    pass.dispatch_workgroups(groups, 1, 1);
    drop(pass);
    gpu.queue.submit([encoder.finish()]);
    Ok(())
}

/// Creates the pipeline of a pass, and the layout of its bindings.
fn pipeline(gpu: &Gpu, pass: Pass, model: &Model) -> Result<(wgpu::BindGroupLayout, wgpu::ComputePipeline), GpuError> {
    let kind = |declared: &Declared| match declared.access {
        Some(access) => wgpu::BufferBindingType::Storage { read_only: access == Access::Read },
        None => wgpu::BufferBindingType::Uniform,
    };
    let declared = declared(pass, model);
    let needed = declared.iter().filter(|declared| declared.access.is_some()).count() as u32;
    let limit = gpu.device.limits().max_storage_buffers_per_shader_stage;
    if needed > limit {
        return Err(GpuError::TooManyBuffers { pass: pass.name(), needed, limit });
    }
    let mut kinds = vec![wgpu::BufferBindingType::Uniform; UNIFORMS as usize];
    kinds.extend(declared.iter().map(kind));
    make_pipeline(gpu, pass.name(), &program(pass, model, gpu.intrinsics), workgroup(pass), &kinds)
}

/// Creates the pipeline of a complete program whose bindings 0, 1, 2 ... are buffers of these kinds.
fn make_pipeline(
    gpu: &Gpu,
    label: &str,
    wgsl: &str,
    workgroup: u32,
    kinds: &[wgpu::BufferBindingType],
) -> Result<(wgpu::BindGroupLayout, wgpu::ComputePipeline), GpuError> {
    let module = gpu.module(label, wgsl, workgroup)?;
    let label = Some(label);
    let entry = |(binding, &ty): (usize, &wgpu::BufferBindingType)| wgpu::BindGroupLayoutEntry {
        binding: binding as u32,
        visibility: wgpu::ShaderStages::COMPUTE,
        ty: wgpu::BindingType::Buffer { ty, has_dynamic_offset: false, min_binding_size: None },
        count: None,
    };
    let entries: Vec<_> = kinds.iter().enumerate().map(entry).collect();
    let layout = gpu.device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label, entries: &entries });
    let pipeline_layout = gpu.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label,
        bind_group_layouts: &[Some(&layout)],
        immediate_size: 0,
    });
    let pipeline = gpu.device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label,
        layout: Some(&pipeline_layout),
        module: &module,
        entry_point: Some("main"),
        compilation_options: wgpu::PipelineCompilationOptions::default(),
        cache: None,
    });
    Ok((layout, pipeline))
}

fn bind_group(
    gpu: &Gpu,
    label: &str,
    layout: &wgpu::BindGroupLayout,
    resources: Vec<wgpu::BindingResource<'_>>,
) -> wgpu::BindGroup {
    let entry = |(i, resource)| wgpu::BindGroupEntry { binding: i as u32, resource };
    let entries: Vec<_> = resources.into_iter().enumerate().map(entry).collect();
    gpu.device.create_bind_group(&wgpu::BindGroupDescriptor { label: Some(label), layout, entries: &entries })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_of_groups_are_no_longer_than_a_dispatch_allows_and_waste_less_than_one() {
        for groups in [0, 1, 65_535, 65_536, 131_071, 200_000, u32::MAX / 4] {
            let [along, rows] = in_rows(groups);
            assert!(along <= MOST_GROUPS && rows >= 1, "{groups}");
            let all = u64::from(along) * u64::from(rows);
            assert!(
                all >= u64::from(groups) && all < u64::from(groups) + u64::from(rows),
                "{groups}: {along} x {rows}"
            );
        }
    }
}
