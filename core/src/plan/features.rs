//! What follows from the choices of a scene: predicates that arrays, passes and the step's order ask.
use crate::layout::Model;
use crate::terms::correction::PRESSURE_CORRECTION;
use crate::terms::density::{counts_masses, is_stepped};
use crate::terms::integrate::{SEMI_IMPLICIT_EULER, knows_velocity};
use crate::terms::table::DIRECT;
use crate::terms::tension::{CURVATURE, NORMAL_CURVATURE};

impl Model {
    /// Does a step need the density and pressure of the particles before it?
    #[must_use]
    pub fn needs_previous(&self) -> bool {
        is_stepped(self) || self.corrects_pressure() || self.has_variable_support == 1
    }

    /// Is pressure iterated?
    #[must_use]
    pub fn corrects_pressure(&self) -> bool {
        self.pressure_solver == PRESSURE_CORRECTION
    }

    /// Does a surface pull by its curvature?
    #[must_use]
    pub fn has_curvature(&self) -> bool {
        self.tension == CURVATURE || self.tension == NORMAL_CURVATURE
    }

    /// Is there anything left to do after the forces?
    #[must_use]
    pub fn integrates_after(&self) -> bool {
        self.has_container == 1 || !knows_velocity(self)
    }

    /// Does density follow from the distances of neighbours alone, whoever they are?
    #[must_use]
    pub fn sums_distances(&self) -> bool {
        !is_stepped(self) && !counts_masses(self) && self.has_variable_support == 0
    }

    /// Does a step list neighbours? The half stencil finds them anew.
    #[must_use]
    pub fn makes_lists(&self) -> bool {
        self.is_half_stencil == 0
    }

    /// Are kernels read from tables?
    #[must_use]
    pub fn reads_tables(&self) -> bool {
        self.evaluation != DIRECT
    }

    /// The same model with the plainest integrator: for a step that only evaluates the forces.
    #[must_use]
    pub(crate) fn at_rest(mut self) -> Model {
        self.integrator = SEMI_IMPLICIT_EULER;
        self.is_reevaluated = 0;
        self
    }
}
