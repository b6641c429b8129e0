//! A layer of air around the liquid (Pirovano, section 3.4.2, who did not finish this idea).

/// Air particles that the solver spawns beside liquid particles exposed at a free surface, and makes inactive again
/// where they have lost contact with the liquid (Pirovano, section 3.4.2; where and when air is spawned is our
/// choice).
///
/// A layer of air corrects the density of the outermost liquid particles, which is too low at a free surface. It needs
/// [`GridStructure::IndexSort`](super::GridStructure::IndexSort), an integrator without a history
/// ([`Integrator::allows_changing_steps`](super::Integrator::allows_changing_steps)) and a support radius of at least
/// 1.75 particle spacings.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub struct Air {
    /// Index of the air in [`Scene::fluids`](super::Scene::fluids), at least 1: fluid 0 is the liquid, to which the
    /// scene's constants refer. The air must not be elastic. A low speed of sound is advisable: air as stiff as the
    /// liquid spawns until none is left.
    pub fluid: u32,
    /// Largest number of air particles, at least 1. Inactive ones take memory, but hardly any time. Increase it if
    /// [`AirReport::refused`](crate::AirReport::refused) is not 0.
    pub capacity: u32,
    /// Length of the normal, times the support radius, above which a liquid particle counts as exposed and spawns an
    /// air particle, one particle spacing away along the outward normal; larger than 0. The normal is the gradient of
    /// the colour of all fluids and walls together. Use about 1. With much smaller values a surface that is already
    /// covered by one row of air still counts as exposed.
    pub threshold: f32,
    /// Density over rest density, 0 to 1, below which an air particle becomes inactive.
    pub minimum_density: f32,
}
