//! Rejects what the half stencil does not support.
use super::bounds::not_together;
use crate::error::SceneError;
use crate::scene::{DensityForm, PressureForce, Scene, Shifting, SurfaceTension, Traversal, Viscosity};

/// Rejects scenes with the half stencil in which the contributions of a pair to its two particles differ, or in which
/// another pass needs all neighbours of a particle.
pub(super) fn check(scene: &Scene) -> Result<(), SceneError> {
    if scene.grid.traversal == Traversal::FullStencil {
        return Ok(());
    }
    let model = &scene.model;
    let alike = "it derives the contribution of a pair to one particle from that to the other, which is not possible \
                 here; use FullStencil";
    let once = "it computes each pair once, and this needs another pass over all neighbours of a particle; use \
                FullStencil";
    let refused = [
        (
            matches!(model.pressure_force, PressureForce::Canonical | PressureForce::Difference),
            "model.pressure_force Canonical or Difference",
            alike,
        ),
        (!scene.walls.is_empty(), "walls", alike),
        (scene.has_wall_particles(), "solids[].model Particles", alike),
        (
            model.initialize_hydrostatic
                && matches!(model.surface_tension, SurfaceTension::Attraction | SurfaceTension::GradientSum),
            "model.initialize_hydrostatic and model.surface_tension Attraction or GradientSum",
            alike,
        ),
        (model.variable_support.is_some(), "model.variable_support", "it searches with one radius; use FullStencil"),
        (
            matches!(model.density, DensityForm::Continuity | DensityForm::ContinuityAdapted),
            "model.density Continuity or ContinuityAdapted",
            "its density pass uses distances only, and these need velocities; use FullStencil",
        ),
        (scene.corrects_pressure(), "model.pressure_solver PressureCorrection", once),
        (
            matches!(model.surface_tension, SurfaceTension::Curvature | SurfaceTension::NormalCurvature),
            "model.surface_tension Curvature or NormalCurvature",
            once,
        ),
        (model.surface_normals, "model.surface_normals", once),
        (model.internal_energy, "model.internal_energy", once),
        (model.viscosity == Viscosity::VelocityExchange, "model.viscosity VelocityExchange", once),
        (model.radial_exchange != 0.0, "model.radial_exchange", once),
        (model.xsph != 0.0, "model.xsph", once),
        (model.shifting != Shifting::Off, "model.shifting", once),
        (model.tensile_control, "model.tensile_control", once),
        (scene.air.is_some(), "air", once),
        (!scene.emitters.is_empty(), "emitters", once),
        (!scene.drains.is_empty(), "drains", once),
        (scene.spare_particles > 0, "spare_particles", once),
    ];
    let first = refused.into_iter().find(|(is_asked, ..)| *is_asked);
    first.map_or(Ok(()), |(_, other, why)| Err(not_together("grid.traversal HalfStencil", other, why)))
}
