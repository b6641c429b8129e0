//! Checks combinations of choices. The errors name both choices, the reason, and what to change.
use super::bounds::{bounded, not_together, positive};
use super::time::integrator;
use super::{closed_walls, shifting, traversal};
use crate::derive::scales::Scales;
use crate::error::{Field, SceneError};
use crate::scene::{
    Adjustable, Air, Correction, DensityDiffusion, DensityForm, Elasticity, EquationOfState, Evaluation, Fluid,
    Formulation, GridStructure, Iteration, Kernel, NearPressure, PressureForce, Scene, SurfaceTension, Viscosity,
    WallPressure,
};
use glam::Vec3;

/// Particle spacings that sound may travel in a step of the literal pressure correction. Beyond, its iteration
/// diverges (Pirovano, section 3.2.2, corrected).
const LITERAL_SPACINGS: f32 = 1.5;

/// Smallest edge of a cell with air, in particle spacings. The exposed particles that could spawn air too close to a
/// spawn position are at most one spacing plus the clearance of 3/4 of a spacing away from it, so they lie in the
/// cells around it.
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
    shifting::check(scene)?;
    closed_walls::check(scene, scales)?;
    traversal::check(scene)?;
    let model = &scene.model;
    let one_sided = matches!(model.pressure_force, PressureForce::Canonical | PressureForce::Difference);
    if model.internal_energy && one_sided {
        return Err(not_together(
            "model.internal_energy",
            "model.pressure_force Canonical or Difference",
            "their pair forces are not equal and opposite, so the work they do cannot be assigned to either particle; \
             use another pressure_force",
        ));
    }
    if scene.ambient_density > 0.0 && scene.gravity == Vec3::ZERO {
        return Err(not_together("ambient_density", "zero gravity", "without gravity nothing is buoyant; set gravity"));
    }
    let gas = |fluid: &Fluid| scene.equation_of(fluid) == EquationOfState::IdealGas;
    if model.initialize_hydrostatic && scene.fluids.iter().any(gas) {
        return Err(not_together(
            "model.initialize_hydrostatic",
            "equation_of_state IdealGas",
            "a gas has no free surface from which to measure depth; use another equation_of_state, or turn \
             initialize_hydrostatic off",
        ));
    }
    if model.initialize_hydrostatic && scene.fluids.iter().any(|fluid| scene.ambient_density >= fluid.rest_density) {
        return Err(not_together(
            "model.initialize_hydrostatic",
            "an ambient_density that is not below every rest_density",
            "the fluid would be buoyant and its hydrostatic profile inverted; lower ambient_density, or turn \
             initialize_hydrostatic off",
        ));
    }
    if model.initialize_hydrostatic && scene.gravity == Vec3::ZERO {
        return Err(not_together("model.initialize_hydrostatic", "zero gravity", "there is no weight; set gravity"));
    }
    Ok(())
}

/// Rejects adjustable terms for which the formulation has no formula with a coefficient that can be changed.
fn live(scene: &Scene) -> Result<(), SceneError> {
    let lists = |term: Adjustable| scene.adjustable.contains(&term);
    if lists(Adjustable::SurfaceTension) && scene.model.surface_tension == SurfaceTension::Off {
        return Err(not_together("adjustable SurfaceTension", "model.surface_tension Off", "choose a surface_tension"));
    }
    if lists(Adjustable::Viscosity)
        && matches!(scene.model.viscosity, Viscosity::Artificial | Viscosity::VelocityExchange)
    {
        return Err(not_together(
            "adjustable Viscosity",
            "model.viscosity Artificial or VelocityExchange",
            "these use coefficients in model, which cannot be changed between steps, instead of dynamic_viscosity; \
             use another model.viscosity, or omit Viscosity from adjustable",
        ));
    }
    Ok(())
}

