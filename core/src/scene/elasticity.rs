//! Springs between the particles of an elastic fluid (S0 section 2.2.6).
use super::lattice::counts;
use super::{Block, Scene};
use crate::guided::support_radius;
use crate::lattice_sums::MOST_SPACINGS;

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

impl Scene {
    /// Ends of springs that there is room for, two a spring.
    #[must_use]
    pub fn spring_ends(&self) -> usize {
        if let Some(capacity) = self.elasticity.capacity {
            return (capacity as usize).saturating_mul(2);
        }
        let elastic = |block: &&Block| self.fluid_of(block.fluid).elastic_stiffness > 0.0;
        let blocks = || self.blocks.iter().filter(elastic);
        let jitter = blocks().map(|block| block.jitter).fold(0.0, f32::max);
        let particles: u64 = blocks().map(|block| counts(block, self).iter().product::<u64>()).sum();
        let particles = particles as usize;
        particles.saturating_mul(self.joined(jitter).min(particles.saturating_sub(1)))
    }

    /// Springs at a particle inside of a lattice.
    #[must_use]
    pub fn springs_of_particle(&self) -> usize {
        self.joined(0.0)
    }

    /// Particles of a lattice, shaken by so much, that a particle of it can be joined to.
    fn joined(&self, jitter: f32) -> usize {
        let d = self.dimension.count();
        let support = support_radius(self) / f64::from(self.particle_spacing);
        // each of two particles may come nearer along each axis by half of the jitter
        let shaken = f64::from(jitter) * libm::sqrt(d as f64);
        let reach = f64::from(self.elasticity.reach).min(support) + shaken;
        let far = reach.min(MOST_SPACINGS) as i64;
        let layers = if d == 3 { far } else { 0 };
        let within = |x: i64, y: i64, z: i64| (x * x + y * y + z * z) as f64 <= reach * reach * (1.0 + 1e-6);
        let lines = (-layers..=layers).flat_map(|z| (-far..=far).map(move |y| (y, z)));
        lines.map(|(y, z)| (-far..=far).filter(|&x| within(x, y, z)).count()).sum::<usize>() - 1
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
