//! Choices that do not go together, refused by name before anything is touched.
use super::bounds::{field, not_together, positive};
use super::time::integrator;
use super::traversal;
use crate::derive::scales::Scales;
use crate::error::SceneError;
use crate::scene::{
    Adjustable, Air, Correction, DensityForm, Elasticity, EquationOfState, Evaluation, Fluid, GridStructure, Iteration,
    Kernel, NearPressure, PressureForce, Scene, SurfaceTension, Viscosity, WallPressure,
};
use glam::Vec3;

/// Spacings that sound may travel in a step of the literal pressure correction: beyond, its iteration grows (errata of Pirovano
/// section 3.2.2).
const LITERAL_SPACINGS: f32 = 1.5;

/// Spacings that cells must have at least with air: from a place of birth, whoever could be about to give birth beside it is
/// seen in the cells around, a spacing and the clearance of 3/4 away.
const CELLS_WITH_AIR: f64 = 1.75;

pub(super) fn check(scene: &Scene, scales: &Scales) -> Result<(), SceneError> {
    kernels(scene)?;
    pressure(scene)?;
    correction(scene)?;
    support(scene)?;
    fluids(scene)?;
    tension(scene)?;
    springs(scene)?;
    air(scene, scales)?;
    integrator(scene)?;
    live(scene)?;
    traversal::check(scene)?;
    let model = &scene.model;
    let one_sided = matches!(model.pressure_force, PressureForce::Canonical | PressureForce::Difference);
    if model.internal_energy && one_sided {
        return Err(not_together(
            "model.internal_energy",
            "a canonical or difference model.pressure_force",
            "its pairs do not act on each other alike, so their work is nobody's",
        ));
    }
    if scene.ambient_density > 0.0 && scene.gravity == Vec3::ZERO {
        return Err(not_together("ambient_density", "no gravity", "nothing would be buoyant"));
    }
    let gas = |fluid: &Fluid| scene.equation_of(fluid) == EquationOfState::IdealGas;
    if model.initialize_hydrostatic && scene.fluids.iter().any(gas) {
        return Err(not_together(
            "model.initialize_hydrostatic",
            "an equation_of_state IdealGas",
            "a gas has no surface to measure depth from",
        ));
    }
    if model.initialize_hydrostatic && scene.fluids.iter().any(|fluid| scene.ambient_density >= fluid.rest_density) {
        return Err(not_together(
            "model.initialize_hydrostatic",
            "an ambient_density as large as the fluid's",
            "its surface would be at the other end",
        ));
    }
    if model.initialize_hydrostatic && scene.gravity == Vec3::ZERO {
        return Err(not_together("model.initialize_hydrostatic", "no gravity", "there is no weight to hold"));
    }
    Ok(())
}

/// A term can only be kept where there is a form of it.
fn live(scene: &Scene) -> Result<(), SceneError> {
    let lists = |term: Adjustable| scene.adjustable.contains(&term);
    if lists(Adjustable::SurfaceTension) && scene.model.surface_tension == SurfaceTension::Off {
        return Err(not_together("live SurfaceTension", "model.surface_tension Off", "there is no term to keep"));
    }
    if lists(Adjustable::Viscosity)
        && matches!(scene.model.viscosity, Viscosity::Artificial | Viscosity::VelocityExchange)
    {
        return Err(not_together(
            "live Viscosity",
            "model.viscosity Artificial or Exchange",
            "these have coefficients of their own, which stay as they are",
        ));
    }
    Ok(())
}

