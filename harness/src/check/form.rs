//! What a run of a study is made with: walls and formulas.
use super::enclosure::Enclosure;
use millpond_core::scene::{DensityDiffusion, DensityForm, Formulation, Shifting};

/// Walls, density and diffusion of density: what most studies compare.
pub(super) type Rules = (Enclosure, DensityForm, DensityDiffusion);

/// Walls and formulas.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Form {
    pub(super) walls: Enclosure,
    pub(super) model: Formulation,
}

impl Form {
    /// Returns these rules, with other formulas from `model`.
    pub(super) fn of(model: Formulation, (walls, density, density_diffusion): Rules) -> Form {
        Form { walls, model: Formulation { density, density_diffusion, ..model } }
    }

    /// Returns the names of walls, density and diffusion, and of the shifting if there is one.
    pub(super) fn name(&self) -> String {
        let Formulation { density, density_diffusion, shifting, .. } = self.model;
        let name = format!("{}, {}, {}", self.walls.name(), density.name(), density_diffusion.name());
        if shifting == Shifting::Off { name } else { format!("{name}, {}", shifting.name()) }
    }
}
