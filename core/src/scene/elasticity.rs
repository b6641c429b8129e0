//! Springs between the particles of an elastic fluid (Pirovano, section 2.2.6).

/// How springs join the particles of a fluid with an [`elastic_stiffness`](super::Fluid::elastic_stiffness). Springs
/// are created once, at the start; no spring is added later.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields, default))]
pub struct Elasticity {
    /// Largest distance at which two particles of one fluid are joined, in particle spacings, larger than 0 (default
    /// 1.5: on a lattice these are the nearest particles and those diagonal to them in a plane). The two must also be
    /// inside each other's support. A larger reach makes a stiffer and more expensive body.
    pub reach: f32,
    /// Largest number of springs (default `None`: enough for the lattices of the blocks, with their jitter). Blocks of
    /// one fluid that overlap, or that touch with lattices that do not match, and particles placed by the caller may
    /// need more.
    pub capacity: Option<u32>,
    /// How rest lengths change under strain (Clavet et al. 2005, section 5.2; default `None`: never).
    pub plasticity: Option<Plasticity>,
    /// Elongation over rest length above which a spring breaks for good, larger than 0 (default `None`: never).
    pub break_at: Option<f32>,
}

impl Default for Elasticity {
    fn default() -> Self {
        Elasticity { reach: 1.5, capacity: None, plasticity: None, break_at: None }
    }
}

/// Plastic flow of springs: where the strain exceeds the yield strain, the rest length L approaches the distance r of
/// the two ends at the speed `rate (|r - L| - yield_strain L)` (Clavet et al. 2005, section 5.2).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub struct Plasticity {
    /// Rate at which the strain beyond the yield strain decays, 1/s, larger than 0 and at most one over the longest
    /// time step, because a step may not remove more than all of the strain.
    pub rate: f32,
    /// Strain up to which a spring is elastic: change of length over rest length, 0 or more.
    pub yield_strain: f32,
}
