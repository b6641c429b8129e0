//! What a solver goes on from beside its arrays, and what tells one scene's bytes from another's.
use crate::clock::SteadyTime;
use crate::hash::Fnv;
use crate::layout::{Materials, Model, Parameters, Status};
use crate::live::{LiveScene, LiveValues};
use crate::memory::{Counts, Requirements};
use crate::plan::Plan;

/// What the pressure correction came to.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CorrectionReport {
    /// Iterations of the last step.
    pub iterations: u32,
    /// Iterations of all steps.
    pub total_iterations: u64,
    /// Largest density miss that the last step was left with, over the rest density.
    pub residual: f32,
}

/// What a solver goes on from beside its arrays.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Record {
    /// Steps that were made.
    pub steps: u64,
    /// How simulated time follows from them, where they are all alike.
    pub steady: SteadyTime,
    /// The clock: its two numbers, the last step and what it should have been, s.
    pub clock: [f32; 4],
    /// The next step, s.
    pub time_step: f32,
    /// Steps made again, and steps that should have been shorter than the shortest.
    pub counts: [u32; 2],
    /// What the pressure correction came to.
    pub correction: CorrectionReport,
    /// Requests for air that found no particle.
    pub air_refused: u64,
    /// What may have been changed between steps.
    pub live: LiveValues,
}

impl Record {
    /// Words of a record.
    pub const WORDS: usize = 19 + LiveValues::WORDS;

    /// Of what a device's status says, with what its host knows.
    #[must_use]
    pub fn of_status(status: &Status, steady: SteadyTime, time_step: f32, live: &LiveScene) -> Record {
        Record {
            steps: u64::from(status.steps),
            steady,
            clock: [status.clock, status.clock_lost, status.last_time_step, status.last_wanted],
            time_step,
            counts: [status.rejected_steps, status.held],
            correction: CorrectionReport {
                iterations: status.last_iterations,
                total_iterations: u64::from(status.total_iterations),
                residual: f32::from_bits(status.last_residual),
            },
            air_refused: u64::from(status.air_refused),
            live: live.values(),
        }
    }

    pub(crate) fn each_word(&self, mut word: impl FnMut(u32)) {
        let mut wide = |x: u64| [x as u32, (x >> 32) as u32].into_iter().for_each(&mut word);
        wide(self.steps);
        wide(self.steady.since);
        wide(self.steady.at.to_bits());
        wide(self.correction.total_iterations);
        wide(self.air_refused);
        self.clock.iter().for_each(|x| word(x.to_bits()));
        word(self.time_step.to_bits());
        self.counts.into_iter().for_each(&mut word);
        word(self.correction.iterations);
        word(self.correction.residual.to_bits());
        self.live.to_words().into_iter().for_each(&mut word);
    }

    pub(crate) fn of_words(words: &[u32]) -> Record {
        let at = |i: usize| words.get(i).copied().unwrap_or(0);
        let wide = |i: usize| u64::from(at(i)) | u64::from(at(i + 1)) << 32;
        let float = |i: usize| f32::from_bits(at(i));
        Record {
            steps: wide(0),
            steady: SteadyTime { since: wide(2), at: f64::from_bits(wide(4)) },
            clock: [float(10), float(11), float(12), float(13)],
            time_step: float(14),
            counts: [at(15), at(16)],
            correction: CorrectionReport { iterations: at(17), total_iterations: wide(6), residual: float(18) },
            air_refused: wide(8),
            live: LiveValues::of_words(words.get(19..).unwrap_or_default()),
        }
    }
}

/// What tells one scene's bytes from another's: its model, its constants at creation, how many there are of everything, and how often
/// pressure is iterated. Where particles are looked up is left out: it changes no bit, but with the half stencil, whose order
/// follows from the number of cells.
#[must_use]
pub(crate) fn fingerprint(
    plan: &Plan,
    parameters: &Parameters,
    materials: &Materials,
    requirements: &Requirements,
) -> u64 {
    let Counts { particles, spring_ends, air, field_nodes, cells: _ } = requirements.counts;
    let counts = [particles, spring_ends, air, field_nodes, plan.iterations() as usize];
    let cells = if plan.model.is_half_stencil == 1 { parameters.cells } else { [0; 4] };
    let (model, parameters) = (Model { cell_places: 0, ..plan.model }, Parameters { cells, ..*parameters });
    let structs = [bytemuck::bytes_of(&model), bytemuck::bytes_of(&parameters), bytemuck::bytes_of(materials)];
    let words = structs.into_iter().flat_map(|bytes| bytemuck::cast_slice::<u8, u32>(bytes).iter().copied());
    words.chain(counts.into_iter().map(|count| count as u32)).fold(Fnv::default(), Fnv::word).0
}
