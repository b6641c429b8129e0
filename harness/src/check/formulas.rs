//! Choices of formulas for the studies. Every field is given here, so that studies do not change when defaults do.
use millpond_core::scene::{
    Correction, DensityDiffusion, DensityForm, EquationOfState, Evaluation, Formulation, Integrator, Iteration, Kernel,
    NearPressure, PressureForce, PressureSolver, Shifting, SurfaceTension, Viscosity, WallPressure,
};

/// Pirovano's choices for a single fluid.
pub(super) const PIROVANO: Formulation = Formulation {
    integrator: Integrator::ModifiedVelocityVerlet,
    reevaluate: false,
    density_kernel: Kernel::Poly6,
    pressure_kernel: Kernel::Spiky,
    viscosity_kernel: Kernel::Viscosity,
    evaluation: Evaluation::Direct,
    density: DensityForm::Summation,
    density_diffusion: DensityDiffusion::Off,
    diffusion: 0.1,
    initialize_hydrostatic: false,
    normalize_mass: false,
    pressure_solver: PressureSolver::EquationOfState,
    equation_of_state: EquationOfState::Tait,
    tait_exponent: 7,
    correction: Correction { iteration: Iteration::Relaxed, iterations: 20, tolerance: 0.001 },
    negative_pressure: true,
    pressure_force: PressureForce::Mueller,
    near_pressure: NearPressure::DensityProportional,
    viscosity: Viscosity::Mueller,
    alpha: 1.0,
    beta: 2.0,
    velocity_exchange: 0.0,
    radial_exchange: 0.0,
    xsph: 0.0,
    shifting: Shifting::Off,
    shifting_coefficient: 1.0,
    shifting_speed: None,
    shift_across_interfaces: false,
    tensile_control: false,
    surface_tension: SurfaceTension::Off,
    surface_threshold: 0.1,
    surface_normals: false,
    internal_energy: false,
    heat_gain: 1.0,
    variable_support: None,
    wall_pressure: WallPressure::Mirrored,
};

/// Wendland's C2 kernel for all terms, the symmetric pressure gradient of Monaghan 1992, the viscosity of Morris et al.
/// 1997, and no near pressure.
pub(super) const WENDLAND: Formulation = Formulation {
    density_kernel: Kernel::WendlandC2,
    pressure_kernel: Kernel::WendlandC2,
    viscosity_kernel: Kernel::WendlandC2,
    pressure_force: PressureForce::Monaghan,
    near_pressure: NearPressure::Off,
    viscosity: Viscosity::Morris,
    ..PIROVANO
};

/// [`WENDLAND`] for water between walls of particles: the continuity equation with a diffusion that leaves a fluid at
/// rest alone, and walls that follow the fluid.
pub(super) const WATER: Formulation = Formulation {
    density: DensityForm::Continuity,
    density_diffusion: DensityDiffusion::Hydrostatic,
    wall_pressure: WallPressure::Extrapolated,
    normalize_mass: true,
    ..WENDLAND
};

/// [`WATER`] that is stretched: particles are shifted to an even distribution, and do not attract each other.
pub(super) const SHIFTED: Formulation = Formulation { shifting: Shifting::Fickian, tensile_control: true, ..WATER };

/// [`WATER`] with a free surface that hardly shears: it starts at rest under its weight, its pressure is not negative,
/// and a little artificial viscosity, whose coefficient a study sets, damps its sound.
pub(super) const WATER_WITH_SURFACE: Formulation = Formulation {
    viscosity: Viscosity::Artificial,
    beta: 0.0,
    initialize_hydrostatic: true,
    negative_pressure: false,
    ..WATER
};

/// Number of neighbours in 2D with which a lattice under pressure keeps its rows with [`WATER`].
pub(super) const ROWS_STAY: f32 = 32.0;

/// [`WENDLAND`] for several fluids: a density that is not smeared across an interface (Solenthaler and Pajarola 2008),
/// and the pressure force of Hu and Adams 2007.
pub(super) const SEVERAL_FLUIDS: Formulation =
    Formulation { density: DensityForm::SummationAdapted, pressure_force: PressureForce::DensityWeighted, ..WENDLAND };
