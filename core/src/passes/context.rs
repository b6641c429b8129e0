//! The input that every pass gets, and the results that passes record about a step as a whole.
use super::columns::Columns;
use crate::arithmetic::level::Simd;
use crate::executor::AnyExecutor;
use crate::flux::Flux;
use crate::layout::{Materials, Model, Parameters, Status, StepUniform, Tables, f32x4};
use crate::memory::{Given, Scratch, State};
use crate::plan::schedule::Command;

/// Returns the arrays that a step uses to sort its particles. This is a macro because a function would borrow all
/// scratch memory of the step.
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
    /// Constants of the materials that the scene uses, column by column, for lookup in lanes.
    pub columns: &'a Columns,
    pub uniform: &'a StepUniform,
    pub tables: &'a Tables,
    pub field: &'a [f32x4],
    /// Poses of the solids at the end of the step, and the sides of polygons.
    pub poses: &'a [f32x4],
    pub simd: Simd,
}

/// A step in progress. It writes the state `new`, and reads the state `old`, which stays unchanged.
pub(crate) struct Step<'s, 'm> {
    pub setup: Setup<'s>,
    pub executor: &'s dyn AnyExecutor,
    pub old: &'s State<'m>,
    pub new: &'s mut State<'m>,
    pub scratch: &'s mut Scratch<'m>,
    pub given: &'s Given<'m>,
    /// Number of words of the neighbour lists that may be used.
    pub list_words: usize,
    pub found: Found,
    /// The command that is being carried out.
    pub command: Command,
}

/// Results that the passes of a step have recorded so far.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Found {
    /// The errors found, if any.
    pub status: Status,
    /// Number of iterations of the pressure solver.
    pub iterations: u32,
    /// Largest density error of the last iteration, over the rest density.
    pub residual: f32,
    /// Whether the pressure iteration has converged.
    pub converged: bool,
    /// The particles that come and go in the step.
    pub flux: Flux,
    pub maxima: Maxima,
}

/// The maxima that limit the next time step. All are 0 if the time step is fixed.
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
    /// Returns the empty result of a step that follows `steps` earlier steps.
    pub(crate) fn nothing(steps: u32) -> Found {
        let status = Status::fine(steps);
        Found {
            status,
            iterations: 0,
            residual: 0.0,
            converged: false,
            flux: Flux::default(),
            maxima: Maxima::default(),
        }
    }
}

impl Maxima {
    pub(crate) fn and(self, other: Maxima) -> Maxima {
        // `max` drops NaN, which does no harm: a step that computes NaN fails
        Maxima {
            speed2: self.speed2.max(other.speed2),
            acceleration2: self.acceleration2.max(other.acceleration2),
            sound: self.sound.max(other.sound),
        }
    }
}
