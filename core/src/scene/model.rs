//! Which formulas a scene uses.
use super::choice::{
    DensityForm, EquationOfState, Evaluation, Integrator, Iteration, Kernel, NearPressure, PressureForce,
    PressureSolver, SurfaceTension, Viscosity, WallPressure,
};

/// Which formula each term uses. The defaults are Pirovano's (section 4.1.2), in their forms for a single fluid.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields, default))]
pub struct Formulation {
    /// How particles are moved.
    pub integrator: Integrator,
    /// Evaluate forces once more at the end of a step, with the velocities that it came to (Pirovano eq. 2.33, corrected): twice the
    /// cost, for stability under damping. Verlet's loses some of it and gains an order; the others keep theirs (default off).
    pub reevaluate: bool,
    /// Kernel of the density sum, and of XSPH.
    pub density_kernel: Kernel,
    /// Kernel of the pressure gradient, and of the divergence in the continuity equation.
    pub pressure_kernel: Kernel,
    /// Kernel of the viscosity.
    pub viscosity_kernel: Kernel,
    /// Kernels by formula or from tables.
    pub evaluation: Evaluation,
    /// Where density comes from.
    pub density: DensityForm,
    /// Start with the density that the weight of the fluid above asks for, and with masses to match (Roy, section 3.1).
    #[cfg_attr(feature = "serde", serde(alias = "hydrostatic_start"))]
    pub initialize_hydrostatic: bool,
    /// Give particles the mass with which the density sum over the lattice is the rest density.
    #[cfg_attr(feature = "serde", serde(alias = "calibrated_mass"))]
    pub normalize_mass: bool,
    /// Where pressure comes from.
    pub pressure_solver: PressureSolver,
    /// Density to pressure, with [`PressureSolver::EquationOfState`].
    pub equation_of_state: EquationOfState,
    /// How pressure is iterated, with [`PressureSolver::PressureCorrection`].
    pub correction: Correction,
    /// May pressure be negative? Suction holds a free cloud together, and lets particles pair without near pressure.
    #[cfg_attr(feature = "serde", serde(alias = "suction"))]
    pub negative_pressure: bool,
    /// Pressure to force.
    pub pressure_force: PressureForce,
    /// What keeps particles from pairing.
    pub near_pressure: NearPressure,
    /// How velocities diffuse.
    pub viscosity: Viscosity,
    /// Linear coefficient of the artificial viscosity (default 1). The formula has the support radius where Monaghan 1992 has the
    /// smoothing length, half of it, so that the same alpha gives twice his viscosity.
    pub alpha: f32,
    /// Quadratic coefficient of the artificial viscosity (default 2).
    pub beta: f32,
    /// Share of the difference between two velocities that a neighbour at no distance exchanges in a step (Gourlay; 0 to 1, default
    /// 0), for [`Viscosity::VelocityExchange`]. Where the shares of all neighbours add up to more than 1, they are scaled
    /// down together: see [`terms::exchange`](crate::terms::exchange).
    pub velocity_exchange: f32,
    /// The same share of the velocity with which two particles approach each other (Gourlay's shock viscosity; 0 to 1, default 0). It
    /// acts beside any viscosity.
    pub radial_exchange: f32,
    /// How much a particle moves with its neighbours (XSPH: Monaghan 1989; Pirovano eq. 2.16, corrected; 0 to 1, default 0).
    pub xsph: f32,
    /// How surfaces pull themselves together.
    pub surface_tension: SurfaceTension,
    /// Length of a normal, over one over the support radius, above which a particle is at the surface (Pirovano, section 3.4.4's
    /// threshold; default 0.1). With `Curvature` and `NormalCurvature` only those feel a tension.
    pub surface_threshold: f32,
    /// Find normals and who is at the surface for the host, also without a tension that needs them (default off).
    pub surface_normals: bool,
    /// Keep account of heat: compression and what viscosity dissipates (Roy; Gourlay).
    #[cfg_attr(feature = "serde", serde(alias = "thermal_energy"))]
    pub internal_energy: bool,
    /// Share of the dissipated energy that becomes internal energy (Gourlay's gain; 0 to 1, default 1), where
    /// [`internal_energy`](Formulation::internal_energy) is on.
    pub heat_gain: f32,
    /// Supports that follow the density, within bounds (Pirovano eq. 4.2, corrected; default: one for all).
    pub variable_support: Option<SupportRange>,
    /// What a particle of a wall does to the pressure of its neighbours.
    pub wall_pressure: WallPressure,
}

impl Default for Formulation {
    fn default() -> Self {
        Formulation {
            integrator: Integrator::default(),
            reevaluate: false,
            density_kernel: Kernel::Poly6,
            pressure_kernel: Kernel::Spiky,
            viscosity_kernel: Kernel::Viscosity,
            evaluation: Evaluation::Direct,
            density: DensityForm::Summation,
            initialize_hydrostatic: false,
            normalize_mass: false,
            pressure_solver: PressureSolver::EquationOfState,
            equation_of_state: EquationOfState::Tait,
            correction: Correction::default(),
            negative_pressure: true,
            pressure_force: PressureForce::Mueller,
            near_pressure: NearPressure::DensityProportional,
            viscosity: Viscosity::Mueller,
            alpha: 1.0,
            beta: 2.0,
            velocity_exchange: 0.0,
            radial_exchange: 0.0,
            xsph: 0.0,
            surface_tension: SurfaceTension::Off,
            surface_threshold: 0.1,
            surface_normals: false,
            internal_energy: false,
            heat_gain: 1.0,
            variable_support: None,
            wall_pressure: WallPressure::Mirrored,
        }
    }
}

impl Formulation {
    /// What the literature after Pirovano found to be better for one fluid: one kernel that does not pair for everything, the
    /// symmetric gradient, Morris' viscosity, and no near pressure, which then has nothing to mend.
    #[must_use]
    pub fn modern() -> Formulation {
        Formulation {
            density_kernel: Kernel::WendlandC2,
            pressure_kernel: Kernel::WendlandC2,
            viscosity_kernel: Kernel::WendlandC2,
            pressure_force: PressureForce::Monaghan,
            near_pressure: NearPressure::Off,
            viscosity: Viscosity::Morris,
            ..Formulation::default()
        }
    }
}

impl Formulation {
    /// The modern choice for several fluids: a density adapted to contrasts (Pirovano, section 3.4.3), and the pressure force that
    /// holds still where they meet.
    #[must_use]
    pub fn multiphase() -> Formulation {
        Formulation {
            density: DensityForm::SummationAdapted,
            pressure_force: PressureForce::DensityWeighted,
            ..Formulation::modern()
        }
    }
}

/// How far the pressure of a step is iterated (Pirovano, section 3.2.2, corrected).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields, default))]
pub struct Correction {
    /// By which rule.
    pub iteration: Iteration,
    /// Most iterations of a step, 1 to [`Correction::MOST`] (default 20).
    pub iterations: u32,
    /// Largest deviation from the density aimed at, as a share of the rest density, at which they end (default 0.001).
    pub tolerance: f32,
}

impl Correction {
    /// Most iterations that a scene can ask for: a device is handed all of them at once.
    pub const MOST: u32 = 200;
}

impl Default for Correction {
    fn default() -> Self {
        Correction { iteration: Iteration::Relaxed, iterations: 20, tolerance: 0.001 }
    }
}

/// Bounds of a particle's support radius, as shares of the scene's.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub struct SupportRange {
    /// Smallest, 0.5 to 1.
    pub smallest: f32,
    /// Largest, 1 to 2; cells are made as large.
    pub largest: f32,
}
