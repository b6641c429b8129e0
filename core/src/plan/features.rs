//! Properties derived from the choices of a scene. The tables of arrays and passes and the schedule of a step use them
//! as conditions.
use crate::layout::Model;
use crate::terms::correction::PRESSURE_CORRECTION;
use crate::terms::density::{counts_masses, is_stepped};
use crate::terms::diffusion::RENORMALISED;
use crate::terms::integrate::{SEMI_IMPLICIT_EULER, knows_velocity};
use crate::terms::shifting::FICKIAN;
use crate::terms::table::DIRECT;
use crate::terms::tension::{CURVATURE, NORMAL_CURVATURE};
use crate::terms::wall::repels_directly;

impl Model {
    /// Returns whether a step needs the density and pressure of the particles before the step.
    #[must_use]
    pub fn needs_previous(&self) -> bool {
        is_stepped(self) || self.corrects_pressure() || self.has_variable_support == 1 || self.renormalises()
    }

    /// Returns whether pressure is found by iteration (pressure correction).
    #[must_use]
    pub fn corrects_pressure(&self) -> bool {
        self.pressure_solver == PRESSURE_CORRECTION
    }

    /// Returns whether a step computes renormalised gradients and the eigenvalue lambda.
    #[must_use]
    pub fn renormalises(&self) -> bool {
        self.density_diffusion == RENORMALISED || self.shifting == FICKIAN || self.has_tensile_control == 1
    }

    /// Returns whether surface tension acts by the curvature of the surface.
    #[must_use]
    pub fn has_curvature(&self) -> bool {
        self.tension == CURVATURE || self.tension == NORMAL_CURVATURE
    }

    /// Returns whether positions or velocities still change after the forces.
    #[must_use]
    pub fn integrates_after(&self) -> bool {
        self.has_container == 1 || !knows_velocity(self)
    }

    /// Returns whether density depends only on the distances to the neighbours, and not on their properties, and no
    /// pass before it needs the neighbours.
    #[must_use]
    pub fn sums_distances(&self) -> bool {
        let depends = is_stepped(self) || counts_masses(self) || repels_directly(self);
        !depends && self.has_variable_support == 0 && !self.renormalises()
    }

    /// Returns whether a step makes neighbour lists. The half stencil searches the cells in each pass instead.
    #[must_use]
    pub fn makes_lists(&self) -> bool {
        self.is_half_stencil == 0
    }

    /// Returns whether kernels are read from tables.
    #[must_use]
    pub fn reads_tables(&self) -> bool {
        self.evaluation != DIRECT
    }

    /// Returns whether a step needs tables: of kernels, or of what lies beyond walls in closed form.
    #[must_use]
    pub fn has_tables(&self) -> bool {
        self.reads_tables() || self.has_closed_walls == 1
    }

    /// The same model with the simplest integrator, for a step that only evaluates the forces.
    #[must_use]
    pub(crate) fn at_rest(mut self) -> Model {
        self.integrator = SEMI_IMPLICIT_EULER;
        self.is_reevaluated = 0;
        self
    }
}
