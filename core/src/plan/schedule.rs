//! The step as data: a list of commands that the CPU interprets, the GPU backend records, and reports print.
use super::arrays::{Array, Side, Unit};
use super::passes::Pass;
use crate::layout::Model;
use heapless::Vec;

/// Largest number of commands in a step.
pub const MOST_COMMANDS: usize = 64;

/// One command of a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Command {
    /// Runs a pass.
    Run(Pass),
    /// Runs a pass once more, with the predicted velocities at the end of the step instead of those of the first
    /// evaluation.
    RunAgain(Pass),
    /// Copies the entries of an array from the slots before the step to those after it.
    Gather {
        /// The array to copy from.
        from: (Array, Side),
        /// The array to copy to.
        to: Array,
    },
    /// Checks that an array of the new state is finite.
    Validate(Array),
    /// Repeats the commands that follow until the last of them reports that the iteration has converged.
    Repeat {
        /// How many of the commands that follow are repeated. Among them there may be another `Repeat` with its own
        /// commands.
        commands: u8,
        /// Largest number of repetitions.
        most: u32,
    },
}

/// The commands of a step.
pub type Schedule = Vec<Command, MOST_COMMANDS>;

impl Command {
    /// The pass that the command runs; `None` for a repetition.
    #[must_use]
    pub fn pass(self) -> Option<Pass> {
        match self {
            Command::Run(pass) | Command::RunAgain(pass) => Some(pass),
            Command::Gather { .. } => Some(Pass::Gather),
            Command::Validate(_) => Some(Pass::Validate),
            Command::Repeat { .. } => None,
        }
    }
}

/// The commands of a step with this model and at most `iterations` pressure iterations.
#[must_use]
pub fn schedule(m: &Model, iterations: u32) -> Schedule {
    let mut commands = Schedule::new();
    // forces are evaluated again after all passes that need the first evaluation
    let (before, after) = Pass::ALL.split_at(Pass::SpawnRequests as usize);
    add(&mut commands, m, before, iterations);
    if m.is_reevaluated == 1 {
        let forces = [Pass::WallSums, Pass::WallStates, Pass::Force, Pass::Tension, Pass::Springs]
            .into_iter()
            .filter(|pass| pass.runs(m));
        forces.for_each(|pass| push(&mut commands, Command::RunAgain(pass)));
    }
    add(&mut commands, m, after, iterations);
    commands
}

/// The commands that only evaluate forces, with time at rest or running backwards. No particles come or go in them, none
/// is put back to the surface of a solid, and they iterate no pressure, since there is no next density to correct.
#[must_use]
pub fn evaluation(m: &Model) -> Schedule {
    let makes = |command: &Command| {
        matches!(command.pass(), Some(Pass::SpawnRequests | Pass::Leave | Pass::Spawn | Pass::Renew | Pass::Contact))
    };
    schedule(m, 0).into_iter().filter(|command| !makes(command)).collect()
}

/// Adds the commands of these passes to the schedule.
fn add(commands: &mut Schedule, m: &Model, passes: &[Pass], iterations: u32) {
    for pass in passes.iter().copied().filter(|pass| pass.runs(m)) {
        match pass {
            Pass::Gather => {
                let sorted = Array::ALL.iter().filter(|array| array.exists(m));
                let gathers = sorted.filter_map(|&to| Some(Command::Gather { from: to.source()?, to }));
                gathers.for_each(|command| push(commands, command));
            }
            Pass::Validate => {
                let of_particles = |array: &Array| array.is_vector() && array.unit() == Unit::Particle;
                let floats = Array::of_state(m).filter(of_particles);
                floats.for_each(|array| push(commands, Command::Validate(array)));
            }
            Pass::PressureForce => {
                // walls follow the pressure of the fluid in every iteration
                let force = || [Pass::WallSums, Pass::WallStates, pass].into_iter().filter(|pass| pass.runs(m));
                let body = || force().chain([Pass::PressureCorrect, Pass::PressureConverged]);
                push(commands, Command::Repeat { commands: body().count() as u8, most: iterations });
                body().chain(force()).for_each(|pass| push(commands, Command::Run(pass)));
            }
            // already added together with the pressure force
            Pass::PressureCorrect | Pass::PressureConverged => {}
            _ => push(commands, Command::Run(pass)),
        }
    }
}

fn push(commands: &mut Schedule, command: Command) {
    let pushed = commands.push(command);
    debug_assert!(pushed.is_ok(), "a step has fewer commands than a schedule has room for");
}

/// Calls `run` for each command, and repeatedly for the commands of a repetition. A repetition ends when `run` returns
/// true for its last command. Returns what `run` returned for the last command.
///
/// # Errors
/// The first error that `run` returns. No command runs after it.
pub fn interpret<E>(commands: &[Command], run: &mut dyn FnMut(Command) -> Result<bool, E>) -> Result<bool, E> {
    let mut converged = false;
    let mut rest = commands.iter();
    while let Some(command) = rest.next() {
        if let Command::Repeat { commands: count, most, .. } = command {
            let (body, after) = rest.as_slice().split_at((*count).into());
            for _ in 0..*most {
                if interpret(body, run)? {
                    break;
                }
            }
            rest = after.iter();
        } else {
            converged = run(*command)?;
        }
    }
    Ok(converged)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn repetitions_nest_and_end_each_by_its_own_convergence() {
        let [outer, inner] = [Pass::Density, Pass::PressureCorrect];
        let repeat = |commands, most| Command::Repeat { commands, most };
        let commands = [repeat(4, 3), repeat(1, 5), Command::Run(inner), Command::Run(outer), Command::Run(outer)];
        // the inner iteration converges after two rounds each time, the outer one never
        let mut rounds = 0;
        let mut order = std::vec::Vec::new();
        let ran: Result<bool, ()> = interpret(&commands, &mut |command| {
            order.push(command);
            rounds += u32::from(command == Command::Run(inner));
            Ok(command == Command::Run(inner) && rounds % 2 == 0)
        });
        assert_eq!(ran, Ok(false));
        let round = [inner, inner, outer, outer].map(Command::Run);
        assert_eq!(order, [round, round, round].concat());
    }
}
