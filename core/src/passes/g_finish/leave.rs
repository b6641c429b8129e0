//! Finds the particles that become inactive: air that is too thin, particles whose life has ended, and those that a
//! drain takes. Runs only where particles can be inactive.
use crate::arithmetic::real::vec3;
use crate::executor::{Jobs, parts, shares, take};
use crate::layout::f32x4;
use crate::passes::context::{Setup, Step};
use crate::passes::lanes::{is_wall, material_of};
use crate::terms::air::is_thin;
use crate::terms::emission::{is_drained, life_after};

/// What becomes of a particle: it stays as it is, or it becomes inactive. Higher numbers are those of requests.
pub(crate) const STAYS: u32 = 0;
pub(crate) const LEAVES: u32 = 1;
pub(crate) const FIRST_REQUEST: u32 = 2;

/// Returns whether a drain takes a particle.
fn drains(setup: &Setup<'_>, position: f32x4) -> bool {
    let p = setup.parameters;
    let rows = p.drains.chunks_exact(2).take(p.drain_count as usize);
    let at = vec3::<f32>::splat(position);
    rows.into_iter().any(|rows| is_drained(at, vec3::splat(rows[0]), vec3::splat(rows[1]), rows[0][3]) > 0.0)
}

/// Fills `fate`, and advances the lives.
pub(crate) fn run(step: &mut Step<'_, '_>) {
    let setup = step.setup;
    let (m, p) = (setup.model, setup.parameters);
    let new = &mut *step.new;
    let (position, velocity, density, id) = (&*new.position, &*new.velocity, &*new.density_pressure, &*new.id);
    let (mut fates, mut lives) = (&mut *step.scratch.fate, &mut *new.life);
    let has_lives = !lives.is_empty();
    let mut jobs = Jobs::new();
    for slots in shares(id.len(), parts(step.executor)) {
        let fates = take(&mut fates, slots.len());
        let lives = take(&mut lives, if has_lives { slots.len() } else { 0 });
        let _ = jobs.push((slots.start, fates, lives));
    }
    step.executor.run(&mut jobs, |(first, fates, lives)| {
        for (i, fate) in fates.iter_mut().enumerate() {
            let slot = *first + i;
            *fate = STAYS;
            if is_wall(setup.materials, velocity[slot][3]) || id[slot] < p.first_spare {
                continue;
            }
            let is_air = m.has_air == 1 && material_of(velocity[slot][3]) == p.air_fluid as usize;
            let mut leaves = is_air && is_thin(p, density[slot][0]) > 0.0;
            if let Some(life) = lives.get_mut(i) {
                life[1] = life_after::<f32>(setup.uniform, life[1]);
                leaves |= life[1] <= 0.0 || drains(&setup, position[slot]);
            }
            if leaves {
                *fate = LEAVES;
            }
        }
    });
}
