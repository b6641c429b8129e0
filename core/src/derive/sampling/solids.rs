//! Positions of the particles of solids: layers of a lattice behind their surfaces, which fits between opposite sides.
use super::lattice::{indices, volume, whole};
use crate::derive::frames::Frames;
use crate::derive::solids::reach;
use crate::scene::{InitialParticle, Scene, Shape, Solid, SolidModel};
use glam::Vec3;

/// Largest number of cells that are looked at for a solid. With more it has too many particles anyway.
const MOST_CELLS: u64 = 1 << 27;

/// The lattice around a solid: its low corner in the frame of the solid, its spacings and its counts.
struct Lattice {
    low: [f64; 3],
    spacing: [f64; 3],
    counts: [u64; 3],
}

fn lattice(solid: &Solid, scene: &Scene, layers: u32) -> Lattice {
    let d = scene.dimension.count();
    let reach = reach(solid, scene.dimension);
    let size = match &solid.shape {
        Shape::Box { size } => *size,
        Shape::Cylinder { radius, height } => Vec3::new(2.0 * radius, *height, 2.0 * radius),
        Shape::Capsule { radius, length } => Vec3::new(2.0 * radius, length + 2.0 * radius, 2.0 * radius),
        _ => Vec3::splat(2.0 * reach),
    };
    let mut lattice = Lattice { low: [0.0; 3], spacing: [0.0; 3], counts: [1; 3] };
    for axis in 0..d {
        // NaN becomes one cell
        let inside = whole(size[axis], scene).max(1);
        let outside = if solid.hollow { u64::from(layers) } else { 0 };
        let spacing = f64::from(size[axis]) / inside as f64;
        lattice.counts[axis] = inside.saturating_add(2 * outside);
        lattice.spacing[axis] = spacing;
        lattice.low[axis] = -0.5 * f64::from(size[axis]) - outside as f64 * spacing;
    }
    lattice
}

/// The solid with this number, if it has particles.
fn sampled(number: usize, scene: &Scene) -> Option<&Solid> {
    let solid = scene.solids.get(number).filter(|solid| solid.model == SolidModel::Particles);
    solid.filter(|solid| !matches!(solid.shape, Shape::Plane | Shape::Facet { .. }))
}

/// Number of particles of a solid. It is found in a bounded time for any scene, checked or not.
pub(crate) fn solid_count(number: usize, scene: &Scene, layers: u32, frames: Frames<'_>) -> u64 {
    let cells = sampled(number, scene).map_or(0, |solid| volume(lattice(solid, scene, layers).counts));
    if cells > MOST_CELLS { cells } else { local_places(number, scene, layers, frames).count() as u64 }
}

/// Positions of the particles of a solid in its own frame.
fn local_places<'a>(
    number: usize,
    scene: &'a Scene,
    layers: u32,
    frames: Frames<'a>,
) -> impl Iterator<Item = Vec3> + use<'a> {
    let solid = sampled(number, scene);
    let depth = (f64::from(layers) * f64::from(scene.particle_spacing)) as f32;
    solid.into_iter().flat_map(move |solid| {
        let Lattice { low, spacing, counts } = lattice(solid, scene, layers);
        let at = move |index: [u64; 3]| {
            Vec3::from_array([0, 1, 2].map(|axis| (low[axis] + (index[axis] as f64 + 0.5) * spacing[axis]) as f32))
        };
        indices(counts).map(at).filter(move |&place| {
            let distance = frames.distance(number, place);
            distance < 0.0 && distance > -depth
        })
    })
}

/// All particles of solids.
pub(crate) fn solid_particles<'a>(
    scene: &'a Scene,
    layers: u32,
    frames: Frames<'a>,
) -> impl Iterator<Item = InitialParticle> + use<'a> {
    (0..scene.solids.len()).flat_map(move |number| {
        local_places(number, scene, layers, frames).filter_map(move |local| frames.particle(number, local))
    })
}
