//! Why a time step cannot be made.
use crate::axis::Axis;
use crate::plan::arrays::Quantity;
use core::fmt;

/// A time step that cannot be made. The fluid is as it was before the step.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum StepError {
    /// A particle is more than 2^22 cells away from the origin, where an `f32` can no longer tell cells apart.
    OutOfRange {
        /// Id of the particle.
        particle: u32,
        /// The axis.
        axis: Axis,
        /// Number of the step, counted from 1.
        step: u64,
    },
    /// A cell holds more particles than it has places, with
    /// [`GridStructure::CellLists`](crate::scene::GridStructure::CellLists).
    CellFull {
        /// Index of the cell.
        cell: u32,
        /// Particles in that cell.
        count: u32,
        /// Places of a cell.
        capacity: u32,
        /// Number of the step, counted from 1.
        step: u64,
    },
    /// A step was rejected and made again with a shorter time step as often as that is allowed, and was always too
    /// long.
    NoTimeStep {
        /// Number of attempts.
        attempts: u32,
        /// Number of the step, counted from 1.
        step: u64,
    },
    /// [`Solver::advance`](crate::Solver::advance) or [`Solver::step_until`](crate::Solver::step_until) was given a
    /// time that is negative, has passed already, or is not finite.
    InvalidTime {
        /// The time that was given, s.
        seconds: f64,
    },
    /// A quantity became NaN or infinite. Most often the time step is too large.
    NotFinite {
        /// Id of the particle.
        particle: u32,
        /// The quantity that is not finite.
        quantity: Quantity,
        /// Number of the step, counted from 1.
        step: u64,
    },
}

impl StepError {
    /// Returns the same error with `now` as the number of its step.
    #[must_use]
    pub fn at_step(mut self, now: u64) -> StepError {
        match &mut self {
            StepError::OutOfRange { step, .. }
            | StepError::CellFull { step, .. }
            | StepError::NoTimeStep { step, .. }
            | StepError::NotFinite { step, .. } => *step = now,
            StepError::InvalidTime { .. } => {}
        }
        self
    }
}

impl fmt::Display for StepError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            StepError::OutOfRange { particle, axis, step } => {
                write!(
                    f,
                    "step {step}: particle {particle} is more than 2^22 cells away from the origin along {axis}; "
                )?;
                write!(f, "the fluid may have become unstable (use a smaller time_step) or fallen out of the scene")
            }
            StepError::CellFull { cell, count, capacity, step } => {
                write!(f, "step {step}: cell {cell} holds {count} particles and has {capacity} places; ")?;
                write!(f, "increase places in grid.structure, or use a smaller time_step")
            }
            StepError::NoTimeStep { attempts, step } => {
                write!(f, "step {step} was tried {attempts} times, each time shorter, and was always too long; ")?;
                write!(f, "increase adaptive.reject_ratio or adaptive.smallest")
            }
            StepError::InvalidTime { seconds } => {
                write!(f, "the time to advance to is {seconds} s; it must be finite, and must not lie in the past")
            }
            StepError::NotFinite { particle, quantity, step } => {
                write!(
                    f,
                    "step {step}: {quantity:?} of particle {particle} is no longer finite; use a smaller time_step"
                )
            }
        }
    }
}

impl core::error::Error for StepError {}
