//! The scene that `tests/bare` and `tests/core_stands_alone.rs` both step.
use millpond_core::glam::Vec3;
use millpond_core::scene::{
    Block, Container, Correction, DensityDiffusion, DensityForm, Dimension, EquationOfState, Evaluation, Fluid,
    Formulation, Grid, Integrator, Iteration, Kernel, NearPressure, PlaneModel, PressureForce, PressureSolver, Scene,
    Shifting, SurfaceTension, Viscosity, WallPressure,
};

/// Returns a scene of a thousand particles in the corner of a box.
pub fn scene() -> Scene {
    let water = Fluid { speed_of_sound: 20.0, dynamic_viscosity: 2.0, ..Fluid::default() };
    let block = Block { size: Vec3::splat(0.5), jitter: 0.02, ..Block::default() };
    let mut scene = Scene::of(Dimension::Three, 0.05, 0.001, water, block);
    scene.average_neighbours = Some(32.0);
    // every formula is named, so that a change of a default does not change the known bits
    scene.model = Formulation {
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
    scene.gravity = Vec3::new(0.0, -9.81, 0.0);
    let model = PlaneModel::Penalty;
    scene.container =
        Some(Container { restitution: 0.5, slip: 0.9, model, ..Container::closed([0.0; 3], [1.0, 1.0, 0.5]) });
    scene.grid = Grid { cells: [8, 8, 8], ..Grid::default() };
    scene
}
