//! The formulas of the recipes.
use super::choice::{
    DensityDiffusion, DensityForm, EquationOfState, Evaluation, Integrator, Iteration, Kernel, NearPressure,
    PressureForce, PressureSolver, Shifting, SurfaceTension, Viscosity, WallPressure,
};
use super::model::{Correction, Formulation};
use super::recipe::Recipe;

/// The formulas of [`Recipe::Pirovano`]. Every field is given here; the other recipes say in what they differ.
const PIROVANO: Formulation = Formulation {
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
    wall_rigidity: 0.02,
};

/// The formulas of [`Recipe::FreeSurface`], from which the other kinds of flow start.
const FREE_SURFACE: Formulation = Formulation {
    // particles do not pair with it
    density_kernel: Kernel::WendlandC2,
    pressure_kernel: Kernel::WendlandC2,
    viscosity_kernel: Kernel::WendlandC2,
    // a sum would be too low at the surface, and boils at walls in closed form
    density: DensityForm::Continuity,
    // without it the pressure is rough; this form leaves a fluid at rest alone
    density_diffusion: DensityDiffusion::Hydrostatic,
    // the lattice starts at the rest density
    normalize_mass: true,
    // under negative pressure a surface tears, and particles clump
    negative_pressure: false,
    // the whole gradient, which conserves momentum
    pressure_force: PressureForce::Monaghan,
    near_pressure: NearPressure::Off,
    // the friction of the fluid, and a damping of noise: with the support radius, a fifth of Monaghan's 0.1
    viscosity: Viscosity::MorrisAndArtificial,
    alpha: 0.01,
    beta: 0.0,
    // the pressure of the fluid, continued into the wall by its weight
    wall_pressure: WallPressure::Extrapolated,
    ..PIROVANO
};

impl Formulation {
    /// Returns the formulas for a kind of flow, or those of a source.
    #[must_use]
    pub const fn of(recipe: Recipe) -> Formulation {
        match recipe {
            Recipe::FreeSurface => FREE_SURFACE,
            // an impact excites sound, which needs more damping
            Recipe::Impact => Formulation { alpha: 0.05, ..FREE_SURFACE },
            // the fluid is held from all sides, so that its pressure may be negative; a background pressure keeps the
            // particles from lining up along the streamlines (Adami et al. 2013), and a sum knows where they are
            Recipe::ClosedBox => Formulation {
                density: DensityForm::Summation,
                density_diffusion: DensityDiffusion::Off,
                negative_pressure: true,
                shifting: Shifting::TransportVelocity,
                ..FREE_SURFACE
            },
            // volumes that are not smeared across an interface (Solenthaler and Pajarola 2008), the pressure force that
            // keeps an interface at rest (Hu and Adams 2007), and damping for the lighter fluid
            Recipe::SeveralFluids => Formulation {
                density: DensityForm::ContinuityAdapted,
                pressure_force: PressureForce::DensityWeighted,
                alpha: 0.05,
                ..FREE_SURFACE
            },
            // a sum, since a drop rotates and deforms for long; normals need a wide and smooth kernel; where the
            // interface lowers the pressure, it may be negative
            Recipe::Drops => Formulation {
                density_kernel: Kernel::WendlandC4,
                pressure_kernel: Kernel::WendlandC4,
                viscosity_kernel: Kernel::WendlandC4,
                density: DensityForm::SummationAdapted,
                density_diffusion: DensityDiffusion::Off,
                negative_pressure: true,
                normalize_mass: false,
                viscosity: Viscosity::Morris,
                surface_tension: SurfaceTension::NormalCurvature,
                ..Formulation::of(Recipe::SeveralFluids)
            },
            // its own friction damps all noise
            Recipe::Viscous => Formulation { viscosity: Viscosity::Morris, ..FREE_SURFACE },
            Recipe::Pirovano => PIROVANO,
            Recipe::Hinsch => Formulation {
                integrator: Integrator::SemiImplicitEuler,
                density_kernel: Kernel::CubicSpline,
                pressure_kernel: Kernel::CubicSpline,
                viscosity_kernel: Kernel::CubicSpline,
                near_pressure: NearPressure::Off,
                pressure_force: PressureForce::Monaghan,
                viscosity: Viscosity::MonaghanGingold,
                ..PIROVANO
            },
        }
    }
}

impl Default for Formulation {
    fn default() -> Self {
        Formulation::of(Recipe::default())
    }
}
