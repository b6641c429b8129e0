//! What becomes of a step: it counts, or it failed and says why.
use crate::axis::Axis;
use crate::error::StepError;
use crate::layout::{MOST_ATTEMPTS, NONE, QUANTITIES_OF_ID, Status};
use crate::passes::context::Step;
use crate::plan::arrays::Quantity;

/// Nothing on the CPU: the interpreter looks at what was found.
pub(crate) fn run<E>(_: &mut Step<'_, '_, E>) {}

/// The error that a status tells of, of the pass that came first; `places` is a cell's.
///
/// # Errors
/// That one.
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
