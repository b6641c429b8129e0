//! Makes air particles where the pass `spawn_requests` requested them, and removes those whose density is too low. Runs
//! only with air.
//!
//! Requests are processed in the order of the ids, so that the result does not depend on slots: the k-th request gets
//! the k-th particle that was inactive before this step. A particle that is removed in this step can be used from the
//! next step on, when the data of its past is gone from the other passes too. The pass is serial, and visits each id
//! once.
use crate::arithmetic::real::vec3;
use crate::derive::material::INACTIVE;
use crate::layout::f32x4;
use crate::memory::State;
use crate::passes::context::Step;
use crate::passes::lanes::is_inactive;
use crate::terms::air::{is_thin, spawn_position};
use core::ops::Range;

/// Makes and removes air particles, and counts the requests for which no inactive particle was left.
pub(crate) fn run(step: &mut Step<'_, '_>) {
    let (m, p, new) = (step.setup.model, step.setup.parameters, &mut *step.new);
    let (gradient, requested) = (&*step.scratch.total_colour_gradient, &*step.scratch.spawn_requested);
    let slots = new.slot_of_id.len();
    let first_air = (p.first_air as usize).min(slots);
    let mut ids = 0..first_air;
    for id in first_air..slots {
        let slot = new.slot_of_id[id] as usize;
        if !is_inactive(step.setup.materials, new.velocity[slot][3]) {
            let thin = is_thin(p, new.density_pressure[slot][0]) > 0.0;
            if thin {
                set(p.rest_volume, new, slot, [0.0, 0.0, 0.0, INACTIVE as f32]);
            }
        } else if let Some(parent) = next_parent(&mut ids, new.slot_of_id, requested) {
            let (x, [u, v, w, _]) = (vec3::splat(new.position[parent]), new.velocity[parent]);
            let place = spawn_position(m, p, x, vec3::splat(gradient[parent]));
            new.position[slot] = [place.x, place.y, place.z, 1.0];
            set(p.rest_volume, new, slot, [u, v, w, p.air_fluid]);
        }
    }
    while next_parent(&mut ids, new.slot_of_id, requested).is_some() {
        step.found.refused += 1;
    }
}

/// Returns the slot of the next particle, in the order of the ids, beside which air is requested.
fn next_parent(ids: &mut Range<usize>, slot_of_id: &[u32], requested: &[u32]) -> Option<usize> {
    ids.map(|id| slot_of_id[id] as usize).find(|&slot| requested[slot] == 1)
}

/// Resets a particle to rest density, without pressure or acceleration, and with this velocity and material.
fn set(rest_volume: f32, new: &mut State<'_>, slot: usize, velocity: f32x4) {
    new.velocity[slot] = velocity;
    new.acceleration[slot] = [0.0; 4];
    new.density_pressure[slot] = [0.0, 0.0, 0.0, rest_volume];
}
