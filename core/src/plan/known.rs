//! What loops over pairs are compiled for.
use crate::layout::Model;
use crate::terms::table::DIRECT;

/// What the compiler may take for granted of a model. Loops over pairs are compiled for each of these, without what only
/// the others need: the numbers of particles that such a thing takes would be in their way, in registers and on the stack.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Known {
    /// One material, between planes; kernels by their formulas, and one support for all.
    OneMaterial,
    /// Any materials, else the same.
    NoPeriods,
    /// Some axis is periodic, else the same.
    Periods,
    /// Nothing is known.
    Nothing,
}

impl Known {
    /// From the most that is known to the least.
    pub(crate) const ALL: [Known; 4] = [Known::OneMaterial, Known::NoPeriods, Known::Periods, Known::Nothing];

    /// As much as is known of this model.
    pub(crate) fn of(model: &Model) -> Known {
        *Known::ALL.iter().find(|known| *model == known.in_model(model)).unwrap_or(&Known::Nothing)
    }

    /// The model of which this much is known: the same one, where it is true of it.
    #[inline(always)]
    pub(crate) const fn in_model(self, model: &Model) -> Model {
        let usual = Model { evaluation: DIRECT, variable_support: 0, air: 0, ..*model };
        match self {
            Known::OneMaterial => Model {
                periodic: 0,
                wall_particles: 0,
                masses: 0,
                species: 0,
                fluids: 0,
                states: 0,
                numbers: 0,
                ..usual
            },
            Known::NoPeriods => Model { periodic: 0, ..usual },
            Known::Periods => Model { periodic: 1, ..usual },
            Known::Nothing => *model,
        }
    }
}
