//! Refuses what the half stencil cannot do.
use super::bounds::not_together;
use crate::error::SceneError;
use crate::scene::{DensityForm, PressureForce, Scene, SurfaceTension, Traversal, Viscosity};

pub(super) fn check(scene: &Scene) -> Result<(), SceneError> {
    if scene.grid.traversal == Traversal::FullStencil {
        return Ok(());
    }
    let model = &scene.model;
    let alike = "it takes what a pair adds to one particle from what it adds to the other, which here differ";
    let once = "it computes each pair once, and this takes another look at all of a particle's neighbours";
    let refused = [
        (
            matches!(model.pressure_force, PressureForce::Canonical | PressureForce::Difference),
            "a canonical or difference model.pressure_force",
            alike,
        ),
        (!scene.walls.is_empty(), "walls of particles", alike),
        (
            model.initialize_hydrostatic
                && matches!(model.surface_tension, SurfaceTension::Attraction | SurfaceTension::GradientSum),
            "model.initialize_hydrostatic and a model.surface_tension between pairs",
            alike,
        ),
        (model.variable_support.is_some(), "model.variable_support", "it searches by one support for all"),
        (
            matches!(model.density, DensityForm::Continuity | DensityForm::ContinuityAdapted),
            "a model.density that is stepped",
            "it sums what follows from distances, and this needs velocities",
        ),
        (scene.corrects_pressure(), "model.pressure_solver PressureCorrection", once),
        (
            matches!(model.surface_tension, SurfaceTension::Curvature | SurfaceTension::NormalCurvature),
            "a model.surface_tension by curvature",
            once,
        ),
        (model.surface_normals, "model.surface_normals", once),
        (model.internal_energy, "model.internal_energy", once),
        (model.viscosity == Viscosity::VelocityExchange, "model.viscosity Exchange", once),
        (model.radial_exchange != 0.0, "model.radial_exchange", once),
        (model.xsph != 0.0, "model.xsph", once),
        (scene.air.is_some(), "air", once),
    ];
    let first = refused.into_iter().find(|(is_asked, ..)| *is_asked);
    first.map_or(Ok(()), |(_, other, why)| Err(not_together("grid.traversal HalfStencil", other, why)))
}
