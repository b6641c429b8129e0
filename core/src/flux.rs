//! Counts of the particles that come and go.
use crate::layout::Status;

/// Numbers of particles and of requests, counted over all steps since the start.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Flux {
    /// Particles that became active.
    pub born: u64,
    /// Particles that became inactive.
    pub removed: u64,
    /// Particles that an emitter did not make because their place was taken.
    pub blocked: u64,
    /// Requests for which no inactive particle was left. An exposed particle of liquid repeats its request for air in
    /// each step; an emitter does not.
    pub refused: u64,
    /// Particles that were found in a solid, and put back to its surface. A particle that stays in contact with a solid is
    /// counted in each step.
    pub hits: u64,
}

impl Flux {
    /// The counts of a GPU, which saturate at the largest `u32`.
    #[must_use]
    pub fn of_status(status: &Status) -> Flux {
        Flux {
            born: status.total_born.into(),
            removed: status.total_removed.into(),
            blocked: status.total_blocked.into(),
            refused: status.air_refused.into(),
            hits: status.total_hits.into(),
        }
    }

    /// Writes the counts into the status from which a GPU continues.
    pub fn fill(&self, status: &mut Status) {
        let short = |count: u64| count.min(u32::MAX.into()) as u32;
        status.total_born = short(self.born);
        status.total_removed = short(self.removed);
        status.total_blocked = short(self.blocked);
        status.air_refused = short(self.refused);
        status.total_hits = short(self.hits);
    }

    pub(crate) fn add(&mut self, step: Flux) {
        self.born += step.born;
        self.removed += step.removed;
        self.blocked += step.blocked;
        self.refused += step.refused;
        self.hits += step.hits;
    }
}
