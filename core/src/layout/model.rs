//! Which formula each term uses: the plan's choices as numbers that both languages compare.
use super::shared;

shared! {
    /// The choices of a scene. On the GPU this is a constant, so that what is not chosen is compiled away.
    pub struct Model {
        /// [`terms::kernel`](crate::terms::kernel) of the density.
        pub density_kernel: u32,
        /// [`terms::kernel`](crate::terms::kernel) of the pressure gradient.
        pub pressure_kernel: u32,
        /// [`terms::kernel`](crate::terms::kernel) of the viscosity.
        pub viscosity_kernel: u32,
        /// [`terms::table`](crate::terms::table): how kernels are evaluated.
        pub evaluation: u32,
        /// [`terms::density`](crate::terms::density).
        pub density: u32,
        /// [`terms::state`](crate::terms::state).
        pub equation_of_state: u32,
        /// [`terms::correction`](crate::terms::correction).
        pub iteration: u32,
        /// 1: pressure may be negative.
        pub suction: u32,
        /// [`terms::pressure`](crate::terms::pressure).
        pub pressure_force: u32,
        /// [`terms::near`](crate::terms::near); 0: none.
        pub near_pressure: u32,
        /// [`terms::viscosity`](crate::terms::viscosity); 0: none.
        pub viscosity: u32,
        /// 1: velocities are exchanged ([`terms::exchange`](crate::terms::exchange)).
        pub exchange: u32,
        /// 1: gravity acts.
        pub gravity: u32,
        /// 1: against the buoyancy of what surrounds the fluid.
        pub buoyancy: u32,
        /// 1: wind acts.
        pub wind: u32,
        /// 1: a field of the host's acts.
        pub field: u32,
        /// 1: there are penalty walls.
        pub walls: u32,
        /// 1: they give back no more than the share of the path that lay behind them.
        pub reflection: u32,
        /// [`terms::wall`](crate::terms::wall): walls of particles; 0: none.
        pub wall_particles: u32,
        /// 1: some axis is periodic.
        pub periodic: u32,
        /// 1: supports follow the density.
        pub variable_support: u32,
        /// 1: particles differ in mass.
        pub masses: u32,
        /// 1: particles differ in kind: walls, or fluids of several viscosities.
        pub species: u32,
        /// 1: there are several fluids.
        pub fluids: u32,
        /// 1: their equations of state differ.
        pub states: u32,
        /// 1: volumes come from the number density, where the density does not.
        pub numbers: u32,
        /// [`terms::tension`](crate::terms::tension); 0: none.
        pub tension: u32,
        /// 1: normals are found.
        pub normals: u32,
        /// 1: springs join particles.
        pub springs: u32,
        /// 1: their lengths at rest change.
        pub plastic: u32,
        /// 1: there is a coat of air.
        pub air: u32,
        /// 1: thermal energy is kept account of.
        pub thermal_energy: u32,
        /// 1: particles move with their neighbours.
        pub xsph: u32,
        /// [`terms::integrate`](crate::terms::integrate).
        pub integrator: u32,
        /// 1: forces are evaluated once more, with the velocities at the end of the step.
        pub reevaluates: u32,
        /// 1: the time step follows from the state.
        pub adaptive: u32,
        /// Cells around a particle's own along z, 0 or 1: in 2D there is one layer.
        pub layers: u32,
        /// Places of a cell in the cell lists; 0 with the index sort.
        pub cell_places: u32,
    }
}

impl Model {
    /// Does a step need what the particles' quantities were before it?
    #[must_use]
    pub fn needs_previous(&self) -> bool {
        crate::terms::density::is_stepped(self) || self.corrects_pressure() || self.variable_support == 1
    }

    /// Is pressure iterated?
    #[must_use]
    pub fn corrects_pressure(&self) -> bool {
        self.equation_of_state == crate::terms::state::PRESSURE_CORRECTION
    }

    /// Does a surface pull by its curvature?
    #[must_use]
    pub fn has_curvature(&self) -> bool {
        use crate::terms::tension::{CURVATURE, NORMAL_CURVATURE};
        self.tension == CURVATURE || self.tension == NORMAL_CURVATURE
    }

    /// Do pairs need the velocities at the end of a step?
    #[must_use]
    pub fn foresees(&self) -> bool {
        self.thermal_energy == 1 || self.xsph == 1 || self.reevaluates == 1
    }

    /// Is there anything left to do after the forces?
    #[must_use]
    pub fn integrates_after(&self) -> bool {
        self.walls == 1 || !crate::terms::integrate::knows_velocity(self)
    }

    /// The same model with the plainest integrator: what a step takes that only evaluates forces.
    #[must_use]
    pub(crate) fn at_rest(mut self) -> Model {
        self.integrator = crate::terms::integrate::SEMI_IMPLICIT_EULER;
        self.reevaluates = 0;
        self
    }

    /// Are kernels read from tables?
    #[must_use]
    pub fn reads_tables(&self) -> bool {
        self.evaluation != crate::terms::table::DIRECT
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
        use crate::terms::viscosity::{MUELLER_VISCOSITY, NO_VISCOSITY};
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
