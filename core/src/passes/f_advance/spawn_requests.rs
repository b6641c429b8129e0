//! Finds the liquid particles beside which an air particle is to be made. Runs only with air.
//!
//! An exposed particle requests an air particle one spacing away, if no particle is near that position. If several
//! particles request air at nearly the same position, the one with the smallest id gets it. Particles that could be in
//! the way are searched around the requested position, not around the exposed particle: across a gap they may be
//! further away than a support radius. Few particles are exposed, so the pass does not use SIMD.
use crate::executor::{Jobs, parts, shares, take};
use crate::passes::context::{Setup, Step};
use crate::passes::pairs::cells;
use crate::passes::places::Places;
use crate::terms::air::is_taken;

/// Returns whether an air particle is to be made beside the particle in this slot.
fn wants_spawn(liquid: Places<'_>, id: &[u32], setup: &Setup<'_>, a: usize) -> bool {
    if liquid.gradient[a][3] == 0.0 {
        return false;
    }
    let place = liquid.beside(setup, a);
    let Some(around) = liquid.around(setup, place) else { return false };
    let goes_first = |b: usize| {
        if liquid.gradient[b][3] == 0.0 || id[b] >= id[a] {
            return false;
        }
        let other = liquid.beside(setup, b);
        is_taken(setup.model, setup.parameters, place, other) > 0.0
            && liquid.around(setup, other).is_some_and(|around| liquid.is_free(setup, other, &around))
    };
    liquid.is_free(setup, place, &around) && !around.runs().flatten().any(goes_first)
}

/// Fills `spawn_requested`.
pub(crate) fn run(step: &mut Step<'_, '_>) {
    let (setup, position, id) = (step.setup, &*step.new.position, &*step.new.id);
    let liquid = Places { sorted: cells!(step), position, gradient: step.scratch.total_colour_gradient };
    let mut rest = &mut *step.scratch.spawn_requested;
    let mut jobs = Jobs::new();
    for slots in shares(id.len(), parts(step.executor)) {
        let own = take(&mut rest, slots.len());
        let _ = jobs.push((slots.start, own));
    }
    step.executor.run(&mut jobs, |(first, own)| {
        for (i, own) in own.iter_mut().enumerate() {
            *own = u32::from(wants_spawn(liquid, id, &setup, *first + i));
        }
    });
}