fn kernels(scene: &Scene) -> Result<(), SceneError> {
    let model = &scene.model;
    if model.density_kernel == Kernel::Viscosity {
        return Err(not_together(
            "model.density_kernel Viscosity",
            "any model.density",
            "it is infinite at distance 0, so a particle's contribution to its own density would be infinite; use \
             another density_kernel",
        ));
    }
    if model.evaluation != Evaluation::Direct {
        if model.variable_support.is_some() {
            return Err(not_together(
                "model.variable_support",
                "model.evaluation Table or SquaredTable",
                "a table is computed for one support radius (Pirovano, section 4.2.3); use model.evaluation Direct",
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
                "model.evaluation Table or SquaredTable",
                "a kernel whose slope or Laplacian is infinite at distance 0",
                "a table cannot store an infinite value; use model.evaluation Direct, or another pressure_kernel or \
                 viscosity_kernel",
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
            "this gradient is derived for the number density; use model.density NumberDensity, or another \
             pressure_force",
        ));
    }
    let mirrored = scene.has_wall_particles() && model.wall_pressure == WallPressure::Mirrored;
    if mirrored && model.pressure_force == PressureForce::Difference {
        return Err(not_together(
            "model.pressure_force Difference",
            "model.wall_pressure Mirrored",
            "a mirrored pressure does not differ from the fluid's, so walls would not hold the fluid; use \
             wall_pressure Dynamic, or another pressure_force",
        ));
    }
    repelling_walls(scene)?;
    let is_stepped = matches!(model.density, DensityForm::Continuity | DensityForm::ContinuityAdapted);
    if model.density_diffusion != DensityDiffusion::Off && !is_stepped {
        return Err(not_together(
            "model.density_diffusion",
            "a model.density other than Continuity or ContinuityAdapted",
            "a density that is summed anew in each step cannot diffuse; use model.density Continuity, or \
             density_diffusion Off",
        ));
    }
    let renormalises = model.density_diffusion == DensityDiffusion::Renormalised;
    if renormalises && scene.has_wall_particles() && model.wall_pressure == WallPressure::Mirrored {
        return Err(not_together(
            "model.density_diffusion Renormalised",
            "model.wall_pressure Mirrored",
            "mirrored walls have no density from which a gradient could follow; use wall_pressure Extrapolated or \
             Dynamic, or density_diffusion Hydrostatic",
        ));
    }
    if model.density == DensityForm::NumberDensity && model.initialize_hydrostatic {
        return Err(not_together(
            "model.initialize_hydrostatic",
            "model.density NumberDensity",
            "a number density ignores particle masses, which the hydrostatic start sets; use another model.density, \
             or turn initialize_hydrostatic off",
        ));
    }
    let unused = |fluid: &Fluid| fluid.stiffness.is_some() && scene.equation_of(fluid) != EquationOfState::Tait;
    if let Some(number) = scene.fluids.iter().position(unused) {
        if scene.corrects_pressure() {
            let (field, solver) =
                (Field::of_item("fluids.stiffness", number), "model.pressure_solver PressureCorrection");
            return Err(not_together(field, solver, "it is unused, because pressure is iterated; omit it"));
        }
        return Err(not_together(
            Field::of_item("fluids.stiffness", number),
            "an equation_of_state other than Tait",
            "it is the constant of Tait's equation; omit it, or use equation_of_state Tait",
        ));
    }
    let stiff = |fluid: &Fluid| fluid.near_stiffness.is_some_and(|k| k > 0.0);
    if let Some(number) = scene.fluids.iter().position(stiff).filter(|_| model.near_pressure == NearPressure::Off) {
        return Err(not_together(
            Field::of_item("fluids.near_stiffness", number),
            "model.near_pressure Off",
            "it is unused; omit it",
        ));
    }
    Ok(())
}

fn correction(scene: &Scene) -> Result<(), SceneError> {
    let Correction { iteration, iterations, tolerance } = scene.model.correction;
    positive("model.correction.tolerance", tolerance)?;
    bounded("model.correction.iterations", iterations as f32, 1.0..=Correction::MOST as f32)?;
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
            "model.pressure_force Mueller, MuellerAdapted, Canonical or NumberDensity",
            "its iteration is derived for other forms of the whole gradient (Pirovano, section 3.2.2); use Monaghan, \
             MonaghanAdapted, DensityWeighted or Difference",
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
            Field::of_item("fluids.equation_of_state", number),
            "model.pressure_solver PressureCorrection",
            "it is unused, because pressure is iterated for all fluids; omit it",
        ));
    }
    let own_volumes =
        model.pressure_force.is_adapted() || !matches!(model.density, DensityForm::Summation | DensityForm::Continuity);
    if model.viscosity == Viscosity::MuellerAdapted && !own_volumes {
        return Err(not_together(
            "model.viscosity MuellerAdapted",
            "model.density Summation or Continuity without an adapted model.pressure_force",
            "it needs a number density; use model.density SummationAdapted, ContinuityAdapted or NumberDensity, or \
             model.pressure_force MuellerAdapted, MonaghanAdapted or DensityWeighted",
        ));
    }
    Ok(())
}

