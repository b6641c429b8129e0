//! Gives each request for a new particle one that is inactive. Runs only where particles can be inactive.
//!
//! Requests are processed in a fixed order, first those for air by the ids of the particles beside which it is
//! requested, then the points of emitters, so that the result does not depend on slots: the k-th request gets the k-th
//! particle, by id, that was inactive before this step. A particle that leaves in this step can be used from the next
//! step on, when the data of its past is gone from the other passes too. The pass is serial, and visits each id once.
use super::leave::{FIRST_REQUEST, LEAVES};
use crate::passes::context::Step;
use crate::passes::f_advance::emit::BLOCKED;
use crate::passes::lanes::is_inactive;
use core::cell::Cell;

/// Fills `fate` for particles that become active, and counts what comes and goes.
pub(crate) fn run(step: &mut Step<'_, '_>) {
    let (m, p, new, scratch) = (step.setup.model, step.setup.parameters, &*step.new, &mut *step.scratch);
    let (requested, emission, fate) =
        (&*scratch.spawn_requested, &*scratch.emission, Cell::from_mut(&mut *scratch.fate).as_slice_of_cells());
    let slots = new.slot_of_id.len();
    let ids = if m.has_air == 1 { 0..slots } else { 0..0 };
    // nobody asks beside a particle that leaves
    let asks = |slot: usize| requested[slot] == 1 && fate[slot].get() != LEAVES;
    let air = ids.map(|id| new.slot_of_id[id]).filter(|&slot| asks(slot as usize));
    let points = (0..).zip(emission.chunks_exact(2)).filter(|(_, rows)| rows[0][3] > 0.0);
    // the slots of particles, then the points
    let mut requests = air.chain(points.map(|(point, _)| p.particle_count + point));
    let mut flux = step.found.flux;
    for id in (p.first_spare as usize).min(slots)..slots {
        let slot = new.slot_of_id[id] as usize;
        if !is_inactive(step.setup.materials, new.velocity[slot][3]) {
            flux.removed += u64::from(fate[slot].get() == LEAVES);
        } else if let Some(request) = requests.next() {
            fate[slot].set(FIRST_REQUEST + request);
            flux.born += 1;
        }
    }
    flux.refused = requests.count() as u64;
    flux.blocked = emission.chunks_exact(2).filter(|rows| rows[0][3] == BLOCKED).count() as u64;
    step.found.flux = flux;
}
