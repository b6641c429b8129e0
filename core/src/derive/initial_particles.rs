//! The particles of a scene at its start: cell centres of a lattice, block after block, then wall after wall and solid
//! after solid, x fastest; last the inactive ones.
use super::derived::Derived;
use super::frames::Frames;
use super::hydrostatic::hydrostatic_deviation;
use super::material::{FIRST_BLOCK, INACTIVE};
use super::sampling::lattice::{cells, centre};
use super::sampling::solids::solid_particles;
use super::sampling::walls::wall_particles;
use crate::scene::{Dimension, InitialParticle, Scene};
use glam::Vec3;

/// All particles of a scene in order of their ids: fluids, walls, solids, then the inactive ones.
pub(crate) fn initial_particles<'a>(
    scene: &'a Scene,
    derived: &'a Derived,
) -> impl Iterator<Item = InitialParticle> + use<'a> {
    // a linear congruential generator (Numerical Recipes): any fixed sequence would do
    let mut seed = 1u32;
    let mut random = move || {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(seed >> 8) / f64::from(1u32 << 24) - 0.5
    };
    let frames = Frames::of(scene, &derived.parameters, &derived.poses);
    let spacing = f64::from(scene.particle_spacing);
    let blocks = scene.blocks.iter().enumerate();
    let fluid = blocks.flat_map(move |(i, block)| cells(block, scene, frames).map(move |index| (i, block, index)));
    let fluid = fluid.map(move |(i, block, index)| {
        let mut position = [0.0; 3];
        let centre = centre(block, index, spacing, scene.dimension.count());
        for axis in 0..scene.dimension.count() {
            let shift = if block.jitter > 0.0 { random() * f64::from(block.jitter) * spacing } else { 0.0 };
            position[axis] = (centre[axis] + shift) as f32;
        }
        let material = if block.dynamic_viscosity.is_some() { FIRST_BLOCK + i as u32 } else { block.fluid };
        let mut particle = InitialParticle::of_fluid(material, position, block.velocity);
        if scene.model.initialize_hydrostatic {
            let own = derived.fluid(block.fluid);
            let (deviation, pressure) = hydrostatic_deviation(scene, block.fluid, own, position);
            let (mass, deviation) = ((1.0 + deviation) as f32, deviation as f32);
            particle = InitialParticle { mass, deviation, pressure, ..particle };
        }
        particle
    });
    let layers = derived.wall_layers;
    fluid.chain(wall_particles(scene, layers)).chain(solid_particles(scene, layers, frames)).chain(inactive(scene))
}

/// Inactive particles. They take no part in any sum, so their position does not matter.
fn inactive(scene: &Scene) -> impl Iterator<Item = InitialParticle> {
    let mut corner = scene.blocks.first().map_or(Vec3::ZERO, |block| block.corner);
    if scene.dimension == Dimension::Two {
        corner[2] = 0.0;
    }
    core::iter::repeat_n(InitialParticle::of_fluid(INACTIVE, corner, [0.0; 3]), scene.inactive_at_start())
}
