//! Ends a step: the step is accepted, or it fails with an error.
use crate::axis::Axis;
use crate::error::StepError;
use crate::layout::{MOST_ATTEMPTS, NONE, QUANTITIES_OF_ID, Status};
use crate::passes::context::Step;
use crate::plan::arrays::Quantity;

/// Does nothing on the CPU, where the interpreter of the schedule checks the results itself.
pub(crate) fn run(_: &mut Step<'_, '_>) {}

/// Returns the error that a status records. If it records several, the error of the earliest pass is returned. `places`
/// is the number of places of a cell, with cell lists.
///
/// # Errors
/// [`StepError::OutOfRange`] if a particle left the range of the grid, [`StepError::CellFull`] if a cell held more
/// particles than places, [`StepError::NotFinite`] if a number of the new state is not finite, and
/// [`StepError::NoTimeStep`] if a step was still too long after [`MOST_ATTEMPTS`] attempts.
pub fn verdict(status: &Status, places: u32) -> Result<(), StepError> {
    let step = u64::from(status.steps) + 1;
    if status.out_of_range != NONE {
        let (particle, axis) = (status.out_of_range / 4, status.out_of_range % 4);
        return Err(StepError::OutOfRange { particle, axis: Axis::of(axis as usize), step });
    }
    if status.cell_full != NONE {
        let (cell, count) = (status.cell_full, status.cell_count);
        return Err(StepError::CellFull { cell, count, capacity: places, step });
    }
    if status.not_finite != NONE {
        let particle = status.not_finite / QUANTITIES_OF_ID;
        let quantity = Quantity::from_word(status.not_finite % QUANTITIES_OF_ID);
        return Err(StepError::NotFinite { particle, quantity, step });
    }
    if status.undone >= MOST_ATTEMPTS {
        return Err(StepError::NoTimeStep { attempts: status.undone, step });
    }
    Ok(())
}
