//! Sets the particles that come and go: those that leave become inactive, and those that were given to a request get
//! its position, velocity and material. Runs only where particles can be inactive.
use super::leave::{FIRST_REQUEST, LEAVES, STAYS};
use crate::arithmetic::real::vec3;
use crate::derive::material::INACTIVE;
use crate::layout::f32x4;
use crate::memory::State;
use crate::passes::context::Step;
use crate::terms::air::spawn_position;

/// Sets the particles whose fate is to leave or to become active. There are few, so the pass is serial.
pub(crate) fn run(step: &mut Step<'_, '_>) {
    let (m, p, new) = (step.setup.model, step.setup.parameters, &mut *step.new);
    let (gradient, emission) = (&*step.scratch.total_colour_gradient, &*step.scratch.emission);
    for (slot, &fate) in step.scratch.fate.iter().enumerate() {
        match fate {
            STAYS => {}
            LEAVES => set(p.rest_volume, new, slot, [0.0, 0.0, 0.0, INACTIVE as f32]),
            request => {
                let request = request - FIRST_REQUEST;
                let (place, life, velocity) = if request < p.particle_count {
                    let parent = request as usize;
                    let (x, [u, v, w, _]) = (vec3::splat(new.position[parent]), new.velocity[parent]);
                    let place = spawn_position(m, p, x, vec3::splat(gradient[parent]));
                    ([place.x, place.y, place.z, 1.0], f32::MAX, [u, v, w, p.air_fluid])
                } else {
                    let first = 2 * (request - p.particle_count) as usize;
                    let [x, y, z, life] = emission[first];
                    ([x, y, z, 1.0], life, emission[first + 1])
                };
                new.position[slot] = place;
                set(p.rest_volume, new, slot, velocity);
                if let Some([generation, left, ..]) = new.life.get_mut(slot) {
                    (*generation, *left) = (*generation + 1.0, life);
                }
            }
        }
    }
}

/// Resets a particle to rest density, without pressure or acceleration, and with this velocity and material.
pub(crate) fn set(rest_volume: f32, new: &mut State<'_>, slot: usize, velocity: f32x4) {
    new.velocity[slot] = velocity;
    new.acceleration[slot] = [0.0; 4];
    new.density_pressure[slot] = [0.0, 0.0, 0.0, rest_volume];
}
