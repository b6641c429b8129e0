//! The ledger of the particles that come and go. Nothing here is part of a step.
use crate::flux::Flux;
use crate::passes::lanes::material_of;
use crate::solver::Solver;

/// The ledger: `active` is the number at the start plus `born` minus `removed`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Census {
    /// Active fluid particles, air included.
    pub active: u32,
    /// What came and went since the start.
    pub flux: Flux,
}

impl Solver<'_> {
    /// The number of active particles, and how many came and went.
    #[must_use]
    pub fn census(&self) -> Census {
        let fluid = |slot: &usize| !self.is_wall(*slot);
        Census { active: (0..self.slots().len()).filter(fluid).count() as u32, flux: self.census }
    }

    /// How often the particle with this id was made, or `None` if there is no such particle. Together with the id it
    /// identifies a particle: an id that is used again has another generation. Always 0 in scenes without emitters,
    /// drains and spare particles.
    #[must_use]
    pub fn generation(&self, id: u32) -> Option<u32> {
        let slot = *self.slots().get(id as usize)?;
        Some(self.state().life.get(slot as usize).map_or(0, |life| life[0] as u32))
    }

    /// Number of active particles of the layer of air.
    pub(crate) fn active_air(&self) -> u32 {
        let air = self.parameters().air_fluid as usize;
        let spare = self.slots().iter().skip(self.parameters().first_spare as usize);
        let is_air = |&&slot: &&u32| material_of(self.state().velocity[slot as usize][3]) == air;
        spare.filter(is_air).count() as u32
    }
}
