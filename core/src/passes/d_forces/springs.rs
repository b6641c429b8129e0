//! Adds the acceleration by the springs of elastic fluids to the other accelerations. Runs only with springs.
//!
//! Each particle processes its own spring ends, in the order of the ids at the other ends. The two ends of a spring
//! compute the same force from the same numbers, and so the same rest length for the next step.
use crate::arithmetic::real::vec3;
use crate::executor::{Jobs, parts, shares, take};
use crate::layout::{f32x4, u32x2, u32x4};
use crate::passes::context::{Setup, Step};
use crate::terms::elastic::spring_pull;
use crate::terms::geometry::flush3;
use crate::terms::pair::separation;
use core::ops::Range;

/// The particles, by slot, and their springs, by id.
#[derive(Clone, Copy)]
pub(crate) struct Springs<'a> {
    pub position: &'a [f32x4],
    pub id: &'a [u32],
    pub slot_of_id: &'a [u32],
    pub ranges: &'a [u32x4],
    pub ends: &'a [u32x2],
}

/// Returns the springs of a step. This is a macro because a function would borrow the whole state.
macro_rules! springs {
    ($step:ident) => {
        $crate::passes::d_forces::springs::Springs {
            position: &*$step.new.position,
            id: &*$step.new.id,
            slot_of_id: &*$step.new.slot_of_id,
            ranges: &*$step.given.spring_ranges,
            ends: &*$step.old.spring_ends,
        }
    };
}
pub(crate) use springs;

impl Springs<'_> {
    /// Returns the vector from the other end of a spring to this particle.
    pub(crate) fn separation_from(&self, setup: &Setup<'_>, x_a: f32x4, other: u32) -> vec3<f32> {
        let x_b = self.position[self.slot_of_id[other as usize] as usize];
        separation(setup.model, setup.parameters, vec3::splat(x_a), vec3::splat(x_b))
    }

    pub(crate) fn ends(&self, id: u32) -> Range<usize> {
        let [first, count, ..] = self.ranges[id as usize];
        first as usize..(first + count) as usize
    }

    /// Returns the acceleration of a particle by all of its springs.
    fn pulled(&self, setup: &Setup<'_>, slot: usize) -> vec3<f32> {
        let (x_a, id) = (self.position[slot], self.id[slot]);
        let pull = f32::from_bits(self.ranges[id as usize][2]);
        let mut sum = vec3(0.0, 0.0, 0.0);
        for &[other, length] in &self.ends[self.ends(id)] {
            sum = sum + spring_pull(self.separation_from(setup, x_a, other), f32::from_bits(length), pull);
        }
        sum
    }
}

/// Adds to the accelerations, or to those without pressure where pressure is iterated.
pub(crate) fn run(step: &mut Step<'_, '_>) {
    let (setup, springs) = (step.setup, springs!(step));
    let corrects = setup.model.corrects_pressure();
    let mut rest = if corrects { &mut *step.scratch.non_pressure_acceleration } else { &mut *step.new.acceleration };
    let mut jobs = Jobs::new();
    for slots in shares(springs.id.len(), parts(step.executor)) {
        let own = take(&mut rest, slots.len());
        let _ = jobs.push((slots.start, own));
    }
    step.executor.run(&mut jobs, |(first, own)| {
        for (i, own) in own.iter_mut().enumerate() {
            let all = flush3(vec3::splat(*own) + springs.pulled(&setup, *first + i));
            *own = [all.x, all.y, all.z, own[3]];
        }
    });
}
