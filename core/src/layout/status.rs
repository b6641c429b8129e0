//! Status written by the GPU step and read by the host program.
use super::shared;

/// No particle or no cell. It is the largest index, so that an atomic minimum finds the smallest index with an error.
pub const NONE: u32 = u32::MAX;

/// Largest number of attempts at one step, each with a shorter time step than the one before. After these the step
/// fails.
pub const MOST_ATTEMPTS: u32 = 64;

/// Number of state arrays that a status word can distinguish: the word is the particle's id times this number, plus the
/// number of the array.
pub const QUANTITIES_OF_ID: u32 = 16;

shared! {
    /// Head of the status buffer. `out_of_range`, `cell_full` and `not_finite` are minima over a pass, so the order of
    /// threads does not change them. The last pass of a step checks them, and a step with an error sets `failed`, after
    /// which all further steps do nothing.
    pub struct Status {
        /// 0: no failure. 1: a step failed, and all further steps do nothing. 2: a step was rejected and is to be
        /// repeated, and the next attempt is skipped, because it was recorded with the two states exchanged.
        pub failed: u32,
        /// Accepted steps.
        pub steps: u32,
        /// Smallest `4 id + axis` of a particle beyond the range of the grid.
        pub out_of_range: u32,
        /// Smallest index of a cell with more particles than places.
        pub cell_full: u32,
        /// Number of particles in that cell.
        pub cell_count: u32,
        /// Smallest `16 id + array` of a particle with a value that is not finite.
        pub not_finite: u32,
        /// State of the pressure iteration: 0 while it has not converged, 1 once it has converged and the last pressure
        /// is still to be applied, 2 when that is done.
        pub pressure_converged: u32,
        /// Largest density error of the current iteration, as the bits of a non-negative f32.
        pub residual: u32,
        /// Pressure iterations of the current step.
        pub iterations: u32,
        /// Pressure iterations of the last accepted step.
        pub last_iterations: u32,
        /// Density error at the end of the last accepted step, as the bits of an f32.
        pub last_residual: u32,
        /// Pressure iterations of all accepted steps.
        pub total_iterations: u32,
        /// Spawn requests of the current step for which no inactive particle was left.
        pub refused: u32,
        /// Spawn requests of all accepted steps for which no inactive particle was left.
        pub air_refused: u32,
        /// Requests of the current step whose place was taken.
        pub blocked: u32,
        /// Particles that became active in the current step.
        pub born: u32,
        /// Particles that became inactive in the current step.
        pub removed: u32,
        /// Requests of all accepted steps whose place was taken.
        pub total_blocked: u32,
        /// Particles that became active in all accepted steps.
        pub total_born: u32,
        /// Particles that became inactive in all accepted steps.
        pub total_removed: u32,
        /// Particles of the current step that were found in a solid.
        pub hits: u32,
        /// Particles that were found in a solid, in all accepted steps.
        pub total_hits: u32,
        /// Active particles of the air layer after the current step.
        pub alive: u32,
        /// Active particles of the air layer after the last accepted step.
        pub air_alive: u32,
        /// Largest squared speed of the current step, as the bits of a non-negative f32, (m/s)^2. This and the next two
        /// fields are only used with adaptive time steps.
        pub max_speed_squared: u32,
        /// Largest squared acceleration, as the bits of a non-negative f32, (m/s2)^2.
        pub max_acceleration_squared: u32,
        /// Largest speed of sound, as the bits of a non-negative f32, m/s.
        pub max_sound_speed: u32,
        /// Density error of the last iteration of the current step, as the bits of an f32.
        pub left: u32,
        /// Attempts at the current step that were rejected.
        pub undone: u32,
        /// Rejected attempts in all accepted steps. Each was repeated with a shorter time step.
        pub rejected_steps: u32,
        /// Accepted steps that should have been shorter than the shortest time step allowed.
        pub clamped_steps: u32,
        /// Number of times that the current step was halved because it could not be made.
        pub halvings_of_step: u32,
        /// Number of halvings of all accepted steps.
        pub halvings: u32,
        /// The next time step, s. This field and the next two are copied into the step's uniform before the step.
        pub time_step: f32,
        /// Half of the next time step, s.
        pub half_time_step: f32,
        /// Inverse of the next time step, 1/s.
        pub inverse_time_step: f32,
        /// Time step of the first attempt at the next step, s. It is restored if the step fails.
        pub first_time_step: f32,
        /// Time step of the last accepted step, s.
        pub last_time_step: f32,
        /// Largest time step that the criteria allowed at the end of the last accepted step, s.
        pub last_wanted: f32,
        /// Simulated time, s.
        pub clock: f32,
        /// Rounding error of the sum in `clock`, s.
        pub clock_lost: f32,
    }
}

impl Status {
    /// The status after `steps` steps without an error.
    #[must_use]
    pub fn fine(steps: u32) -> Status {
        Status { steps, out_of_range: NONE, cell_full: NONE, not_finite: NONE, ..bytemuck::Zeroable::zeroed() }
    }
}
