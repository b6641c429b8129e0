//! Checks that the constants derived from a scene are finite and positive as f32.
use crate::derive::Derived;
use crate::error::{Field, SceneError};
use crate::scene::Scene;

/// Rejects derived constants that f32 cannot represent; the error names the field from which they are derived.
pub(super) fn check(scene: &Scene, derived: &Derived) -> Result<(), SceneError> {
    let (p, materials) = (&derived.parameters, &derived.materials);
    let scale = |field, value, derived: &[f32]| {
        let fine = derived.iter().all(|d| d.is_finite() && *d > 0.0);
        if fine { Ok(()) } else { Err(SceneError::OutOfScale { field, value }) }
    };
    for (number, (fluid, constants)) in scene.fluids.iter().zip(&derived.fluids).enumerate() {
        let [state, near, ..] = materials.states[number];
        let [pressure_response, offset, compressibility, _] = materials.corrections[number];
        let correction = pressure_response * scene.time_step * scene.time_step + offset;
        scale(Field::of_item("fluids.speed_of_sound", number), fluid.speed_of_sound, &[state, compressibility])?;
        if !near.is_finite() || (near == 0.0 && constants.near_stiffness > 0.0) {
            let (field, value) = match fluid.near_stiffness {
                Some(stiffness) => (Field::of_item("fluids.near_stiffness", number), stiffness),
                None => (Field::of_item("fluids.speed_of_sound", number), fluid.speed_of_sound),
            };
            return Err(SceneError::OutOfScale { field, value });
        }
        scale("time_step".into(), scene.time_step, &[correction, 1.0 / correction])?;
        scale(Field::of_item("fluids.rest_density", number), fluid.rest_density, &[materials.properties[number][2]])?;
        if fluid.elastic_stiffness > 0.0 {
            let pull = constants.spring_pull as f32;
            scale(Field::of_item("fluids.elastic_stiffness", number), fluid.elastic_stiffness, &[pull])?;
        }
    }
    scale("time_step".into(), scene.time_step, &[derived.step.inverse_time_step])?;
    scale("fluids[0].rest_density".into(), scene.first_fluid().rest_density, &[p.particle_mass])?;
    let of_length = [
        p.density_constant,
        p.inverse_cell[0],
        p.inverse_support_squared,
        p.continuity_constant,
        p.pressure_constant,
        p.near_constant,
        p.viscosity_laplacian_constant,
    ];
    scale("particle_spacing".into(), scene.particle_spacing, &of_length)
}
