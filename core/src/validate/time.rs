//! Checks the time step: bounds of an adaptive step, and what can be combined with which integrator.
use super::bounds::{bounded, finite, not_together, positive};
use crate::error::{Field, SceneError};
use crate::scene::{AdaptiveTimeStep, Integrator, Recovery, Scene, Viscosity};

/// Checks the numbers of an adaptive time step, and the coefficient of a stiffness derived from the time step.
pub(super) fn step_lengths(scene: &Scene) -> Result<(), SceneError> {
    if let Some(courant) = scene.stiffness_for_time_step {
        positive("stiffness_for_time_step", courant)?;
    }
    if scene.recovery != Recovery::Refuse {
        bounded("recovery.times", scene.recovery.times() as f32, 1.0..=Recovery::MOST_TIMES as f32)?;
    }
    let Some(adaptive) = &scene.adaptive else { return Ok(()) };
    let criteria = [
        ("adaptive.speed", adaptive.speed),
        ("adaptive.acceleration", adaptive.acceleration),
        ("adaptive.sound", adaptive.sound),
        ("adaptive.viscosity", adaptive.viscosity),
    ];
    for (field, courant) in criteria {
        courant.map_or(Ok(()), |courant| positive(field, courant))?;
    }
    positive("adaptive.smallest", adaptive.smallest)?;
    finite("adaptive.smallest", &[1.0 / adaptive.smallest])?;
    bounded("adaptive.largest", adaptive.largest, adaptive.smallest..=f32::MAX)?;
    bounded("adaptive.max_growth", adaptive.max_growth, 1.0..=f32::MAX)?;
    bounded("adaptive.reject_ratio", adaptive.reject_ratio.unwrap_or(1.0), 1.0..=f32::MAX)?;
    bounded("time_step", scene.time_step, adaptive.smallest..=adaptive.largest)
}

/// Checks what is combined with the integrator.
pub(super) fn integrator(scene: &Scene) -> Result<(), SceneError> {
    let model = &scene.model;
    let changes = model.integrator.allows_changing_steps();
    let corrects = scene.corrects_pressure();
    if let Some(AdaptiveTimeStep { speed, acceleration, sound, viscosity, .. }) = scene.changing_step() {
        let choice = if scene.adaptive.is_some() { "adaptive" } else { "recovery ShortenStep" };
        if !changes {
            return Err(not_together(
                choice,
                "model.integrator Verlet or any variant of Beeman",
                "their history of the last step assumes steps of equal length; use another integrator, such as \
                 ModifiedVelocityVerlet",
            ));
        }
        if scene.adaptive.is_some() && [speed, acceleration, sound, viscosity].iter().all(Option::is_none) {
            return Err(not_together(
                "adaptive",
                "all criteria off",
                "set its speed, acceleration, sound or viscosity",
            ));
        }
        if model.viscosity == Viscosity::VelocityExchange || scene.model.radial_exchange > 0.0 {
            return Err(not_together(
                choice,
                "model.viscosity VelocityExchange or a model.radial_exchange above 0",
                "these exchange a share of velocity per step, so the viscosity would change with the time step; use \
                 another viscosity and set radial_exchange to 0",
            ));
        }
    }
    if scene.air.is_some() && !changes {
        return Err(not_together(
            "air",
            "model.integrator Verlet or any variant of Beeman",
            "they need a history of the last step, which new air particles do not have; use another integrator, such \
             as ModifiedVelocityVerlet",
        ));
    }
    let drifts = matches!(model.integrator, Integrator::ModifiedVelocityVerlet | Integrator::SemiImplicitEuler);
    if corrects && !drifts {
        return Err(not_together(
            "model.pressure_solver PressureCorrection",
            "a model.integrator other than ModifiedVelocityVerlet or SemiImplicitEuler",
            "pressure is iterated for the velocity with which these two move the particles; use one of them",
        ));
    }
    if model.reevaluate {
        if matches!(model.integrator, Integrator::Euler | Integrator::SemiImplicitEuler) {
            return Err(not_together(
                "model.reevaluate",
                "model.integrator Euler or SemiImplicitEuler",
                "these already evaluate forces with the velocity at the end of the step; turn reevaluate off",
            ));
        }
        if matches!(model.integrator, Integrator::Clavet | Integrator::PositionCorrectedBeeman) {
            return Err(not_together(
                "model.reevaluate",
                "model.integrator Clavet or PositionCorrectedBeeman",
                "these move particles after the forces, so neighbours would have to be found again; turn reevaluate \
                 off, or use another integrator",
            ));
        }
        if corrects {
            return Err(not_together(
                "model.reevaluate",
                "model.pressure_solver PressureCorrection",
                "the pressure is iterated for the forces of the first evaluation; turn reevaluate off",
            ));
        }
    }
    stiffness(scene)
}

/// Checks what is combined with a stiffness derived from the time step.
fn stiffness(scene: &Scene) -> Result<(), SceneError> {
    if scene.stiffness_for_time_step.is_none() {
        return Ok(());
    }
    if scene.adaptive.is_some() {
        return Err(not_together(
            "stiffness_for_time_step",
            "adaptive",
            "one derives the stiffness from the time step, the other the time step from the stiffness; omit one of \
             them",
        ));
    }
    if let Some(number) = scene.fluids.iter().position(|fluid| fluid.stiffness.is_some()) {
        return Err(not_together(
            "stiffness_for_time_step",
            Field::of_item("fluids.stiffness", number),
            "omit one of the two",
        ));
    }
    if scene.corrects_pressure() {
        return Err(not_together(
            "stiffness_for_time_step",
            "model.pressure_solver PressureCorrection",
            "with a pressure solver the speed of sound does not limit the time step; omit stiffness_for_time_step",
        ));
    }
    Ok(())
}
