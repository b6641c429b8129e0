//! Where particles are at the start: cell centres of a lattice, block after block, x fastest.
use super::{Block, Dimension, Scene};

/// One particle at the start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// Where, m.
    pub position: [f32; 3],
    /// How fast, m/s.
    pub velocity: [f32; 3],
}

/// Particles of a block along x, y, z. Each count is rounded before they are multiplied.
pub(super) fn counts(block: &Block, scene: &Scene) -> [u64; 3] {
    let along = |axis: usize| {
        if axis == 2 && scene.dimension == Dimension::Two {
            return 1;
        }
        let count = f64::from(block.size[axis]) / f64::from(scene.particle_spacing);
        if count > 0.0 { (count + 0.5) as u64 } else { 0 }
    };
    [along(0), along(1), along(2)]
}

/// Every particle of a scene that [`Scene::check`] accepts, in order of its id.
pub fn places(scene: &Scene) -> impl Iterator<Item = Place> {
    // a linear congruential generator (Numerical Recipes): any fixed sequence will do
    let mut seed = 1u32;
    let mut random = move || {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(seed >> 8) / f64::from(1u32 << 24) - 0.5
    };
    let spacing = f64::from(scene.particle_spacing);
    scene.blocks.iter().flat_map(|block| indices(counts(block, scene)).map(move |index| (block, index))).map(
        move |(block, index)| {
            let mut position = [0.0; 3];
            for axis in 0..scene.dimension.count() {
                let centre = f64::from(block.corner[axis]) + (index[axis] as f64 + 0.5) * spacing;
                let shift = if block.jitter > 0.0 { random() * f64::from(block.jitter) * spacing } else { 0.0 };
                position[axis] = (centre + shift) as f32;
            }
            Place { position, velocity: block.velocity }
        },
    )
}

/// All triples below `counts`, the first one fastest.
fn indices(counts: [u64; 3]) -> impl Iterator<Item = [u64; 3]> {
    let [nx, ny, nz] = counts;
    (0..nz).flat_map(move |z| (0..ny).flat_map(move |y| (0..nx).map(move |x| [x, y, z])))
}
