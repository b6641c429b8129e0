//! What loops over pairs are compiled for.
use crate::layout::Model;
use crate::terms::table::DIRECT;

/// How much the compiler may take for granted of a model. Loops over pairs are compiled once for each of these, without the code that
/// only other scenes need: that code would take registers and stack even where it never runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Known {
    /// One material, no walls of particles and no periodic axis; kernels by their formulas, one support for all, no air.
    OneMaterial,
    /// Any materials, masses and walls of particles; no periodic axis; kernels, supports and air as above.
    NoPeriods,
    /// Some axis is periodic; else as with no periods.
    Periods,
    /// Anything.
    Nothing,
}

// loops name one by its place in the list
const _: () = {
    let mut i = 0;
    while i < Known::ALL.len() {
        assert!(Known::ALL[i] as usize == i);
        i += 1;
    }
};

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
        let usual = Model { evaluation: DIRECT, has_variable_support: 0, has_air: 0, ..*model };
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
