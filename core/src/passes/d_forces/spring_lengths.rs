//! Computes the rest lengths of springs after the step. Runs only where they change: with plasticity, or with springs
//! that break.
use super::springs::springs;
use crate::executor::{Jobs, parts, shares, take};
use crate::passes::context::Step;
use crate::terms::elastic::plastic_rest_length;

/// Fills `spring_ends` of the new state.
pub(crate) fn run(step: &mut Step<'_, '_>) {
    let (setup, springs) = (step.setup, springs!(step));
    let mut rest = &mut *step.new.spring_ends;
    let count = rest.len();
    let first_end = |id: usize| springs.ranges.get(id).map_or(count, |range| range[0] as usize);
    let mut jobs = Jobs::new();
    for ids in shares(springs.ranges.len(), parts(step.executor)) {
        let first = first_end(ids.start);
        let own = take(&mut rest, first_end(ids.end) - first);
        let _ = jobs.push((ids, first, own));
    }
    step.executor.run(&mut jobs, |(ids, first_end, own)| {
        for id in ids.clone() {
            let x_a = springs.position[springs.slot_of_id[id] as usize];
            for end in springs.ends(id as u32) {
                let [other, length] = springs.ends[end];
                let x_ab = springs.separation_from(&setup, x_a, other);
                let given = plastic_rest_length(setup.parameters, setup.uniform, x_ab, f32::from_bits(length));
                own[end - *first_end] = [other, given.to_bits()];
            }
        }
    });
}
