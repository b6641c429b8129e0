//! Particles that the host adds and removes between two steps.
use crate::arithmetic::real::vec3;
use crate::derive::material::INACTIVE;
use crate::error::SpawnError;
use crate::grid::cell_of;
use crate::passes::g_finish::renew::set;
use crate::passes::lanes::is_inactive;
use crate::solids::is_in_solid;
use crate::solver::Solver;
use crate::terms::air::is_taken;
use crate::terms::boundary::depth_behind;
use crate::terms::geometry::flush3;
use crate::terms::integrate::wrap;
use glam::Vec3;

/// A particle that the host adds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NewParticle {
    /// Index of its fluid.
    pub fluid: u32,
    /// Position, m.
    pub position: Vec3,
    /// Velocity, m/s.
    pub velocity: Vec3,
    /// How long it lives, s, larger than 0 (`None`: until a drain or the host removes it).
    pub life: Option<f32>,
}

/// What identifies a particle for as long as it is active: an id that is used again has another generation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ParticleId {
    /// The particle's id, its place in the order of [`Solver::particles`].
    pub index: u32,
    /// How often the id was made active since the start: [`Solver::generation`].
    pub generation: u32,
}

impl Solver<'_> {
    /// Adds a particle of fluid at rest density, from the next step on. It is the inactive particle with the smallest
    /// id. The scene must have [`spare_particles`](crate::scene::Scene::spare_particles), emitters or drains.
    ///
    /// # Errors
    /// A [`SpawnError`]: another particle is nearer than 3/4 of a particle spacing, so that both would be pushed apart
    /// violently ([`Flux::blocked`](crate::Flux::blocked) counts it); no inactive particle is left
    /// ([`Flux::refused`](crate::Flux::refused) counts it); or a value is not valid. The fluid stays as it was.
    pub fn spawn(&mut self, new: &NewParticle) -> Result<ParticleId, SpawnError> {
        let (m, p) = (self.plan().model, *self.parameters());
        if m.has_turnover == 0 {
            return Err(SpawnError::NotPlanned);
        }
        let numbers = [new.position, new.velocity].into_iter().flat_map(|v| v.to_array());
        if !numbers.chain(new.life).all(f32::is_finite) {
            return Err(SpawnError::NotFinite);
        }
        if new.life.is_some_and(|life| life <= 0.0) {
            return Err(SpawnError::LifeNotPositive);
        }
        let fluids = self.live().fluids();
        if new.fluid >= fluids {
            return Err(SpawnError::NoSuchFluid { fluid: new.fluid, fluids });
        }
        if m.is_3d == 0 && (new.position.z != 0.0 || new.velocity.z != 0.0) {
            return Err(SpawnError::OutOfPlane);
        }
        let at = |v: Vec3| flush3::<f32>(vec3(v.x, v.y, v.z));
        let (place, velocity) = (wrap(&m, &p, at(new.position)), at(new.velocity));
        if cell_of(&p, [place.x, place.y, place.z, 0.0]).is_err() {
            return Err(SpawnError::OutOfRange);
        }
        let planes = if m.has_container == 1 { p.plane_count as usize } else { 0 };
        if p.planes[..planes].iter().any(|plane| depth_behind(place, vec3::splat(*plane), plane[3]) > 0.0) {
            return Err(SpawnError::BehindPlane);
        }
        if is_in_solid(&m, &p, self.state().pose, place) {
            return Err(SpawnError::InSolid);
        }
        let (materials, state) = (self.materials(), self.state());
        let active = |slot: usize| !is_inactive(materials, state.velocity[slot][3]);
        let taken = |slot: usize| is_taken(&m, &p, place, vec3::<f32>::splat(state.position[slot])) > 0.0;
        if (0..state.id.len()).any(|slot| active(slot) && taken(slot)) {
            self.census.blocked += 1;
            return Err(SpawnError::Taken);
        }
        let spare = (0..).zip(state.slot_of_id.iter()).find(|(_, slot)| !active(**slot as usize));
        let Some((index, slot)) = spare.map(|(id, &slot)| (id, slot as usize)) else {
            self.census.refused += 1;
            return Err(SpawnError::NoSpare);
        };
        self.census.born += 1;
        let state = self.state_mut();
        state.position[slot] = [place.x, place.y, place.z, 1.0];
        set(p.rest_volume, state, slot, [velocity.x, velocity.y, velocity.z, new.fluid as f32]);
        let [generation, left, ..] = &mut state.life[slot];
        (*generation, *left) = (*generation + 1.0, new.life.unwrap_or(f32::MAX));
        Ok(ParticleId { index, generation: *generation as u32 })
    }

    /// Removes a fluid particle, from the next step on. Returns false, and changes nothing, if it is not there any
    /// more, if it belongs to a wall, or if the scene has no spare particles, emitters or drains.
    pub fn remove(&mut self, particle: ParticleId) -> bool {
        let Some(slot) = self.slot_of(particle) else { return false };
        self.census.removed += 1;
        let rest_volume = self.parameters().rest_volume;
        let state = self.state_mut();
        set(rest_volume, state, slot, [0.0, 0.0, 0.0, INACTIVE as f32]);
        // a step would do this, but the particle may be used again before the next one
        for array in [&mut state.drift_velocity, &mut state.normal] {
            if let Some(row) = array.get_mut(slot) {
                *row = [0.0; 4];
            }
        }
        true
    }

    /// Identifies the particle that has this id now; `None` if there is no such id, or if it is inactive.
    #[must_use]
    pub fn identify(&self, index: u32) -> Option<ParticleId> {
        let particle = ParticleId { index, generation: self.generation(index)? };
        let slot = *self.slots().get(index as usize)? as usize;
        (!is_inactive(self.materials(), self.state().velocity[slot][3])).then_some(particle)
    }

    /// Slot of a fluid particle that can be removed.
    fn slot_of(&self, particle: ParticleId) -> Option<usize> {
        let slot = *self.slots().get(particle.index as usize)? as usize;
        let is_spare = self.plan().model.has_turnover == 1 && particle.index >= self.parameters().first_spare;
        (is_spare && self.identify(particle.index) == Some(particle) && !self.is_wall(slot)).then_some(slot)
    }
}
