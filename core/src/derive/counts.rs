//! Counts of a scene: particles, nodes of its acceleration field, spring ends. They are computed so that no scene makes
//! them overflow.
use super::emission::points;
use super::frames::Own;
use super::lattice_sums::MOST_SPACINGS;
use super::sampling::lattice::particles;
use super::sampling::solids::solid_count;
use super::sampling::walls::{wall_count, wall_layers};
use super::scales::Scales;
use crate::scene::{AccelerationField, Block, Dimension, Scene};

/// Number of particles in a scene.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Counts {
    /// Fluid particles.
    pub(crate) fluid: u64,
    /// Wall particles.
    pub(crate) walls: u64,
    /// Particles of solids.
    pub(crate) solids: u64,
    /// Particles that are inactive at the start.
    pub(crate) inactive: u64,
    /// Points of all emitters.
    pub(crate) emitter_points: u64,
    /// Layers of particles in a wall.
    pub(crate) wall_layers: u32,
}

impl Counts {
    /// Counts the particles of any scene, checked or not.
    pub(crate) fn of(scene: &Scene, scales: &Scales) -> Counts {
        let wall_layers = wall_layers(scene, scales);
        let add = |all: u64, more: u64| all.saturating_add(more);
        let own = Own::of(scene);
        let frames = own.frames(scene);
        let solids = 0..scene.solids.len();
        Counts {
            fluid: scene.blocks.iter().map(|block| particles(block, scene, frames)).fold(0, add),
            walls: scene.walls.iter().map(|wall| wall_count(wall, scene, wall_layers)).fold(0, add),
            solids: solids.map(|number| solid_count(number, scene, wall_layers, frames)).fold(0, add),
            inactive: scene.inactive_at_start() as u64,
            emitter_points: scene.emitters.iter().map(|emitter| points(scene, emitter).count() as u64).fold(0, add),
            wall_layers,
        }
    }

    /// Number of all particles.
    pub(crate) fn all(&self) -> u64 {
        [self.walls, self.solids, self.inactive].into_iter().fold(self.fluid, u64::saturating_add)
    }
}

/// Nodes of the acceleration field supplied by the caller along x, y, z, and in total.
pub(crate) fn field_counts(scene: &Scene) -> [u32; 4] {
    let Some(AccelerationField { counts: [x, y, z], .. }) = scene.acceleration_field else { return [0; 4] };
    let z = if scene.dimension == Dimension::Two { 1 } else { z };
    [x, y, z, x.saturating_mul(y).saturating_mul(z)]
}

/// Number of spring ends that there is room for, two per spring.
pub(crate) fn spring_ends(scene: &Scene, scales: &Scales) -> usize {
    if let Some(capacity) = scene.elasticity.capacity {
        return (capacity as usize).saturating_mul(2);
    }
    let elastic = |block: &&Block| scene.fluid_of(block.fluid).elastic_stiffness > 0.0;
    let blocks = || scene.blocks.iter().filter(elastic);
    let jitter = blocks().map(|block| block.jitter).fold(0.0, f32::max);
    let own = Own::of(scene);
    let particles =
        blocks().map(|block| particles(block, scene, own.frames(scene))).fold(0, u64::saturating_add) as usize;
    particles.saturating_mul(springs_of_particle(scene, scales, jitter).min(particles.saturating_sub(1)))
}

/// Number of particles to which a particle inside a lattice with this jitter can be joined.
pub(crate) fn springs_of_particle(scene: &Scene, scales: &Scales, jitter: f32) -> usize {
    let d = scene.dimension.count();
    // each of two particles may move by half of the jitter towards the other along each axis
    let shaken = f64::from(jitter) * libm::sqrt(d as f64);
    let reach = f64::from(scene.elasticity.reach).min(scales.spacings(scene)) + shaken;
    let far = reach.min(MOST_SPACINGS) as i64;
    let layers = if d == 3 { far } else { 0 };
    let within = |x: i64, y: i64, z: i64| (x * x + y * y + z * z) as f64 <= reach * reach * (1.0 + 1e-6);
    let lines = (-layers..=layers).flat_map(|z| (-far..=far).map(move |y| (y, z)));
    let all = lines.map(|(y, z)| (-far..=far).filter(|&x| within(x, y, z)).count()).sum::<usize>();
    // without the particle itself
    all.saturating_sub(1)
}
