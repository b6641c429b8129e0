//! Acceleration by the springs of elastic fluids, added to all else. Only with springs.
//!
//! Each particle walks its own ends, in the order of the ids at the other ends: two ends of a spring compute the same pull from
//! the same numbers, and so the same length at rest for the next step.
use super::Setup;
use crate::arithmetic::real::vec3;
use crate::executor::{Executor, Jobs, parts, shares, take};
use crate::layout::{f32x4, u32x2, u32x4};
use crate::terms::elastic::{spring_given_way, spring_pull};
use crate::terms::geometry::flush3;
use crate::terms::pair::separation;
use core::ops::Range;

/// The particles, in their slots, and their springs, by id.
#[derive(Clone, Copy)]
pub(crate) struct Sprung<'a> {
    pub position: &'a [f32x4],
    pub id: &'a [u32],
    pub slot_of: &'a [u32],
    pub of: &'a [u32x4],
    pub ends: &'a [u32x2],
}

impl Sprung<'_> {
    /// Way from the other end of a spring to this particle.
    fn separation_from(&self, setup: &Setup<'_>, x_a: f32x4, other: u32) -> vec3<f32> {
        let x_b = self.position[self.slot_of[other as usize] as usize];
        separation(setup.model, setup.parameters, vec3::splat(x_a), vec3::splat(x_b))
    }

    fn ends(&self, id: u32) -> Range<usize> {
        let [first, count, ..] = self.of[id as usize];
        first as usize..(first + count) as usize
    }

    /// Its acceleration by all of its springs.
    fn pulled(&self, setup: &Setup<'_>, slot: usize) -> vec3<f32> {
        let (x_a, id) = (self.position[slot], self.id[slot]);
        let pull = f32::from_bits(self.of[id as usize][2]);
        let mut sum = vec3(0.0, 0.0, 0.0);
        for &[other, length] in &self.ends[self.ends(id)] {
            sum = sum + spring_pull(self.separation_from(setup, x_a, other), f32::from_bits(length), pull);
        }
        sum
    }
}

/// Adds to `acceleration`.
pub(crate) fn run(setup: Setup<'_>, executor: &impl Executor, sprung: Sprung<'_>, acceleration: &mut [f32x4]) {
    let mut rest = acceleration;
    let mut jobs = Jobs::new();
    for slots in shares(sprung.id.len(), parts(executor)) {
        let own = take(&mut rest, slots.len());
        let _ = jobs.push((slots.start, own));
    }
    executor.run(&mut jobs, |(first, own)| {
        for (i, own) in own.iter_mut().enumerate() {
            let all = flush3(vec3::splat(*own) + sprung.pulled(&setup, *first + i));
            *own = [all.x, all.y, all.z, own[3]];
        }
    });
}

/// Lengths at rest after the step. Only where they change.
pub(crate) fn give_way(setup: Setup<'_>, executor: &impl Executor, sprung: Sprung<'_>, new_ends: &mut [u32x2]) {
    let count = new_ends.len();
    let first_end = |id: usize| sprung.of.get(id).map_or(count, |of| of[0] as usize);
    let mut rest = new_ends;
    let mut jobs = Jobs::new();
    for ids in shares(sprung.of.len(), parts(executor)) {
        let first = first_end(ids.start);
        let own = take(&mut rest, first_end(ids.end) - first);
        let _ = jobs.push((ids, first, own));
    }
    executor.run(&mut jobs, |(ids, first_end, own)| {
        for id in ids.clone() {
            let x_a = sprung.position[sprung.slot_of[id] as usize];
            for end in sprung.ends(id as u32) {
                let [other, length] = sprung.ends[end];
                let x_ab = sprung.separation_from(&setup, x_a, other);
                let given = spring_given_way(setup.parameters, x_ab, f32::from_bits(length));
                own[end - *first_end] = [other, given.to_bits()];
            }
        }
    });
}
