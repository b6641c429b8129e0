//! Checks that are shared by many fields.
use crate::arithmetic::codes::ROW_BITS;
use crate::error::SceneError;
use crate::scene::Scene;

/// Path of a field of the fluid with this number, such as `fluids[1].rest_density`.
macro_rules! field {
    ($number:expr, $name:literal) => {
        $crate::validate::bounds::field!(@ $number, $name, "0" "1" "2" "3" "4" "5" "6" "7")
    };
    (@ $number:expr, $name:literal, $($fluid:literal)*) => {{
        const NAMES: [&str; $crate::scene::FLUIDS] = [$(concat!("fluids[", $fluid, "].", $name)),*];
        NAMES[$number.min(NAMES.len() - 1)]
    }};
}
pub(super) use field;

/// Largest number of particles in a scene. There are two reasons: an error report stores an id and an axis or a
/// quantity in one word of 32 bits, and the offset of a particle's row in bytes must fit into such a word too.
pub(super) const MOST_PARTICLES: u64 = (1 << 28) - 1;

const _: () = assert!(MOST_PARTICLES < 1 << (u32::BITS - ROW_BITS));

/// Rejects values that are not finite.
pub(super) fn finite(field: &'static str, values: &[f32]) -> Result<(), SceneError> {
    match values.iter().find(|v| !v.is_finite()) {
        Some(&value) => Err(SceneError::NotFinite { field, value }),
        None => Ok(()),
    }
}

/// Rejects a value that is not finite or not larger than 0.
pub(super) fn positive(field: &'static str, value: f32) -> Result<(), SceneError> {
    finite(field, &[value])?;
    if value > 0.0 { Ok(()) } else { Err(SceneError::NotPositive { field, value }) }
}

/// Rejects a value that is not finite or is negative.
pub(super) fn not_negative(field: &'static str, value: f32) -> Result<(), SceneError> {
    finite(field, &[value])?;
    if value >= 0.0 { Ok(()) } else { Err(SceneError::Negative { field, value }) }
}

/// Rejects a value that is not between 0 and 1.
pub(super) fn share(field: &'static str, value: f32) -> Result<(), SceneError> {
    finite(field, &[value])?;
    if (0.0..=1.0).contains(&value) { Ok(()) } else { Err(SceneError::NotAShare { field, value }) }
}

/// Rejects the index of a fluid that the scene does not have.
pub(super) fn known_fluid(scene: &Scene, field: &'static str, fluid: u32) -> Result<(), SceneError> {
    let fluids = scene.fluids.len() as u32;
    if fluid < fluids { Ok(()) } else { Err(SceneError::NoSuchFluid { field, fluid, fluids }) }
}

/// Rejects more than [`MOST_PARTICLES`] particles.
pub(crate) fn check_count(particles: u64) -> Result<(), SceneError> {
    if particles > MOST_PARTICLES {
        return Err(SceneError::TooManyParticles { particles, most: MOST_PARTICLES });
    }
    Ok(())
}

/// Returns the error of two settings that cannot be combined; `why` gives the reason and what to change.
pub(super) fn not_together(choice: &'static str, other: &'static str, why: &'static str) -> SceneError {
    SceneError::NotTogether { choice, other, why }
}
