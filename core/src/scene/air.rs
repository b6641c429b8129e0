//! A coat of air around the liquid (Pirovano, section 3.4.2, an idea that the thesis did not finish).

/// Air that is made where a surface is bare, and goes where it has lost the liquid.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub struct Air {
    /// Which of the scene's fluids is the air; not the first, which is the liquid that the scene's constants are of.
    pub fluid: u32,
    /// Particles of air at most. Those that are not needed take memory and no time.
    pub capacity: u32,
    /// Length of the normal of all that is there, over one over the support radius, above which a particle of liquid is bare
    /// and gets one of air beside it, a spacing away. About 1: much less, and a surface with one row of air still counts as bare.
    pub threshold: f32,
    /// Share of its density at rest below which a particle of air vanishes.
    pub minimum_density: f32,
}
