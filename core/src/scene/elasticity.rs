//! Springs between the particles of an elastic fluid (Pirovano, section 2.2.6).

/// How particles of a fluid with an [`elastic_stiffness`](super::Fluid::elastic_stiffness) are joined at the start. Springs
/// are made once; none is ever added.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields, default))]
pub struct Elasticity {
    /// Particles of one fluid are joined that are no farther apart than so many spacings (default 1.5: on a lattice the
    /// nearest and the diagonal ones), and inside each other's support.
    pub reach: f32,
    /// Springs at most (default: as many as a lattice needs whose particles are shaken by the blocks' jitter). Blocks of one
    /// fluid that overlap, or touch with their lattices out of step, and places of a host's own may need more.
    pub capacity: Option<u32>,
    /// Do lengths at rest give way to strain? (Clavet et al. 2005, section 5.2; default never.)
    pub plasticity: Option<Plasticity>,
    /// Stretch, over its length at rest, at which a spring breaks for good (default never).
    pub break_at: Option<f32>,
}

impl Default for Elasticity {
    fn default() -> Self {
        Elasticity { reach: 1.5, capacity: None, plasticity: None, break_at: None }
    }
}

/// A length at rest L follows the distance r where strain is larger than the yield: `dL/dt = rate (|r - L| - yield L)`
/// towards r.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub struct Plasticity {
    /// Share of the strain beyond the yield that is lost in a second, 1/s.
    pub rate: f32,
    /// Strain that a spring bears without giving way, over its length at rest.
    pub yield_strain: f32,
}
