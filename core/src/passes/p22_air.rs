//! Air is made where the pass before the last said, and vanishes where it is thin. Only with air.
//!
//! In the order of the ids, so that no slot decides who becomes whom: the k-th birth takes the k-th particle that was not there
//! before this step. Who vanishes now is free from the next step on, when the other passes have forgotten what it was. Serial: one
//! look at each id.
use super::{Setup, is_dormant};
use crate::arithmetic::real::vec3;
use crate::derive::material::DORMANT;
use crate::layout::f32x4;
use crate::memory::State;
use crate::terms::air::{is_thin, place_of_birth};

/// What became of a step's air.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Coat {
    /// Particles of the coat that are there.
    pub alive: u32,
    /// Births for which none was left.
    pub refused: u32,
}

/// Makes and unmakes particles of `new`; `slot_of` is the slot of each id.
pub(crate) fn run(setup: Setup<'_>, new: &mut State<'_>, (bare, birth): (&[f32x4], &[u32]), slot_of: &[u32]) -> Coat {
    let (m, p) = (setup.model, setup.parameters);
    let (parents, coat) = slot_of.split_at((p.first_air as usize).min(slot_of.len()));
    let mut parents = parents.iter().map(|&slot| slot as usize).filter(|&slot| birth[slot] == 1);
    let mut made = Coat::default();
    for &slot in coat {
        let slot = slot as usize;
        if !is_dormant(p, new.velocity[slot][3]) {
            let thin = is_thin(p, new.density_pressure[slot][0]) > 0.0;
            if thin {
                set(p.rest_volume, new, slot, [0.0, 0.0, 0.0, DORMANT as f32]);
            }
            made.alive += u32::from(!thin);
        } else if let Some(parent) = parents.next() {
            let (x, [u, v, w, _]) = (vec3::splat(new.position[parent]), new.velocity[parent]);
            let place = place_of_birth(m, p, x, vec3::splat(bare[parent]));
            new.position[slot] = [place.x, place.y, place.z, 1.0];
            set(p.rest_volume, new, slot, [u, v, w, p.air_fluid]);
            made.alive += 1;
        }
    }
    made.refused = parents.count() as u32;
    made
}

/// A particle without a past.
fn set(rest_volume: f32, new: &mut State<'_>, slot: usize, velocity: f32x4) {
    new.velocity[slot] = velocity;
    new.acceleration[slot] = [0.0; 4];
    new.density_pressure[slot] = [0.0, 0.0, 0.0, rest_volume];
}