fn springs(scene: &Scene) -> Result<(), SceneError> {
    let elastic = |fluid: &Fluid| fluid.elastic_stiffness > 0.0;
    if scene.elasticity != Elasticity::default() && !scene.fluids.iter().any(elastic) {
        return Err(not_together("elasticity", "an elastic_stiffness of 0 in every fluid", "it is unused; omit it"));
    }
    if scene.air.is_some_and(|air| elastic(scene.fluid_of(air.fluid))) {
        return Err(not_together(
            "air.fluid",
            "an elastic_stiffness of that fluid",
            "springs would stay attached to air particles that have become inactive; set the elastic_stiffness of the \
             air to 0",
        ));
    }
    Ok(())
}

fn tension(scene: &Scene) -> Result<(), SceneError> {
    let model = &scene.model;
    let pulls = |fluid: &Fluid| fluid.surface_tension > 0.0;
    if let Some(number) = scene.fluids.iter().position(pulls).filter(|_| model.surface_tension == SurfaceTension::Off) {
        return Err(not_together(
            Field::of_item("fluids.surface_tension", number),
            "model.surface_tension Off",
            "choose a model, or set it to 0",
        ));
    }
    if model.surface_tension == SurfaceTension::Curvature && model.density_kernel.is_cusped() {
        return Err(not_together(
            "model.surface_tension Curvature",
            "a model.density_kernel with a cusp at distance 0",
            "the kernel's Laplacian is infinite there; use a smooth density_kernel such as WendlandC2, or \
             model.surface_tension NormalCurvature",
        ));
    }
    Ok(())
}

fn air(scene: &Scene, scales: &Scales) -> Result<(), SceneError> {
    let Some(Air { fluid, .. }) = scene.air else { return Ok(()) };
    if fluid == 0 {
        return Err(not_together(
            "air.fluid 0",
            "a layer of air",
            "fluid 0 must be the liquid, because the scene's constants refer to it; add a fluid for the air, and set \
             air.fluid to its number",
        ));
    }
    if matches!(scene.grid.structure, GridStructure::CellLists { .. }) {
        return Err(not_together(
            "air",
            "grid.structure CellLists",
            "inactive air particles share one cell, which would need a place for each of them; use grid.structure \
             IndexSort",
        ));
    }
    if scales.least_cell < CELLS_WITH_AIR * f64::from(scene.particle_spacing) {
        return Err(not_together(
            "air",
            "such a small average_neighbours",
            "the support radius must be at least 1.75 particle spacings, so that air particles spawned in one step \
             keep their distance; increase average_neighbours",
        ));
    }
    Ok(())
}

fn support(scene: &Scene) -> Result<(), SceneError> {
    let Some(range) = scene.model.variable_support else { return Ok(()) };
    bounded("model.variable_support.smallest", range.smallest, 0.5..=1.0)?;
    bounded("model.variable_support.largest", range.largest, 1.0..=2.0)
}

/// Rejects what does not go with wall particles that repel.
fn repelling_walls(scene: &Scene) -> Result<(), SceneError> {
    let model = &scene.model;
    let repels = model.wall_pressure.repels();
    if !repels && model.wall_rigidity != Formulation::default().wall_rigidity {
        return Err(not_together(
            "model.wall_rigidity",
            "a model.wall_pressure other than LennardJones or KernelForce",
            "nothing uses it; omit it, or choose one of these",
        ));
    }
    let refused = [
        (model.density_diffusion == DensityDiffusion::Renormalised, "model.density_diffusion Renormalised"),
        (scene.corrects_pressure(), "model.pressure_solver PressureCorrection"),
        (model.internal_energy, "model.internal_energy"),
    ];
    let first = refused.into_iter().find(|(is_asked, _)| *is_asked && repels && scene.has_wall_particles());
    first.map_or(Ok(()), |(_, field)| {
        Err(not_together(
            field,
            "model.wall_pressure LennardJones or KernelForce",
            "walls that repel have no density and no pressure; use wall_pressure Extrapolated",
        ))
    })
}
