//! What follows from the choices of a scene: predicates that arrays, passes and the step's order ask.
use crate::layout::Model;
use crate::terms::correction::PRESSURE_CORRECTION;
use crate::terms::density::{counts_masses, is_stepped};
use crate::terms::integrate::{SEMI_IMPLICIT_EULER, knows_velocity};
use crate::terms::table::DIRECT;
use crate::terms::tension::{CURVATURE, NORMAL_CURVATURE};
use crate::terms::viscosity::{MUELLER_VISCOSITY, NO_VISCOSITY};

impl Model {
    /// Does a step need the density and pressure of the particles before it?
    #[must_use]
    pub fn needs_previous(&self) -> bool {
        is_stepped(self) || self.corrects_pressure() || self.variable_support == 1
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
        self.walls == 1 || !knows_velocity(self)
    }

    /// Does density follow from the distances of neighbours alone, whoever they are?
    #[must_use]
    pub fn sums_distances(&self) -> bool {
        !is_stepped(self) && !counts_masses(self) && self.variable_support == 0
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
        self.reevaluates = 0;
        self
    }

    /// Is this one of the usual scenes, of one fluid on fixed supports between planes? Loops over pairs are compiled for
    /// these once more, without what only the others need: that is worth a factor of two.
    #[must_use]
    pub(crate) fn is_plain(&self) -> bool {
        *self == self.plain()
    }

    /// This model, as the compiler may take it for granted where [`Model::is_plain`] says so.
    #[inline(always)]
    #[must_use]
    pub(crate) fn plain(&self) -> Model {
        // curvature acts in passes of its own
        Model {
            evaluation: 0,
            density: 0,
            iteration: 0,
            viscosity: if self.viscosity == NO_VISCOSITY { NO_VISCOSITY } else { MUELLER_VISCOSITY },
            exchange: 0,
            field: 0,
            wall_particles: 0,
            periodic: 0,
            variable_support: 0,
            masses: 0,
            species: 0,
            fluids: 0,
            states: 0,
            numbers: 0,
            air: 0,
            tension: if self.has_curvature() { self.tension } else { 0 },
            ..*self
        }
    }
}
