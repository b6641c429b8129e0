//! Moves the solids to where they are at the end of the step. Runs only with solids.
use crate::passes::context::Step;

/// Does nothing on the CPU, where the poses are computed before the step, because all passes read them.
pub(crate) fn run(_: &mut Step<'_, '_>) {}
