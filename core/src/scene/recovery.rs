//! What happens when a time step cannot be made.

/// What happens when a time step cannot be made, because a particle would leave the range of the grid, a quantity would
/// no longer be finite, or a cell would hold more particles than it has places.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub enum Recovery {
    /// The step is refused with an error that says why, and the fluid is as it was before. Since steps are
    /// deterministic, the same step is refused again until something is changed.
    #[default]
    Refuse,
    /// The step is tried again with half of its time step, and refused only when it fails at the shortest one.
    /// [`TimeReport::halvings`](crate::TimeReport::halvings) counts the halvings. With a fixed time step the next step
    /// has its full length again; an adaptive one grows from the short one. It cannot be combined with integrators that
    /// need steps of equal length (Verlet and those of Beeman), nor with exchanges of velocity, whose shares are those
    /// of a step; and with a fixed time step, [`Solver::set_time_step`](crate::Solver::set_time_step) is refused.
    ShortenStep {
        /// How many times a step is halved, 1 to [`Recovery::MOST_TIMES`].
        times: u32,
    },
}

impl Recovery {
    /// Largest number of times that a step can be halved.
    pub const MOST_TIMES: u32 = 20;

    /// How many times a step is halved before it is refused.
    #[must_use]
    pub fn times(self) -> u32 {
        match self {
            Recovery::Refuse => 0,
            Recovery::ShortenStep { times } => times,
        }
    }
}
