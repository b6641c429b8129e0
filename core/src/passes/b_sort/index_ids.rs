//! Records the slot of each particle, by id.
use crate::passes::context::Step;

/// Fills `slot_of_id`.
pub(crate) fn run(step: &mut Step<'_, '_>) {
    for (slot, &id) in step.new.id.iter().enumerate() {
        step.new.slot_of_id[id as usize] = slot as u32;
    }
}
