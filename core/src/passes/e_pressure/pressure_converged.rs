//! Checks whether the pressure iteration has converged. Runs only with pressure correction.
use crate::passes::context::Step;

/// Counts the iteration. The pressure has converged if the largest density error is within the tolerance. A residual
/// that is not finite never converges.
pub(crate) fn run(step: &mut Step<'_, '_>) {
    step.found.iterations += 1;
    step.found.converged = step.found.residual <= step.setup.parameters.tolerance;
}
