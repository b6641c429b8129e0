//! Air is made where the pass before the last said, and vanishes where it is thin. Only with air.
//!
//! In the order of the ids, so that no slot decides who becomes whom: the k-th birth takes the k-th particle that was not there
//! before this step. Who vanishes now is free from the next step on, when the other passes have forgotten what it was. Serial: one
//! look at each id.
use crate::arithmetic::real::vec3;
use crate::derive::material::INACTIVE;
use crate::layout::f32x4;
use crate::memory::State;
use crate::passes::context::Step;
use crate::passes::lanes::is_inactive;
use crate::terms::air::{is_thin, place_of_birth};
use core::ops::Range;

/// Makes and removes air; counts the requests for which no particle was left.
pub(crate) fn run<E>(step: &mut Step<'_, '_, E>) {
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
            let place = place_of_birth(m, p, x, vec3::splat(gradient[parent]));
            new.position[slot] = [place.x, place.y, place.z, 1.0];
            set(p.rest_volume, new, slot, [u, v, w, p.air_fluid]);
        }
    }
    while next_parent(&mut ids, new.slot_of_id, requested).is_some() {
        step.found.refused += 1;
    }
}

/// Slot of the next particle, in the order of the ids, beside which air is wanted.
fn next_parent(ids: &mut Range<usize>, slot_of_id: &[u32], requested: &[u32]) -> Option<usize> {
    ids.map(|id| slot_of_id[id] as usize).find(|&slot| requested[slot] == 1)
}

/// A particle without a past.
fn set(rest_volume: f32, new: &mut State<'_>, slot: usize, velocity: f32x4) {
    new.velocity[slot] = velocity;
    new.acceleration[slot] = [0.0; 4];
    new.density_pressure[slot] = [0.0, 0.0, 0.0, rest_volume];
}