fn kernels(scene: &Scene) -> Result<(), SceneError> {
    let model = &scene.model;
    if model.density_kernel == Kernel::Viscosity {
        return Err(not_together(
            "model.density_kernel Viscosity",
            "any density",
            "its value at no distance, and so a particle's own share, is infinite",
        ));
    }
    if model.evaluation != Evaluation::Direct {
        if model.variable_support.is_some() {
            return Err(not_together(
                "model.variable_support",
                "model.evaluation from tables",
                "a table is made for one support (Pirovano, section 4.2.3)",
            ));
        }
        let endless = model.pressure_kernel == Kernel::Viscosity
            || match model.viscosity {
                Viscosity::Mueller | Viscosity::MuellerAdapted => {
                    model.viscosity_kernel.is_cusped() && model.viscosity_kernel != Kernel::Viscosity
                }
                Viscosity::VelocityExchange => false,
                _ => model.viscosity_kernel == Kernel::Viscosity,
            };
        if endless {
            return Err(not_together(
                "model.evaluation from tables",
                "a kernel whose slope or Laplacian is infinite at no distance",
                "no table ends there",
            ));
        }
    }
    Ok(())
}

fn pressure(scene: &Scene) -> Result<(), SceneError> {
    let model = &scene.model;
    let on_numbers = model.pressure_force == PressureForce::NumberDensity;
    if on_numbers && model.density != DensityForm::NumberDensity {
        return Err(not_together(
            "model.pressure_force NumberDensity",
            "a model.density other than NumberDensity",
            "it is the gradient on that density",
        ));
    }
    let mirrored = !scene.walls.is_empty() && model.wall_pressure == WallPressure::Mirrored;
    if mirrored && model.pressure_force == PressureForce::Difference {
        return Err(not_together(
            "model.pressure_force Difference",
            "model.wall_pressure Mirrored",
            "a mirrored pressure makes no difference, so nothing would hold the fluid",
        ));
    }
    if model.density == DensityForm::NumberDensity && model.initialize_hydrostatic {
        return Err(not_together(
            "model.initialize_hydrostatic",
            "model.density NumberDensity",
            "masses that differ change no number",
        ));
    }
    let unused = |fluid: &Fluid| fluid.stiffness.is_some() && scene.equation_of(fluid) != EquationOfState::Tait;
    if let Some(number) = scene.fluids.iter().position(unused) {
        if scene.corrects_pressure() {
            let (field, solver) = (field!(number, "stiffness"), "model.pressure_solver PressureCorrection");
            return Err(not_together(field, solver, "nothing would use it"));
        }
        return Err(not_together(
            field!(number, "stiffness"),
            "an equation_of_state other than Tait",
            "it is the constant of that equation",
        ));
    }
    let stiff = |fluid: &Fluid| fluid.near_stiffness.is_some_and(|k| k > 0.0);
    if let Some(number) = scene.fluids.iter().position(stiff).filter(|_| model.near_pressure == NearPressure::Off) {
        return Err(not_together(field!(number, "near_stiffness"), "model.near_pressure Off", "nothing would use it"));
    }
    Ok(())
}

fn correction(scene: &Scene) -> Result<(), SceneError> {
    let Correction { iteration, iterations, tolerance } = scene.model.correction;
    positive("model.correction.tolerance", tolerance)?;
    if iterations == 0 || iterations > Correction::MOST {
        let (value, most) = (iterations as f32, Correction::MOST as f32);
        return Err(SceneError::OutOfBounds { field: "model.correction.iterations", value, least: 1.0, most });
    }
    if !scene.corrects_pressure() {
        return Ok(());
    }
    let iterated = [
        PressureForce::Monaghan,
        PressureForce::MonaghanAdapted,
        PressureForce::DensityWeighted,
        PressureForce::Difference,
    ];
    if !iterated.contains(&scene.model.pressure_force) {
        return Err(not_together(
            "model.pressure_solver PressureCorrection",
            "a canonical model.pressure_force, one of Mueller's or one on Gourlay's number density",
            "its iteration takes the whole gradient (Pirovano, section 3.2.2)",
        ));
    }
    let fastest = scene.fluids.iter().map(|fluid| fluid.speed_of_sound).fold(0.0, f32::max);
    let spacings = fastest * scene.longest_step() / scene.particle_spacing;
    if iteration == Iteration::Literal && spacings > LITERAL_SPACINGS {
        return Err(SceneError::CannotConverge { spacings, most: LITERAL_SPACINGS });
    }
    Ok(())
}

