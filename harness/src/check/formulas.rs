//! Choices of formulas for the studies. They rest on those of a source, so that studies do not change when defaults do.
use millpond_core::scene::{
    DensityDiffusion, DensityForm, Formulation, Kernel, NearPressure, PressureForce, Recipe, Shifting, Viscosity,
    WallPressure,
};

/// Pirovano's choices for a single fluid.
pub(super) const PIROVANO: Formulation = Formulation::of(Recipe::Pirovano);

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
