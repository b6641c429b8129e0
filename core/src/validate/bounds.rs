//! Checks that are shared by many fields.
use crate::arithmetic::codes::ROW_BITS;
use crate::error::{Field, SceneError};
use crate::scene::Scene;
use core::ops::RangeInclusive;

/// Largest number of particles in a scene. There are two reasons: an error report stores an id and an axis or a
/// quantity in one word of 32 bits, and the offset of a particle's row in bytes must fit into such a word too.
pub(super) const MOST_PARTICLES: u64 = (1 << 28) - 1;

const _: () = assert!(MOST_PARTICLES < 1 << (u32::BITS - ROW_BITS));

/// Rejects values that are not finite.
pub(super) fn finite(field: impl Into<Field>, values: &[f32]) -> Result<(), SceneError> {
    match values.iter().find(|v| !v.is_finite()) {
        Some(&value) => Err(SceneError::NotFinite { field: field.into(), value }),
        None => Ok(()),
    }
}

/// Rejects a value that is not finite or not larger than 0.
pub(super) fn positive(field: impl Into<Field>, value: f32) -> Result<(), SceneError> {
    let field = field.into();
    finite(field, &[value])?;
    if value > 0.0 { Ok(()) } else { Err(SceneError::NotPositive { field, value }) }
}

/// Rejects a value that is not finite or is negative.
pub(super) fn not_negative(field: impl Into<Field>, value: f32) -> Result<(), SceneError> {
    let field = field.into();
    finite(field, &[value])?;
    if value >= 0.0 { Ok(()) } else { Err(SceneError::Negative { field, value }) }
}

/// Rejects a value that is not between 0 and 1.
pub(super) fn share(field: impl Into<Field>, value: f32) -> Result<(), SceneError> {
    let field = field.into();
    finite(field, &[value])?;
    if (0.0..=1.0).contains(&value) { Ok(()) } else { Err(SceneError::NotAShare { field, value }) }
}

/// Rejects a value outside of its bounds.
pub(super) fn bounded(field: impl Into<Field>, value: f32, bounds: RangeInclusive<f32>) -> Result<(), SceneError> {
    let (field, least, most) = (field.into(), *bounds.start(), *bounds.end());
    if bounds.contains(&value) { Ok(()) } else { Err(SceneError::OutOfBounds { field, value, least, most }) }
}

/// Rejects the index of a fluid that the scene does not have.
pub(super) fn known_fluid(scene: &Scene, field: impl Into<Field>, fluid: u32) -> Result<(), SceneError> {
    let fluids = scene.fluids.len() as u32;
    if fluid < fluids { Ok(()) } else { Err(SceneError::NoSuchFluid { field: field.into(), fluid, fluids }) }
}

/// Rejects more than [`MOST_PARTICLES`] particles.
pub(crate) fn check_count(particles: u64) -> Result<(), SceneError> {
    if particles > MOST_PARTICLES {
        return Err(SceneError::TooManyParticles { particles, most: MOST_PARTICLES });
    }
    Ok(())
}

/// Returns the error of two settings that cannot be combined; `why` gives the reason and what to change.
pub(crate) fn not_together(choice: impl Into<Field>, other: impl Into<Field>, why: &'static str) -> SceneError {
    SceneError::NotTogether { choice: choice.into(), other: other.into(), why }
}
