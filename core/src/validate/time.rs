//! How time may be stepped: bounds of an adaptive step, and what goes with which integrator.
use super::bounds::{field, finite, not_together, positive};
use crate::error::SceneError;
use crate::scene::{AdaptiveTimeStep, Integrator, Scene, Viscosity};

/// The bounds of an adaptive step.
pub(super) fn step_lengths(scene: &Scene) -> Result<(), SceneError> {
    if let Some(courant) = scene.stiffness_for_time_step {
        positive("stiffness_for_time_step", courant)?;
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
    let bounds = [
        ("adaptive.largest", adaptive.largest, adaptive.smallest, f32::MAX),
        ("adaptive.max_growth", adaptive.max_growth, 1.0, f32::MAX),
        ("adaptive.reject_ratio", adaptive.reject_ratio.unwrap_or(1.0), 1.0, f32::MAX),
        ("time_step", scene.time_step, adaptive.smallest, adaptive.largest),
    ];
    for (field, value, least, most) in bounds {
        if !(least..=most).contains(&value) {
            return Err(SceneError::OutOfBounds { field, value, least, most });
        }
    }
    Ok(())
}

/// What goes with the integrator.
pub(super) fn integrator(scene: &Scene) -> Result<(), SceneError> {
    let model = &scene.model;
    let changes = model.integrator.allows_changing_steps();
    let corrects = scene.corrects_pressure();
    if let Some(AdaptiveTimeStep { speed, acceleration, sound, viscosity, .. }) = scene.adaptive {
        if !changes {
            return Err(not_together(
                "adaptive",
                "a model.integrator Verlet or one of Beeman's",
                "what it remembers of the step before is of a step of the same length",
            ));
        }
        if [speed, acceleration, sound, viscosity].iter().all(Option::is_none) {
            return Err(not_together("adaptive", "no criterion", "there is nothing for the time step to follow"));
        }
        if model.viscosity == Viscosity::VelocityExchange || scene.model.radial_exchange > 0.0 {
            return Err(not_together(
                "adaptive",
                "exchanges of velocity",
                "their shares are of a step, so that with its length the viscosity would change",
            ));
        }
    }
    if scene.air.is_some() && !changes {
        return Err(not_together(
            "air",
            "a model.integrator Verlet or one of Beeman's",
            "air that has just been made has no step before to remember",
        ));
    }
    let drifts = matches!(model.integrator, Integrator::ModifiedVelocityVerlet | Integrator::SemiImplicitEuler);
    if corrects && !drifts {
        return Err(not_together(
            "model.pressure_solver PressureCorrection",
            "a model.integrator other than ModifiedVelocityVerlet or SemiImplicitEuler",
            "pressure is iterated for the velocity that these drift with",
        ));
    }
    if model.reevaluate {
        if matches!(model.integrator, Integrator::Euler | Integrator::SemiImplicitEuler) {
            return Err(not_together(
                "model.reevaluate",
                "one of Euler's for model.integrator",
                "forces are evaluated with the velocity at the end of the step already",
            ));
        }
        if matches!(model.integrator, Integrator::Clavet | Integrator::PositionCorrectedBeeman) {
            return Err(not_together(
                "model.reevaluate",
                "a model.integrator Clavet or PositionCorrectedBeeman",
                "it moves particles after the forces, so that neighbours would have to be found again",
            ));
        }
        if corrects {
            return Err(not_together(
                "model.reevaluate",
                "model.pressure_solver PressureCorrection",
                "the pressure was iterated for the forces without it",
            ));
        }
    }
    stiffness(scene)
}

fn stiffness(scene: &Scene) -> Result<(), SceneError> {
    if scene.stiffness_for_time_step.is_none() {
        return Ok(());
    }
    if scene.adaptive.is_some() {
        return Err(not_together(
            "stiffness_for_time_step",
            "adaptive",
            "either the stiffness follows from the time step or the time step from the stiffness",
        ));
    }
    if let Some(number) = scene.fluids.iter().position(|fluid| fluid.stiffness.is_some()) {
        return Err(not_together("stiffness_for_time_step", field!(number, "stiffness"), "it already says how stiff"));
    }
    if scene.corrects_pressure() {
        return Err(not_together(
            "stiffness_for_time_step",
            "model.pressure_solver PressureCorrection",
            "sound that is iterated for does not limit the time step",
        ));
    }
    Ok(())
}
