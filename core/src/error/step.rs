//! Why a step could not be made.
use crate::axis::Axis;
use crate::plan::arrays::Quantity;
use core::fmt;

/// A step that could not be made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum StepError {
    /// A particle went beyond 2^22 cells from the origin, where `f32` no longer tells cells apart.
    OutOfRange {
        /// Its id.
        particle: u32,
        /// The axis.
        axis: Axis,
        /// The step that was tried, counted from 1.
        step: u64,
    },
    /// More particles came into a cell than it has places. Give `grid.structure` more places, or take shorter steps.
    CellFull {
        /// Index of the cell.
        cell: u32,
        /// Particles that wanted in.
        count: u32,
        /// Places it has.
        capacity: u32,
        /// The step that was tried, counted from 1.
        step: u64,
    },
    /// A step was undone and made again, shorter, so often that there seems to be no step that is short enough.
    NoTimeStep {
        /// How often.
        attempts: u32,
        /// The step that was tried, counted from 1.
        step: u64,
    },
    /// A quantity became NaN or infinite; most often the time step is too large.
    NotFinite {
        /// Its id.
        particle: u32,
        /// What is not finite.
        quantity: Quantity,
        /// The step that was tried, counted from 1.
        step: u64,
    },
}

impl StepError {
    /// The same error of step number `now`.
    #[must_use]
    pub fn at_step(mut self, now: u64) -> StepError {
        match &mut self {
            StepError::OutOfRange { step, .. }
            | StepError::CellFull { step, .. }
            | StepError::NoTimeStep { step, .. }
            | StepError::NotFinite { step, .. } => *step = now,
        }
        self
    }
}

impl fmt::Display for StepError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            StepError::OutOfRange { particle, axis, step } => {
                write!(f, "step {step}: particle {particle} went beyond the grid's range along {axis}")
            }
            StepError::CellFull { cell, count, capacity, step } => {
                write!(f, "step {step}: cell {cell} has {count} particles and {capacity} places")
            }
            StepError::NoTimeStep { attempts, step } => {
                write!(
                    f,
                    "step {step} was made {attempts} times, each shorter than the one before, and is still too long: "
                )?;
                write!(f, "increase adaptive.reject_ratio or adaptive.smallest")
            }
            StepError::NotFinite { particle, quantity, step } => {
                write!(f, "step {step}: {quantity:?} of particle {particle} is not finite any more")
            }
        }
    }
}

impl core::error::Error for StepError {}
