//! The lattice on which particles start. Its spacing is the scene's particle spacing.
use crate::scene::{Block, Dimension, Scene};

/// Number of particles of a block along x, y, z. Each number is rounded before they are multiplied.
pub(crate) fn counts(block: &Block, scene: &Scene) -> [u64; 3] {
    let along = |axis: usize| {
        if axis == 2 && scene.dimension == Dimension::Two { 1 } else { whole(block.size[axis], scene) }
    };
    [along(0), along(1), along(2)]
}

/// Product of the counts along each axis.
pub(crate) fn volume(counts: [u64; 3]) -> u64 {
    counts.iter().fold(1, |all, &n| all.saturating_mul(n))
}

/// A length as a whole number of spacings.
pub(crate) fn whole(length: f32, scene: &Scene) -> u64 {
    let count = f64::from(length) / f64::from(scene.particle_spacing);
    if count > 0.0 { (count + 0.5) as u64 } else { 0 }
}

/// All index triples below `counts`, the first index fastest.
pub(crate) fn indices(counts: [u64; 3]) -> impl Iterator<Item = [u64; 3]> {
    let [nx, ny, nz] = counts;
    (0..nz).flat_map(move |z| (0..ny).flat_map(move |y| (0..nx).map(move |x| [x, y, z])))
}
