//! Where particles are at the start: cell centres of a lattice, block after block, then wall after wall, x fastest; last
//! the air that is not there.
use super::walls::wall_places;
use super::{Block, DORMANT, Dimension, FIRST_BLOCK, Scene};
use crate::guided::hydrostatic_deviation;

/// One particle at the start. Its thermal energy is the fluid's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// Where, m.
    pub position: [f32; 3],
    /// How fast, m/s; of a wall's, how fast its surface slides.
    pub velocity: [f32; 3],
    /// Which of the scene's kinds of particle: a fluid's is its number ([`kind_of`](super::kind_of)).
    pub species: u32,
    /// Mass over that of a particle of its fluid at rest.
    pub mass: f32,
    /// Density over the rest density, less one.
    pub deviation: f32,
    /// Pressure, Pa: where a pressure correction begins.
    pub pressure: f32,
}

impl Place {
    /// A particle of the first fluid, at rest density.
    #[must_use]
    pub fn at(position: [f32; 3], velocity: [f32; 3]) -> Place {
        Place::of_fluid(0, position, velocity)
    }

    /// A particle of a fluid by number, at rest density.
    #[must_use]
    pub fn of_fluid(fluid: u32, position: [f32; 3], velocity: [f32; 3]) -> Place {
        Place { position, velocity, species: fluid, mass: 1.0, deviation: 0.0, pressure: 0.0 }
    }
}

/// Particles of a block along x, y, z. Each count is rounded before they are multiplied.
pub(super) fn counts(block: &Block, scene: &Scene) -> [u64; 3] {
    let along = |axis: usize| {
        if axis == 2 && scene.dimension == Dimension::Two { 1 } else { whole(block.size[axis], scene) }
    };
    [along(0), along(1), along(2)]
}

/// A length in whole spacings.
pub(super) fn whole(length: f32, scene: &Scene) -> u64 {
    let count = f64::from(length) / f64::from(scene.particle_spacing);
    if count > 0.0 { (count + 0.5) as u64 } else { 0 }
}

/// Every particle of a scene that [`Scene::check`] accepts, in order of its id: the fluid, then the walls, then
/// air that is not there yet.
pub fn places(scene: &Scene) -> impl Iterator<Item = Place> {
    // a linear congruential generator (Numerical Recipes): any fixed sequence will do
    let mut seed = 1u32;
    let mut random = move || {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(seed >> 8) / f64::from(1u32 << 24) - 0.5
    };
    let spacing = f64::from(scene.particle_spacing);
    let blocks = scene.blocks.iter().enumerate();
    let fluid = blocks.flat_map(|(i, block)| indices(counts(block, scene)).map(move |index| (i, block, index)));
    let fluid = fluid.map(move |(i, block, index)| {
        let mut position = [0.0; 3];
        for axis in 0..scene.dimension.count() {
            let centre = f64::from(block.corner[axis]) + (index[axis] as f64 + 0.5) * spacing;
            let shift = if block.jitter > 0.0 { random() * f64::from(block.jitter) * spacing } else { 0.0 };
            position[axis] = (centre + shift) as f32;
        }
        let species = if block.dynamic_viscosity.is_some() { FIRST_BLOCK + i as u32 } else { block.fluid };
        let mut place = Place::of_fluid(species, position, block.velocity);
        if scene.model.hydrostatic_start {
            let (deviation, pressure) = hydrostatic_deviation(scene, block.fluid, position);
            place = Place { mass: (1.0 + deviation) as f32, deviation: deviation as f32, pressure, ..place };
        }
        place
    });
    fluid.chain(wall_places(scene)).chain(air_places(scene))
}

/// Air that is not there: it takes no part in anything, so it may lie anywhere.
fn air_places(scene: &Scene) -> impl Iterator<Item = Place> {
    let mut corner = scene.blocks.first().map_or([0.0; 3], |block| block.corner);
    if scene.dimension == Dimension::Two {
        corner[2] = 0.0;
    }
    core::iter::repeat_n(Place::of_fluid(DORMANT, corner, [0.0; 3]), scene.air_capacity())
}

/// All triples below `counts`, the first one fastest.
pub(super) fn indices(counts: [u64; 3]) -> impl Iterator<Item = [u64; 3]> {
    let [nx, ny, nz] = counts;
    (0..nz).flat_map(move |z| (0..ny).flat_map(move |y| (0..nx).map(move |x| [x, y, z])))
}
