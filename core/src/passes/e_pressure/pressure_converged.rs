//! Is the pressure good enough? Only where it is corrected.
use crate::passes::context::Step;

/// Counts the iteration, and ends them where the largest miss is within the tolerance. One that is not finite never is.
pub(crate) fn run<E>(step: &mut Step<'_, '_, E>) {
    step.found.iterations += 1;
    step.found.converged = step.found.residual <= step.setup.parameters.tolerance;
}
