//! The cases for which loops over pairs are compiled.
use crate::layout::Model;
use crate::terms::table::DIRECT;

/// What the compiler may assume about a model. Loops over pairs are compiled once for each of these cases, without the
/// code that only other scenes need. Such code would take registers and stack even if it never ran.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Known {
    /// One material, no wall particles and no periodic axis; kernels evaluated by formula, a constant support, no
    /// particles that can be inactive, and no walls that repel.
    OneMaterial,
    /// Any materials, masses and wall particles; no periodic axis; kernels, support and activity as for `OneMaterial`.
    NoPeriods,
    /// At least one periodic axis; otherwise as for `NoPeriods`.
    Periods,
    /// Any model.
    Nothing,
}

// loops refer to a case by its index in the list
const _: () = {
    let mut i = 0;
    while i < Known::ALL.len() {
        assert!(Known::ALL[i] as usize == i);
        i += 1;
    }
};

impl Known {
    /// All cases, from the most specific to the most general.
    pub(crate) const ALL: [Known; 4] = [Known::OneMaterial, Known::NoPeriods, Known::Periods, Known::Nothing];

    /// The most specific case that applies to this model.
    pub(crate) fn of(model: &Model) -> Known {
        *Known::ALL.iter().find(|known| *model == known.in_model(model)).unwrap_or(&Known::Nothing)
    }

    /// The model with the assumed values as constants. It equals `model` if the case applies.
    #[inline(always)]
    pub(crate) const fn in_model(self, model: &Model) -> Model {
        let usual = Model {
            evaluation: DIRECT,
            has_variable_support: 0,
            has_inactive: 0,
            tait_exponent: 7,
            has_repelling_walls: 0,
            ..*model
        };
        match self {
            Known::OneMaterial => Model {
                is_periodic: 0,
                wall_particles: 0,
                has_variable_mass: 0,
                has_materials: 0,
                is_multi_fluid: 0,
                has_mixed_state_equations: 0,
                has_number_density_volume: 0,
                ..usual
            },
            Known::NoPeriods => Model { is_periodic: 0, ..usual },
            Known::Periods => Model { is_periodic: 1, ..usual },
            Known::Nothing => *model,
        }
    }
}
