//! The refusals that many fields share.
use crate::arithmetic::codes::ROW_BITS;
use crate::error::SceneError;
use crate::scene::Scene;

/// Name of a field of a fluid by number.
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

/// Most particles of a scene: an id shares a word with an axis or a quantity in an error report, and a word holds how many
/// bytes a particle's row is away from the first.
pub(super) const MOST_PARTICLES: u64 = (1 << 28) - 1;

const _: () = assert!(MOST_PARTICLES < 1 << (u32::BITS - ROW_BITS));

pub(super) fn finite(field: &'static str, values: &[f32]) -> Result<(), SceneError> {
    match values.iter().find(|v| !v.is_finite()) {
        Some(&value) => Err(SceneError::NotFinite { field, value }),
        None => Ok(()),
    }
}

pub(super) fn positive(field: &'static str, value: f32) -> Result<(), SceneError> {
    finite(field, &[value])?;
    if value > 0.0 { Ok(()) } else { Err(SceneError::NotPositive { field, value }) }
}

pub(super) fn not_negative(field: &'static str, value: f32) -> Result<(), SceneError> {
    finite(field, &[value])?;
    if value >= 0.0 { Ok(()) } else { Err(SceneError::Negative { field, value }) }
}

pub(super) fn share(field: &'static str, value: f32) -> Result<(), SceneError> {
    finite(field, &[value])?;
    if (0.0..=1.0).contains(&value) { Ok(()) } else { Err(SceneError::NotAShare { field, value }) }
}

/// Refuses the number of a fluid that the scene has not.
pub(super) fn known_fluid(scene: &Scene, field: &'static str, fluid: u32) -> Result<(), SceneError> {
    let fluids = scene.fluids.len() as u32;
    if fluid < fluids { Ok(()) } else { Err(SceneError::NoSuchFluid { field, fluid, fluids }) }
}

/// Refuses more particles than a status word can name.
pub(crate) fn check_count(particles: u64) -> Result<(), SceneError> {
    if particles > MOST_PARTICLES {
        return Err(SceneError::TooManyParticles { particles, most: MOST_PARTICLES });
    }
    Ok(())
}

pub(super) fn not_together(choice: &'static str, other: &'static str, why: &'static str) -> SceneError {
    SceneError::NotTogether { choice, other, why }
}
