//! Checks the shifting of particles and the tensile control.
use super::bounds::not_together;
use crate::error::SceneError;
use crate::scene::{PressureForce, Scene, Shifting};

pub(super) fn check(scene: &Scene) -> Result<(), SceneError> {
    let model = &scene.model;
    if model.shift_across_interfaces && model.shifting != Shifting::Fickian {
        return Err(not_together(
            "model.shift_across_interfaces",
            "a model.shifting other than Fickian",
            "it is unused; turn it off, or use model.shifting Fickian",
        ));
    }
    if model.shifting_speed.is_some() && model.shifting != Shifting::Fickian {
        return Err(not_together(
            "model.shifting_speed",
            "a model.shifting other than Fickian",
            "it is unused; omit it, or use model.shifting Fickian",
        ));
    }
    if model.tensile_control && !model.negative_pressure {
        return Err(not_together(
            "model.tensile_control",
            "model.negative_pressure false",
            "without negative pressure there is no tension; turn one of them off",
        ));
    }
    if model.tensile_control && scene.corrects_pressure() {
        return Err(not_together(
            "model.tensile_control",
            "model.pressure_solver PressureCorrection",
            "its iteration counts on forces that are equal and opposite; turn tensile_control off, or use \
             pressure_solver EquationOfState",
        ));
    }
    let one_sided = matches!(model.pressure_force, PressureForce::Canonical | PressureForce::Difference);
    if model.tensile_control && one_sided {
        return Err(not_together(
            "model.tensile_control",
            "model.pressure_force Canonical or Difference",
            "it changes the sign of a pressure in a sum of two, which these forms do not have; use another \
             pressure_force",
        ));
    }
    Ok(())
}
