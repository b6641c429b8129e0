//! What a solver needs besides its arrays to continue, and the fingerprint that identifies the scene of saved bytes.
use crate::clock::SteadyTime;
use crate::flux::Flux;
use crate::hash::Fnv;
use crate::layout::{Materials, Model, Parameters, Status};
use crate::live::{LiveScene, LiveValues};
use crate::memory::{Counts, Requirements};
use crate::plan::Plan;

/// Result of the pressure correction.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CorrectionReport {
    /// Iterations in the last step.
    pub iterations: u32,
    /// Iterations in all steps.
    pub total_iterations: u64,
    /// Largest density error left at the end of the last step, over the rest density.
    pub residual: f32,
}

/// What a solver needs besides its arrays to continue.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Record {
    /// Number of steps made.
    pub steps: u64,
    /// Simulated time in scenes with a constant time step.
    pub steady: SteadyTime,
    /// Up to when [`Solver::advance`](crate::Solver::advance) was asked for steps, s.
    pub due: f64,
    /// The clock: simulated time, its rounding error, the last time step, and the largest time step that the criteria
    /// allowed, s.
    pub clock: [f32; 4],
    /// The next time step, s.
    pub time_step: f32,
    /// Number of rejected steps, of steps that should have been shorter than the shortest time step allowed, and of
    /// halvings.
    pub counts: [u32; 3],
    /// Result of the pressure correction.
    pub correction: CorrectionReport,
    /// The particles that came and went.
    pub flux: Flux,
    /// The values that may be changed between steps.
    pub live: LiveValues,
}

impl Record {
    /// Number of words in a record.
    pub const WORDS: usize = 30 + LiveValues::WORDS;

    /// The record of a GPU solver: from its status, and from values that the host program keeps.
    #[must_use]
    pub fn of_status(status: &Status, steady: SteadyTime, due: f64, time_step: f32, live: &LiveScene) -> Record {
        Record {
            steps: u64::from(status.steps),
            steady,
            due,
            clock: [status.clock, status.clock_lost, status.last_time_step, status.last_wanted],
            time_step,
            counts: [status.rejected_steps, status.clamped_steps, status.halvings],
            correction: CorrectionReport {
                iterations: status.last_iterations,
                total_iterations: u64::from(status.total_iterations),
                residual: f32::from_bits(status.last_residual),
            },
            flux: Flux::of_status(status),
            live: live.values(),
        }
    }

    pub(crate) fn each_word(&self, mut word: impl FnMut(u32)) {
        let mut wide = |x: u64| [x as u32, (x >> 32) as u32].into_iter().for_each(&mut word);
        wide(self.steps);
        wide(self.steady.since);
        wide(self.steady.at.to_bits());
        wide(self.correction.total_iterations);
        let Flux { refused, blocked, born, removed, hits } = self.flux;
        [refused, blocked, born, removed, hits].into_iter().for_each(wide);
        self.clock.iter().for_each(|x| word(x.to_bits()));
        word(self.time_step.to_bits());
        self.counts.into_iter().for_each(&mut word);
        word(self.correction.iterations);
        word(self.correction.residual.to_bits());
        let due = self.due.to_bits();
        [due as u32, (due >> 32) as u32].into_iter().for_each(&mut word);
        self.live.to_words().into_iter().for_each(&mut word);
    }

    pub(crate) fn of_words(words: &[u32]) -> Record {
        let at = |i: usize| words.get(i).copied().unwrap_or(0);
        let wide = |i: usize| u64::from(at(i)) | u64::from(at(i + 1)) << 32;
        let float = |i: usize| f32::from_bits(at(i));
        Record {
            steps: wide(0),
            steady: SteadyTime { since: wide(2), at: f64::from_bits(wide(4)) },
            clock: [float(18), float(19), float(20), float(21)],
            time_step: float(22),
            counts: [at(23), at(24), at(25)],
            correction: CorrectionReport { iterations: at(26), total_iterations: wide(6), residual: float(27) },
            flux: Flux { refused: wide(8), blocked: wide(10), born: wide(12), removed: wide(14), hits: wide(16) },
            due: f64::from_bits(wide(28)),
            live: LiveValues::of_words(words.get(30..).unwrap_or_default()),
        }
    }
}

/// Fingerprint that identifies the scene of saved bytes: a hash of its model, its constants at creation, its counts,
/// and the largest number of pressure iterations. The grid is left out, because it does not change a bit of the result.
/// With the half stencil the number of cells is included, since the order of its sums depends on it.
#[must_use]
pub(crate) fn fingerprint(
    plan: &Plan,
    parameters: &Parameters,
    materials: &Materials,
    requirements: &Requirements,
) -> u64 {
    let Counts { particles, spring_ends, spares, emitter_points, field_nodes, .. } = requirements.counts;
    let counts = [particles, spring_ends, spares, emitter_points, field_nodes, plan.iterations() as usize];
    let cells = if plan.model.is_half_stencil == 1 { parameters.cells } else { [0; 4] };
    let (model, parameters) = (Model { cell_places: 0, ..plan.model }, Parameters { cells, ..*parameters });
    let structs = [bytemuck::bytes_of(&model), bytemuck::bytes_of(&parameters), bytemuck::bytes_of(materials)];
    let words = structs.into_iter().flat_map(|bytes| bytemuck::cast_slice::<u8, u32>(bytes).iter().copied());
    words.chain(counts.into_iter().map(|count| count as u32)).fold(Fnv::default(), Fnv::word).0
}
