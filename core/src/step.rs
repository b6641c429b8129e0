//! One step: carries out the commands of a schedule, one after the other.
use crate::error::StepError;
use crate::passes::g_finish::commit::verdict;
use crate::passes::{self, context::Step};
use crate::plan::passes::Pass;
use crate::plan::schedule::{Command, interpret};

/// Makes the new state, or returns the error because of which it cannot be made. The old state stays as it was.
/// `begins` is called with each pass before it runs.
pub(crate) fn run(
    step: &mut Step<'_, '_>,
    commands: &[Command],
    begins: &mut (dyn FnMut(Pass) + Send),
) -> Result<(), StepError> {
    let mut run = |command: Command| {
        if let Some(pass) = command.pass() {
            begins(pass);
            step.command = command;
            passes::run(pass, step);
            // these passes find the errors after which the following ones cannot run; the last pass ends the step
            if matches!(pass, Pass::Count | Pass::CellLists | Pass::Commit) {
                verdict(&step.found.status, step.setup.model.cell_places)?;
            }
        }
        Ok(step.found.converged)
    };
    interpret(commands, &mut run).map(|_| ())
}
