//! Carries the particles of solids along with them. Runs only if a solid with particles moves.
use crate::arithmetic::real::vec3;
use crate::executor::{Jobs, parts, shares, take};
use crate::memory::Sorting;
use crate::passes::context::{Step, sorting};
use crate::solids::solids;
use crate::terms::geometry::flush3;
use crate::terms::integrate::wrap;

/// Sets the positions and velocities of the particles of solids.
pub(crate) fn run(step: &mut Step<'_, '_>) {
    let (setup, executor, anchors, ids) = (step.setup, step.executor, &*step.given.anchor, &*step.old.id);
    let Sorting { moved_position: mut positions, moved_velocity: mut velocities, .. } = sorting!(step);
    let mut jobs = Jobs::new();
    for slots in shares(ids.len(), parts(executor)) {
        let own = (take(&mut positions, slots.len()), take(&mut velocities, slots.len()));
        let _ = jobs.push((&ids[slots], own));
    }
    executor.run(&mut jobs, |(ids, (positions, velocities))| {
        for ((&id, position), velocity) in ids.iter().zip(positions.iter_mut()).zip(velocities.iter_mut()) {
            let anchor = anchors[id as usize];
            if anchor[3] < 0.0 {
                continue;
            }
            let Some(solid) = solids(setup.model, setup.parameters, setup.poses).nth(anchor[3] as usize) else {
                continue;
            };
            let local = vec3::splat(anchor);
            let x = wrap(setup.model, setup.parameters, flush3(solid.point(local)));
            let v = flush3(solid.velocity_at(local));
            position[..3].copy_from_slice(&[x.x, x.y, x.z]);
            velocity[..3].copy_from_slice(&[v.x, v.y, v.z]);
        }
    });
}
