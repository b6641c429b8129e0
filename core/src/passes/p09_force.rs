//! Acceleration of each particle: pressure, viscosity and gravity. Walks the neighbour lists of the density pass.
use super::p08_density::NOT_LISTED;
use super::{Setup, load, load_one, store};
use crate::arithmetic::level::Work;
use crate::arithmetic::real::{Real, real, vec3};
use crate::executor::{Executor, Jobs, parts, take};
use crate::grid::{Cells, Stencil};
use crate::layout::f32x4;
use crate::terms::neighbour::{Local, acceleration_close, force_neighbour};
use core::ops::Range;

/// What the pass reads of every particle.
#[derive(Clone, Copy)]
pub(crate) struct Inputs<'a> {
    pub position: &'a [f32x4],
    pub velocity: &'a [f32x4],
    pub density_pressure: &'a [f32x4],
    pub block: &'a [[u32; 2]],
    pub list: &'a [u32],
}

struct Job<'a> {
    setup: Setup<'a>,
    sorted: Cells<'a>,
    inputs: Inputs<'a>,
    cells: Range<usize>,
    first_slot: usize,
    out: &'a mut [f32x4],
}

/// Fills `out`, the accelerations.
pub(crate) fn run(
    setup: Setup<'_>,
    executor: &impl Executor,
    sorted: Cells<'_>,
    inputs: Inputs<'_>,
    out: &mut [f32x4],
) {
    let mut outs = out;
    let mut jobs = Jobs::new();
    for (cells, slots) in sorted.shares(parts(executor), inputs.position.len()) {
        let out = take(&mut outs, slots.len());
        let _ = jobs.push(Job { setup, sorted, inputs, cells, first_slot: slots.start, out });
    }
    executor.run(&mut jobs, |job| setup.simd.run(job));
}

impl Inputs<'_> {
    /// Particles `first ..= last` in the lanes.
    #[inline(always)]
    fn receivers<R: Real>(&self, first: usize, last: usize) -> Local<R> {
        Local {
            position: load(self.position, first, last),
            velocity: load(self.velocity, first, last),
            pressure: load_one(self.density_pressure, first, last, 1),
            near_pressure: load_one(self.density_pressure, first, last, 2),
            volume: load_one(self.density_pressure, first, last, 3),
        }
    }

    /// Particle `b` in every lane.
    #[inline(always)]
    fn neighbour<R: Real>(&self, b: usize) -> Local<R> {
        let [_, pressure, near_pressure, volume] = self.density_pressure[b];
        Local {
            position: vec3::splat(self.position[b]),
            velocity: vec3::splat(self.velocity[b]),
            pressure: real(pressure),
            near_pressure: real(near_pressure),
            volume: real(volume),
        }
    }
}

impl Work for &mut Job<'_> {
    #[inline(always)]
    fn run<R: Real>(self) {
        let (m, p, inputs) = (self.setup.model, self.setup.parameters, &self.inputs);
        let nothing = vec3(real::<R>(0.0), real(0.0), real(0.0));
        let gravity = vec3::splat(p.gravity);
        for cell in self.cells.clone() {
            let members = self.sorted.members(cell);
            for first in members.clone().step_by(R::LANES) {
                let end = (first + R::LANES).min(members.end);
                let a = inputs.receivers::<R>(first, end - 1);
                let mut force = nothing;
                let [begin, length] = inputs.block[first];
                if length == NOT_LISTED {
                    let stencil = Stencil::around(p, m.layers as i32, self.sorted, cell);
                    for b in stencil.runs().flatten() {
                        force = force + force_neighbour(m, p, a, inputs.neighbour(b));
                    }
                } else {
                    for &b in &inputs.list[begin as usize..(begin + length) as usize] {
                        force = force + force_neighbour(m, p, a, inputs.neighbour(b as usize));
                    }
                }
                let density = load_one(inputs.density_pressure, first, end - 1, 0);
                // the box keeps LLVM from carrying the loop above in the shape of the store below, at half its speed
                let force = core::hint::black_box(force);
                let acceleration = acceleration_close(m, force, density, gravity);
                store(&mut self.out[first - self.first_slot..end - self.first_slot], acceleration);
            }
        }
    }
}
