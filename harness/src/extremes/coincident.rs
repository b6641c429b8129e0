//! Two particles at the same position, under every choice of formulas. No direction is defined for their forces, and
//! kernels are steepest there.
use super::{Case, End, Measure, built_in};
use crate::failure::Failure;
use millpond_core::scene::{
    DensityDiffusion, DensityForm, EquationOfState, Evaluation, InitialParticle, Kernel, NearPressure, PressureForce,
    PressureSolver, Scene, Shifting, SupportRange, SurfaceTension, Viscosity,
};

/// Number of steps, enough for most coincident particles to separate.
const STEPS: u32 = 10;

/// Returns the cases.
///
/// # Errors
/// A built-in scene that cannot be read.
pub fn cases() -> Result<Vec<Case>, Failure> {
    let mut scene = built_in("thesis-cube", 200)?;
    scene.grid.cells = [4, 4, 4];
    let mut cases = Vec::new();
    // two particles pass through each other, two are at rest at the same position, and one is near
    let places = [(0.0, 1.0), (0.0, -1.0), (0.05, 0.0), (0.05, 0.0), (0.03, 0.0)];
    let places = places.map(|(x, v)| InitialParticle::at([x, 0.0, 0.0], [0.0, v, 0.0]));
    let mut add = |what: &str, change: &dyn Fn(&mut Scene)| {
        let mut scene = scene.clone();
        change(&mut scene);
        let name = format!("coincident particles, {what}");
        cases.push(Case::of_places(name, &scene, places.to_vec(), STEPS, End::Runs(Measure::Finite)));
    };
    // combine the choices so that few scenes contain each of them
    for (&kernel, &near) in Kernel::ALL.iter().zip(NearPressure::ALL.iter().cycle()) {
        for viscosity in [Viscosity::Mueller, Viscosity::Morris] {
            add(&format!("kernel {kernel:?}, viscosity {viscosity:?}, near pressure {near:?}"), &|s| {
                (s.model.pressure_kernel, s.model.viscosity_kernel) = (kernel, kernel);
                if kernel.has_value() {
                    s.model.density_kernel = kernel;
                }
                (s.model.viscosity, s.model.near_pressure) = (viscosity, near);
            });
        }
    }
    for (&force, &tension) in PressureForce::ALL.iter().zip(SurfaceTension::ALL.iter().cycle()) {
        add(&format!("pressure force {force:?}, surface tension {tension:?}"), &|s| {
            (s.model.pressure_force, s.model.density) = (force, DensityForm::NumberDensity);
            s.model.surface_tension = tension;
            s.fluids[0].surface_tension = if tension == SurfaceTension::Off { 0.0 } else { 1.0 };
        });
    }
    for (&density, &state) in DensityForm::ALL.iter().zip(EquationOfState::ALL.iter().cycle()) {
        add(&format!("density {density:?}, equation of state {state:?}"), &|s| {
            (s.model.density, s.model.equation_of_state) = (density, state);
            s.model.pressure_force = PressureForce::Monaghan;
        });
    }
    for &solver in PressureSolver::ALL {
        add(&format!("pressure solver {solver:?}"), &|s| {
            (s.model.pressure_solver, s.model.pressure_force) = (solver, PressureForce::Monaghan);
        });
    }
    for &viscosity in Viscosity::ALL {
        add(&format!("viscosity {viscosity:?}, internal energy"), &|s| {
            (s.model.viscosity, s.model.density) = (viscosity, DensityForm::SummationAdapted);
            (s.model.internal_energy, s.model.velocity_exchange) = (true, 0.1);
        });
    }
    for evaluation in [Evaluation::Table, Evaluation::SquaredTable] {
        add(&format!("kernels by {evaluation:?}"), &|s| s.model.evaluation = evaluation);
    }
    add("springs", &|s| s.fluids[0].elastic_stiffness = 100.0);
    add("XSPH", &|s| s.model.xsph = 0.5);
    for shifting in [Shifting::Fickian, Shifting::TransportVelocity] {
        add(&format!("shifting {shifting:?}, tensile control, renormalised diffusion"), &|s| {
            (s.model.shifting, s.model.tensile_control) = (shifting, true);
            (s.model.density, s.model.pressure_force) = (DensityForm::Continuity, PressureForce::Monaghan);
            s.model.density_diffusion = DensityDiffusion::Renormalised;
        });
    }
    add("variable support", &|s| s.model.variable_support = Some(SupportRange { smallest: 0.5, largest: 2.0 }));
    Ok(cases)
}