fn fluids(scene: &Scene) -> Result<(), SceneError> {
    let model = &scene.model;
    let own = scene.fluids.iter().position(|fluid| fluid.equation_of_state.is_some());
    if let Some(number) = own.filter(|_| scene.corrects_pressure()) {
        return Err(not_together(
            field!(number, "equation_of_state"),
            "model.pressure_solver PressureCorrection",
            "pressure is iterated for all fluids, so that nothing would use it",
        ));
    }
    let own_volumes =
        model.pressure_force.is_adapted() || !matches!(model.density, DensityForm::Summation | DensityForm::Continuity);
    if model.viscosity == Viscosity::MuellerAdapted && !own_volumes {
        return Err(not_together(
            "model.viscosity MuellerAdapted",
            "a model.density and a model.pressure_force that are not adapted",
            "no number density is there for it",
        ));
    }
    Ok(())
}

fn springs(scene: &Scene) -> Result<(), SceneError> {
    let elastic = |fluid: &Fluid| fluid.elastic_stiffness > 0.0;
    if scene.elasticity != Elasticity::default() && !scene.fluids.iter().any(elastic) {
        return Err(not_together("elasticity", "an elastic_stiffness of 0 in every fluid", "nothing would use it"));
    }
    if scene.air.is_some_and(|air| elastic(scene.fluid_of(air.fluid))) {
        return Err(not_together(
            "air.fluid",
            "an elastic_stiffness of that fluid",
            "springs would hold on to air that has vanished",
        ));
    }
    Ok(())
}

fn tension(scene: &Scene) -> Result<(), SceneError> {
    let model = &scene.model;
    let pulls = |fluid: &Fluid| fluid.surface_tension > 0.0;
    if let Some(number) = scene.fluids.iter().position(pulls).filter(|_| model.surface_tension == SurfaceTension::Off) {
        return Err(not_together(
            field!(number, "surface_tension"),
            "model.surface_tension Off",
            "nothing would use it",
        ));
    }
    if model.surface_tension == SurfaceTension::Curvature && model.density_kernel.is_cusped() {
        return Err(not_together(
            "model.surface_tension Curvature",
            "a model.density_kernel with an edge at no distance",
            "its Laplacian is infinite there",
        ));
    }
    Ok(())
}

fn air(scene: &Scene, scales: &Scales) -> Result<(), SceneError> {
    let Some(Air { fluid, .. }) = scene.air else { return Ok(()) };
    if fluid == 0 {
        return Err(not_together(
            "air.fluid 0",
            "a coat of air",
            "the first fluid is the liquid: a scene's constants are of it",
        ));
    }
    if matches!(scene.grid.structure, GridStructure::CellLists { .. }) {
        return Err(not_together(
            "air",
            "a grid.structure CellLists",
            "all air that is not there lies in one cell, which would need a place for each",
        ));
    }
    if scales.least_cell < CELLS_WITH_AIR * f64::from(scene.particle_spacing) {
        return Err(not_together(
            "air",
            "so few average_neighbours",
            "a support must reach 1.75 spacings, so that two that are made never meet",
        ));
    }
    Ok(())
}

fn support(scene: &Scene) -> Result<(), SceneError> {
    let Some(range) = scene.model.variable_support else { return Ok(()) };
    let bounds = [
        ("model.variable_support.smallest", range.smallest, 0.5, 1.0),
        ("model.variable_support.largest", range.largest, 1.0, 2.0),
    ];
    for (field, value, least, most) in bounds {
        if !(least..=most).contains(&value) {
            return Err(SceneError::OutOfBounds { field, value, least, most });
        }
    }
    Ok(())
}
