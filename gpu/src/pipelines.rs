//! A step as commands: for each pass of the plan a pipeline, its bind groups for both directions, its work groups.
use crate::bindings::{Access, Array, Threads, UNIFORMS, arrays, threads, workgroup};
use crate::buffers::{Buffers, Role};
use crate::device::Gpu;
use crate::error::GpuError;
use crate::program::program;
use millpond_core::layout::WORKGROUP;
use millpond_core::terms::integrate::{has_history, needs_earlier};
use millpond_core::{Pass, Plan};

/// Most work groups along one dimension of a dispatch (WebGPU's default limit).
const MOST_GROUPS: u32 = 65_535;

/// What one pass does each step.
#[derive(Clone, Debug)]
pub(crate) struct Command {
    pass: Pass,
    pipeline: wgpu::ComputePipeline,
    /// With state 0, and with state 1, as the old one.
    groups: [wgpu::BindGroup; 2],
    size: [u32; 2],
}

/// What the gather pass moves: from where the moved particles wait to where they belong, and what else a plan needs of the
/// step before.
fn gathered(plan: &Plan) -> Vec<Role> {
    let m = &plan.model;
    let all = [
        (true, [Array::NewDensityPressure, Array::NewPosition]),
        (true, [Array::NewAcceleration, Array::NewVelocity]),
        (m.needs_previous(), [Array::OldDensityPressure, Array::Previous]),
        (m.thermal_energy == 1, [Array::OldHeat, Array::NewHeat]),
        (has_history(m), [Array::OldHistory, Array::NewHistory]),
        (needs_earlier(m), [Array::OldAcceleration, Array::Earlier]),
    ];
    all.into_iter().filter(|(needed, _)| *needed).map(|(_, moved)| Role::Gather(moved)).collect()
}

/// Passes that make a force, which those that are evaluated again go through once more. What springs give way by is written
/// again then, and is the same: it follows from places alone.
fn is_force(pass: Pass) -> bool {
    matches!(pass, Pass::Force | Pass::Tension | Pass::Springs)
}

/// The commands of a step.
pub(crate) fn commands(gpu: &Gpu, plan: &Plan, buffers: &Buffers, particles: u32) -> Result<Vec<Command>, GpuError> {
    let mut commands = Vec::new();
    let mut again = Vec::new();
    for pass in plan.passes() {
        let (layout, pipeline) = pipeline(gpu, pass, plan)?;
        let command = |role: Role| {
            let groups = [0, 1].map(|old| bind(gpu, pass, &layout, buffers, old, role));
            Command { pass, pipeline: pipeline.clone(), groups, size: size(pass, particles) }
        };
        if pass == Pass::Coat || pass == Pass::IntegrateAfter {
            commands.append(&mut again);
        }
        if pass == Pass::Gather {
            commands.extend(gathered(plan).into_iter().map(command));
        } else {
            commands.push(command(Role::Usual));
        }
        if plan.model.reevaluates == 1 && is_force(pass) {
            again.push(command(Role::Again));
        }
    }
    Ok(iterated(&commands, plan.iterations()))
}

/// The same commands with those of an iteration of pressure repeated, its force once more at the end. All are recorded; on
/// the device those after the last needed one do nothing.
fn iterated(commands: &[Command], iterations: u32) -> Vec<Command> {
    let is_iterated =
        |c: &&Command| matches!(c.pass, Pass::PressureForce | Pass::PressureCorrect | Pass::PressureSettle);
    let first = commands.iter().position(|c| is_iterated(&c)).unwrap_or(commands.len());
    let (before, rest) = commands.split_at(first);
    let (iteration, after) = rest.split_at(rest.iter().take_while(is_iterated).count());
    let mut all = before.to_vec();
    for _ in 0..iterations {
        all.extend_from_slice(iteration);
    }
    all.extend(iteration.first().cloned());
    all.extend_from_slice(after);
    all
}

/// Records one step from state `old`.
pub(crate) fn record(commands: &[Command], encoder: &mut wgpu::CommandEncoder, old: usize) {
    for command in commands {
        let label = Some(command.pass.name());
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor { label, timestamp_writes: None });
        pass.set_pipeline(&command.pipeline);
        pass.set_bind_group(0, &command.groups[old], &[]);
        pass.dispatch_workgroups(command.size[0], command.size[1], 1);
    }
}

/// Work groups of a pass, in rows.
fn size(pass: Pass, particles: u32) -> [u32; 2] {
    let groups = match threads(pass) {
        Threads::Particles => particles.div_ceil(workgroup(pass)),
        Threads::OneGroup => 1,
    };
    let rows = groups.div_ceil(MOST_GROUPS).max(1);
    [groups.div_ceil(rows), rows]
}

/// Runs a program of two storage buffers, one read and one written, once.
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
    let bind = bind_group(gpu, label, &layout, &[from, to]);
    let mut encoder = gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
    pass.set_pipeline(&pipeline);
    pass.set_bind_group(0, &bind, &[]);
    pass.dispatch_workgroups(groups, 1, 1);
    drop(pass);
    gpu.queue.submit([encoder.finish()]);
    Ok(())
}

/// Pipeline of a pass, with the layout of its bindings.
fn pipeline(gpu: &Gpu, pass: Pass, plan: &Plan) -> Result<(wgpu::BindGroupLayout, wgpu::ComputePipeline), GpuError> {
    let storage =
        |(_, access): &(Array, Access)| wgpu::BufferBindingType::Storage { read_only: *access == Access::Read };
    let mut kinds = vec![wgpu::BufferBindingType::Uniform; UNIFORMS as usize];
    kinds.extend(arrays(pass).iter().map(storage));
    make_pipeline(gpu, pass.name(), &program(pass, &plan.model, gpu.words), workgroup(pass), &kinds)
}

/// Pipeline of a complete program whose bindings 0, 1, 2 ... are buffers of these kinds.
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

/// The arrays of a pass when state `old` is the old one.
fn bind(
    gpu: &Gpu,
    pass: Pass,
    layout: &wgpu::BindGroupLayout,
    buffers: &Buffers,
    old: usize,
    role: Role,
) -> wgpu::BindGroup {
    let mut bound = vec![&buffers.parameters, &buffers.tables];
    bound.extend(arrays(pass).iter().map(|(array, _)| buffers.array(*array, old, role)));
    bind_group(gpu, pass.name(), layout, &bound)
}

fn bind_group(gpu: &Gpu, label: &str, layout: &wgpu::BindGroupLayout, buffers: &[&wgpu::Buffer]) -> wgpu::BindGroup {
    let entries: Vec<_> = buffers
        .iter()
        .enumerate()
        .map(|(i, buffer)| wgpu::BindGroupEntry { binding: i as u32, resource: buffer.as_entire_binding() })
        .collect();
    gpu.device.create_bind_group(&wgpu::BindGroupDescriptor { label: Some(label), layout, entries: &entries })
}
