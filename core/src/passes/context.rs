//! What every pass is given, and what it finds.
use super::columns::Columns;
use crate::arithmetic::level::Simd;
use crate::layout::{Materials, Model, Parameters, Status, StepUniform, Tables, f32x4};
use crate::memory::{Given, Scratch, State};
use crate::plan::schedule::Command;

/// The arrays of a step that sort its particles: a macro, since a function would borrow all of the memory that a step works in.
macro_rules! sorting {
    ($step:ident) => {
        $crate::memory::Sorting::of(&mut *$step.scratch.neighbours, $step.old.id.len())
    };
}
pub(crate) use sorting;

/// The constants of a step.
#[derive(Clone, Copy)]
pub(crate) struct Setup<'a> {
    pub model: &'a Model,
    pub parameters: &'a Parameters,
    pub materials: &'a Materials,
    /// The same, of those that the scene has, column by column.
    pub columns: &'a Columns,
    pub uniform: &'a StepUniform,
    pub tables: &'a Tables,
    pub field: &'a [f32x4],
    pub simd: Simd,
}

/// A step that is being made: `new` from `old`, which stays as it is.
pub(crate) struct Step<'s, 'm, E> {
    pub setup: Setup<'s>,
    pub executor: &'s E,
    pub old: &'s State<'m>,
    pub new: &'s mut State<'m>,
    pub scratch: &'s mut Scratch<'m>,
    pub given: &'s Given<'m>,
    /// Words of the neighbour lists that may be used.
    pub list_words: usize,
    pub found: Found,
    /// The command that is being carried out.
    pub command: Command,
}

/// What the passes of a step have found so far.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Found {
    /// What is wrong, if anything.
    pub status: Status,
    /// Iterations of pressure.
    pub iterations: u32,
    /// Largest density miss of the last one, over the rest density.
    pub residual: f32,
    /// Was that good enough?
    pub converged: bool,
    /// Air that was wanted and for which no particle was left.
    pub refused: u32,
    pub maxima: Maxima,
}

/// The largest of what limits the next time step; all 0 where nothing follows from them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Maxima {
    /// Squared speed, (m/s)^2.
    pub speed2: f32,
    /// Squared acceleration, (m/s2)^2.
    pub acceleration2: f32,
    /// Speed of sound, m/s.
    pub sound: f32,
}

impl Found {
    /// Nothing yet, after `steps` steps.
    pub(crate) fn nothing(steps: u32) -> Found {
        let status = Status::fine(steps);
        Found { status, iterations: 0, residual: 0.0, converged: false, refused: 0, maxima: Maxima::default() }
    }
}

impl Maxima {
    pub(crate) fn and(self, other: Maxima) -> Maxima {
        // none of them is NaN where it counts: a step with one fails
        Maxima {
            speed2: self.speed2.max(other.speed2),
            acceleration2: self.acceleration2.max(other.acceleration2),
            sound: self.sound.max(other.sound),
        }
    }
}
