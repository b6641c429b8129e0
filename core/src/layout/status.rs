//! What a step on a device has to say for itself.
use super::shared;

/// No particle, no cell: the largest index, so that an atomic minimum finds the smallest offender.
pub const NONE: u32 = u32::MAX;

/// Attempts at one step, each shorter than the one before, after which it is refused.
pub const MOST_ATTEMPTS: u32 = 64;

/// Arrays of a state that a status word can tell apart: it holds this many times a particle's id, and the number of the array.
pub const QUANTITIES_OF_ID: u32 = 16;

shared! {
    /// Head of the status buffer. The three offenders are minima over a pass, so no order of threads changes them; the
    /// last pass of a step looks at them once, and a step that finds one sets `failed`, after which no step does anything.
    pub struct Status {
        /// 0; 1 for good; 2 for an attempt that sits out, since the one before is to be made again and its states are the
        /// other way round.
        pub failed: u32,
        /// Steps that count.
        pub steps: u32,
        /// Smallest `4 id + axis` of a particle beyond the grid's range.
        pub out_of_range: u32,
        /// Smallest cell with more particles than places.
        pub cell_full: u32,
        /// Particles in that cell.
        pub cell_count: u32,
        /// Smallest `16 id + array` of a particle that is not finite any more.
        pub not_finite: u32,
        /// Iterations of pressure: 0 while there is something to mend, 1 when the last pressure is still to act, 2 when
        /// all is done.
        pub pressure_converged: u32,
        /// Largest density miss of the last iteration, as the bits of a number that is not negative.
        pub residual: u32,
        /// Iterations of this step.
        pub iterations: u32,
        /// Iterations of the last step that counts.
        pub last_iterations: u32,
        /// Density miss at its end.
        pub last_residual: u32,
        /// Iterations of all steps that count.
        pub total_iterations: u32,
        /// Births of air in this step for which no particle was left.
        pub refused: u32,
        /// Of all steps that count.
        pub air_refused: u32,
        /// Particles of the coat of air that are there after this step.
        pub alive: u32,
        /// After the last step that counts.
        pub air_alive: u32,
        /// Largest squared speed of this step, as the bits of a number that is not negative, (m/s)^2. These three only where
        /// the time step follows from them.
        pub max_speed_squared: u32,
        /// Largest squared acceleration, likewise, (m/s2)^2.
        pub max_acceleration_squared: u32,
        /// Largest speed of sound, likewise, m/s.
        pub max_sound_speed: u32,
        /// Density miss of the last iteration of this step.
        pub left: u32,
        /// Times that this step was undone.
        pub undone: u32,
        /// Steps that were made again, shorter.
        pub rejected_steps: u32,
        /// Steps that were not made as short as they should have been, the shortest being longer.
        pub held: u32,
        /// The next step, s. This and the next two go into the step's uniform before it.
        pub time_step: f32,
        /// Half of it, s.
        pub half_time_step: f32,
        /// One over it, 1/s.
        pub inverse_time_step: f32,
        /// What the next step was to be after the last one that counts, s.
        pub first_time_step: f32,
        /// The last step that counts, s.
        pub last_time_step: f32,
        /// What it should have been at most, s.
        pub last_wanted: f32,
        /// Simulated time, s.
        pub clock: f32,
        /// And what that sum lost, s.
        pub clock_lost: f32,
    }
}

impl Status {
    /// Nothing has gone wrong after `steps` steps.
    #[must_use]
    pub fn fine(steps: u32) -> Status {
        Status { steps, out_of_range: NONE, cell_full: NONE, not_finite: NONE, ..bytemuck::Zeroable::zeroed() }
    }
}
